// SPDX-License-Identifier: BSD-3-Clause
// The policy outside the model's domain: docs/adr/0002-low-stress.md.
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/update.hpp"

using namespace tests;

namespace {

Point stress_free(const Sand& sand) {
    const VoidRatios limits = void_ratios(sand, 0.0);
    State x;
    x.e = 0.5 * (limits.e_d + limits.e_c);
    return point_of(x);
}

double pressure(const Point& x) { return -(x.stress[0] + x.stress[1] + x.stress[2]) / 3.0; }
bool has_no_stress(const Point& x) {
    return std::all_of(x.stress, x.stress + 6, [](double s) { return s == 0.0; });
}

Outcome strain_isotropically(const Sand& sand, Point& x, double volumetric) {
    const double d[6] = {volumetric / 3, volumetric / 3, volumetric / 3, 0, 0, 0};
    return update(sand, x, d, options_with(1e-7));
}

// Work done on the sand per step, trapezoidal; where stress jumps to or from zero within the step the
// rule cannot see where: slack collects what it may have missed.
struct Work {
    double done = 0.0, slack = 0.0;
    void add(const Point& before, const Point& after, const double d[6]) {
        double step = 0.0;
        for (int c = 0; c < 6; ++c) step += 0.5 * (before.stress[c] + after.stress[c]) * d[c];
        done += step;
        if (has_no_stress(before) != has_no_stress(after)) slack += std::fabs(step);
    }
};

}  // namespace

TEST(LowStress, CompressionFromNothingBuildsStressAtOnce) {
    for (const Sand& sand : four_sands()) {
        Point x = stress_free(sand);
        const Outcome first = strain_isotropically(sand, x, -1e-4);
        EXPECT_EQ(first.status, GRIT_OK);
        EXPECT_EQ(first.report.flags & GRIT_SAND_STRESS_FREE, 0);
        EXPECT_GT(pressure(x), 0.0);
    }
}

TEST(LowStress, ExtensionOpensAndStressReturnsOnlyAfterTheSameCompression) {
    for (const Sand& sand : four_sands()) {
        Point x = stress_free(sand);
        strain_isotropically(sand, x, 1e-2);
        EXPECT_TRUE(has_no_stress(x));
        EXPECT_NEAR(x.state[GRIT_SAND_SEPARATION], 1e-2, 1e-15);
        const Outcome almost = strain_isotropically(sand, x, -0.99e-2);
        EXPECT_TRUE(has_no_stress(x));
        EXPECT_TRUE(almost.report.flags & GRIT_SAND_STRESS_FREE);
        EXPECT_NEAR(x.state[GRIT_SAND_SEPARATION], 1e-4, 1e-14);
        const Outcome closed = strain_isotropically(sand, x, -2e-4);
        EXPECT_EQ(closed.report.flags & GRIT_SAND_STRESS_FREE, 0);
        EXPECT_GT(pressure(x), 0.0);
        EXPECT_EQ(x.state[GRIT_SAND_SEPARATION], 0.0);
    }
}

TEST(LowStress, ClosingInOneStepOrInManyGivesTheSameStress) {
    for (const Sand& sand : four_sands()) {
        Point once = stress_free(sand);
        strain_isotropically(sand, once, 1e-3);
        Point often = once;
        strain_isotropically(sand, once, -4e-3);
        for (int i = 0; i < 40; ++i) strain_isotropically(sand, often, -1e-4);
        EXPECT_NEAR(pressure(often) / pressure(once), 1.0, 41 * 1e-7) << sand.name;
        EXPECT_NEAR(often.state[GRIT_SAND_VOID_RATIO], once.state[GRIT_SAND_VOID_RATIO], 1e-12);
    }
}

TEST(LowStress, ExtensionFromStressSeparatesAndRemembersWhatWasOpenedSince) {
    for (const Sand& sand : four_sands()) {
        Point x = stress_free(sand);
        strain_isotropically(sand, x, -1e-2);
        const double e_loaded = x.state[GRIT_SAND_VOID_RATIO];
        EXPECT_GT(pressure(x), 1e-7 * sand.p.granulate_hardness);
        const Outcome apart = strain_isotropically(sand, x, 5e-2);
        EXPECT_TRUE(apart.report.flags & GRIT_SAND_STRESS_FREE);
        EXPECT_TRUE(has_no_stress(x));
        EXPECT_GT(x.state[GRIT_SAND_SEPARATION],
                  4e-2);  // unloading is stiff: most of it is opening
        EXPECT_LT(x.state[GRIT_SAND_SEPARATION], 5e-2);
        EXPECT_NEAR(x.state[GRIT_SAND_VOID_RATIO], (1 + e_loaded) * std::exp(5e-2) - 1, 1e-14);
        const double opened = x.state[GRIT_SAND_SEPARATION];
        strain_isotropically(sand, x, -opened * (1 - 1e-9));
        EXPECT_TRUE(has_no_stress(x));
        strain_isotropically(sand, x, -1e-5);
        EXPECT_GT(pressure(x), 0.0);
    }
}

TEST(LowStress, ShearingAtConstantVolumeBuildsNoStressFromNothing) {
    const Sand& sand = four_sands()[0];
    Point x = stress_free(sand);
    const double shear[6] = {1e-3, -1e-3, 0, 2e-3, 0, 0};
    EXPECT_EQ(update(sand, x, shear).status, GRIT_OK);
    EXPECT_TRUE(has_no_stress(x));
}

TEST(LowStress, TensionInTheInputIsReleasedNotRefused) {
    for (const Sand& sand : four_sands()) {
        Point x = stress_free(sand);
        for (int c = 0; c < 3; ++c) x.stress[c] = 50.0;
        const Outcome out = strain_isotropically(sand, x, 1e-6);
        EXPECT_EQ(out.status, GRIT_OK);
        EXPECT_TRUE(has_no_stress(x));
    }
}

TEST(LowStress, StressFreePointsReportAFiniteStiffness) {
    for (const Sand& sand : four_sands())
        for (const double increment : {0.0, 1e-5, -1e-5}) {
            Point x = stress_free(sand);
            const double d[6] = {increment, 0, 0, 0, 0, 0};
            const Outcome out = update(sand, x, d, options_with(1e-5, GRIT_TANGENT_CONSISTENT));
            for (const int diagonal : {0, 7, 14, 21, 28, 35}) EXPECT_GT(out.tangent[diagonal], 0.0);
        }
}

TEST(LowStress, PressuresWellAboveTheFloorAreNotTouchedByIt) {
    for (const Sand& sand : four_sands()) {
        State x;
        const double p = 1e-6 * sand.p.granulate_hardness;  // 100 times the floor
        for (int c = 0; c < 3; ++c) x.T[c] = -p;
        x.e = void_ratios(sand, p).e_c;
        Random random(5);
        const Vec dE = 1e-9 * random.direction();
        const State y = updated(sand, x, dE, options_with(1e-12));
        const Vec expected = x.T + rate(sand, x, dE).T;
        EXPECT_LT((y.T - expected).norm(), 1e-4 * (expected - x.T).norm());
    }
}

TEST(LowStress, DeviatorOutsideTheConeIsScaledBackAndFlagged) {
    const Sand& sand = four_sands()[0];
    State x;
    x.T << 10, 10, -320, 0, 0, 0;  // tan psi = 1.56
    x.e = 0.7;
    Point point = point_of(x);
    const double d[6] = {-1e-9, 0, 0, 0, 0, 0};
    const Outcome out = update(sand, point, d);
    EXPECT_EQ(out.status, GRIT_OK);
    EXPECT_TRUE(out.report.flags & GRIT_SAND_OUTSIDE_CONE);
    grit_sand_invariants i{};
    i.struct_size = sizeof i;
    grit_sand_invariants_of(sand, point.stress, point.state, &i);
    EXPECT_LT(i.tan_psi, std::sqrt(2.0));
    EXPECT_NEAR(pressure(point), 100.0, 1e-2);
}

TEST(LowStress, ClosedStrainCyclesFromNothingNeverGiveEnergy) {
    Random random(99);
    int separated = 0, loaded = 0;
    for (int cycle = 0; cycle < 600; ++cycle) {
        const Sand& sand = four_sands()[cycle % 4];
        const VoidRatios limits = void_ratios(sand, 0.0);
        State x;
        x.e = random.uniform(limits.e_d, limits.e_i);
        Point point = point_of(x);
        const double amplitude = random.log_uniform(1e-6, 3e-2);
        const int corners = 1 + cycle % 5, steps = 60;
        Vec at = Vec::Zero();
        Work work;
        double largest = 0.0;
        for (int leg = 0; leg <= corners; ++leg) {
            Vec to = Vec::Zero();
            if (leg < corners) {
                to = amplitude * random.uniform() * random.direction();
                if (random.uniform() < 0.5)
                    for (int c = 0; c < 3; ++c) to[c] -= 0.5 * amplitude;
            }
            const auto d = voigt_strain(Vec((to - at) / steps));
            for (int i = 0; i < steps; ++i) {
                const Point before = point;
                ASSERT_EQ(update(sand, point, d.data(), options_with(1e-6)).status, GRIT_OK);
                work.add(before, point, d.data());
                separated += has_no_stress(point);
                loaded += !has_no_stress(point);
                largest = std::max(largest, pressure(point));
            }
            at = to;
        }
        EXPECT_GE(work.done, -work.slack - 1e-12 * largest * amplitude)
            << sand.name << " cycle " << cycle << " amplitude " << amplitude;
    }
    EXPECT_GT(separated, 1000);  // the cycles do both
    EXPECT_GT(loaded, 1000);
}
