// SPDX-License-Identifier: BSD-3-Clause
// Numbers in messages.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>

#include <adapters/mpm/step/text.hpp>

namespace {

using namespace grit::mpm;

TEST(NumberInAMessage, HasSixDigitsOrAsManyAsTellItFromAnyOther) {
    EXPECT_EQ(text(1.0 / 3.0), "0.333333");
    EXPECT_EQ(text(-2.5e-7), "-2.5e-07");
    EXPECT_EQ(place_text(1.0 / 3.0, -2.0), "(0.333333, -2) m");
    for (const double x : {1.0 / 3.0, -1.0 / 3.0e200, std::numeric_limits<double>::denorm_min(),
                           std::numeric_limits<double>::max()})
        EXPECT_EQ(std::strtod(exact_text(-x).c_str(), nullptr), -x);
    EXPECT_EQ(exact_text(0.1), "0.1");
}

}  // namespace
