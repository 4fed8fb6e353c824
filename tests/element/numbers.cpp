// SPDX-License-Identifier: BSD-3-Clause
#include <element/number.hpp>

#include <gtest/gtest.h>

namespace {

using element::number_length;
using element::number_of;

TEST(Number, IsReadAsFortranWritesIt) {
    EXPECT_EQ(number_of("-200d0"), -200.0);
    EXPECT_EQ(number_of(" +1.5D-3\r"), 1.5e-3);
    EXPECT_EQ(number_of(".5"), 0.5);
    EXPECT_EQ(number_of("4."), 4.0);
}

TEST(Number, IsTheWholeTextAndFinite) {
    for (const char* text : {"", " ", "80 kPa", "n/a", "nan", "inf", "1e999", "0x10", "1,5", "--1",
                             "+-1", ".", "e5", "1e"})
        EXPECT_FALSE(number_of(text)) << text;
}

TEST(Number, EndsWhereItsTextGoesOn) {
    EXPECT_EQ(number_length("2.5*s1"), 3u);
    EXPECT_EQ(number_length("1e3+2"), 3u);
    EXPECT_EQ(number_length("1 e"), 1u);
    EXPECT_EQ(number_length("s1"), 0u);
}

}  // namespace
