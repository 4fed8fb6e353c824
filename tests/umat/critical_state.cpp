// SPDX-License-Identifier: BSD-3-Clause
#include "support/states.hpp"

namespace {

using namespace tests;

constexpr int angles = 24;

struct CriticalState {
    State x;
    Vec n;  // direction of T_hat*
};

CriticalState critical_state(const Sand& sand, double p, const Vec& n) {
    State x;
    x.T = stress_with(p, critical_obliquity(sand, n), n);
    x.e = void_ratios(sand, p).e_c;
    return {x, n};
}

template <class Check> void at_critical_states(Check check) {
    for (const Sand& sand : four_sands())
        for (int i = 0; i < angles; ++i) {
            SCOPED_TRACE(sand.name + ", Lode angle " + std::to_string(360 / angles * i));
            const double theta = 2.0 * M_PI / angles * i;
            check(sand, critical_state(sand, 150.0, deviatoric_direction(theta)));
        }
}

double sine_of(const Sand& sand) { return std::sin(sand.p.critical_friction_angle); }

TEST(CriticalState, FlowsAtConstantStressAndVolume) {
    at_critical_states([](const Sand& sand, const CriticalState& c) {
        const Vec D = -c.n;
        const Rate r = basic_rate(sand, c.x, D);
        const double elastic = (stiffness_L(sand, c.x.T, c.x.e) * D).norm();
        EXPECT_LE(r.T.norm(), 1e-12 * elastic);
        EXPECT_LE(std::fabs(r.e), 1e-14);
    });
}

TEST(CriticalState, DoesNotFlowInAnotherDirection) {
    at_critical_states([](const Sand& sand, const CriticalState& c) {
        const Vec D = c.n;
        const double elastic = (stiffness_L(sand, c.x.T, c.x.e) * D).norm();
        EXPECT_GE(basic_rate(sand, c.x, D).T.norm(), 0.5 * elastic);
    });
}

TEST(CriticalState, LiesOnTheSurfaceOfMatsuokaAndNakai) {
    at_critical_states([](const Sand& sand, const CriticalState& c) {
        const double I1 = trace(c.x.T);
        const double I2 = 0.5 * (I1 * I1 - c.x.T.squaredNorm());
        const double I3 = full(c.x.T).determinant();
        const double s_sq = sine_of(sand) * sine_of(sand);
        const double expected = (9.0 - s_sq) / (1.0 - s_sq);
        EXPECT_NEAR(I1 * I2 / I3 / expected, 1.0, 1e-12);
    });
}

double stress_ratio(const Sand& sand, const Vec& n) {
    const State x = critical_state(sand, 150.0, n).x;
    return std::sqrt(1.5) * deviator(x.T).norm() / (-trace(x.T) / 3.0);
}

TEST(CriticalState, HasTheCriticalFrictionAngleInTriaxialCompression) {
    for (const Sand& sand : four_sands()) {
        const Vec n = deviatoric_direction(0.0);
        const double s = sine_of(sand);
        EXPECT_NEAR(stress_ratio(sand, n) / (6.0 * s / (3.0 - s)), 1.0, 1e-12) << sand.name;
        const State x = critical_state(sand, 150.0, n).x;
        EXPECT_NEAR(factors(sand, x.T, x.e).F, 1.0, 1e-14) << sand.name;
    }
}

TEST(CriticalState, HasTheCriticalFrictionAngleInTriaxialExtension) {
    for (const Sand& sand : four_sands()) {
        const double s = sine_of(sand);
        const double ratio = stress_ratio(sand, -deviatoric_direction(0.0));
        EXPECT_NEAR(ratio / (6.0 * s / (3.0 + s)), 1.0, 1e-12) << sand.name;
    }
}

}  // namespace
