// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

// Residuals of the increments of a step after the first, printed.
std::vector<std::vector<double>> residuals_of(const char* title, const Step& step,
                                              double law_tolerance) {
    const GritLaw law = lausitz_law(law_tolerance);
    Sample sample = isotropic_sample(law, 100.0, 0.6);
    Settings settings;
    settings.tolerance = 1e-12;
    settings.keep_residuals = true;
    const History history = simulate(law, sample, {step}, settings);
    EXPECT_FALSE(history.failure) << history.failure->message;
    std::vector<std::vector<double>> out;
    std::printf("%s, tolerance of the law %.0e\n", title, law_tolerance);
    for (const Record& record : history.records) {
        if (record.increment == 0) continue;
        std::printf("  increment %2d:", record.increment);
        for (const double r : record.residuals) std::printf(" %.1e", r);
        std::printf("\n");
        out.push_back(record.residuals);
    }
    return out;
}

// r_{k+1} <= C r_k^2 with one C until roundoff, and few iterations.
void expect_quadratic(const std::vector<std::vector<double>>& increments, double C) {
    for (const auto& r : increments) {
        EXPECT_LE(r.size(), 7u);
        EXPECT_LE(r.back(), 1e-12);
        for (std::size_t k = 0; k + 1 < r.size(); ++k) {
            if (r[k] > 1e-2) continue;
            EXPECT_LE(r[k + 1], std::max(C * r[k] * r[k], 1e-12)) << r[k];
        }
    }
}

Step large(Step step) {
    step.increments = 8;
    return step;
}

TEST(Newton, ConvergesQuadraticallyUnderMixedControl) {
    expect_quadratic(residuals_of("drained triaxial, 0.25 % per increment",
                                  large(triaxial_drained(-0.02)), 1e-10),
                     100.0);
}

TEST(Newton, ConvergesQuadraticallyUnderStressControlInAllComponents) {
    Vector6 change;
    change << -60.0, -20.0, 0.0, 10.0, -5.0, 8.0;
    Step step = component_control({Control::stress, Control::stress, Control::stress,
                                   Control::stress, Control::stress, Control::stress},
                                  change);
    expect_quadratic(residuals_of("stress alone", large(step), 1e-10), 100.0);
}

TEST(Newton, ConvergesQuadraticallyWithThePorePressureUnknown) {
    expect_quadratic(
        residuals_of("undrained by total stress", large(triaxial_undrained_stress(-60.0)), 1e-10),
        100.0);
}

TEST(Newton, ConvergesToItsToleranceWithTheLawAtItsDefault) {
    for (const auto& r : residuals_of("drained triaxial", large(triaxial_drained(-0.02)), 1e-5))
        EXPECT_LE(r.size(), 8u);
}

TEST(Newton, NeedsFewIterationsAlongADrainedTriaxialTest) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.55);
    Step step = triaxial_drained(-0.20);
    step.increments = 400;
    step.first_share = 1e-4;
    const History history = simulate(law, sample, {step});
    ASSERT_FALSE(history.failure) << history.failure->message;
    long iterations = 0, cut_backs = 0;
    for (const Record& record : history.records) {
        iterations += record.iterations;
        cut_backs += record.cut_backs;
    }
    EXPECT_LE(iterations, 3 * 400);
    EXPECT_EQ(cut_backs, 0);
    EXPECT_NEAR(sample.point.stress[0], -398.912, 1e-4 * 398.912);
}

}  // namespace
