// SPDX-License-Identifier: BSD-3-Clause
// Sizes, null pointers, PNEWDT: what hosts pass, rightly and wrongly.
#include <gtest/gtest.h>

#include <limits>

#include "support/library.hpp"
#include "support/umat_call.hpp"

namespace {

// The call changes nothing but PNEWDT, and says why.
void expect_refused(UmatCall call, const std::string& word) {
    const UmatCall before = call;
    const std::string said = call.complaint();
    EXPECT_NE(said.find(word), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), said.size() - 1) << "one line: " << said;
    EXPECT_TRUE(call.same_results(before));
    if (!call.sparse) {
        EXPECT_LT(call.pnewdt, 1.0);
        EXPECT_GT(call.pnewdt, 0.0);
    }
}

UmatCall loaded() {
    UmatCall call = UmatCall::hochstetten();
    call.set_dstran(-1e-4, 0, 0);
    return call;
}

TEST(UmatLayout, RefusesTooFewPropsAndStatev) {
    for (const int nprops : {-1, 0, 8, 15}) {
        UmatCall call = loaded();
        call.nprops = nprops;
        call.props.close_beyond(nprops < 0 ? 0 : nprops);
        expect_refused(call, "NPROPS must be at least 16");
    }
    for (const int nstatv : {-1, 0, 7, 12}) {
        UmatCall call = loaded();
        call.nstatv = nstatv;
        call.statev.close_beyond(nstatv < 0 ? 0 : nstatv);
        expect_refused(call, "NSTATV must be at least 13");
    }
}

TEST(UmatLayout, RefusesPlaneStressAndOddSizes) {
    UmatCall call = loaded();
    call.use_components(3);
    call.ndi = 2;
    call.nshr = 1;
    expect_refused(call, "plane stress is not supported");
    for (const int ntens : {-1, 0, 1, 2, 5, 7, 100}) {
        call = loaded();
        call.ntens = ntens;
        expect_refused(call, "NTENS must be 6, 4");
    }
}

TEST(UmatLayout, KeepsWithinThirteenStatev) {
    UmatCall with = loaded();
    UmatCall without = with;
    without.nstatv = 13;
    without.statev.close_beyond(13);
    with.run();
    without.run();
    EXPECT_TRUE(without.in_bounds());
    EXPECT_EQ(without.stress, with.stress);
    for (int i = 0; i < 13; ++i) EXPECT_EQ(without.statev[i], with.statev[i]);
}

TEST(UmatLayout, LeavesFurtherStatevAlone) {
    UmatCall call = loaded();
    call.nstatv = 16;
    call.statev[14] = 3.0;
    call.statev[15] = 4.0;
    call.run();
    EXPECT_EQ(call.statev[14], 3.0);
    EXPECT_EQ(call.statev[15], 4.0);
    EXPECT_TRUE(call.in_bounds());
}

TEST(UmatLayout, DoesWithoutWhateverTheLawDoesNotNeed) {
    UmatCall full = loaded();
    UmatCall sparse = full;
    sparse.sparse = true;
    full.run();
    sparse.run();
    EXPECT_TRUE(sparse.same_results(full));
    sparse.dstran[0] = std::numeric_limits<double>::quiet_NaN();
    expect_refused(sparse, "strain_increment");
}

TEST(UmatLayout, ComputesStressWithoutATangent) {
    UmatCall with = loaded();
    UmatCall without = with;
    with.run();
    umat()(without.stress.data(), without.statev.data(), nullptr, nullptr, nullptr, nullptr,
           nullptr, nullptr, nullptr, nullptr, nullptr, without.dstran.data(), nullptr, nullptr,
           nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &without.ntens,
           &without.nstatv, without.props.data(), &without.nprops, nullptr, nullptr, nullptr,
           nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, 0);
    EXPECT_EQ(without.stress, with.stress);
    EXPECT_EQ(without.statev, with.statev);
}

TEST(UmatLayout, SurvivesACallOfNothingButNulls) {
    double pnewdt = 1.0;
    unload(GRIT_UMAT_LIBRARY);
    testing::internal::CaptureStderr();
    umat()(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
           nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
           nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &pnewdt, nullptr, nullptr,
           nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, 0);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("null pointer"), std::string::npos);
    EXPECT_LT(pnewdt, 1.0);
}

TEST(UmatLayout, NamesEveryNullPointerThatTheSandNeeds) {
    for (const char* name : {"STRESS", "STATEV", "DSTRAN", "PROPS", "NTENS", "NSTATV", "NPROPS"}) {
        UmatCall call = loaded();
        call.missing = name;
        const UmatCall before = call;
        const std::string said = call.complaint();
        EXPECT_NE(said.find(std::string(name) + " is a null pointer"), std::string::npos) << said;
        EXPECT_TRUE(call.same_results(before));
        EXPECT_LT(call.pnewdt, 1.0);
    }
}

// Of several points that share a PNEWDT, as in CalculiX, the one that wants least has it.
TEST(UmatLayout, NeverRaisesAPnewdtThatAnotherPointHasAskedFor) {
    for (const double strain : {-0.22, std::numeric_limits<double>::infinity()}) {
        UmatCall call = loaded();
        call.pnewdt = 0.1;
        call.set_dstran(strain, 0, 0);
        call.complaint();
        EXPECT_EQ(call.pnewdt, 0.1);
        call.pnewdt = 0.9;
        call.complaint();
        EXPECT_LT(call.pnewdt, 0.9);
    }
}

TEST(UmatLayout, WritesPnewdtOnlyOnFailureAndThenBelowOne) {
    for (const double given : {1.0, -1.0, std::numeric_limits<double>::max(), 0.5}) {
        UmatCall call = loaded();
        call.pnewdt = given;
        call.run();
        EXPECT_EQ(call.pnewdt, given);
        call.dstran[0] = std::numeric_limits<double>::infinity();
        call.complaint();
        EXPECT_LT(call.pnewdt, 1.0);
        EXPECT_GT(call.pnewdt, 0.0);
    }
}

TEST(UmatLayout, AddsTheWorkOfTheTotalStressToSse) {
    for (const double K_w : {0.0, 2e6}) {
        UmatCall call = loaded();
        call.props[14] = K_w;
        call.set_dstran(-1e-4, 3e-5, 2e-5, 1e-4, 4e-5, -2e-5);
        const UmatCall before = call;
        call.run();
        double work = 0.0;
        for (int c = 0; c < 6; ++c)
            work += 0.5 * (before.stress[c] + call.stress[c]) * call.dstran[c];
        EXPECT_GT(work, 0.0);
        EXPECT_NEAR(call.energy[0], 11.0 + work, 1e-13);
        EXPECT_EQ(call.energy[1], 12.0) << "SPD";
        EXPECT_EQ(call.energy[2], 13.0) << "SCD";
    }
}

TEST(UmatLayout, LeavesSseAloneWhenItFails) {
    UmatCall call = loaded();
    call.stress[0] = std::numeric_limits<double>::infinity();
    call.complaint();
    EXPECT_EQ(call.energy[0], 11.0);
}

TEST(UmatLayout, AnswersToEveryNameThatHostsLookUp) {
    UmatCall usual = loaded();
    usual.run();
    for (const char* name : {"umat_", "umat", "UMAT"}) {
        const auto function = reinterpret_cast<UmatFunction>(symbol_of(GRIT_UMAT_LIBRARY, name));
        ASSERT_NE(function, nullptr) << name;
        UmatCall call = loaded();
        call.run(function);
        EXPECT_TRUE(call.same_results(usual)) << name;
    }
}

}  // namespace
