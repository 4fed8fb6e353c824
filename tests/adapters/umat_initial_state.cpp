// SPDX-License-Identifier: BSD-3-Clause
// Where the void ratio comes from, and first calls at zero everything.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/umat_call.hpp"

namespace {

double void_ratio_after_zero_increment(double e_0, double given, double p) {
    UmatCall call = UmatCall::hochstetten();
    for (int c = 0; c < 3; ++c) call.stress[c] = -p;
    call.props[15] = e_0;
    call.statev[6] = given;
    call.run();
    EXPECT_EQ(call.pnewdt, 1.0);
    EXPECT_TRUE(call.finite());
    return call.statev[6];
}

TEST(UmatInitialState, CompressesAVoidRatioAtZeroPressure) {
    const double e = 0.75 * std::exp(-std::pow(3.0 * 100.0 / 1e6, 0.25));  // (H6)
    EXPECT_NEAR(void_ratio_after_zero_increment(0.75, 0.0, 100.0), e, 1e-15);
    EXPECT_NEAR(void_ratio_after_zero_increment(0.75, 0.9e-3, 100.0), e, 1e-15);
}

TEST(UmatInitialState, DoesNotCompressBelowOneThousandth) {
    EXPECT_EQ(void_ratio_after_zero_increment(0.75, 0.0, 1e-3), 0.75);
    EXPECT_EQ(void_ratio_after_zero_increment(0.75, 0.0, 0.0), 0.75);
    EXPECT_LT(void_ratio_after_zero_increment(0.75, 0.0, 1.1e-3), 0.75);
}

TEST(UmatInitialState, TakesTenOffATrueVoidRatio) {
    EXPECT_DOUBLE_EQ(void_ratio_after_zero_increment(10.75, 0.0, 100.0), 0.75);
}

TEST(UmatInitialState, KeepsAVoidRatioThatIsThere) {
    EXPECT_EQ(void_ratio_after_zero_increment(10.75, 0.66, 100.0), 0.66);
    EXPECT_EQ(void_ratio_after_zero_increment(0.0, 0.66, 100.0), 0.66);
}

TEST(UmatInitialState, UsesTheEffectivePressure) {
    UmatCall call = UmatCall::hochstetten();
    call.props[15] = 0.75;
    call.statev[7] = -60.0;  // p_w = 60 kPa
    call.run();
    EXPECT_NEAR(call.statev[6], 0.75 * std::exp(-std::pow(3.0 * 40.0 / 1e6, 0.25)), 1e-15);
}

TEST(UmatInitialState, SaysWhereAVoidRatioIsNowhere) {
    UmatCall call = UmatCall::hochstetten();
    call.props[15] = 0.0;
    const UmatCall before = call;
    const std::string said = call.complaint();
    EXPECT_NE(said.find("no void ratio"), std::string::npos) << said;
    EXPECT_LT(call.pnewdt, 1.0);
    EXPECT_TRUE(call.same_results(before));
}

TEST(UmatInitialState, AnswersAFirstCallWithAFiniteStiffness) {
    for (const double e_0 : {0.75, 10.75})
        for (const int n : {6, 4, 3}) {
            UmatCall call = UmatCall::hochstetten();
            call.props[15] = e_0;
            call.use_components(n);
            for (int c = 0; c < n; ++c) call.stress[c] = 0.0;
            call.run();
            EXPECT_EQ(call.pnewdt, 1.0);
            ASSERT_TRUE(call.finite());
            EXPECT_TRUE(call.in_bounds());
            for (int c = 0; c < n; ++c) {
                EXPECT_EQ(call.stress[c], 0.0);
                EXPECT_GT(call.tangent(c, c), 0.0);
            }
        }
}

TEST(UmatInitialState, CarriesStressOnceAStressFreePointIsCompressed) {
    UmatCall call = UmatCall::hochstetten();
    for (int c = 0; c < 3; ++c) call.stress[c] = 0.0;
    call.set_dstran(1e-3, 0, 0);
    call.run();
    EXPECT_EQ(call.stress[0], 0.0);
    EXPECT_NEAR(call.statev[13], 1e-3, 1e-15) << "STATEV(14): what has opened";
    call.set_dstran(-0.9e-3, 0, 0);
    call.run();
    EXPECT_EQ(call.stress[0], 0.0);
    call.set_dstran(-1e-3, 0, 0);
    call.run();
    EXPECT_LT(call.stress[0], 0.0);
    EXPECT_EQ(call.statev[13], 0.0);
}

}  // namespace
