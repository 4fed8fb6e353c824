// SPDX-License-Identifier: BSD-3-Clause
// The second layout is the first with other places: radians, m_T before m_R, e before h.
#include <gtest/gtest.h>

#include <cmath>

#include "support/library.hpp"
#include "support/umat_call.hpp"

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

UmatFunction radian_umat(const char* name = "umat_") {
    return reinterpret_cast<UmatFunction>(symbol_of(GRIT_UMATR_LIBRARY, name));
}

UmatCall in_radians(const UmatCall& classic) {
    UmatCall out = classic;
    out.props[0] = classic.props[0] * degree;
    out.props[1] = 0.2;  // Poisson's ratio: not used
    out.props[9] = classic.props[10];
    out.props[10] = classic.props[9];
    out.statev[0] = classic.statev[6];
    for (int c = 0; c < 6; ++c) out.statev[1 + c] = classic.statev[c];
    return out;
}

void expect_same(const UmatCall& radian, const UmatCall& classic) {
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(radian.stress[c], classic.stress[c], 1e-10) << c;
    EXPECT_NEAR(radian.statev[0], classic.statev[6], 1e-15) << "e";
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(radian.statev[1 + c], classic.statev[c], 1e-16) << c;
    for (const int k : {7, 8, 11, 12, 13})
        EXPECT_NEAR(radian.statev[k], classic.statev[k], 1e-10) << k;
    EXPECT_NEAR(radian.statev[10], classic.statev[10] * degree, 1e-12);
    for (int i = 0; i < 36; ++i) EXPECT_NEAR(radian.ddsdde[i], classic.ddsdde[i], 1e-6) << i;
}

TEST(UmatRadian, IsTheClassicUmatWithOtherPlaces) {
    const double path[][6] = {{-1e-3, 2e-4, 1e-4, 3e-4, -2e-4, 5e-4},
                              {1e-4, 0, 0, 0, -1e-4, 0},
                              {-2e-4, 1e-5, 3e-5, -4e-5, 0, 2e-5}};
    for (const double m_R : {5.0, 0.5})
        for (const double e_0 : {10.70, 0.75})
            for (const double K_w : {0.0, 2e6}) {
                UmatCall classic = UmatCall::hochstetten();
                classic.props[9] = m_R;
                classic.props[14] = K_w;
                classic.props[15] = e_0;
                UmatCall radian = in_radians(classic);
                for (const auto& d : path) {
                    for (UmatCall* call : {&classic, &radian})
                        call->set_dstran(d[0], d[1], d[2], d[3], d[4], d[5]);
                    classic.run();
                    radian.run(radian_umat());
                    ASSERT_EQ(radian.pnewdt, 1.0);
                    expect_same(radian, classic);
                    EXPECT_TRUE(radian.in_bounds());
                }
            }
}

TEST(UmatRadian, HasTheToleranceInTheSamePlace) {
    UmatCall classic = UmatCall::hochstetten();
    classic.set_tolerance(1e-7);
    classic.set_dstran(-1e-2, 2e-3, 3e-3, 4e-3, -3e-3, 2e-3);
    UmatCall radian = in_radians(classic);
    classic.run();
    radian.run(radian_umat());
    ASSERT_EQ(radian.pnewdt, 1.0);
    expect_same(radian, classic);
    EXPECT_EQ(radian.statev[9], classic.statev[9]) << "evaluations";
}

TEST(UmatRadian, KeepsTheVoidRatioOfStatevOne) {
    UmatCall call = in_radians(UmatCall::hochstetten());
    call.statev[0] = 0.66;
    call.run(radian_umat());
    EXPECT_EQ(call.statev[0], 0.66);
}

TEST(UmatRadian, AnswersToEveryNameThatHostsLookUp) {
    for (const char* name : {"umat_", "umat", "UMAT", "SAND"})
        EXPECT_NE(radian_umat(name), nullptr) << name;
    EXPECT_NE(radian_umat(), umat()) << "a library of its own";
}

std::string refusal(int place, double value) {
    UmatCall call = in_radians(UmatCall::hochstetten());
    call.props[place] = value;
    const UmatCall before = call;
    unload(GRIT_UMATR_LIBRARY);
    testing::internal::CaptureStderr();
    call.run(radian_umat());
    EXPECT_LT(call.pnewdt, 1.0);
    EXPECT_TRUE(call.same_results(before));
    return testing::internal::GetCapturedStderr();
}

TEST(UmatRadian, RefusesDegreesWithAHint) {
    EXPECT_NE(
        refusal(0, 33.0).find("PROPS(1) (phi_c) must be in [0.174533, 1.0472] radians, got 33: "
                              "degrees?"),
        std::string::npos);
}

TEST(UmatRadian, RefusesAPressureWhereItsFamilyHasPoissonsRatio) {
    EXPECT_NE(refusal(1, 10.0).find("PROPS(2)"), std::string::npos);
}

TEST(UmatRadian, SaysThatTheVoidRatioIsMissingInItsOwnPlace) {
    EXPECT_NE(refusal(15, 0.0).find("STATEV(1) is below 0.001"), std::string::npos);
}

}  // namespace
