// SPDX-License-Identifier: BSD-3-Clause
// Cases in space: bodies that go from brick to brick, loads, contact, rigid bodies and sand, with the bits of the driver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <adapters/mpm/space/kernel/particles.hpp>
#include <cli/process/exit_code.hpp>

#include "support/both_hosts.hpp"
#include "support/brick.hpp"

namespace {

namespace c = grit::mpm::space::column;

constexpr long all = 1000000;

double lowest(const Told& told, int column) {
    double least = INFINITY;
    for (const auto& [id, row] : told.points)
        least = std::min(least, row[static_cast<std::size_t>(column)]);
    return least;
}

// Rows after a step, but the first of those that follow a restart: its forces are means since the row before.
void expect_rest(const Told& whole, const Told& after, std::size_t step) {
    Told rest = whole, steps = after;
    ASSERT_GT(rest.rows.size(), step + 1);
    ASSERT_FALSE(steps.rows.empty());
    EXPECT_EQ(steps.rows[0][2], rest.rows[step][2]);
    rest.rows.erase(rest.rows.begin(), rest.rows.begin() + static_cast<std::ptrdiff_t>(step) + 1);
    steps.rows.erase(steps.rows.begin());
    EXPECT_EQ(first_difference(rest, steps), "");
}

// From the first sub-domain into the last one, across all borders.
TEST(LammpsSpace, HasTheBitsOfTheDriverHoweverTheGridIsCut) {
    const BothHosts hosts(brick_case("4, 3.5, 3.5", "2.4"));
    const Told driver = hosts.in_driver(all);
    ASSERT_GT(driver.rows.size(), 50u);
    EXPECT_GT(lowest(driver, c::x), 11.0);
    EXPECT_GT(lowest(driver, c::y), 9.0);
    EXPECT_GT(lowest(driver, c::z), 9.0);
    for (const auto& bricks : {std::array{1, 1, 1}, std::array{2, 1, 1}, std::array{1, 2, 1},
                               std::array{1, 1, 2}, std::array{2, 2, 1}, std::array{2, 2, 2}})
        EXPECT_EQ(first_difference(driver, hosts.in_lammps(bricks)), "")
            << bricks[0] << ' ' << bricks[1] << ' ' << bricks[2];
}

TEST(LammpsSpace, LosesNoPointOnTheWayBackThroughThreeSubdomains) {
    std::string text = brick_case("-6, -3.5, 0.5", "2.2");
    text = replaced(text, "[2, 6]", "[17, 21]");
    text = replaced(text, "[2, 5]", "[12, 15]");
    const BothHosts hosts(text);
    const Told lammps = hosts.in_lammps({3, 2, 1});
    EXPECT_LT(lowest(lammps, c::x), 6.0);
    EXPECT_LT(lowest(lammps, c::y), 6.0);
    EXPECT_EQ(first_difference(hosts.in_driver(all), lammps), "");
}

// The grid is cut anew: balance moves the cuts to where the block is.
TEST(LammpsSpace, GoesOnWhereTheGridIsCutAnew) {
    const BothHosts hosts(brick_case("1, 0.5, 0.5", "1.2"));
    const std::string script = replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                                        "run 7\nbalance 1.0 shift xyz 10 1.01\nrun ${most_steps}");
    const Told lammps = hosts.in_lammps({2, 2, 2}, script);
    EXPECT_EQ(first_difference(hosts.in_driver(all), lammps), "");
}

TEST(LammpsSpace, FollowsTheCutsOfFixBalanceInARun) {
    const BothHosts hosts(brick_case("4, 0.5, 1", "2.4"));
    const std::string script =
        replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                 "fix cuts all balance 10 1.0 shift xz 10 1.01\nrun ${most_steps}\n"
                 "print \"moved $(f_cuts[2]!=0)\"\nunfix cuts");
    EXPECT_EQ(first_difference(hosts.in_driver(all), hosts.in_lammps({2, 1, 2}, script)), "");
}

// Sand with loads, a rigid body that turns and one that moves freely, contact by both laws at nodes.
class LammpsSpaceStamp : public ::testing::Test {
  protected:
    static std::string text() {
        std::ostringstream out;
        out << std::ifstream(STAMP_IN_SPACE).rdbuf();
        return out.str();
    }
    static const Told& reference() {
        static const Told told = BothHosts(text()).in_driver(all);
        return told;
    }
};

TEST_F(LammpsSpaceStamp, HasTheBitsOfTheDriverHoweverTheGridIsCut) {
    constexpr std::size_t tip = 6, damping = 17, moment = 40;
    for (const std::size_t column : {tip, damping, moment})
        EXPECT_NE(reference().rows.back()[column], 0.0) << column;
    const BothHosts hosts(text());
    for (const auto& bricks : {std::array{1, 1, 1}, std::array{1, 1, 2}, std::array{2, 2, 2}})
        EXPECT_EQ(first_difference(reference(), hosts.in_lammps(bricks)), "")
            << bricks[0] << ' ' << bricks[1] << ' ' << bricks[2];
}

// ... the sand below its water table, whose pressure is that of cells across the cuts, and does not rub.
TEST_F(LammpsSpaceStamp, HasTheBitsOfTheDriverInWetSandToo) {
    const BothHosts hosts(replaced(text(), "[body.sand]",
                                   "[body.water]\nbulk_modulus_kPa = 50000\nwater_table_m = 0\n"
                                   "[body.sand]"));
    const Told driver = hosts.in_driver(all);
    constexpr std::size_t tip = 6, pore_water_work = 28;
    for (const std::size_t column : {tip, pore_water_work})
        EXPECT_GT(std::fabs(driver.rows.back()[column]), 1e-3) << column;
    for (const auto& bricks : {std::array{1, 1, 1}, std::array{1, 1, 2}, std::array{2, 2, 2}})
        EXPECT_EQ(first_difference(driver, hosts.in_lammps(bricks)), "")
            << bricks[0] << ' ' << bricks[1] << ' ' << bricks[2];
    const Told before = hosts.in_lammps({2, 1, 2}, "restart 40 stamp\n" + hosts.script());
    EXPECT_EQ(first_difference(driver, before), "");
    expect_rest(driver, hosts.in_lammps({2, 2, 2}, hosts.go_on("stamp.40")), 40);
}

// In the second stage.
TEST_F(LammpsSpaceStamp, GoesOnOnOtherBricksFromARestartFile) {
    const BothHosts hosts(text());
    const Told before = hosts.in_lammps({2, 1, 2}, "restart 15 stamp\n" + hosts.script());
    EXPECT_EQ(first_difference(reference(), before), "");
    expect_rest(reference(), hosts.in_lammps({2, 2, 2}, hosts.go_on("stamp.15")), 15);
    expect_rest(reference(), hosts.in_lammps({1, 1, 1}, hosts.go_on("stamp.15")), 15);
}

// From a file that was written before any step: a process without an atom, too.
TEST(LammpsSpace, GoesOnFromARestartFileOfBricksOfWhichSomeAreEmpty) {
    const BothHosts hosts(brick_case("4, 3.5, 3.5", "2.4"));
    const Told driver = hosts.in_driver(all);
    hosts.in_lammps({2, 2, 2}, "restart 9 brick\n" + hosts.script());
    expect_rest(driver, hosts.in_lammps({3, 1, 1}, hosts.go_on("brick.9")), 9);
    expect_rest(driver, hosts.in_lammps({1, 2, 2}, hosts.go_on("brick.18")), 18);
}

// Two blocks meet where eight sub-domains do. What one of them loses the other one gains: forces on nodes that
// several processes hold balance, and none is counted twice.
TEST(LammpsSpace, MassMomentumAndContactForcesBalanceToRoundoff) {
    std::string text = brick_case("2, 1.5, 1", "3", R"(
[[body]]
name = "target"
density_kg_per_m3 = 1500
[[body.box]]
x_m = [11, 14]
y_m = [7, 12]
z_m = [5, 12]
[body.elastic]
youngs_modulus_kPa = 400
poissons_ratio = 0.2
[[contact]]
stiff = "block"
soft = "target"
law = "frictional"
friction_coefficient = 0.3
)");
    text = replaced(text, "gravity_m_per_s2 = 0.5", "gravity_m_per_s2 = 0");
    text = replaced(text, "local_damping = 0.01", "local_damping = 0");
    text = replaced(text, "fixed_point = true", "fixed_point = false");
    text = replaced(text, "kPa = 20", "kPa = 400");
    text = replaced(text, "x_m = [2, 6]", "x_m = [6, 10]");
    text = replaced(text, "y_m = [2, 5]", "y_m = [5, 8]");
    text = replaced(text, "z_m = [3, 6]", "z_m = [6, 9]");
    const Told lammps = BothHosts(text).in_lammps({2, 2, 2});
    const double m = 2000.0 * 36.0, m_target = 1500.0 * 105.0, v[] = {2.0, 1.5, 1.0};
    constexpr int last_of_block = 8 * 36;
    double mass = 0.0, momentum[3] = {}, of_block[3] = {};
    for (const auto& [id, row] : lammps.points) {
        mass += row[c::mass];
        for (std::size_t k = 0; k < 3; ++k) {
            momentum[k] += row[c::mass] * row[c::v_x + k];
            if (id <= last_of_block) of_block[k] += row[c::mass] * row[c::v_x + k];
        }
    }
    EXPECT_NEAR(mass, m + m_target, 1e-13 * (m + m_target));
    double impulse[3] = {}, t = 0.0;
    for (const std::vector<double>& row : lammps.rows) {
        constexpr std::size_t time = 2, contact_x = 35;
        for (std::size_t k = 0; k < 3; ++k) impulse[k] += row[contact_x + k] * (row[time] - t);
        t = row[time];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(momentum[k], m * v[k], 1e-12 * 2.0 * m);
        EXPECT_NEAR(impulse[k], of_block[k] - m * v[k], 1e-12 * 2.0 * m);
    }
    EXPECT_LT(of_block[0], 0.8 * m * v[0]);  // they did meet, and rub
    EXPECT_GT(std::fabs(impulse[1]) + std::fabs(impulse[2]), 1e-3 * m);
}

// A load and a motion as formulas of the script, time for time.
TEST(LammpsSpace, TakesLoadsAndMotionsFromVariables) {
    const BothHosts hosts(brick_case("0, 0, 0", "0.8", R"(
[[body]]
name = "plate"
[[body.box]]
x_m = [2, 6]
y_m = [2, 5]
z_m = [6, 7]
[body.rigid]
velocity_z_m_per_s = [-1]
angular_velocity_z_rad_per_s = [0.5]
[[traction]]
body = "block"
edge = "left"
[traction.pulses]
peak_kPa = 1
duration_s = 0.5
[[contact]]
stiff = "plate"
soft = "block"
law = "frictional"
friction_coefficient = 0.3
)"));
    std::string fix = hosts.folder.read("both.fix");
    const std::size_t begin = fix.find("pulses "), end = fix.find(" &", begin);
    ASSERT_NE(begin, std::string::npos);
    fix.replace(begin, end - begin, "v_hammer");
    fix = replaced(fix, "motion plate 0 0 -1 spin 0 0 0.5",
                   "motion plate 0 0 v_down spin 0 0 v_turn");
    hosts.folder.write("both.fix", "variable hammer equal \"1000*(time<0.5)*sin(PI*time/0.5)\"\n"
                                   "variable down equal -1\nvariable turn equal 0.5\n" +
                                       fix);
    const Told driver = hosts.in_driver(all), lammps = hosts.in_lammps({2, 1, 2});
    ASSERT_EQ(lammps.rows.size(), driver.rows.size());
    constexpr std::size_t traction_work = 14, rigid_work = 15;
    for (const std::size_t column : {traction_work, rigid_work}) {
        const double wanted = driver.rows.back()[column];
        EXPECT_GT(std::fabs(wanted), 1.0);
        EXPECT_NEAR(lammps.rows.back()[column], wanted, 1e-12 * std::fabs(wanted));
    }
}

// ... what a case in space does not have across processes, or not at all, by name.
class LammpsSpaceRefuses : public ::testing::Test {
  protected:
    void expect(const std::string& words, const std::string& other, const std::string& why,
                int processes = 1) {
        std::string script = hosts.folder.read("both.in"), fix = hosts.folder.read("both.fix");
        std::string& text = fix.find(words) == std::string::npos ? script : fix;
        text = replaced(text, words, other);
        hosts.folder.write("changed.fix", fix);
        const Answer answer = hosts.lammps(processes, replaced(script, "both.fix", "changed.fix"));
        EXPECT_NE(answer.status, 0);
        EXPECT_TRUE(answer.says("ERROR") && answer.says(why)) << answer.text;
    }
    const BothHosts hosts{brick_case("1, 0.5, 0.5", "0.1")};
};

TEST_F(LammpsSpaceRefuses, ABoxOfThePlane) {
    expect("dimension 3", "dimension 2", "");
    expect("boundary f f f", "boundary f f p", "fixed boundaries along x, y and z: boundary f f f");
    expect("grid z 18", "grid z 17", "grid z ends at 17");
}

TEST_F(LammpsSpaceRefuses, WhatIsNotThere) {
    expect("driven block", "water block flow porosity 0.4 conductivity 1e-3 driven block",
           "water that flows is not there in space");
    expect("driven block", "water block undrained pressure implicit porosity 0.4 driven block",
           "an implicit one is not there in space");
    expect("scheme usl", "scheme musl", "another scheme than usl is not there in space");
    expect("driven block", "contact block block surface 0.3 after_damping yes driven block",
           "contact after damping is not there in space");
    expect("driven block", "contact block block penalty 0.3 driven block",
           "the law of a contact must be one of geo, frictional, surface, got \"penalty\"");
    expect("driven block", "boundary front absorbing driven block",
           "the boundary of a side must be one of free, roller, fixed");
}

TEST_F(LammpsSpaceRefuses, SubdomainsThinnerThanTheHalo) {
    expect("units si", "processors 1 1 4\nunits si", "is too thin for the cells there", 4);
}

TEST(LammpsSpace, CasesThatItDoesNotHaveAreRefusedBeforeAnyFileIsWritten) {
    const std::string block = brick_case("1, 0.5, 0.5", "0.1");
    EXPECT_THROW(BothHosts(replaced(block, "bottom = \"roller\"", "bottom = \"absorbing\"")),
                 cli::BadInput);
}

}  // namespace
