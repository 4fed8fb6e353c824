// SPDX-License-Identifier: BSD-3-Clause
// V3
#include <gtest/gtest.h>

#include "support/manufactured.hpp"

namespace {

using namespace mpm_test;

Settings with(Shape shape) {
    Settings settings;
    settings.shape = shape;
    settings.cfl = 0.2;
    return settings;
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

TEST(ManufacturedSolution, IsMetWithSecondOrderUpToTheAxis) {
    const auto at_16 = Manufactured::run(16, with(Shape::cpdi));
    const auto at_32 = Manufactured::run(32, with(Shape::cpdi));
    const auto at_64 = Manufactured::run(64, with(Shape::cpdi));
    EXPECT_LT(at_32.rms, 6e-4);
    EXPECT_GT(order(at_16.rms, at_32.rms), 1.8);
    EXPECT_GT(order(at_32.rms, at_64.rms), 1.8);
    EXPECT_GT(order(at_32.axis, at_64.axis), 1.8);
    EXPECT_LT(at_64.axis, 1.8e-4);
}

TEST(ManufacturedSolution, IsMetByMuslAsWell) {
    Settings settings = with(Shape::cpdi);
    settings.scheme = Scheme::musl;
    const auto at_16 = Manufactured::run(16, settings), at_32 = Manufactured::run(32, settings);
    EXPECT_GT(order(at_16.rms, at_32.rms), 1.8);
    EXPECT_LT(at_32.rms, 6e-4);
}

// What the domains buy: particles that cross cells spoil the original method as the grid is refined.
TEST(ManufacturedSolution, IsLostByTheOriginalPointsAsTheGridIsRefined) {
    const auto at_16 = Manufactured::run(16, with(Shape::point));
    const auto at_32 = Manufactured::run(32, with(Shape::point));
    EXPECT_GT(at_32.rms, at_16.rms);
    EXPECT_LT(Manufactured::run(16, with(Shape::ugimp)).rms, 2e-3);
}

}  // namespace
