// SPDX-License-Identifier: BSD-3-Clause
// Sand below its water table in both hosts: a pile that is driven into it, and one that is pushed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include <adapters/mpm/run/history.hpp>

#include "support/both_hosts.hpp"

namespace {

// Of the history.
constexpr std::size_t tip_force = 6, rigid_work = 15, contact_loss = 16, water_work = 28,
                      drag_loss = 29, smallest_pressure = 30, largest_pressure = 31;

const std::string flow =
    "drainage = \"flow\"\nconductivity_m_per_s = 1e-3\nconductivity_law = \"kozeny_carman\"";
const std::string undrained = "drainage = \"undrained\"";
const std::string implicit = "\npressure = \"implicit\"";

std::string pile_blows() {
    std::ostringstream out;
    out << std::ifstream(PILE_BLOWS).rdbuf();
    return out.str();
}

// With explicit pressure water as soft as the sand, so that it does not limit the step; else ten times as stiff.
std::string wet(const std::string& drainage) {
    std::string text =
        replaced(pile_blows(), "[body.stress_at_rest]",
                 "[body.water]\nwater_table_m = 0.0\n" + drainage + "\n[body.stress_at_rest]");
    text = replaced(text, "[body.water]",
                    drainage.ends_with(implicit) ? "[body.water]\nbulk_modulus_kPa = 2e5"
                                                 : "[body.water]\nbulk_modulus_kPa = 2e4");
    text = replaced(text, "time_s = 0.03", "time_s = 0.012");
    text = replaced(text, "count = 2", "count = 1");
    text = replaced(text, "interval_s = 0.02", "interval_s = 0.006");
    text = replaced(text, "blows = 2", "blows = 1");
    return replaced(text, "right = \"roller\"", "right = \"roller\"\ndrained = [\"right\"]");
}
// The pile is rigid and sinks at 1 m/s.
std::string pushed(const std::string& drainage) {
    std::string text =
        replaced(wet(drainage), "[body.elastic]\nyoungs_modulus_kPa = 1e5\npoissons_ratio = 0.2",
                 "[body.rigid]\nvelocity_r_m_per_s = [0]\n"
                 "velocity_z_m_per_s = [-1]");
    const std::size_t load = text.find("[[traction]]\nbody = \"pile\"");
    text.erase(load, text.find("[[contact]]") - load);
    return replaced(text, "blows = 1", "time_s = 0.006");
}

class LammpsWater : public ::testing::TestWithParam<std::string> {};
bool has_flow(const std::string& drainage) { return drainage.starts_with(flow); }
INSTANTIATE_TEST_SUITE_P(Drainage, LammpsWater,
                         testing::Values(undrained, flow, undrained + implicit, flow + implicit),
                         [](const auto& of) {
                             return std::string(has_flow(of.param) ? "Flow" : "Undrained") +
                                    (of.param.ends_with(implicit) ? "Implicit" : "Explicit");
                         });

constexpr long all = 1000000;

void expect_bits_however_cut(const BothHosts& hosts, const Told& driver) {
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 1)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 2)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 2)), "");
}

TEST_P(LammpsWater, UnderBlowsHasTheBitsOfTheDriverHoweverTheGridIsCut) {
    const BothHosts hosts(wet(GetParam()));
    const Told driver = hosts.in_driver(all);
    ASSERT_GT(driver.rows.size(), 100u);
    EXPECT_NE(driver.rows.back()[water_work], 0.0);
    EXPECT_EQ(driver.rows.back()[drag_loss] > 0.0, has_flow(GetParam()));
    EXPECT_GT(driver.rows.back()[largest_pressure], 1.1 * 9810.0 * 1.1);
    EXPECT_GT(driver.rows.back()[contact_loss], 0.0);
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 1)), "");
    expect_bits_however_cut(hosts, driver);
}

// What alternates beside cavities goes off between the cells of several processes.
TEST(LammpsCavities, HaveTheBitsOfTheDriverHoweverTheGridIsCut) {
    for (const std::string& drainage : {undrained, flow}) {
        const BothHosts hosts(
            replaced(wet(drainage + implicit), "[body.water]", "[body.water]\ncavitation_kPa = 0"));
        const Told driver = hosts.in_driver(all);
        const auto cavitates = [](const auto& row) { return row[smallest_pressure] == 0.0; };
        EXPECT_GT(std::count_if(driver.rows.begin(), driver.rows.end(), cavitates), 3);
        expect_bits_however_cut(hosts, driver);
    }
}

// A load at the surface that water bears a share of.
TEST(LammpsWaterAtSurfaces, BearsItsShareOfALoadAsInTheDriver) {
    const std::string text =
        replaced(replaced(wet(flow), "stress_kPa = [1]", "stress_kPa = [1]\nacts_on = \"mixture\""),
                 "time_s = 0.012", "time_s = 0.002");
    const BothHosts hosts(text);
    const Told driver = hosts.in_driver(20);
    const std::string script = hosts.folder.read("both.in");
    const std::string steps =
        script.substr(0, script.find("run ${most_steps}")) + "run 20\n";  // of the first stage
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 1, steps)), "");
    hosts.folder.write("both.fix", replaced(hosts.folder.read("both.fix"), " mixture", ""));
    EXPECT_NE(first_difference(driver, hosts.in_lammps(2, 1, steps)), "");
}

TEST_P(LammpsWater, UnderARigidPileHasTheBitsOfTheDriverHoweverTheGridIsCut) {
    const BothHosts hosts(pushed(GetParam()));
    const Told driver = hosts.in_driver(all);
    EXPECT_GT(driver.rows.back()[rigid_work], 0.0);
    EXPECT_GT(driver.rows.back()[tip_force], 0.0);
    expect_bits_however_cut(hosts, driver);
}

TEST_P(LammpsWater, GoesOnFromARestartFileOnMoreProcesses) {
    const BothHosts hosts(pushed(GetParam()));
    const Told driver = hosts.in_driver(all);
    std::size_t first = 0;  // step of the last stage
    while (driver.rows.at(first)[0] != driver.rows.back()[0]) ++first;
    const std::string step = std::to_string(first + 10);
    const Told before = hosts.in_lammps(2, 1, "restart " + step + " wet\n" + hosts.script());
    const Told after = hosts.in_lammps(2, 2, hosts.go_on("wet." + step));
    ASSERT_FALSE(after.rows.empty());
    EXPECT_EQ(after.rows.front()[1], static_cast<double>(first + 10));
    EXPECT_GT(after.rows.size(), 20u);
    EXPECT_EQ(first_difference({{before.rows.back()}, before.points},
                               {{after.rows.back()}, after.points}),
              "");
}

TEST_P(LammpsWater, GoesOnWhereTheGridIsCutAnew) {
    const BothHosts hosts(pushed(GetParam()));
    std::string script = hosts.folder.read(hosts.name + ".in");
    const std::size_t first = script.find("run ${most_steps}");
    script.replace(first, 17, "run 40\nbalance 1.0 x 0.55\nrun ${most_steps}");
    EXPECT_EQ(first_difference(hosts.in_driver(all), hosts.in_lammps(2, 1, script)), "");
}

std::string at_surfaces(const std::string& text) {
    return replaced(text, "law = \"geo\"", "law = \"surface\"");
}

TEST(LammpsWaterAtSurfaces, HasTheBitsOfTheDriverHoweverTheGridIsCut) {
    for (const std::string& drainage : {undrained, flow}) {
        const BothHosts hosts(at_surfaces(pushed(drainage)));
        const Told driver = hosts.in_driver(all);
        EXPECT_GT(driver.rows.back()[tip_force], 0.0);
        expect_bits_however_cut(hosts, driver);
    }
}

TEST(LammpsWaterAtSurfaces, RefusesAnImplicitPressure) {
    const BothHosts hosts(at_surfaces(pushed(undrained + implicit)));
    const Answer answer = hosts.lammps(1, hosts.script());
    EXPECT_NE(answer.status, 0);
    EXPECT_TRUE(answer.says("contact pile soil: implicit pore pressure, in \"soil\", knows no "
                            "surface contact across processes"))
        << answer.text;
}

// Sums in another order are other sums, by roundoff that grows with the steps; a solver that stops at 1e-5 of its
// load may stop an iteration sooner.
TEST_P(LammpsWater, FollowsTheDriverWithDoubleSums) {
    const BothHosts hosts(replaced(wet(GetParam()), "fixed_point = true", "fixed_point = false"));
    const Told driver = hosts.in_driver(80), lammps = hosts.in_lammps(2, 2);
    ASSERT_EQ(driver.rows.size(), 81u);
    ASSERT_GT(lammps.rows.size(), 81u);
    const double tolerance = GetParam().ends_with(implicit) ? 1e-5 : 1e-9;
    const std::span<const grit::mpm::HistoryColumn> columns = grit::mpm::history_columns();
    ASSERT_EQ(driver.rows[0].size(), columns.size());
    // Of a column, or of all energies: the residual is what they leave.
    const auto size_of = [&](std::size_t c) {
        double size = 0.0;
        for (const auto& row : driver.rows)
            if (std::isfinite(row[c])) size = std::max(size, std::abs(row[c]));
        return size;
    };
    double energies = 0.0;
    for (std::size_t c = 0; c < columns.size(); ++c)
        if (std::string_view(columns[c].unit) == "J") energies = std::max(energies, size_of(c));
    bool any = false;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const std::string_view name = columns[c].name, unit = columns[c].unit;
        const double size = unit == "J" ? energies : name == "residual_share" ? 1.0 : size_of(c);
        for (std::size_t i = 0; i <= 80; ++i) {
            const double here = driver.rows[i][c], there = lammps.rows[i][c];
            if (std::isnan(here) && std::isnan(there)) continue;
            EXPECT_NEAR(there, here, tolerance * size) << "row " << i << ", column " << c + 1;
            any = any || here != there;
        }
    }
    EXPECT_TRUE(any) << "four processes have the bits of one: were there four?";
}

// A points file may leave the pressure to the water table.
TEST(LammpsWaterTable, GivesPressuresThatTheFileOfPointsDoesNotHave) {
    const BothHosts hosts(wet(flow));
    std::istringstream lines(hosts.folder.read("both_soil.points"));
    std::string without, line;
    while (std::getline(lines, line)) {
        for (int words = 0; words < 4; ++words) line.erase(line.rfind(' '));  // p_w w_r w_z m_w
        without += line + '\n';
    }
    EXPECT_EQ(without.find("p_w"), std::string::npos);
    hosts.folder.write("both_soil.points", without);
    const std::string fix = hosts.folder.read("both.fix");
    hosts.folder.write("both.fix", replaced(fix, "water soil flow", "water soil flow table -0.3"));
    const Answer low = hosts.lammps(1, hosts.script());
    EXPECT_TRUE(low.status != 0 && low.says("the table of water soil must not lie below the body"))
        << low.text;
    hosts.folder.write("both.fix", replaced(fix, "water soil flow", "water soil flow table 0"));
    EXPECT_EQ(first_difference(hosts.in_driver(all), hosts.in_lammps(2, 1)), "");
}

class LammpsWaterRefuses : public ::testing::Test {
  protected:
    void expect(const std::string& words, const std::string& other, const std::string& why) const {
        const std::string fix = hosts.folder.read("both.fix");
        hosts.folder.write("both.fix", replaced(fix, words, other));
        const Answer answer = hosts.lammps(1, hosts.script());
        hosts.folder.write("both.fix", fix);
        EXPECT_NE(answer.status, 0);
        EXPECT_TRUE(answer.says("ERROR: Illegal fix grit/mpm command: " + why)) << answer.text;
    }
    const BothHosts hosts{wet(flow)};
};

TEST_F(LammpsWaterRefuses, WhatTheDriverRefuses) {
    expect("water soil flow", "water soil flow porosity 0.4",
           "water soil: porosity: sand has a void ratio instead");
    expect("conductivity 0.001", "", "water soil: conductivity is missing");
    expect("water soil flow", "water soil undrained",
           "water soil: conductivity belongs to drainage");
    expect("conductivity 0.001", "conductivity -0.001", "conductivity must be > 0, got -0.001");
    expect("water soil flow", "water soil flows",
           "the drainage of a body must be one of undrained, flow, got \"flows\"");
    expect("scheme usl", "scheme musl", "water soil: pore water needs the scheme usl");
    expect("points soil", "water soil undrained points soil", "water soil: it has water already");
    expect("driven pile", "body other type 1 rigid water other undrained driven pile",
           "water other: a rigid body has no pores");
}

}  // namespace
