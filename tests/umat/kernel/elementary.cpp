// SPDX-License-Identifier: BSD-3-Clause
// exp and log of the kernels: close to std's, and the same bits for scalar and pack.
#define GRIT_TARGET kernel_test
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "support/elementary.hpp"
#include "tests/umat/support/random.hpp"

namespace {

namespace kernel = grit::kernel_test;
using tests::Random;

// Numbers representable between a and b.
std::int64_t ulps_between(double a, double b) {
    return std::abs(std::bit_cast<std::int64_t>(a) - std::bit_cast<std::int64_t>(b));
}

constexpr int samples = 400000;

TEST(Exp, IsWithinTwoUlpsOfTheStandardLibrary) {
    Random random(1);
    std::int64_t worst = 0;
    for (int i = 0; i < samples; ++i) {
        const double x = i % 2 ? random.uniform(-700.0, 700.0)
                               : random.log_uniform(1e-20, 30.0) * (i % 4 ? 1.0 : -1.0);
        worst = std::max(worst, ulps_between(kernel::exp(x), std::exp(x)));
    }
    EXPECT_LE(worst, 2);
    EXPECT_EQ(kernel::exp(0.0), 1.0);
}

TEST(Log, IsWithinTwoUlpsOfTheStandardLibrary) {
    Random random(2);
    std::int64_t worst = 0;
    for (int i = 0; i < samples; ++i) {
        const double x = i % 2 ? random.log_uniform(1e-300, 1e300)
                               : 1.0 + random.log_uniform(1e-15, 1.0) * (i % 4 ? 1.0 : -0.5);
        worst = std::max(worst, ulps_between(kernel::log(x), std::log(x)));
    }
    EXPECT_LE(worst, 2);
    EXPECT_EQ(kernel::log(1.0), 0.0);
}

TEST(Exp, IsClampedWhereNoPathOfTheKernelLeads) {
    EXPECT_EQ(kernel::exp(-1e4), kernel::exp(-700.0));
    EXPECT_EQ(kernel::exp(1e4), kernel::exp(700.0));
    EXPECT_TRUE(std::isfinite(kernel::exp(1e300)));
}

template <int W, class Scalar, class Packed>
int lanes_that_differ(double low, double high, bool logarithmic, Scalar scalar, Packed packed) {
    Random random(3);
    int differ = 0;
    for (int i = 0; i < samples / 10; ++i) {
        kernel::Pack<W> x;
        for (int lane = 0; lane < W; ++lane)
            x.set(lane, logarithmic ? random.log_uniform(low, high) : random.uniform(low, high));
        const kernel::Pack<W> y = packed(x);
        for (int lane = 0; lane < W; ++lane)
            differ += std::bit_cast<std::int64_t>(y[lane]) !=
                      std::bit_cast<std::int64_t>(scalar(x[lane]));
    }
    return differ;
}

template <int W> void expect_scalar_bits() {
    const auto exp_1 = [](double x) { return kernel::exp(x); };
    const auto exp_W = [](kernel::Pack<W> x) { return kernel::exp(x); };
    const auto log_1 = [](double x) { return kernel::log(x); };
    const auto log_W = [](kernel::Pack<W> x) { return kernel::log(x); };
    EXPECT_EQ((lanes_that_differ<W>(-720.0, 720.0, false, exp_1, exp_W)), 0) << W;
    EXPECT_EQ((lanes_that_differ<W>(-1.0, 1.0, false, exp_1, exp_W)), 0) << W;
    EXPECT_EQ((lanes_that_differ<W>(1e-300, 1e300, true, log_1, log_W)), 0) << W;
    EXPECT_EQ((lanes_that_differ<W>(0.5, 2.0, false, log_1, log_W)), 0) << W;
}

TEST(Pack, LanesHaveTheBitsOfTheScalar) {
    expect_scalar_bits<2>();
    expect_scalar_bits<4>();
    expect_scalar_bits<8>();
}

TEST(Pack, SelectsComparesAndTakesRootsLaneByLane) {
    constexpr int W = kernel::native_lanes;
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        kernel::Pack<W> a, b, c;
        for (int lane = 0; lane < W; ++lane) {
            a.set(lane, random.normal());
            b.set(lane, random.normal());
            c.set(lane, random.normal());
        }
        const auto less = a < b;
        const auto chosen = select(less, a, b);
        const auto root = sqrt(fabs(a));
        const auto sum = fma(a, b, c);
        for (int lane = 0; lane < W; ++lane) {
            EXPECT_EQ(less[lane], a[lane] < b[lane]);
            EXPECT_EQ(chosen[lane], std::fmin(a[lane], b[lane]));
            EXPECT_EQ(root[lane], std::sqrt(std::fabs(a[lane])));
            EXPECT_EQ(sum[lane], kernel::fma(a[lane], b[lane], c[lane]));
        }
        EXPECT_EQ(any(less), any(!(b <= a)));
    }
}

}  // namespace
