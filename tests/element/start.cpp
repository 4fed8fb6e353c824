// SPDX-License-Identifier: BSD-3-Clause
// What a sample may start with.
#include <element/start.hpp>

#include <gtest/gtest.h>

#include <grit/sand_operators.h>

#include "support/lausitz.hpp"
#include <element/errors.hpp>

namespace {

using namespace tests;
using namespace element;

// (H10): the limits of e are those at p + p_t, which the library's functions take.
TEST(Start, TakesTheVoidRatiosThatTheUpdateDoesNotClamp) {
    for (const double p_t : {0.0, 30.0, 300.0})
        for (const double p : {1.0, 100.0}) {
            grit_sand_parameters parameters = lausitz();
            parameters.pressure_shift = p_t;
            const GritLaw law(parameters);
            double limits[3], e = 0.0;  // e_i, e_c, e_d
            ASSERT_EQ(grit_sand_void_ratios(&law.sand(), p + p_t, limits), GRIT_OK);
            ASSERT_EQ(grit_sand_void_ratio_at_pressure(&law.sand(), 0.6, p + p_t, &e), GRIT_OK);
            EXPECT_EQ(void_ratio_at_pressure(law.sand(), 0.6, p), e);
            const VoidRatios range = void_ratios(law.sand(), p);
            EXPECT_EQ(range.loosest, limits[0]);
            EXPECT_EQ(range.critical, limits[1]);
            EXPECT_EQ(range.densest, limits[2]);
            Start start;
            start.stress = -p * unit_tensor();
            for (const double inside : {limits[2], limits[0]}) {
                start.void_ratio = inside;
                EXPECT_NO_THROW(start_point(law, start)) << p_t << ' ' << p;
            }
            for (const double outside : {limits[2] * (1.0 - 1e-9), limits[0] * (1.0 + 1e-9)}) {
                start.void_ratio = outside;
                EXPECT_THROW(start_point(law, start), BadCase) << p_t << ' ' << p;
            }
        }
}

}  // namespace
