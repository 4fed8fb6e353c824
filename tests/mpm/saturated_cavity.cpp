// SPDX-License-Identifier: BSD-3-Clause
// A cavity in undrained sand, against the balance of forces along the radius.
#include <gtest/gtest.h>

#include "support/undrained_cavity.hpp"

namespace {

using namespace mpm_test;

// The sand's own error is that of a cell's mean strain, where stresses fall by an eighth from cell to cell; with h it gets
// less as fast.
TEST(UndrainedSand, ExpandsACavityWithThePressuresOfTheBalanceAlongTheRadius) {
    CavityErrors of[2];
    CavityByPoints points = undrained_cavity(0.55, 6);
    const UndrainedCavity exact(points, points.bulk_modulus, 100);
    for (const int i : {0, 1}) {
        points.cells = i == 0 ? 6 : 9;
        of[i] = compare(points, exact);
        EXPECT_LT(of[i].wall_most, i == 0 ? 0.03 : 0.015);
        EXPECT_LT(of[i].effective_most, i == 0 ? 0.09 : 0.06);
        EXPECT_LT(of[i].pore_most, i == 0 ? 0.11 : 0.075);
        EXPECT_LT(of[i].innermost.p_w, -3.5e6);
    }
    EXPECT_LT(std::fabs(of[1].effective), 0.7 * std::fabs(of[0].effective));
    EXPECT_LT(std::fabs(of[1].pore), 0.7 * std::fabs(of[0].pore));
}

TEST(UndrainedSand, ExpandsACavityInLooseSandToo) {
    const CavityByPoints points = undrained_cavity(0.75, 6);
    const CavityErrors seen = compare(points, UndrainedCavity(points, points.bulk_modulus, 100));
    EXPECT_LT(seen.wall_most, 0.01);
    EXPECT_LT(seen.effective_most, 0.01);
    EXPECT_LT(seen.pore_most, 0.03);
    EXPECT_GT(seen.innermost.p_w, 3e4);
}

// A wall with an implicit pressure: at the surface, without noise.
TEST(ImplicitPressure, MeetsTheWallOfACavityWithThePressureOfTheBalanceAlongTheRadius) {
    for (const double e : {0.55, 0.75}) {
        CavityByPoints points = undrained_cavity(e, e < 0.6 ? 9 : 6);
        points.implicit = true;
        const CavityErrors seen =
            compare(points, UndrainedCavity(points, points.bulk_modulus, 100));
        EXPECT_LT(seen.wall_most, e < 0.6 ? 0.01 : 0.002);
        EXPECT_LT(seen.effective_most, e < 0.6 ? 0.06 : 0.01);
        EXPECT_LT(seen.pore_most, e < 0.6 ? 0.075 : 0.03);
    }
}

// With contact at nodes the wall meets too much, with either pressure, and the sand has the stresses of the balance.
TEST(ImplicitPressure, LeavesASandItsStressesBesideContactAtNodesAsTheExplicitOne) {
    CavityByPoints points = undrained_cavity(0.75, 6);
    points.kind = ContactKind::geo_ungated;
    const UndrainedCavity exact(points, points.bulk_modulus, 100);
    double wall[2];
    for (const bool implicit : {false, true}) {
        points.implicit = implicit;
        const CavityErrors seen = compare(points, exact);
        wall[implicit ? 1 : 0] = seen.wall_mean;
        EXPECT_NEAR(seen.wall_mean, 0.05, 0.02) << implicit;
        EXPECT_LT(seen.effective_most, 0.03) << implicit;
    }
    EXPECT_NEAR(wall[1], wall[0], 0.02);
}

// By the pressure of that balance, without contact.
TEST(ImplicitPressure, ExpandsACavityAsFarAsTheBalanceAlongTheRadius) {
    CavityByPoints points = undrained_cavity(0.55, 6);
    points.implicit = true;
    const UndrainedCavity exact(points, points.bulk_modulus, 100);
    points.pressure = [&](double t) { return exact.at(CavityProblem::a, t).total; };
    const CavityErrors seen = compare(points, exact);
    EXPECT_LT(seen.wall_most, 0.02);
    EXPECT_LT(seen.effective_most, 0.08);
    EXPECT_LT(seen.pore_most, 0.1);
}

}  // namespace
