// SPDX-License-Identifier: BSD-3-Clause
#include "support/states.hpp"

namespace {

using namespace tests;

Vec flow_tensor(const Sand& sand, const Vec& T, double e) {
    return stiffness_L(sand, T, e).partialPivLu().solve(stiffness_N(sand, T, e));
}

// L^-1 N in closed form.
Vec closed_flow_tensor(const Sand& sand, const Vec& T, double e) {
    const grit_sand_scalar_factors f = factors(sand, T, e);
    const Vec T_hat = T / trace(T);
    const Vec sum = T_hat + deviator(T_hat);
    const double a_F = f.a / f.F;
    const double share = T_hat.dot(sum) / (1.0 / (a_F * a_F) + T_hat.squaredNorm());
    return f.f_d * a_F * (sum - share * T_hat);
}

TEST(Factors, OfTheVoidRatioAreThoseOfH7) {
    for (const Sand& sand : four_sands()) {
        Random random(7);
        for (int i = 0; i < 100; ++i) {
            const State x = random_state(sand, random);
            const auto [e_i, e_c, e_d] = void_ratios(sand, -trace(x.T) / 3.0);
            if (x.e <= e_d || x.e >= e_i) continue;
            const grit_sand_scalar_factors f = factors(sand, x.T, x.e);
            EXPECT_NEAR(f.f_e / std::pow(e_c / x.e, sand.p.stiffness_void_exponent), 1.0, 1e-12);
            EXPECT_NEAR(f.f_b * f.f_e / f.f_s, 1.0, 1e-14);
        }
    }
}

TEST(LimitSurface, FlowTensorHasItsClosedForm) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(6);
        for (int i = 0; i < 100; ++i) {
            const State x = random_state(sand, random);
            const Vec closed = closed_flow_tensor(sand, x.T, x.e);
            EXPECT_LE((flow_tensor(sand, x.T, x.e) - closed).norm(), 1e-12 * closed.norm());
        }
    }
}

TEST(LimitSurface, FlowTensorHasUnitLengthAtCriticalStates) {
    for (const Sand& sand : four_sands())
        for (int i = 0; i < 24; ++i) {
            const Vec n = deviatoric_direction(M_PI / 12.0 * i);
            const Vec T = stress_with(80.0, critical_obliquity(sand, n), n);
            const double e_c = void_ratios(sand, 80.0).e_c;
            EXPECT_NEAR(flow_tensor(sand, T, e_c).norm(), 1.0, 1e-12) << sand.name << " " << i;
        }
}

// Dense sand carries more: there too a direction exists in which the stress stands still.
TEST(LimitSurface, StressStandsStillAlongTheFlowTensorAtEveryDensity) {
    for (const Sand& sand : four_sands())
        for (const double looseness : {0.5, 0.8, 1.05}) {
            SCOPED_TRACE(sand.name + ", looseness " + std::to_string(looseness));
            const double e = void_ratio_at(sand, 200.0, looseness);
            for (int i = 0; i < 12; ++i) {
                const Vec n = deviatoric_direction(M_PI / 6.0 * i + 0.1);
                const double x = root_in(0.0, 0.75, [&](double y) {
                    return closed_flow_tensor(sand, stress_with(200.0, y, n), e).norm() - 1.0;
                });
                ASSERT_LT(x, 0.74);
                State s;
                s.T = stress_with(200.0, x, n);
                s.e = e;
                const Vec D = -closed_flow_tensor(sand, s.T, e);
                const double elastic = (stiffness_L(sand, s.T, e) * D).norm();
                EXPECT_LE(basic_rate(sand, s, D).T.norm(), 1e-12 * elastic);
                EXPECT_EQ(trace(D) > 0.0, looseness < 1.0);  // dense sand dilates
            }
        }
}

}  // namespace
