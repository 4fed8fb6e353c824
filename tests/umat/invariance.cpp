// SPDX-License-Identifier: BSD-3-Clause
// Homogeneity, rate independence, objectivity.
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

// At fixed e/e_i: T_rate(lambda T) = lambda^(1-n) [(1+e_i')/e_i'] / [(1+e_i)/e_i] T_rate(T).
TEST(Homogeneity, StressRateGrowsWithThePowerOfPressure) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(7);
        for (int i = 0; i < 50; ++i) {
            const State x = random_state(sand, random);
            const Vec D = random.direction();
            const double p = -trace(x.T) / 3.0;
            const double e_i = void_ratios(sand, p).e_i;
            for (const double lambda : {0.1, 0.5, 2.0, 10.0}) {
                const double e_i_new = void_ratios(sand, lambda * p).e_i;
                State y = x;
                y.T *= lambda;
                y.e *= e_i_new / e_i;
                const double factor = std::pow(lambda, 1.0 - sand.p.stiffness_exponent) *
                                      ((1.0 + e_i_new) / e_i_new) / ((1.0 + e_i) / e_i);
                for (const auto igs : {Intergranular::off, Intergranular::on}) {
                    const Vec expected = factor * rate(sand, x, D, igs).T;
                    EXPECT_LE((rate(sand, y, D, igs).T - expected).norm(), 1e-12 * expected.norm());
                }
            }
        }
    }
}

TEST(RateIndependence, RatesAreOfDegreeOneInTheStrainRate) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(8);
        for (int i = 0; i < 50; ++i) {
            const State x = random_state(sand, random);
            const Vec D = random.direction();
            for (const auto igs : {Intergranular::off, Intergranular::on}) {
                const Rate one = rate(sand, x, D, igs);
                for (const double k : {1e-9, 0.3, 7.0, 1e6}) {
                    const Rate many = rate(sand, x, k * D, igs);
                    EXPECT_LE((many.T - k * one.T).norm(), 1e-12 * k * one.T.norm());
                    EXPECT_LE((many.h - k * one.h).norm(), 1e-12 * k);
                    EXPECT_NEAR(many.e, k * one.e, 1e-12 * k);
                }
            }
        }
    }
}

Full random_rotation_of_both(Random& random, Point& point) {
    const Full Q = random.rotation();
    double row_major[9];
    for (int i = 0; i < 9; ++i) row_major[i] = Q(i / 3, i % 3);
    EXPECT_EQ(grit_sand_rotate(row_major, point.stress, point.state), GRIT_OK);
    return Q;
}

TEST(Objectivity, RatesTurnWithStressMemoryAndStrainRate) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(9);
        for (int i = 0; i < 20; ++i) {
            const State x = random_state(sand, random);
            const Vec D = random.direction();
            Point point = point_of(x);
            const Full Q = random_rotation_of_both(random, point);
            for (const auto igs : {Intergranular::off, Intergranular::on}) {
                const Rate still = rate(sand, x, D, igs);
                const Rate turned = rate(sand, state_of(point), rotated(Q, D), igs);
                EXPECT_LE((turned.T - rotated(Q, still.T)).norm(), 1e-12 * still.T.norm());
                EXPECT_LE((turned.h - rotated(Q, still.h)).norm(), 1e-12);
            }
        }
    }
}

TEST(Objectivity, UpdatesTurnWithStressMemoryAndStrain) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(10);
        for (int i = 0; i < 20; ++i) {
            const State x = random_state(sand, random);
            const Vec dE = random.log_uniform(1e-6, 3e-3) * random.direction();
            Point point = point_of(x);
            const Full Q = random_rotation_of_both(random, point);
            const State still = updated(sand, x, dE);
            const State turned = updated(sand, state_of(point), rotated(Q, dE));
            EXPECT_LE((turned.T - rotated(Q, still.T)).norm(), 1e-12 * still.T.norm());
            EXPECT_LE((turned.h - rotated(Q, still.h)).norm(),
                      1e-12 * sand.p.elastic_strain_radius);
        }
    }
}

}  // namespace
