// SPDX-License-Identifier: BSD-3-Clause
// Increments between the rows of a sheet.
#include "cli/calibrate/followed_steps.hpp"

#include <gtest/gtest.h>

namespace {

using namespace cli;

// Machines that turn give the row at the turn twice: what comes after it is as fine as without.
TEST(FollowedSteps, AreFinestAfterATurnThoughItsRowIsRepeated) {
    for (const LaboratoryTest& test : laboratory_tests())
        for (const Way& way : test.ways) {
            const double turn = way.strain() ? -0.01 : -200.0, back = 0.8 * turn;
            const Followed once = follow(way, {0.0, turn, back}, 1.0);
            const Followed twice = follow(way, {0.0, turn, turn, turn, back}, 1.0);
            const auto of_last = [](const Followed& steps) {
                return steps.increments.back() - steps.increments[steps.increments.size() - 2];
            };
            EXPECT_EQ(of_last(twice), of_last(once)) << test.name << " " << way.key;
            EXPECT_GT(of_last(once), 1);
        }
}

}  // namespace
