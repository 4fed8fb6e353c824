// SPDX-License-Identifier: BSD-3-Clause
// The operators against the printed equations.
#include "support/paper.hpp"
#include "support/states.hpp"

namespace {

using namespace tests;

template <class Check> void at_random_states(std::uint64_t seed, Check check) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(seed);
        for (int i = 0; i < 200; ++i) {
            const State x = random_state(sand, random, 1.0, 2000.0);
            check(sand, x, random.direction());
        }
    }
}

TEST(StressRate, IsThatOfVonWolffersdorff) {
    at_random_states(1, [](const Sand& sand, const State& x, const Vec& D) {
        const Vec expected = paper::basic_rate<double>(sand.p, x.T, x.e, D);
        EXPECT_LE((basic_rate(sand, x, D).T - expected).norm(), 1e-12 * expected.norm());
    });
}

// tan psi above 1 too, where no sand of a catalogue comes to rest.
TEST(StressRate, IsThatOfVonWolffersdorffAtAnySteepness) {
    Random random(9);
    for (const Sand& sand : four_sands())
        for (int i = 0; i < 200; ++i) {
            State x;
            const double p = random.log_uniform(1.0, 1e3), steep = random.uniform(0.5, 0.8);
            x.T = stress_with(p, steep, deviator(random.direction()).normalized());
            x.e = 0.7;
            const Vec D = random.direction();
            const Vec expected = paper::basic_rate<double>(sand.p, x.T, x.e, D);
            EXPECT_LE((basic_rate(sand, x, D).T - expected).norm(), 1e-12 * expected.norm());
        }
}

TEST(StressRate, IsThatOfNiemunisAndHerle) {
    at_random_states(2, [](const Sand& sand, const State& x, const Vec& D) {
        const Rate r = rate(sand, x, D);
        const Vec expected = paper::intergranular_rate<double>(sand.p, x.T, x.h, x.e, D);
        EXPECT_LE((r.T - expected).norm(), 1e-12 * expected.norm());
        // Grit keeps (G3) finite at u = 1 by 1e-12.
        EXPECT_LE((r.h - paper::memory_rate(sand.p, x.h, D)).norm(), 1e-11);
        EXPECT_NEAR(r.e, (1.0 + x.e) * trace(D), 1e-14);
    });
}

TEST(StressRate, IsTheProductOfTheOperatorsWithTheStrainRate) {
    at_random_states(3, [](const Sand& sand, const State& x, const Vec& D) {
        const Vec basic = stiffness_L(sand, x.T, x.e) * D + stiffness_N(sand, x.T, x.e) * D.norm();
        EXPECT_LE((basic_rate(sand, x, D).T - basic).norm(), 1e-12 * basic.norm());
        const Vec full = stiffness_M(sand, x, D) * D;
        EXPECT_LE((rate(sand, x, D).T - full).norm(), 1e-12 * full.norm());
    });
}

TEST(StressRate, FactorsAreThoseOfThePaper) {
    at_random_states(4, [](const Sand& sand, const State& x, const Vec&) {
        const grit_sand_scalar_factors f = factors(sand, x.T, x.e);
        const auto k = paper::parts<double>(sand.p, x.T, x.e);
        EXPECT_NEAR(f.a / k.a, 1.0, 1e-13);
        EXPECT_NEAR(f.F / k.F, 1.0, 1e-12);
        EXPECT_NEAR(f.f_d / k.f_d, 1.0, 1e-12);
        EXPECT_NEAR(f.f_e / k.f_e, 1.0, 1e-12);
        EXPECT_NEAR(f.f_b / k.f_b, 1.0, 1e-12);
        EXPECT_NEAR(f.f_s / k.f_s, 1.0, 1e-12);
    });
}

// (H10): stored is T, evaluated is T - p_t I.
TEST(StressRate, WithAPressureShiftIsThatOfTheShiftedStress) {
    for (const Sand& plain : four_sands()) {
        grit_sand_parameters p = plain.p;
        p.pressure_shift = 7.5;
        const Sand shifted = prepared(plain.name, p);
        Random random(10);
        for (int i = 0; i < 20; ++i) {
            const State x = random_state(plain, random);
            State y = x;
            y.T += 7.5 * identity();
            const Vec D = random.direction();
            const Vec expected = rate(plain, x, D).T;
            EXPECT_LE((rate(shifted, y, D).T - expected).norm(), 1e-12 * expected.norm());
        }
    }
}

}  // namespace
