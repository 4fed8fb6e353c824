// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/hertz.hpp"

namespace {

using namespace mpm_test;

void is_that_of_hertz(const Hertz& hertz) {
    const Hertz::Result result = hertz.run();
    EXPECT_GT(result.radius, 10.0 * Hertz::a / hertz.cells);
    EXPECT_NEAR(result.radius_error, 0.0, 0.03);
    EXPECT_NEAR(result.pressure_error, 0.0, 0.03);
    EXPECT_NEAR(result.sum_error, 0.0, 0.005);
}

TEST(PressedParaboloid, HasThePressureOfHertzByGeoContactOnAGridLine) {
    is_that_of_hertz({.cells = 11, .kind = ContactKind::geo});
}

TEST(PressedParaboloid, HasThePressureOfHertzByFrictionalContactBetweenGridLines) {
    is_that_of_hertz({.cells = 11, .beyond = 0.5, .kind = ContactKind::frictional});
}

// Where points that nearly touch do not count, p0 is 18 % too high on the line.
TEST(PressedParaboloid, HasThePressureOfHertzBySurfaceContactOnAGridLineAndBetween) {
    for (const double beyond : {0.0, 0.25, 0.5})
        is_that_of_hertz({.cells = 11, .beyond = beyond, .kind = ContactKind::surface});
}

// Two cells apart the radius is off by 2.7 %.
TEST(PressedParaboloid, HasThePressureOfHertzWithSevenCellsAndPressuresACellApart) {
    const Hertz::Result result =
        Hertz{.cells = 7, .beyond = 0.75, .kind = ContactKind::surface_1}.run();
    EXPECT_NEAR(result.pressure_error, 0.0, 0.028);
    EXPECT_NEAR(result.radius_error, 0.0, 0.02);
}

}  // namespace
