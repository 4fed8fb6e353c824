// SPDX-License-Identifier: BSD-3-Clause
// What a sand would show in a test, and how that changes with its parameters.
#include <gtest/gtest.h>

#include "element/calibration/problem.hpp"
#include "samples.hpp"

namespace {

using namespace calibration;

ParameterSpace space_of(const std::vector<std::string>& symbols) {
    ParameterSpace out;
    out.base = lausitz();
    for (const std::string& each : symbols) {
        const int index = parameter_index(each);
        out.free.push_back({index, 0.3 * get(out.base, index), 3.0 * get(out.base, index)});
    }
    return out;
}

// Slopes by the coordinates against central differences.
void expect_slopes(const ParameterSpace& space, Experiment test) {
    test.options.tolerance = 1e-9;
    measure(test, lausitz(), 0.01);
    const Problem problem(space, {test}, {{0, 0.55, 0.01}}, 1);
    const Vector x = space.coordinates(space.base);
    const auto at = problem.residuals(x, true);
    ASSERT_TRUE(at);
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        const double step = 1e-4 * std::fabs(x[k]);
        Vector low = x, high = x;
        low[k] -= step;
        high[k] += step;
        const Vector slope =
            (problem.residuals(high, false)->values - problem.residuals(low, false)->values) /
            (2.0 * step);
        EXPECT_LT((slope - at->slopes.col(k)).norm(), 1e-4 * slope.norm() + 1e-9)
            << space.free[static_cast<std::size_t>(k)].index;
    }
}

const std::vector<std::string> all = {"phi_c", "h_s", "n", "e_d0", "e_c0", "e_i0", "alpha", "beta"};

TEST(Slopes, OfATriaxialTestAreItsDifferences) { expect_slopes(space_of(all), triaxial(100, 0.6)); }

TEST(Slopes, OfASampleAtRestFollowTheEarthPressure) {
    expect_slopes(space_of(all), oedometer(0.7));
}

TEST(Slopes, OfAVoidRatioAtZeroPressureFollowTheCompression) {
    expect_slopes(space_of(all), oedometer(0.72, true));
}

TEST(Slopes, OfATiedParameterArePartOfTheOther) {
    ParameterSpace space = space_of({"phi_c", "h_s", "e_c0"});
    const int e_i0 = parameter_index("e_i0"), e_c0 = parameter_index("e_c0");
    space.ties = {{e_i0, e_c0, 1.2}};
    set(space.base, e_i0, 1.2 * get(space.base, e_c0));
    expect_slopes(space, oedometer(0.7));
}

TEST(Experiments, ThatCannotStartAreAFailureAndNoCrash) {
    EXPECT_NE(predict(triaxial(100, 1.5), lausitz()).failure, "");
    grit_sand_parameters none = lausitz();
    none.critical_void_ratio = 0.1;
    EXPECT_NE(predict(triaxial(100, 0.6), none).failure, "");
}

// (1 + u u')^-1 of the residuals' covariance: r' W^2 r = r' r - (u' r)^2/(1 + u' u).
TEST(Weights, OfAnUncertainVoidRatioAreThoseOfItsCovariance) {
    Experiment test = oedometer(0.7);
    measure(test, lausitz(), 0.01);
    for (Reading& each : test.readings) each.value += 0.004 * each.row;
    test.void_ratio_error = 0.01;
    const ParameterSpace space = space_of({"h_s"});
    Problem problem(space, {test}, {}, 1);
    const Vector x = space.coordinates(space.base);
    const Vector r = problem.residuals(x, false)->values;
    const Prediction by_e = predict(test, lausitz(), {element::by_void_ratio});
    Vector u(r.size());
    for (Eigen::Index i = 0; i < u.size(); ++i)
        u[i] = 0.01 * by_e.slopes(i, 0) / test.readings[static_cast<std::size_t>(i)].error;
    ASSERT_TRUE(problem.weigh_starts(x));
    EXPECT_NEAR(problem.residuals(x, false)->values.squaredNorm(),
                r.squaredNorm() - std::pow(u.dot(r), 2) / (1.0 + u.squaredNorm()),
                1e-9 * r.squaredNorm());
}

TEST(Sums, AreDroppedAsSoonAsTheyExceedTheirLimit) {
    Experiment test = oedometer(0.7);
    measure(test, lausitz(), 0.01);
    for (Reading& each : test.readings) each.value *= 1.02;
    const ParameterSpace space = space_of({"h_s"});
    const Problem problem(space, {test}, {}, 1);
    const Vector x = space.coordinates(space.base);
    const auto square = [](double r2) { return r2; };
    const double sum = problem.residuals(x, false)->values.squaredNorm();
    EXPECT_DOUBLE_EQ(problem.sum(x, 1e9, square).value(), sum);
    EXPECT_FALSE(problem.sum(x, 0.5 * sum, square));
}

}  // namespace
