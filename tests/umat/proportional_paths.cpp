// SPDX-License-Identifier: BSD-3-Clause
#include "support/states.hpp"

namespace {

using namespace tests;

// |T_rate - its part along T| / |T_rate|
double angle_to_stress(const Vec& T_rate, const Vec& T) {
    return across(T_rate, T.normalized()).norm() / T_rate.norm();
}

TEST(ProportionalPaths, OedometricStrainKeepsTheStressRatioOfTheAttractor) {
    for (const Sand& sand : four_sands())
        for (const double p : {20.0, 500.0})
            for (const double looseness : {0.3, 0.7, 1.0}) {
                SCOPED_TRACE(sand.name);
                State x;
                x.e = void_ratio_at(sand, p, looseness);
                const grit_sand_scalar_factors f = factors(sand, -p * identity(), x.e);
                const double K0 = f.a * f.f_d / (3.0 + f.a * f.f_d);
                x.T = -3.0 * p / (1.0 + 2.0 * K0) * principal(1.0, K0, K0);
                const Vec D = principal(-1.0, 0.0, 0.0);
                EXPECT_LE(angle_to_stress(basic_rate(sand, x, D).T, x.T), 1e-12);
            }
}

TEST(ProportionalPaths, AtTheCriticalDensityTheOedometricRatioOfLausitzSandIsKnown) {
    const Sand sand = sand_named("lausitz");
    const double a = factors(sand, -100.0 * identity(), 0.7).a;
    EXPECT_NEAR(a / (3.0 + a), 0.479, 5e-4);
}

// T_hat* = F D* / (F tr D - f_d a |D|): solved for |T_hat*|, F depends on it.
TEST(ProportionalPaths, EveryCompressionHasAStressThatItKeepsProportional) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(5);
        for (int i = 0; i < 100; ++i) {
            const double p = random.log_uniform(20.0, 500.0);
            const double e = void_ratio_at(sand, p, random.uniform(0.2, 1.0));
            const Vec D = random.uniform(0.3, 1.0) * deviator(random.direction()).normalized() -
                          random.uniform(0.5, 1.5) * identity();
            const Vec n = -deviator(D).normalized();
            const grit_sand_scalar_factors f = factors(sand, -p * identity(), e);
            const double x = root_in(0.0, cone, [&](double y) {
                const double F = lode_factor(sand, y, n);
                return y * (f.f_d * f.a * D.norm() - F * trace(D)) - F * deviator(D).norm();
            });
            ASSERT_LT(x, 0.7);
            State s;
            s.T = stress_with(p, x, n);
            s.e = e;
            EXPECT_LE(angle_to_stress(basic_rate(sand, s, D).T, s.T), 1e-12);
        }
    }
}

}  // namespace
