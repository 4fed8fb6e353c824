// SPDX-License-Identifier: BSD-3-Clause
// Hochstetten sand, isotropic 100 kPa, e = 0.70, h = 0, 0.5 % oedometric compression: numbers that
// other codes have published.
#include "support/update.hpp"

namespace {

using namespace tests;

constexpr double agreement = 5e-4;

class HochstettenOedometer : public testing::Test {
  protected:
    HochstettenOedometer() : sand(sand_named("hochstetten")) {
        x.T = -100.0 * identity();
        x.e = 0.70;
    }
    void compress(double strain) { x = updated(sand, x, principal(-strain, 0.0, 0.0)); }

    Sand sand;
    State x;
};

void expect_agreement(double value, double published) {
    EXPECT_NEAR(value / published, 1.0, agreement) << value;
}

TEST_F(HochstettenOedometer, ReachesThePublishedAxialStress) {
    compress(0.005);
    expect_agreement(x.T[0], -294.3);
    EXPECT_NEAR(x.T[0], -294.27458, 2e-5 * 294.27458);
}

TEST_F(HochstettenOedometer, HasThePublishedSecantOfLoading) {
    compress(0.0049);
    const double before = x.T[0];
    compress(1e-4);
    expect_agreement((before - x.T[0]) / 1e-4, 29080.15);
}

TEST_F(HochstettenOedometer, HasThePublishedSecantOfUnloading) {
    compress(0.005);
    const double before = x.T[0];
    compress(-1e-4);
    expect_agreement((x.T[0] - before) / 1e-4, 316557.1);
}

TEST_F(HochstettenOedometer, HasTheTangentsOfLoadingAndUnloading) {
    compress(0.005);
    const Vec axial = principal(1.0, 0.0, 0.0);
    expect_agreement(stiffness_M(sand, x, -axial)(0, 0), 29176.6);
    expect_agreement(stiffness_M(sand, x, axial)(0, 0), 329688.0);
}

TEST_F(HochstettenOedometer, ReturnsTheLoadingTangentWithTheUpdate) {
    compress(0.0049);
    for (const int tangent : {GRIT_TANGENT_CONTINUUM, GRIT_TANGENT_CONSISTENT}) {
        Point point = point_of(x);
        const double strain[6] = {-1e-4, 0.0, 0.0, 0.0, 0.0, 0.0};
        const Outcome out = update(sand, point, strain, options_with(1e-5, tangent));
        EXPECT_NEAR(out.tangent[0] / 29176.6, 1.0, 5e-3);
    }
}

TEST(ConstantVolumeShear, ReachesTheReferenceStressOfLausitzSand) {
    const Sand sand = sand_named("lausitz");
    State x;
    x.T = -100.0 * identity();
    x.h = -sand.p.elastic_strain_radius / std::sqrt(3.0) * identity();
    x.e = 0.60;
    for (int i = 0; i < 20; ++i)
        x = updated(sand, x, Vec(0.0, 0.0, 0.0, 0.10 / 20 / root_2, 0.0, 0.0));
    expect_agreement(x.T[3] / root_2, 70.528);
    for (int i = 0; i < 3; ++i) expect_agreement(x.T[i], -110.293);
}

}  // namespace
