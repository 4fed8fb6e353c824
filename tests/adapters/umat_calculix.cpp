// SPDX-License-Identifier: BSD-3-Clause
// SAND, the entry for CalculiX: the same sand, in axes that do not turn, with a symmetric tangent.
#include <grit/classic_layout.h>
#include <grit/sand_operators.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/library.hpp"
#include "support/umat_call.hpp"

namespace {

UmatFunction sand() { return reinterpret_cast<UmatFunction>(symbol_of(GRIT_UMAT_LIBRARY, "SAND")); }

UmatCall sheared() {
    UmatCall call = UmatCall::hochstetten();
    call.set_dstran(-1e-3, 4e-4, 1e-4, 5e-4, -2e-4, 1e-4);
    return call;
}

// As CalculiX does: a turn of the material, that is not even orthogonal in a first iteration.
TEST(UmatCalculix, GetsTheStateOfAUmatWithoutDrot) {
    UmatCall still = sheared();
    still.run();
    for (const double scale : {1.0, 0.9}) {
        UmatCall call = sheared();
        const double turned[9] = {0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1};
        for (int i = 0; i < 9; ++i) call.drot[i] = scale * turned[i];
        call.run(sand());
        EXPECT_EQ(call.pnewdt, 1.0);
        EXPECT_EQ(call.stress, still.stress);
        EXPECT_EQ(call.statev, still.statev);
    }
}

TEST(UmatCalculix, GetsASymmetricTangentThatAShareOfLStiffens) {
    UmatCall usual = sheared(), call = sheared();
    usual.run();
    call.run(sand());

    grit_sand_parameters parameters;
    grit_classic_parameters(call.props.data(), &parameters);
    grit_sand prepared;
    ASSERT_EQ(grit_sand_prepare(&parameters, &prepared, nullptr), GRIT_OK);
    double L[36];
    ASSERT_EQ(grit_sand_stiffness(&prepared, call.stress.data(), call.statev[6], L, nullptr),
              GRIT_OK);
    double skew = 0.0;
    for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c) {
            EXPECT_EQ(call.tangent(r, c), call.tangent(c, r));
            const double symmetric = 0.5 * (usual.tangent(r, c) + usual.tangent(c, r));
            EXPECT_NEAR(call.tangent(r, c), symmetric + 0.5 * L[6 * r + c], 1e-12 * L[0]);
            skew = std::max(skew, std::abs(usual.tangent(r, c) - usual.tangent(c, r)));
        }
    EXPECT_GT(skew, 0.1 * L[0]) << "or there would be nothing to hold back";
}

TEST(UmatCalculix, AddsThePoreWaterToTheSymmetricTangent) {
    UmatCall dry = sheared(), wet = sheared();
    wet.props[14] = 1e6;
    dry.run(sand());
    wet.run(sand());
    EXPECT_NEAR(wet.tangent(0, 1), dry.tangent(0, 1) + 1e6, 1e-3);
    EXPECT_NEAR(wet.tangent(3, 3), dry.tangent(3, 3), 1e-3);
}

}  // namespace
