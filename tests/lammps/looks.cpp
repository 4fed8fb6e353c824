// SPDX-License-Identifier: BSD-3-Clause
// Columns of particles are right whenever another style of LAMMPS looks.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

std::string with(const BothHosts& hosts, const std::string& run) {
    return replaced(hosts.folder.read("both.in"), "run ${most_steps}", run);
}

// Lines of id, x, and the column that is x too; balance scales x there and back.
void expect_x_twice(const std::string& dump) {
    std::istringstream lines(dump.substr(dump.find("ITEM: ATOMS")));
    std::string line;
    std::getline(lines, line);
    int count = 0;
    for (double id = 0, x = 0, column = 0; lines >> id >> x >> column; ++count)
        EXPECT_NEAR(x, column, 1e-12) << "atom " << id;
    EXPECT_EQ(count, 48);
}

const std::string dump = " id x f_mpm[1] modify format float %.17g\n";

TEST(LammpsLooks, MeansOfAtomsAreThoseOfEachStep) {
    const BothHosts hosts(block_case("4, 0.5", "2.4"));
    const Answer answer =
        hosts.lammps(2, with(hosts, "fix means all ave/atom 1 10 10 f_mpm[1] x\n"
                                    "dump d all custom 10 d.*.dump id f_means[2] f_means[1]\n"
                                    "dump_modify d first no format float %.17g\nrun 20\n"));
    ASSERT_EQ(answer.status, 0) << answer.text;
    for (const char* name : {"d.10.dump", "d.20.dump"}) expect_x_twice(hosts.folder.read(name));
}

TEST(LammpsLooks, AtomsKeepTheirColumnsWhereACommandSendsThem) {
    const BothHosts hosts(block_case("4, 0.5", "2.4"));
    const Answer answer = hosts.lammps(
        2, with(hosts, "write_dump all custom before.dump" + dump +
                           "run 7\nwrite_restart r.bin\nwrite_dump all custom a.dump" + dump +
                           "run 6 pre no\nwrite_dump all custom b.dump" + dump +
                           "balance 1.0 shift x 10 1.01\nwrite_dump all custom c.dump" + dump +
                           "run 4\nwrite_dump all custom d.dump" + dump));
    ASSERT_EQ(answer.status, 0) << answer.text;
    for (const char* name : {"before.dump", "a.dump", "b.dump", "c.dump", "d.dump"})
        expect_x_twice(hosts.folder.read(name));
}

TEST(LammpsLooks, DumpsMayBeAtAnyStep) {
    const BothHosts hosts(block_case("4, 0.5", "2.4"));
    const Answer answer =
        hosts.lammps(2, with(hosts, "dump d all custom 7 d.*.dump id x f_mpm[1]\n"
                                    "dump_modify d format float %.17g\nrun 15\n"));
    ASSERT_EQ(answer.status, 0) << answer.text;
    for (const char* name : {"d.7.dump", "d.14.dump"}) expect_x_twice(hosts.folder.read(name));
}

}  // namespace
