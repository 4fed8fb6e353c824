// SPDX-License-Identifier: BSD-3-Clause
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

State with_memory(State x, const Sand& sand, double rho, const Vec& direction) {
    x.h = rho * sand.p.elastic_strain_radius * direction;
    return x;
}

// Expected stress rate, T_rate and its elastic scale, at 50 random states of the four sands.
template <class Case> void at_random_states(std::uint64_t seed, Case check) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(seed);
        for (int i = 0; i < 50; ++i) check(sand, random_state(sand, random), random);
    }
}

void expect_rate(const Sand& sand, const State& x, const Vec& D, const Vec& expected) {
    EXPECT_LE((rate(sand, x, D).T - expected).norm(), 1e-12 * expected.norm());
    EXPECT_LE((stiffness_M(sand, x, D) * D - expected).norm(), 1e-12 * expected.norm());
}

TEST(IntergranularStiffness, IsTheReversalStiffnessWhenStrainIsReversed) {
    at_random_states(91, [](const Sand& sand, const State& s, Random& random) {
        const Vec D = random.direction();
        const State x = with_memory(s, sand, random.uniform(), -D);
        expect_rate(sand, x, D, sand.p.reversal_stiffness * stiffness_L(sand, x.T, x.e) * D);
    });
}

TEST(IntergranularStiffness, IsTheTransverseStiffnessAcrossAFullyMobilisedMemory) {
    at_random_states(92, [](const Sand& sand, const State& s, Random& random) {
        const Vec h_hat = random.direction();
        const Vec D = across(random.direction(), h_hat).normalized();
        const State x = with_memory(s, sand, 1.0, h_hat);
        expect_rate(sand, x, D, sand.p.transverse_stiffness * stiffness_L(sand, x.T, x.e) * D);
    });
}

TEST(IntergranularStiffness, IsTheReversalStiffnessInEveryDirectionWithoutMemory) {
    at_random_states(93, [](const Sand& sand, const State& s, Random& random) {
        const Vec D = random.direction();
        const State x = with_memory(s, sand, 0.0, D);
        expect_rate(sand, x, D, sand.p.reversal_stiffness * stiffness_L(sand, x.T, x.e) * D);
    });
}

TEST(IntergranularStiffness, IsBasicHypoplasticityAlongAFullyMobilisedMemory) {
    at_random_states(94, [](const Sand& sand, const State& s, Random& random) {
        const Vec D = random.uniform(0.1, 10.0) * random.direction();
        const State x = with_memory(s, sand, 1.0, D.normalized());
        expect_rate(sand, x, D,
                    stiffness_L(sand, x.T, x.e) * D + stiffness_N(sand, x.T, x.e) * D.norm());
    });
}

TEST(IntergranularStiffness, RateIsContinuousBetweenLoadingAndUnloading) {
    at_random_states(95, [](const Sand& sand, const State& s, Random& random) {
        const Vec h_hat = random.direction();
        const Vec D = across(random.direction(), h_hat).normalized();
        const State x = with_memory(s, sand, random.uniform(), h_hat);
        const Rate loading = rate(sand, x, D + 1e-10 * h_hat);
        const Rate unloading = rate(sand, x, D - 1e-10 * h_hat);
        EXPECT_LE((loading.T - unloading.T).norm(), 1e-8 * loading.T.norm());
        EXPECT_LE((loading.h - unloading.h).norm(), 1e-8);
    });
}

// F = 1 and T_hat:T_hat = 1/3 at an isotropic state: G0 = 3/2 m_R f_s in engineering shear.
TEST(IntergranularStiffness, GivesTheSmallStrainShearModulusAtIsotropicStress) {
    for (const Sand& sand : four_sands())
        for (const double p : {10.0, 100.0, 1000.0}) {
            State x;
            x.T = -p * identity();
            x.e = void_ratio_at(sand, p, 0.5);
            const double G0 = 1.5 * sand.p.reversal_stiffness * factors(sand, x.T, x.e).f_s;
            double M[36];
            const double D[6] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
            ASSERT_EQ(grit_sand_intergranular_stiffness(sand, voigt_stress(x.T).data(),
                                                        state_array(x).data(), D, M),
                      GRIT_OK);
            for (const int shear : {3, 4, 5}) EXPECT_NEAR(M[7 * shear] / G0, 1.0, 1e-12);
            Point point = point_of(x);
            const double gamma = 1e-9;
            const double strain[6] = {0.0, 0.0, 0.0, gamma, 0.0, 0.0};
            ASSERT_EQ(update(sand, point, strain, options_with(1e-12)).status, GRIT_OK);
            EXPECT_NEAR(point.stress[3] / gamma / G0, 1.0, 1e-6) << sand.name;
        }
}

TEST(IntergranularStiffness, IsNotThereWithoutIntergranularStrain) {
    const Sand with_memory = four_sands()[0];
    grit_sand_parameters p = with_memory.p;
    for (double* each : {&p.reversal_stiffness, &p.transverse_stiffness, &p.elastic_strain_radius,
                         &p.evolution_exponent, &p.stiffness_interpolation_exponent})
        *each = NAN;
    grit_sand plain;
    ASSERT_EQ(grit_sand_prepare(&p, &plain, nullptr), GRIT_OK);
    State x;
    x.T = -100.0 * identity();
    x.e = void_ratio_at(with_memory, 100.0, 0.5);
    const double D[6] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    double M[36];
    EXPECT_EQ(grit_sand_intergranular_stiffness(&plain, voigt_stress(x.T).data(),
                                                state_array(x).data(), D, M),
              GRIT_BAD_CALL);
}

}  // namespace
