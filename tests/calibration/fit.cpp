// SPDX-License-Identifier: BSD-3-Clause
// Fits whose answer is known.
#include <gtest/gtest.h>

#include "cli/calibrate/advice.hpp"
#include "element/calibration/ensemble.hpp"
#include "element/calibration/fit.hpp"
#include "samples.hpp"

namespace {

using namespace calibration;

ParameterSpace hardness_and_exponent() {
    ParameterSpace out;
    out.base = lausitz();
    for (const char* each : {"h_s", "n"}) {
        const int index = parameter_index(each);
        out.free.push_back({index, 0.2 * get(out.base, index), 5.0 * get(out.base, index)});
    }
    return out;
}

Experiment noisy(double error, std::uint64_t seed) {
    Experiment out = oedometer(0.75);
    measure(out, lausitz(), error);
    for (std::size_t i = 0; i < out.readings.size(); ++i)  // of both signs, the same everywhere
        out.readings[i].value += out.readings[i].error * std::sin(3.7 * double(i) + double(seed));
    return out;
}

TEST(Fit, FindsWhatTheTestWasMadeWith) {
    Experiment test = oedometer(0.75);
    measure(test, lausitz(), 0.001);
    const ParameterSpace space = hardness_and_exponent();
    Problem problem(space, {test}, {}, 1);
    const Vector truth = space.coordinates(space.base);
    const Fit found = fit(problem, start_around(space, truth, 0.3, 3), {});
    for (int i : {1, 2}) EXPECT_NEAR(get(space.at(found.x), i) / get(space.base, i), 1.0, 1e-6);
}

TEST(Fit, WithARobustLossMindsOneWildReadingLess) {
    Experiment test = noisy(0.001, 1);
    test.readings[4].value += 30.0 * test.readings[4].error;
    const ParameterSpace space = hardness_and_exponent();
    const Vector truth = space.coordinates(space.base);
    double distance[2] = {};
    int k = 0;
    for (const char* word : {"squares", "cauchy"}) {
        Problem problem(space, {test}, {}, 1);
        FitOptions options;
        options.loss = Loss(word, 2.0);
        options.starts = 1;
        distance[k++] = (fit(problem, truth, options).x - truth).norm();
    }
    EXPECT_LT(distance[1], 0.3 * distance[0]);
}

TEST(Fit, HoldsParametersWithinTheirBounds) {
    Experiment test = noisy(0.001, 1);
    ParameterSpace space = hardness_and_exponent();
    space.free[1].lowest = 1.3 * get(space.base, 2);
    space.free[1].highest = 2.0 * get(space.base, 2);
    Vector start = space.coordinates(space.base);
    start[1] = space.free[1].coordinate(1.5 * get(space.base, 2));
    Problem problem(space, {test}, {}, 1);
    EXPECT_NEAR(fit(problem, start, {}).x[1], space.free[1].lowest, 1e-9);
}

TEST(Identifiability, TellsWhatOneCurveDoesNotDetermine) {
    Experiment test = noisy(0.002, 2);
    ParameterSpace space = hardness_and_exponent();
    const int alpha = parameter_index("alpha");
    space.free.push_back({alpha, 0.01, 1.0});
    Problem problem(space, {test}, {}, 1);
    const auto at = problem.residuals(space.coordinates(space.base), true);
    const Laplace found = laplace(problem, *at, false);
    EXPECT_FALSE(found.determines(2));
    bool told = false;
    for (const std::string& each : cli::advice(space, found))
        told = told || (each.find("do not determine") != std::string::npos &&
                        each.find("alpha") != std::string::npos &&
                        each.find("beyond its peak") != std::string::npos);
    EXPECT_TRUE(told);
}

// A nearly linear problem: samples have the spread of the normal distribution, with delayed acceptance and without
// anybody's threads in it.
TEST(Ensemble, OfANearlyLinearProblemHasItsSpread) {
    Experiment test = noisy(0.0005, 3);
    test.options.tolerance = 1e-4;
    const ParameterSpace space = hardness_and_exponent();
    SampleOptions options;
    options.samples = 6000;
    Matrix samples[2];
    for (const int threads : {1, 2}) {
        Problem problem(space, {test}, {}, threads);
        const Fit best = fit(problem, space.coordinates(space.base), {});
        const Laplace around = laplace(problem, best.residuals, false);
        const Posterior found = sample(problem, best.x, around, options);
        samples[threads - 1] = found.samples;
        const Vector mean = found.mean();
        const Matrix centred = found.samples.rowwise() - mean.transpose();
        const Matrix covariance =
            centred.transpose() * centred / static_cast<double>(found.samples.rows());
        for (int k = 0; k < 2; ++k) {
            EXPECT_NEAR(mean[k], best.x[k], 0.3 * around.deviation[k]);
            EXPECT_NEAR(std::sqrt(covariance(k, k)) / around.deviation[k], 1.0, 0.15);
            EXPECT_LT(found.r_hat[k], 1.05);
            EXPECT_GT(found.effective[k], 150.0);
        }
        EXPECT_NEAR(found.correlation()(0, 1), around.correlation(0, 1), 0.05);
    }
    EXPECT_TRUE(samples[0] == samples[1]);
}

// Also while it computes what it will leave out.
TEST(Ensemble, EndsWithoutSamplesWhenItIsAskedTo) {
    const ParameterSpace space = hardness_and_exponent();
    Problem problem(space, {noisy(0.0005, 3)}, {}, 1);
    const Fit best = fit(problem, space.coordinates(space.base), {});
    const Laplace around = laplace(problem, best.residuals, false);
    for (const int steps : {1, 40}) {
        SampleOptions options;
        options.samples = 6000;
        options.burn_in = 0.5;
        int left = steps;
        options.progress = [&left](long done, long all) {
            EXPECT_LE(done, all);
            return --left > 0;
        };
        const Posterior found = sample(problem, best.x, around, options);
        EXPECT_TRUE(found.stopped);
        EXPECT_EQ(found.samples.rows(), 0);
        EXPECT_EQ(left, 0);
    }
}

}  // namespace
