// SPDX-License-Identifier: BSD-3-Clause
// What a step leaves apart from particles, for hosts that store it in their own files.
#include <gtest/gtest.h>

#include <algorithm>

#include <adapters/mpm/io/grid_state.hpp>

#include "support/pressed_sand.hpp"

namespace {

using namespace mpm_test;

TEST(GridState, IsTakenByASimulationOfTheSameCase) {
    const PressedSand made;
    const auto one = made.build(), other = made.build();
    for (int i = 0; i < 60; ++i) one->step();
    const std::vector<std::uint64_t> nodes = GridState::nodes(*one);
    const std::string common = GridState::common(*one);
    ASSERT_NE(GridState::nodes(*other), nodes);
    ASSERT_NE(GridState::common(*other), common);
    GridState::take_common(*other, common);
    GridState::take_nodes(*other, nodes);
    EXPECT_EQ(GridState::nodes(*other), nodes);
    EXPECT_EQ(GridState::common(*other), common);
    EXPECT_EQ(other->time(), one->time());
}

// A node that pressed stays closed, so what pressed must be known.
TEST(GridState, KnowsWhichNodesPressed) {
    const PressedSand made;
    const auto one = made.build(), other = made.build();
    const auto pressed = [](Simulation& simulation) {
        const std::size_t each = GridState::words_per_node(simulation);
        const std::vector<std::uint64_t> words = GridState::nodes(simulation);
        std::vector<std::uint64_t> out;
        for (std::size_t i = each - 1; i < words.size(); i += each) out.push_back(words[i]);
        return out;
    };
    for (int i = 0; i < 60; ++i) one->step();
    const std::vector<std::uint64_t> wanted = pressed(*one);
    ASSERT_GT(std::count(wanted.begin(), wanted.end(), 1u), 0);
    GridState::take_nodes(*other, GridState::nodes(*one));
    EXPECT_EQ(pressed(*other), wanted);
}

TEST(GridState, ShowsTheContactForcesOfTheLastStep) {
    const PressedSand made;
    const auto one = made.build(), other = made.build();
    for (int i = 0; i < 60; ++i) one->step();
    GridState::take_common(*other, GridState::common(*one));
    const ContactPair::Measured &wanted = one->contact(0).faces(), &now = other->contact(0).faces();
    EXPECT_NE(wanted.along_z[1], 0.0);
    EXPECT_EQ(now.along_z[1], wanted.along_z[1]);
    EXPECT_EQ(now.along_r[1], wanted.along_r[1]);
    EXPECT_EQ(now.largest_gap, wanted.largest_gap);
    EXPECT_EQ(other->contact(0).totals().force_on_a[1], one->contact(0).totals().force_on_a[1]);
}

TEST(GridState, ShowsTheForcesAtSurfacesOfTheLastStep) {
    PressedSand made;
    made.at_surfaces = true;
    const auto one = made.build(), other = made.build();
    for (int i = 0; i < 60; ++i) one->step();
    GridState::take_common(*other, GridState::common(*one));
    const SurfacePair &wanted = one->surface_contact(0), &now = other->surface_contact(0);
    EXPECT_LT(wanted.faces().along_z[1], 0.0);  // on the sand below
    EXPECT_EQ(now.faces().along_z[1], wanted.faces().along_z[1]);
    EXPECT_EQ(now.faces().along_r[1], wanted.faces().along_r[1]);
    EXPECT_EQ(now.totals().impulse_on_a[1], wanted.totals().impulse_on_a[1]);
}

TEST(GridState, OfAnotherCaseIsRefused) {
    PressedSand made;
    const auto one = made.build();
    made.ring = false;
    const auto other = made.build();
    EXPECT_THROW(GridState::take_common(*other, GridState::common(*one)), std::runtime_error);
    EXPECT_THROW(GridState::take_nodes(*other, GridState::nodes(*one)), std::runtime_error);
}

}  // namespace
