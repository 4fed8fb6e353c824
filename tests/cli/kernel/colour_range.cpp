// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/colour_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using cli::colour_range;
using cli::ColourRange;

std::vector<double> even(int count) {
    std::vector<double> out;
    for (int i = 0; i <= count; ++i) out.push_back(static_cast<double>(i) / count);
    return out;
}

TEST(ColourRange, IsThatOfTheValues) {
    const ColourRange range = colour_range({3.0, NAN, -1.0, 2.0, INFINITY});
    EXPECT_EQ(range.low, -1.0);
    EXPECT_EQ(range.high, 3.0);
    EXPECT_EQ(range.beyond, "");
    EXPECT_EQ(colour_range(even(1000)).low, 0.0);
    EXPECT_EQ(colour_range(even(1000)).high, 1.0);
}

TEST(ColourRange, IsNeverEmpty) {
    EXPECT_LT(colour_range({}).low, colour_range({}).high);
    EXPECT_LT(colour_range({5.0}).low, 5.0);
    EXPECT_GT(colour_range({5.0}).high, 5.0);
}

TEST(ColourRange, LeavesAFewFarValuesOutsideAndSaysSo) {
    std::vector<double> values = even(1000);
    for (int i = 0; i < 4; ++i) values.push_back(100.0);
    const ColourRange range = colour_range(values);
    EXPECT_NEAR(range.high, 1.0, 0.01);
    EXPECT_NEAR(range.low, 0.0, 0.01);
    EXPECT_EQ(range.beyond, "0 … 100");
}

TEST(ColourRange, KeepsAFewValuesWhereAllOthersAreTheSame) {
    std::vector<double> values(1000, 0.0);
    values.push_back(2.0);
    EXPECT_EQ(colour_range(values).high, 2.0);
    EXPECT_EQ(colour_range(values).beyond, "");
}

}  // namespace
