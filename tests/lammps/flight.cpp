// SPDX-License-Identifier: BSD-3-Clause
// Bodies that go from process to process.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <adapters/mpm/kernel/particles.hpp>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

namespace c = grit::mpm::column;

double lowest(const Told& told, int column) {
    double least = INFINITY;
    for (const auto& [id, row] : told.points)
        least = std::min(least, row[static_cast<std::size_t>(column)]);
    return least;
}

TEST(LammpsFlight, LosesNoPointAcrossAllBordersOfSubdomains) {
    const BothHosts hosts(block_case("4, 3.5", "3.2"));
    const Told driver = hosts.in_driver(1000000), lammps = hosts.in_lammps(2, 2);
    // From the first sub-domain into the last one, across both borders at 12 m.
    EXPECT_GT(lowest(lammps, c::r), 12.0);
    EXPECT_GT(lowest(lammps, c::z), 12.0);
    EXPECT_EQ(first_difference(driver, lammps), "");
}

TEST(LammpsFlight, CrossesThreeSubdomainsInARow) {
    const BothHosts hosts(block_case("6, 1", "2.4"));
    const Told lammps = hosts.in_lammps(3, 1);
    EXPECT_GT(lowest(lammps, c::r), 16.0);
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), lammps), "");
}

// Mass and momentum are those of the start to roundoff: the columns are summed over particles.
TEST(LammpsFlight, KeepsMassAndMomentumToRoundoff) {
    const BothHosts hosts(block_case("4, 3.5", "3.2"));
    const Told lammps = hosts.in_lammps(2, 2);
    double mass = 0.0, p_r = 0.0, p_z = 0.0;
    for (const auto& [id, row] : lammps.points) {
        mass += row[c::mass];
        p_r += row[c::mass] * row[c::v_r];
        p_z += row[c::mass] * row[c::v_z];
    }
    const double wanted = 2000.0 * 4.0 * 3.0;
    EXPECT_NEAR(mass, wanted, 1e-13 * wanted);
    EXPECT_NEAR(p_r, 4.0 * wanted, 1e-13 * 4.0 * wanted);
    EXPECT_NEAR(p_z, 3.5 * wanted, 1e-13 * 3.5 * wanted);
}

// The grid is cut anew: balance moves the cut along r to where the block is.
TEST(LammpsFlight, GoesOnWhereTheGridIsCutAnew) {
    const BothHosts hosts(block_case("1, 0.5", "1.2"));
    std::string script = hosts.folder.read(hosts.name + ".in");
    script.replace(script.find("run ${most_steps}"), 17,
                   "run 7\nbalance 1.0 shift x 10 1.01\nrun ${most_steps}");
    const Told lammps = hosts.in_lammps(2, 1, script);
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), lammps), "");
}

// The hammer as a formula of the script, time for time.
TEST(LammpsFlight, TakesTheHammerFromAVariable) {
    const std::string hammer = "[[traction]]\nbody = \"block\"\nedge = \"left\"\n"
                               "[traction.pulses]\npeak_kPa = 1\nduration_s = 0.5\n";
    const BothHosts hosts(block_case("1, 0", "0.8", hammer));
    std::string fix = hosts.folder.read("both.fix");
    const std::size_t begin = fix.find("pulses "), end = fix.find(" &", begin);
    ASSERT_NE(begin, std::string::npos);
    fix.replace(begin, end - begin, "v_hammer");
    hosts.folder.write("both.fix",
                       "variable hammer equal \"1000*(time<0.5)*sin(PI*time/0.5)\"\n" + fix);
    const Told driver = hosts.in_driver(1000000), lammps = hosts.in_lammps(2, 1);
    ASSERT_EQ(lammps.rows.size(), driver.rows.size());
    constexpr std::size_t external_work = 12;
    const double wanted = driver.rows.back()[external_work];
    EXPECT_GT(wanted, 1.0);
    EXPECT_NEAR(lammps.rows.back()[external_work], wanted, 1e-12 * wanted);
}

}  // namespace
