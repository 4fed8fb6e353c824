// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/umat_call.hpp"

namespace {

// Published for Hochstetten sand, isotropic 100 kPa, e 0.70, h 0: 0.5 % oedometric compression.
// origin: 294.3 kPa, 29 080 kPa and 316 559 kPa of the literature; digits from the formulas alone.
TEST(UmatOedometer, ReproducesTheHochstettenBenchmark) {
    UmatCall call = UmatCall::hochstetten();
    double before_last = 0.0;
    for (int i = 0; i < 50; ++i) {
        before_last = call.stress[0];
        call.set_dstran(-1e-4, 0, 0);
        call.run();
        ASSERT_EQ(call.pnewdt, 1.0);
    }
    const double top = call.stress[0];
    EXPECT_NEAR(top, -294.27458, 5e-4 * 294.27458);
    EXPECT_NEAR((before_last - top) / 1e-4, 29080.15, 5e-4 * 29080.15);
    call.set_dstran(1e-4, 0, 0);
    call.run();
    EXPECT_NEAR((call.stress[0] - top) / 1e-4, 316557.1, 5e-4 * 316557.1);
}

}  // namespace
