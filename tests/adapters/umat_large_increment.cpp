// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/umat_call.hpp"

namespace {

// In one call what a thousand small ones give, or a refusal that changes nothing: never garbage.
TEST(UmatLargeIncrement, AgreesWithManySmallOnesInAnyDirection) {
    const double d = 0.1;
    const double directions[][6] = {{-d, 0, 0, 0, 0, 0},   {d, 0, 0, 0, 0, 0},
                                    {0, -d, d, 0, 0, 0},   {0, 0, 0, d, 0, 0},
                                    {-d, -d, -d, 0, 0, 0}, {0, 0, 0, 0, d, -d},
                                    {d, d, -d, 0, d, 0},   {-d, d / 4, d / 4, d / 4, 0, 0}};
    int answered = 0;
    for (const auto& e : directions) {
        UmatCall once = UmatCall::hochstetten();
        UmatCall often = once;
        const UmatCall before = once;
        once.set_dstran(e[0], e[1], e[2], e[3], e[4], e[5]);
        once.run();
        EXPECT_TRUE(once.in_bounds());
        if (once.pnewdt < 1.0) {
            EXPECT_TRUE(once.same_results(before));
            continue;
        }
        ++answered;
        const int n = 1000;
        often.set_dstran(e[0] / n, e[1] / n, e[2] / n, e[3] / n, e[4] / n, e[5] / n);
        for (int i = 0; i < n; ++i) often.run();
        ASSERT_EQ(often.pnewdt, 1.0);
        EXPECT_TRUE(once.finite());
        const double scale = often.statev[8] + 1e-9;
        for (int c = 0; c < 6; ++c) EXPECT_NEAR(once.stress[c], often.stress[c], 1e-3 * scale) << c;
        EXPECT_NEAR(once.statev[6], often.statev[6], 1e-12);
    }
    EXPECT_GE(answered, 6);
}

}  // namespace
