// SPDX-License-Identifier: BSD-3-Clause
// Global sums, in fixed point: no order, no cut changes a bit, and what does not fit is no number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <adapters/mpm/kernel/exchange.hpp>

namespace {

using grit::mpm::Total;

std::vector<double> numbers(std::size_t count) {
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> exponent(-60.0, 30.0), mantissa(-1.0, 1.0);
    std::vector<double> out(count);
    for (double& x : out)
        x = std::ldexp(mantissa(generator), static_cast<int>(exponent(generator)));
    return out;
}

Total sum(const std::vector<double>& x, std::size_t begin, std::size_t end) {
    Total out;
    for (std::size_t i = begin; i < end; ++i) out.add(x[i], true);
    return out;
}

TEST(Totals, DependOnNoOrderAndNoCut) {
    std::vector<double> x = numbers(5000);
    const double whole = sum(x, 0, x.size()).value();
    long double reference = 0.0L;
    for (const double value : x) reference += value;
    EXPECT_NEAR(whole, static_cast<double>(reference), 1e-15 * 0x1p34);
    std::reverse(x.begin(), x.end());
    EXPECT_EQ(sum(x, 0, x.size()).value(), whole);
    Total parts = sum(x, 0, 1234);
    parts += sum(x, 1234, x.size());
    EXPECT_EQ(parts.value(), whole);
    parts -= sum(x, 1000, x.size());
    EXPECT_EQ(parts.value(), sum(x, 0, 1000).value());
    // In double it does.
    Total forth, back;
    for (const double value : x) forth.add(value, false);
    std::reverse(x.begin(), x.end());
    for (const double value : x) back.add(value, false);
    EXPECT_NE(forth.value(), back.value());
}

TEST(Totals, OfProcessesAreSumsOfTheirWords) {
    const std::vector<double> x = numbers(3000);
    for (const double sign : {1.0, -1.0}) {
        std::vector<double> y = x;
        for (double& value : y) value *= sign;
        std::int64_t words[Total::words] = {};
        for (const std::size_t begin : {0u, 1000u, 2000u}) {
            std::int64_t part[Total::words];
            sum(y, begin, begin + 1000).write(part);
            for (int i = 0; i < Total::words; ++i) words[i] += part[i];
        }
        Total together;
        together.read(words);
        EXPECT_EQ(together.value(), sum(y, 0, y.size()).value());
    }
}

TEST(Totals, WhatDoesNotFitIsNoNumber) {
    for (const double x : {Total::largest, -Total::largest, double{INFINITY}, double{NAN}}) {
        Total total;
        total.add(1.0, true);
        total.add(x, true);
        EXPECT_TRUE(std::isnan(total.value())) << x;
    }
    Total many;
    const double most = std::nextafter(Total::largest, 0.0);
    for (int i = 0; i < 1 << 12; ++i) many.add(most, true);
    EXPECT_NEAR(many.value(), 0x1p46, 0x1p30);
    for (int i = 0; i < 1 << 13; ++i) many.add(most, true);
    EXPECT_TRUE(std::isnan(many.value()));
}

}  // namespace
