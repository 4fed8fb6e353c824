// SPDX-License-Identifier: BSD-3-Clause
// The material that was prepared for the last call is kept: nobody may notice but by the clock.
#include <gtest/gtest.h>

#include <string>

#include "support/library.hpp"
#include "support/umat_call.hpp"

namespace {

// A material with all seventeen, each of which the answer depends on.
UmatCall loaded() {
    UmatCall call = UmatCall::hochstetten();
    call.props[1] = 1.0;
    call.props[14] = 2e6;
    call.set_tolerance(3e-2);
    call.statev[3] = 5e-5;  // a turn by 90 degrees, or m_T would hardly matter
    call.set_dstran(-5e-3, 1e-3, 2e-3, 4e-3, -3e-3, 2e-3);
    return call;
}

// All calls from one memory, as a host makes them: the address of PROPS tells nothing.
UmatCall answer_to(const UmatCall& call) {
    static UmatCall memory;
    memory = call;
    memory.run();
    EXPECT_EQ(memory.pnewdt, 1.0);
    return memory;
}

UmatCall first_answer_to(const UmatCall& call) {
    unload(GRIT_UMAT_LIBRARY);
    return answer_to(call);
}

void expect_alternating(const UmatCall& a, const UmatCall& b) {
    const UmatCall alone_b = first_answer_to(b), alone_a = first_answer_to(a);
    EXPECT_FALSE(alone_a.same_results(alone_b)) << "or nobody could tell which it was";
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_TRUE(answer_to(b).same_results(alone_b));
        EXPECT_TRUE(answer_to(a).same_results(alone_a));
        EXPECT_TRUE(answer_to(a).same_results(alone_a)) << "once more";
    }
}

TEST(UmatKeptMaterial, IsAnotherWhereOneNumberDiffersInItsLastDigits) {
    for (int i = 0; i < 17; ++i) {
        SCOPED_TRACE("PROPS(" + std::to_string(i + 1) + ")");
        UmatCall other = loaded();
        other.props[i] *= 1.0 + 1e-10;
        expect_alternating(loaded(), other);
    }
}

TEST(UmatKeptMaterial, IsAnotherWhereTheToleranceComesGoesOrChanges) {
    UmatCall usual = loaded(), fine = loaded();
    usual.nprops = 16;
    usual.props.close_beyond(16);
    fine.set_tolerance(1e-6);
    expect_alternating(usual, fine);
    expect_alternating(loaded(), fine);
    expect_alternating(usual, loaded());
}

// The numbers that are read before the wrong one stay out of the next answer, and the wrong one is not
// taken the second time.
TEST(UmatKeptMaterial, IsNoneAfterARefusal) {
    const UmatCall alone = first_answer_to(loaded());
    const struct {
        int place;
        double value;
    } wrong[] = {{0, 0.576}, {3, 2.0}, {14, -1.0}, {15, -1.0}, {16, 0.2}};
    for (const auto& prop : wrong) {
        UmatCall call = loaded();
        call.props[13] = 4.0;
        call.props[14] = 1e6;
        call.props[prop.place] = prop.value;
        testing::internal::CaptureStderr();
        for (int time = 0; time < 2; ++time) {
            UmatCall refused = call;
            refused.run();
            EXPECT_LT(refused.pnewdt, 1.0) << prop.place;
            EXPECT_TRUE(refused.same_results(call)) << prop.place;
        }
        testing::internal::GetCapturedStderr();
        EXPECT_TRUE(answer_to(loaded()).same_results(alone)) << prop.place;
    }
}

}  // namespace
