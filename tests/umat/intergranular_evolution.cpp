// SPDX-License-Identifier: BSD-3-Clause
#include "support/paper.hpp"
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

double rho_of(const Sand& sand, const State& x) {
    return x.h.norm() / sand.p.elastic_strain_radius;
}

State start_at(const Sand& sand, double p) {
    State x;
    x.T = -p * identity();
    x.e = void_ratio_at(sand, p, 0.7);
    return x;
}

// eps/R at which rho is reached from 0 with beta_r = 1/2.
double path_to(double rho) {
    const double root = std::sqrt(rho);
    return -2.0 * (root + std::log(1.0 - root));
}

const Vec shear = Vec(0.0, 0.0, 0.0, 1.0, 0.0, 0.0);

TEST(IntergranularStrain, NeverExceedsItsRadius) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        const double R = sand.p.elastic_strain_radius;
        Random random(10);
        State x = start_at(sand, 1000.0);
        for (int i = 0; i < 2000; ++i) {
            const Vec D = deviator(random.direction());
            State y = start_at(sand, 1000.0);
            y.h = x.h;
            x = updated(sand, y, random.log_uniform(1e-7, 1e-3) * D);
            ASSERT_LE(x.h.norm(), R * (1.0 + 1e-12));
        }
    }
}

TEST(IntergranularStrain, EvolvesAlongAStraightPathAsTheScalarEquation) {
    for (const Sand& sand : four_sands())
        for (const double rho : {0.01, 0.3, 0.9, 0.999}) {
            State x = start_at(sand, 100.0);
            x.h = rho * sand.p.elastic_strain_radius * shear;
            const double expected = 1.0 - std::pow(rho, sand.p.evolution_exponent);
            EXPECT_NEAR(rate(sand, x, shear).h.dot(shear), expected, 1e-12) << sand.name;
        }
}

TEST(IntergranularStrain, SaturatesExponentiallyWithUnitExponent) {
    for (const Sand& original : four_sands()) {
        const Sand sand = with_evolution_exponent(original, 1.0);
        for (const double length : {0.1, 0.5, 1.0, 3.0, 8.0}) {
            const double R = sand.p.elastic_strain_radius;
            const State x = updated(sand, start_at(sand, 200.0), length * R * shear);
            EXPECT_NEAR(rho_of(sand, x), 1.0 - std::exp(-length), 1e-4) << sand.name;
        }
    }
}

TEST(IntergranularStrain, SaturatesAsItsFirstIntegralWithExponentOneHalf) {
    for (const Sand& original : four_sands()) {
        const Sand sand = with_evolution_exponent(original, 0.5);
        for (const double rho : {0.1, 0.5, 0.9, 0.99}) {
            const double R = sand.p.elastic_strain_radius;
            const State x = updated(sand, start_at(sand, 200.0), path_to(rho) * R * shear);
            EXPECT_NEAR(rho_of(sand, x), rho, 1e-4) << sand.name;
        }
    }
}

TEST(IntergranularStrain, VanishesOneRadiusAfterAFullReversal) {
    for (const Sand& sand : four_sands()) {
        const double R = sand.p.elastic_strain_radius;
        State x = start_at(sand, 100.0);
        x.h = -R * shear;
        const State y = updated(sand, x, R * shear);
        EXPECT_LE(y.h.norm(), 1e-12 * R) << sand.name;
    }
}

// Lengths in R at which rho^6 has recovered to 0.90, 0.95 and 0.99.
TEST(IntergranularStrain, RecoversOverThePublishedLengths) {
    const double lengths[] = {7.50, 8.92, 12.17};
    const double recovered[] = {0.90, 0.95, 0.99};
    for (const Sand& original : four_sands()) {
        const Sand sand = with_evolution_exponent(original, 0.5);
        const double R = sand.p.elastic_strain_radius;
        for (int i = 0; i < 3; ++i) {
            const double exact = path_to(std::pow(recovered[i], 1.0 / 6.0));
            EXPECT_NEAR(exact, lengths[i], 0.005);
            const State monotonic = updated(sand, start_at(sand, 200.0), exact * R * shear);
            EXPECT_NEAR(std::pow(rho_of(sand, monotonic), 6.0), recovered[i], 1e-4) << sand.name;
            State reversed = start_at(sand, 200.0);
            reversed.h = -R * shear;
            reversed = updated(sand, reversed, (exact + 1.0) * R * shear);
            EXPECT_NEAR(std::pow(rho_of(sand, reversed), 6.0), recovered[i], 1e-4) << sand.name;
        }
    }
}

TEST(IntergranularStrain, IsForgottenAfterStrainingFarAlongOneDirection) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        const double length = 10.0 * sand.p.elastic_strain_radius / sand.p.evolution_exponent;
        Random random(14);
        for (int i = 0; i < 20; ++i) {
            const Vec D = (deviator(random.direction()) - 0.2 * identity()).normalized();
            State x = start_at(sand, 200.0);
            x.h = random_memory(sand, random);
            x = updated(sand, x, length * D);
            const double elastic = (stiffness_L(sand, x.T, x.e) * D).norm();
            EXPECT_LE((rate(sand, x, D).T - basic_rate(sand, x, D).T).norm(), 5e-3 * elastic);
        }
    }
}

}  // namespace
