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

TEST(LammpsFlight, LosesNoPointOnTheWayBack) {
    std::string text = block_case("-4, -3.5", "3.2");
    text = replaced(text, "[2, 6]", "[18, 22]");
    text = replaced(text, "[3, 6]", "[18, 21]");
    const BothHosts hosts(text);
    const Told lammps = hosts.in_lammps(2, 2);
    EXPECT_LT(lowest(lammps, c::r), 8.0);
    EXPECT_LT(lowest(lammps, c::z), 9.0);
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), lammps), "");
}

TEST(LammpsFlight, CrossesThreeSubdomainsInARow) {
    const BothHosts hosts(block_case("6, 1", "2.4"));
    const Told lammps = hosts.in_lammps(3, 1);
    EXPECT_GT(lowest(lammps, c::r), 16.0);
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), lammps), "");
}

// Of body 0 or 1, or of both.
struct Momentum {
    double mass = 0.0, r = 0.0, z = 0.0;
};

Momentum momentum(const Told& told, int first, int last) {
    Momentum out;
    for (const auto& [id, row] : told.points) {
        if (id < first || id > last) continue;
        out.mass += row[c::mass];
        out.r += row[c::mass] * row[c::v_r];
        out.z += row[c::mass] * row[c::v_z];
    }
    return out;
}

// Two blocks meet where four sub-domains do. What one of them loses the other one gains: forces on nodes that
// several processes hold balance, and none is counted twice.
class LammpsContact : public ::testing::TestWithParam<std::string> {};

TEST_P(LammpsContact, MassMomentumAndContactForcesBalanceToRoundoff) {
    std::string text = block_case("2, 2", "3.6", R"(
[[body]]
name = "target"
density_kg_per_m3 = 1500
[[body.box]]
r_m = [11.5, 16.5]
z_m = [8, 16]
[body.elastic]
youngs_modulus_kPa = 20
poissons_ratio = 0.2
[[contact]]
stiff = "block"
soft = "target"
law = "frictional"
friction_coefficient = 0.3
)");
    text = replaced(text, "frictional", GetParam());
    text = replaced(text, "fixed_point = true", "fixed_point = false");
    for (std::size_t at = 0; (at = text.find("kPa = 20", at)) != std::string::npos; ++at)
        text.replace(at, 8, "kPa = 400");
    const BothHosts hosts(text);
    const Told lammps = hosts.in_lammps(2, 2);
    constexpr int last_of_block = 48, last = 48 + 160;
    const double m = 2000.0 * 12.0, m_target = 1500.0 * 40.0;
    const Momentum all = momentum(lammps, 1, last), block = momentum(lammps, 1, last_of_block);
    ASSERT_EQ(lammps.points.size(), static_cast<std::size_t>(last));
    EXPECT_NEAR(all.mass, m + m_target, 1e-13 * (m + m_target));
    EXPECT_NEAR(all.r, 2.0 * m, 1e-13 * 2.0 * m);
    EXPECT_NEAR(all.z, 2.0 * m, 1e-13 * 2.0 * m);
    // The forces that the history tells, means over its rows, are the block's change of momentum.
    double impulse = 0.0, t = 0.0;
    for (const std::vector<double>& row : lammps.rows) {
        constexpr std::size_t time = 2, tip = 6, shaft = 7;
        impulse += (row[tip] + row[shaft]) * (row[time] - t);
        t = row[time];
    }
    EXPECT_NEAR(impulse, block.z - 2.0 * m, 1e-13 * 2.0 * m);
    // They did meet, and rub.
    EXPECT_LT(block.r, 1.5 * m);
    EXPECT_GT(std::abs(block.z - 2.0 * m), 1e-3 * m);
}

INSTANTIATE_TEST_SUITE_P(Laws, LammpsContact, testing::Values("frictional", "surface"));

// The grid is cut anew: balance moves the cut along r to where the block is.
TEST(LammpsFlight, GoesOnWhereTheGridIsCutAnew) {
    const BothHosts hosts(block_case("1, 0.5", "1.2"));
    const std::string script = replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                                        "run 7\nbalance 1.0 shift x 10 1.01\nrun ${most_steps}");
    const Told lammps = hosts.in_lammps(2, 1, script);
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), lammps), "");
}

// ... and while a run goes on: the block takes the cut along.
TEST(LammpsFlight, FollowsTheCutsOfFixBalanceInARun) {
    const BothHosts hosts(block_case("4, 0.5", "2.4"));
    const std::string script =
        replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                 "fix cuts all balance 10 1.0 shift x 10 1.01\nrun ${most_steps}\n"
                 "print \"moved $(f_cuts[2]!=0)\"\nunfix cuts");
    const Told driver = hosts.in_driver(1000000);
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 1, script)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 1, script)), "");
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
