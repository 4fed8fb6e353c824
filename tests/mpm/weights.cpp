// SPDX-License-Identifier: BSD-3-Clause
// V1: the weights of a particle, as its forces show them.
#include <gtest/gtest.h>

#include "support/one_particle.hpp"

namespace {

using namespace mpm_test;

// S, G, T of a node by 2 x 2 Gauss points of the domain, from the corner values of its shape function.
struct Weights {
    double S = 0.0, G_r = 0.0, G_z = 0.0, T = 0.0;
};

Weights by_gauss(OneParticle& q, int i, int j, bool axisymmetric) {
    const double r_p = q[column::r], z_p = q[column::z];
    const double r1[2] = {q[column::F_rr] * q[column::l_r], q[column::F_zr] * q[column::l_r]};
    const double r2[2] = {q[column::F_rz] * q[column::l_z], q[column::F_zz] * q[column::l_z]};
    const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double g = 1.0 / std::sqrt(3.0), det = r1[0] * r2[1] - r1[1] * r2[0];
    const double W = axisymmetric ? 4.0 * det * r_p : 4.0 * det;
    Weights out;
    for (const double a : {-g, g})
        for (const double b : {-g, g}) {
            const double radius = axisymmetric ? r_p + a * r1[0] + b * r2[0] : 1.0;
            double N = 0.0, N_a = 0.0, N_b = 0.0;
            for (const auto& c : corner) {
                const double value = q.hat(i, j, r_p + c[0] * r1[0] + c[1] * r2[0],
                                           z_p + c[0] * r1[1] + c[1] * r2[1]);
                N += 0.25 * (1 + c[0] * a) * (1 + c[1] * b) * value;
                N_a += 0.25 * c[0] * (1 + c[1] * b) * value;
                N_b += 0.25 * (1 + c[0] * a) * c[1] * value;
            }
            out.S += N * radius * det / W;
            out.G_r += (N_a * r2[1] - N_b * r1[1]) * radius / W;
            out.G_z += (N_b * r1[0] - N_a * r2[0]) * radius / W;
            if (axisymmetric) out.T += N * det / W;
        }
    return out;
}

class Weight : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Of, Weight, testing::Bool(), [](const auto& kind) {
    return kind.param ? "Axisymmetry" : "PlaneStrain";
});

TEST_P(Weight, OfAParallelogramIsItsGaussIntegral) {
    std::mt19937 generator(1);
    for (int sample = 0; sample < 200; ++sample) {
        OneParticle q = OneParticle::random(generator, GetParam());
        const auto G_r = q.force_weights(Shape::cpdi, GetParam(), column::S_rz, record::f_z);
        const auto G_z = q.force_weights(Shape::cpdi, GetParam(), column::S_rz, record::f_r);
        const auto zz = q.force_weights(Shape::cpdi, GetParam(), column::S_zz, record::f_z);
        const auto rr = q.force_weights(Shape::cpdi, GetParam(), column::S_rr, record::f_r);
        const auto T = q.force_weights(Shape::cpdi, GetParam(), column::S_tt, record::f_r);
        for (int j = 0, k = 0; j < q.z.nodes(); ++j)
            for (int i = 0; i < q.r.nodes(); ++i, ++k) {
                const Weights w = by_gauss(q, i, j, GetParam());
                const auto n = static_cast<std::size_t>(k);
                const double m = q[column::mass], slope = 1.0 / 0.01;
                EXPECT_NEAR(q.nodes[n][record::m], w.S * m, 1e-12 * m);
                EXPECT_NEAR(q.nodes[n][record::p_r], w.S * m * q[column::v_r], 1e-12 * m);
                EXPECT_NEAR(q.nodes[n][record::p_z], w.S * m * q[column::v_z], 1e-12 * m);
                EXPECT_NEAR(G_r[n], w.G_r, 1e-12 * slope);
                EXPECT_NEAR(rr[n], w.G_r, 1e-12 * slope);
                EXPECT_NEAR(G_z[n], w.G_z, 1e-12 * slope);
                EXPECT_NEAR(zz[n], w.G_z, 1e-12 * slope);
                EXPECT_NEAR(T[n], w.T, 1e-12 * slope);
            }
    }
}

TEST_P(Weight, SumsToOneAndItsGradientsToThoseOfALinearField) {
    std::mt19937 generator(2);
    for (int sample = 0; sample < 200; ++sample) {
        OneParticle q = OneParticle::random(generator, GetParam());
        for (const Shape shape : {Shape::cpdi, Shape::cpdi_published, Shape::ugimp, Shape::point}) {
            const auto G_r = q.force_weights(shape, GetParam(), column::S_rr, record::f_r);
            const auto G_z = q.force_weights(shape, GetParam(), column::S_zz, record::f_z);
            const auto T = q.force_weights(shape, GetParam(), column::S_tt, record::f_r);
            double mass = 0.0, sum[2] = {}, slope[2][2] = {}, hoop = 0.0;
            for (int j = 0, k = 0; j < q.z.nodes(); ++j)
                for (int i = 0; i < q.r.nodes(); ++i, ++k) {
                    const auto n = static_cast<std::size_t>(k);
                    mass += q.nodes[n][record::m];
                    sum[0] += G_r[n];
                    sum[1] += G_z[n];
                    slope[0][0] += G_r[n] * q.r[i];
                    slope[0][1] += G_r[n] * q.z[j];
                    slope[1][0] += G_z[n] * q.r[i];
                    slope[1][1] += G_z[n] * q.z[j];
                    hoop += T[n] * q.r[i];
                }
            EXPECT_NEAR(mass, q[column::mass], 1e-13 * q[column::mass]);
            EXPECT_NEAR(sum[0], 0.0, 1e-10);
            EXPECT_NEAR(sum[1], 0.0, 1e-10);
            EXPECT_NEAR(slope[0][0], 1.0, 1e-11);
            EXPECT_NEAR(slope[1][1], 1.0, 1e-11);
            EXPECT_NEAR(slope[1][0], 0.0, 1e-11);
            EXPECT_NEAR(slope[0][1], 0.0, 1e-11);
            if (GetParam()) EXPECT_NEAR(hoop, 1.0, 1e-12);
            else EXPECT_EQ(hoop, 0.0);
        }
    }
}

// What a node that is hardly reached bears: with S the mean of a hat over [x - l, x + l] and G that of its slope, 1/h at the
// most, G^2 l <= S/h. Were S but a few bits less, a free body would burst.
TEST(Ugimp, LeavesANodeTheMassThatItsForceNeedsHoweverLittleItIsReached) {
    std::mt19937 generator(3);
    int reached = 0;
    for (int sample = 0; sample < 4000; ++sample) {
        OneParticle q = OneParticle::random(generator, false);
        q[column::F_rr] = q[column::F_zz] = 1.0;
        q[column::F_rz] = q[column::F_zr] = 0.0;
        if (sample % 4 == 0) q[column::l_r] *= 1e-4;  // seen as an eighth of its cell
        const double side = sample % 2 ? 1.0 : -1.0, l = std::max(q[column::l_r], 0.01);
        double& x = q[column::r] = q.r[3 + sample % 3] - side * l;
        for (int ulps = sample % 9 - 4; ulps != 0; ulps -= ulps > 0 ? 1 : -1)
            x = std::nextafter(x, ulps > 0 ? 1.0 : 0.0);
        const auto G = q.force_weights(Shape::ugimp, false, column::S_rr, record::f_r);
        for (std::size_t n = 0; n < G.size(); ++n) {
            const double S = q.nodes[n][record::m] / q[column::mass];
            reached += S > 0.0 && S < 1e-12;
            EXPECT_LE(G[n] * G[n] * l, (1.0 + 1e-9) * S / 0.08) << sample << " node " << n;
        }
    }
    EXPECT_GT(reached, 100);
}

}  // namespace
