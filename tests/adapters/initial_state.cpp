// SPDX-License-Identifier: BSD-3-Clause
// SIGINI and SDVINI as they ship: ground at rest, and points that the UMAT goes on from.
#include <gtest/gtest.h>

#include <cmath>

#include "support/umat_call.hpp"

extern "C" {
void sigini_(double* sigma, const double* coords, const int* ntens, const int* ncrds,
             const int* noel, const int* npt, const int* layer, const int* kspt, const int* lrebar,
             const char* names, std::size_t length);
void sdvini_(double* statev, const double* coords, const int* nstatv, const int* ncrds,
             const int* noel, const int* npt, const int* layer, const int* kspt);
}

namespace {

constexpr int one = 1;
const char names[160] = {};

TEST(InitialState, IsGroundAtRestInThePlaneAndInSpace) {
    const double y[3] = {7.0, -10.0, 0.0}, z[3] = {1.0, 2.0, -10.0}, air[2] = {0.0, 5.0};
    double stress[6];
    const int two = 2, three = 3, four = 4, six = 6;
    sigini_(stress, y, &four, &two, &one, &one, &one, &one, &one, names, 80);
    EXPECT_DOUBLE_EQ(stress[1], -101.0);
    EXPECT_DOUBLE_EQ(stress[0], -0.45 * 101.0);
    EXPECT_DOUBLE_EQ(stress[2], -0.45 * 101.0);
    EXPECT_EQ(stress[3], 0.0);
    sigini_(stress, z, &six, &three, &one, &one, &one, &one, &one, names, 80);
    EXPECT_DOUBLE_EQ(stress[2], -101.0);
    EXPECT_DOUBLE_EQ(stress[1], -0.45 * 101.0);
    sigini_(stress, air, &four, &two, &one, &one, &one, &one, &one, names, 80);
    EXPECT_DOUBLE_EQ(stress[1], -1.0) << "the surface load alone";
}

TEST(InitialState, HandsTheUmatAVoidRatioAndAMemory) {
    const double coords[2] = {0.0, -10.0};
    const int two = 2, four = 4;
    UmatCall call = UmatCall::hochstetten();
    call.use_components(4);
    sigini_(call.stress.data(), coords, &four, &two, &one, &one, &one, &one, &one, names, 80);
    sdvini_(call.statev.data(), coords, &call.nstatv, &two, &one, &one, &one, &one);
    const double p = 101.0 * 1.9 / 3.0;
    EXPECT_NEAR(call.statev[6], 0.65 * std::exp(-std::pow(3.0 * p / 1.6e6, 0.19)), 1e-15);
    EXPECT_EQ(call.statev[1], -1e-4) << "the vertical component of h";
    EXPECT_EQ(call.statev[0], 0.0);
    const double e = call.statev[6];
    call.set_dstran(0, -1e-5, 0);
    call.run();
    EXPECT_EQ(call.pnewdt, 1.0);
    EXPECT_NEAR(call.statev[6], e, 1e-4);
    EXPECT_LT(call.stress[1], -101.0);
    EXPECT_TRUE(call.in_bounds());
}

}  // namespace
