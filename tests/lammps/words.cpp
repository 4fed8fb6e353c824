// SPDX-License-Identifier: BSD-3-Clause
// What else a case says comes through to LAMMPS.
#include <gtest/gtest.h>

#include <string>

#include <cli/process/exit_code.hpp>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

const char* const plate = R"(
[[body]]
name = "plate"
[[body.box]]
r_m = [1, 16]
z_m = [12, 13]
[body.rigid]
from_stage = "press"
time_s = [0, 0.2, 0.4]
velocity_r_m_per_s = [0, 0.3, 0.1]
velocity_z_m_per_s = [0, -2, -1]
[[traction]]
body = "block"
edge = "right"
z_m = [5, 9]
from_stage = "press"
[traction.pulses]
peak_kPa = 3
form = "triangle"
duration_s = 0.3
peak_time_s = 0.1
interval_s = 0.35
count = 2
start_s = 0.05
[[contact]]
stiff = "plate"
soft = "block"
law = "geo"
penalty_power = 4
friction_coefficient = 0.2
normal = "soft"
distance = "edge"
gated = false
[[stage]]
name = "press"
local_damping = 0.1
pic_rate_per_s = 3
cfl = 0.3
gravity = false
[stage.until]
time_s = 1.2
depth_m = 3
)";

// A rigid plate presses a soft block onto the floor, across four sub-domains, by another scheme.
TEST(LammpsWords, RigidMotionTablesPulsesAndSchemesComeThrough) {
    std::string text = block_case("0.2, 0", "0.3", plate);
    text = replaced(text, "gravity_m_per_s2 = 0.0", "gravity_m_per_s2 = 0.5");
    text = replaced(text, "fixed_point = true",
                    "fixed_point = true\nscheme = \"musl\"\nlargest_step_s = 0.02\n"
                    "bulk_viscosity_linear = 0.1\nbulk_viscosity_quadratic = 1\n"
                    "local_damping = 0.2\n[boundary]\nbottom = \"fixed\"\nright = \"roller\"");
    text = replaced(text, "[body.elastic]", "[body.neo_hooke]");
    text = replaced(text, "kPa = 20", "kPa = 200");
    text = replaced(text, "[2, 6]", "[2, 15]");
    text = replaced(text, "[3, 6]", "[0, 11.9]");
    const BothHosts hosts(text);
    const Told driver = hosts.in_driver(1000000);
    EXPECT_EQ(driver.rows.back()[0], 2.0);   // the second stage
    EXPECT_NE(driver.rows.back()[13], 0.0);  // rigid work: they do touch
    EXPECT_NE(driver.rows.back()[16], 0.0);  // bulk viscosity
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 2)), "");
}

// Thermo output has no row for the last step of a stage but by chance.
TEST(LammpsWords, TheScriptTellsTheLastDepthOfAStage) {
    const BothHosts hosts(block_case("2, -1", "0.5"));
    const Answer answer = hosts.lammps(2, hosts.script());
    const std::string words = "\nstage flight: depth ";
    ASSERT_TRUE(answer.says(words)) << answer.text;
    const double depth = std::stod(answer.text.substr(answer.text.find(words) + words.size()));
    constexpr std::size_t column = 4;
    EXPECT_EQ(depth, hosts.in_driver(1000000).rows.back()[column]);
}

TEST(LammpsWords, BodiesMayBeGroups) {
    const BothHosts hosts(block_case("2, 1", "0.5"));
    const std::string fix = hosts.folder.read("both.fix");
    hosts.folder.write("both.fix", "group some id 1:48\n" +
                                       replaced(fix, "body block type 1", "body block group some"));
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), hosts.in_lammps(2, 1)), "");
}

TEST(LammpsWords, WhatLammpsDoesNotHaveIsRefusedBeforeAnyFileIsWritten) {
    const std::string block = block_case("2, 1", "0.5");
    EXPECT_THROW(BothHosts(replaced(block, "[[body]]",
                                    "[boundary]\nleft = \"absorbing\"\np_wave_m_per_s = 3\n"
                                    "s_wave_m_per_s = 2\n[[body]]")),
                 cli::BadInput);
}

}  // namespace
