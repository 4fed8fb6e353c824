// SPDX-License-Identifier: BSD-3-Clause
// A failed call changes nothing, asks for a smaller increment, and names what is wrong.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "support/umat_call.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refusal_of(const std::function<void(UmatCall&)>& spoil) {
    UmatCall call = UmatCall::hochstetten();
    call.set_dstran(-1e-4, 2e-5, 0, 1e-5);
    spoil(call);
    const UmatCall before = call;
    std::string said = call.complaint();
    EXPECT_LT(call.pnewdt, 1.0);
    EXPECT_GT(call.pnewdt, 0.0);
    EXPECT_TRUE(call.same_results(before));
    return said;
}

bool contains(const std::string& text, const char* word) {
    return text.find(word) != std::string::npos;
}

TEST(UmatFailure, ChangesNothingForNumbersThatAreNone) {
    for (const double bad : {nan, infinity, -infinity}) {
        for (int c = 0; c < 6; ++c) {
            EXPECT_FALSE(refusal_of([&](UmatCall& x) { x.dstran[c] = bad; }).empty());
            EXPECT_FALSE(refusal_of([&](UmatCall& x) { x.stress[c] = bad; }).empty());
            EXPECT_FALSE(refusal_of([&](UmatCall& x) { x.statev[c] = bad; }).empty());
        }
        for (const int i : {7, 12, 13})
            EXPECT_FALSE(refusal_of([&](UmatCall& x) { x.statev[i] = bad; }).empty()) << i;
        for (const int i : {0, 4, 8})
            EXPECT_FALSE(refusal_of([&](UmatCall& x) { x.drot[i] = bad; }).empty()) << i;
    }
    EXPECT_FALSE(refusal_of([](UmatCall& x) { x.statev[6] = nan; }).empty());
    EXPECT_FALSE(refusal_of([](UmatCall& x) { x.statev[6] = infinity; }).empty());
}

TEST(UmatFailure, RefusesEveryPropsThatIsNotANumber) {
    for (int i = 0; i < 16; ++i)
        for (const double bad : {nan, infinity})
            EXPECT_FALSE(refusal_of([&](UmatCall& x) { x.props[i] = bad; }).empty()) << i + 1;
}

TEST(UmatFailure, NamesTheParameterAndItsRange) {
    EXPECT_EQ(refusal_of([](UmatCall& x) { x.props[0] = 0.576; }),
              "Grit UMAT: element 12, point 3: PROPS(1) (phi_c) must be in [10, 60] degrees, got "
              "0.576: radians?\n");
    EXPECT_TRUE(contains(refusal_of([](UmatCall& x) { x.props[2] = -1.0; }), "h_s"));
    EXPECT_TRUE(contains(refusal_of([](UmatCall& x) { x.props[4] = 0.97; }), "e_d0"));
    EXPECT_TRUE(contains(refusal_of([](UmatCall& x) { x.props[9] = 0.7; }), "m_R"));
    EXPECT_TRUE(contains(refusal_of([](UmatCall& x) { x.props[14] = -1.0; }), "K_w"));
}

TEST(UmatFailure, NamesElementAndPoint) {
    const std::string said = refusal_of([](UmatCall& x) { x.props[3] = 2.0; });
    EXPECT_EQ(said.rfind("Grit UMAT: element 12, point 3: ", 0), 0U) << said;
}

// The library counts the points of its call from 0, and a UMAT has one.
TEST(UmatFailure, LeavesTheLibrarysCountOfPointsOut) {
    const std::string said = refusal_of([](UmatCall& x) { x.stress[1] = nan; });
    EXPECT_EQ(said.rfind("Grit UMAT: element 12, point 3: stress", 0), 0U) << said;
}

TEST(UmatFailure, IsSaidOnceHoweverManyPointsFail) {
    UmatCall call = UmatCall::hochstetten();
    call.props[3] = 2.0;
    EXPECT_NE(call.complaint(), "");
    testing::internal::CaptureStderr();
    for (int i = 0; i < 100; ++i) {
        call.pnewdt = 1.0;
        call.run();
        EXPECT_LT(call.pnewdt, 1.0) << "every failure is reported to the host";
    }
    call.props[3] = 0.25;
    call.props[0] = 0.5;
    call.run();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Many hosts cut back and go on: what is worse is still said.
TEST(UmatFailure, HasALineForIncrementsThatAreTooLargeAndOneForAllElse) {
    UmatCall call = UmatCall::hochstetten();
    call.set_dstran(-0.5, 0, 0);
    const std::string said = call.complaint();
    EXPECT_EQ(
        said.rfind("Grit UMAT: element 12, point 3: |strain increment| must be at most 0.2", 0), 0U)
        << said;
    testing::internal::CaptureStderr();
    call.run();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    call.props[3] = 2.0;
    testing::internal::CaptureStderr();
    call.run();
    EXPECT_NE(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
