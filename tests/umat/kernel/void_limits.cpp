// SPDX-License-Identifier: BSD-3-Clause
// Whether e is outside its limits at the end of a path: told from the start, it is what the logarithm tells.
#define GRIT_TARGET kernel_test
#include <limits>

#include <gtest/gtest.h>

#include "tests/umat/support/random.hpp"
#include "umat/batch/finish.hpp"

namespace {

namespace kernel = grit::kernel_test;
using tests::Random;

constexpr int width = 4;
using Lanes = kernel::Pack<width>;
using Mask = kernel::PackMask<width>;

grit::Material material(double h_s, double n) {
    grit::Material m{};
    m.h_s = h_s;
    m.n = n;
    m.three_over_hs = 3.0 / h_s;
    m.e_d0 = 0.44;
    m.e_i0 = 1.0;
    return m;
}

// Starts beside the limits and changes of the pressure on both sides of what is taken without a logarithm.
TEST(VoidLimits, AreTheSameFromTheStartOfAPathAndFromItsEnd) {
    Random random(21);
    int outside = 0, inside = 0, differ = 0;
    for (const double n : {0.01, 0.19, 0.99})
        for (int i = 0; i < 40000; ++i) {
            const grit::Material m = material(1e6, n);
            kernel::Tensor<Lanes> T_0, T_1;
            Lanes e;
            kernel::Tensor<double> alone_0[width], alone_1[width];
            double e_alone[width];
            for (int lane = 0; lane < width; ++lane) {
                const double p = random.log_uniform(1e-6 * m.h_s, 0.3 * m.h_s);
                const double size = random.log_uniform(1e-6, 30.0);
                double change = i % 2 ? size : -std::fmin(size, 1.2);
                if (i % 100 == 0 && lane == 1) change = std::numeric_limits<double>::quiet_NaN();
                const double p_1 = p * (1.0 + change);
                const double expansion = kernel::compression(m, p_1).expansion;
                e_alone[lane] =
                    (lane % 2 ? m.e_d0 : m.e_i0) / expansion * (1.0 + random.uniform(-0.05, 0.05));
                alone_0[lane] = kernel::isotropic(-p);
                alone_1[lane] = kernel::isotropic(-p_1);
                e.set(lane, e_alone[lane]);
                for (int c = 0; c < 6; ++c) {
                    T_0[c].set(lane, alone_0[lane][c]);
                    T_1[c].set(lane, alone_1[lane][c]);
                }
            }
            const Mask wanted(i % 7 != 0);
            const Mask all = kernel::void_clamped(m, kernel::marched(m, T_0), T_1, e, wanted);
            for (int lane = 0; lane < width; ++lane) {
                const bool exact = kernel::void_clamped(m, alone_1[lane], e_alone[lane]);
                const bool quick = kernel::void_clamped(m, kernel::marched(m, alone_0[lane]),
                                                        alone_1[lane], e_alone[lane], true);
                differ += quick != exact;
                differ += all[lane] != (exact && wanted[lane]);
                ++(exact ? outside : inside);
            }
        }
    EXPECT_EQ(differ, 0);
    EXPECT_GT(outside, 100000);
    EXPECT_GT(inside, 100000);
}

TEST(VoidLimits, NeedAPressureAtTheStart) {
    const grit::Material m = material(1e6, 0.2);
    const kernel::Marched<double> nothing{kernel::isotropic(0.0), {0.0, 1.0}};
    const kernel::Tensor<double> T = kernel::isotropic(-100.0);
    EXPECT_TRUE(kernel::void_clamped(m, nothing, T, 0.9, true));
    EXPECT_FALSE(kernel::void_clamped(m, nothing, T, 0.7, true));
}

}  // namespace
