// SPDX-License-Identifier: BSD-3-Clause
// Restart files at other times and under other words.
#include <gtest/gtest.h>

#include <string>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

class LammpsRestarts : public ::testing::Test {
  protected:
    const BothHosts hosts{block_case("1, 0.5", "0.4")};
    std::string changed(const std::string& words, const std::string& other) const {
        return replaced(hosts.folder.read("both.in"), words, other);
    }
    void expect_refused(const std::string& words, const std::string& other) const {
        const std::string fix = hosts.folder.read("both.fix");
        hosts.folder.write("both.fix", replaced(fix, words, other));
        const Answer answer = hosts.lammps(2, hosts.go_on("some.restart"));
        hosts.folder.write("both.fix", fix);
        EXPECT_NE(answer.status, 0);
        EXPECT_TRUE(answer.says("of a fix with other words")) << answer.text;
    }
};

TEST_F(LammpsRestarts, BeginFromAFileThatWasWrittenBeforeTheFirstRun) {
    const Answer before =
        hosts.lammps(2, changed("run ${most_steps}", "write_restart some.restart"));
    ASSERT_EQ(before.status, 0) << before.text;
    const Told told = hosts.in_lammps(
        1, 1, hosts.go_on("some.restart", "fix_modify mpm stage flight until_time 0.4\n"));
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), told), "");
}

TEST_F(LammpsRestarts, MayBeWrittenAgainBeforeARun) {
    ASSERT_EQ(
        hosts.lammps(2, changed("run ${most_steps}", "run 3\nwrite_restart some.restart")).status,
        0);
    const Answer again = hosts.lammps(1, "atom_modify map yes\nread_restart some.restart\n"
                                         "include both.fix\nwrite_restart again.restart\n");
    ASSERT_EQ(again.status, 0) << again.text;
    const Told told = hosts.in_lammps(2, 1, hosts.go_on("again.restart"));
    const Told driver = hosts.in_driver(1000000);
    ASSERT_FALSE(told.rows.empty());
    EXPECT_EQ(
        first_difference({{driver.rows.back()}, driver.points}, {{told.rows.back()}, told.points}),
        "");
    EXPECT_EQ(told.rows.front()[1], 3.0);
}

TEST_F(LammpsRestarts, RefuseOtherWords) {
    ASSERT_EQ(
        hosts.lammps(2, changed("run ${most_steps}", "run 3\nwrite_restart some.restart")).status,
        0);
    expect_refused("elastic 20000", "elastic 30000");
    expect_refused("fixed_point yes", "fixed_point no");
    // Names of files and threads may be others.
    hosts.folder.write("other.points", hosts.folder.read("both_block.points"));
    hosts.folder.write("both.fix",
                       replaced(hosts.folder.read("both.fix"), "points block both_block.points",
                                "threads 2 points block other.points"));
    const Answer answer = hosts.lammps(2, hosts.go_on("some.restart"));
    EXPECT_EQ(answer.status, 0) << answer.text;
}

}  // namespace
