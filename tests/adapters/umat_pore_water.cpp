// SPDX-License-Identifier: BSD-3-Clause
// Undrained by penalty: K_w of the mixture, total stress outside, effective stress inside.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/umat_call.hpp"

namespace {

constexpr double K_w = 2.0e6;

TEST(UmatPoreWater, FollowsTheVolumetricStrain) {
    UmatCall undrained = UmatCall::hochstetten();
    UmatCall drained = undrained;
    undrained.props[14] = K_w;
    double volumetric = 0.0;
    for (int i = 0; i < 100; ++i) {
        for (UmatCall* call : {&undrained, &drained}) {
            call->set_dstran(-1e-4, 3e-5, 2e-5, 1e-4, 0, -2e-5);
            call->run();
            ASSERT_EQ(call->pnewdt, 1.0);
        }
        volumetric += -1e-4 + 3e-5 + 2e-5;
    }
    const double pore_stress = K_w * volumetric;  // minus the pore pressure: it has risen
    EXPECT_NEAR(undrained.statev[7], pore_stress, 1e-12 * -pore_stress);
    EXPECT_EQ(drained.statev[7], 0.0);
    for (int c = 0; c < 6; ++c)
        EXPECT_NEAR(undrained.stress[c], drained.stress[c] + (c < 3 ? pore_stress : 0.0),
                    1e-9 * -pore_stress);
    EXPECT_NEAR(undrained.statev[8], drained.statev[8], 1e-6) << "STATEV(9) is effective";
}

TEST(UmatPoreWater, StiffensTheNormalBlockOfTheTangentByItsModulus) {
    UmatCall undrained = UmatCall::hochstetten();
    UmatCall drained = undrained;
    undrained.props[14] = K_w;
    for (UmatCall* call : {&undrained, &drained}) {
        call->set_dstran(-1e-4, 3e-5, 2e-5, 1e-4, 0, -2e-5);
        call->run();
    }
    for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
            EXPECT_EQ(undrained.tangent(r, c),
                      drained.tangent(r, c) + (r < 3 && c < 3 ? K_w : 0.0));
}

TEST(UmatPoreWater, KeepsAPorePressureWhenDrained) {
    UmatCall dry = UmatCall::hochstetten();
    UmatCall wet = dry;
    wet.statev[7] = -50.0;
    for (int c = 0; c < 3; ++c) wet.stress[c] -= 50.0;
    for (UmatCall* call : {&dry, &wet}) {
        call->set_dstran(-1e-4, 3e-5, 2e-5, 1e-4);
        call->run();
    }
    EXPECT_EQ(wet.statev[7], -50.0);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(wet.stress[c], dry.stress[c] - 50.0, 1e-12);
}

// Taking the pore pressure off and on again would cost bits in some of these.
TEST(UmatPoreWater, CostsNoBitInAZeroIncrement) {
    int costly = 0;
    for (int i = 1; i <= 50; ++i) {
        UmatCall call = UmatCall::hochstetten();
        call.props[14] = K_w;
        call.statev[7] = 100.0 + 1.0 / (3.0 * i);  // suction
        for (int c = 0; c < 3; ++c) call.stress[c] = -100.0 - 0.1 * (i + c);
        const UmatCall before = call;
        for (int c = 0; c < 3; ++c) {
            const double effective = call.stress[c] - call.statev[7];
            if (effective + call.statev[7] != call.stress[c]) ++costly;
        }
        call.run();
        EXPECT_EQ(call.stress, before.stress);
        EXPECT_EQ(call.statev[7], before.statev[7]);
    }
    EXPECT_GT(costly, 0);
}

// PROPS(19) = 1: K_w is that of the water in pores of the void ratio.
TEST(UmatPoreWater, ItselfIsCompressedWithThePores) {
    UmatCall call = UmatCall::hochstetten(), drained = call;
    call.set_water(2.2e6, 0.0, 1.0);
    const double e_0 = call.props[15] - 10.0;
    for (UmatCall* each : {&call, &drained}) {
        each->set_dstran(-1e-3, 3e-4, 2e-4, 1e-4, 0, -2e-5);
        each->run();
        ASSERT_EQ(each->pnewdt, 1.0);
    }
    const double e = call.statev[6];
    EXPECT_NEAR(-call.statev[7], -2.2e6 * std::log(e / e_0), 1e-6);
    EXPECT_NEAR(call.tangent(0, 1) - drained.tangent(0, 1), 2.2e6 * (1.0 + e) / e, 1e-6);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(call.stress[c], drained.stress[c] + call.statev[7], 1e-9);
}

// PROPS(18): STATEV(8) goes on, what bears does not; and back again.
TEST(UmatPoreWater, BearsItsLargestTensionUntilTheCavityHasClosed) {
    for (const double itself : {0.0, 1.0}) {
        UmatCall call = UmatCall::hochstetten(), drained = call;
        call.set_water(2.2e6, 100.0, itself);
        const auto both = [&](double volumetric) {
            for (UmatCall* each : {&call, &drained}) {
                const double d = volumetric / 3.0;
                each->set_dstran(d, d, d, 1e-4);
                each->run();
                ASSERT_EQ(each->pnewdt, 1.0);
            }
        };
        both(1e-3);
        EXPECT_GT(call.statev[7], 2000.0);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(call.stress[c], drained.stress[c] + 100.0, 1e-9);
        for (int c = 3; c < 6; ++c) EXPECT_NEAR(call.stress[c], drained.stress[c], 1e-9);
        for (int k = 0; k < 36; ++k) EXPECT_NEAR(call.ddsdde[k], drained.ddsdde[k], 1e-9);
        both(-0.5e-3);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(call.stress[c], drained.stress[c] + 100.0, 1e-9);
        both(-0.501e-3);
        EXPECT_LT(call.statev[7], 0.0);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(call.stress[c], drained.stress[c] + call.statev[7], 1e-9);
    }
}

TEST(UmatPoreWater, IsRefusedWhereItIsNone) {
    const struct {
        double K_w, largest_tension, itself;
        const char* words;
    } waters[] = {
        {-1.0, 0.0, 0.0, "PROPS(15) (K_w) must be >= 0 and finite, got -1"},
        {1.0, -100.0, 0.0, "PROPS(18) (largest tension) must be >= 0 and finite, got -100"},
        {1.0, 0.0, 0.4,
         "PROPS(19) must be 1, where K_w is that of the water itself, or 0, got 0.4"}};
    for (const auto& water : waters) {
        UmatCall call = UmatCall::hochstetten();
        call.set_water(water.K_w, water.largest_tension, water.itself);
        const UmatCall before = call;
        const std::string said = call.complaint();
        EXPECT_NE(said.find(water.words), std::string::npos) << said;
        EXPECT_TRUE(call.same_results(before));
    }
}

}  // namespace
