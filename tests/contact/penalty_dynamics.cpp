// SPDX-License-Identifier: BSD-3-Clause
// The stable step, and impacts in explicit steps.
#include "../larger.hpp"
#include "support/penalty.hpp"

namespace {

using namespace tests;

constexpr double eps = 1e6, infinite = std::numeric_limits<double>::infinity();

double stable_step(const std::vector<double>& m_a, const std::vector<double>& k_a,
                   const std::vector<double>& m_b, const std::vector<double>& k_b) {
    const auto view = [](const std::vector<double>& x) { return grit_view_of(x.data(), 1, 1); };
    const grit_view views[4] = {view(m_a), view(k_a), view(m_b), view(k_b)};
    double step = 0.0;
    EXPECT_EQ(grit_penalty_stable_step(static_cast<std::ptrdiff_t>(m_a.size()), &views[0],
                                       &views[1], static_cast<std::ptrdiff_t>(m_b.size()),
                                       &views[2], &views[3], &step, nullptr),
              GRIT_OK);
    return step;
}

// A rigid punch that a large dead load keeps in contact, on a ground at rest or free to move.
struct Oscillator {
    Surface a = punch(-0.5, 0.5, 0.01, 2), b = ground(-0.6, 0.6, 3);
    Contact contact{eps, 10.0};
    double m_a = 2.0, m_b = infinite;
    double v_a = 0.0, v_b = 0.0, load = 1e4;

    double step_of_s5() {
        contact(a, b);
        double k_a = 0.0, k_b = 0.0;
        for (const double k : a.stiffness) k_a += k;  // one node each, N = 1
        for (const double k : b.stiffness) k_b += k;
        return m_b == infinite ? stable_step({m_a}, {k_a}, {}, {})
                               : stable_step({m_a}, {k_a}, {m_b}, {k_b});
    }
    // The largest distance from equilibrium, 0.01, in many steps.
    double run(double dt) {
        a.move({0.0, 1e-5});
        double largest = 0.0;
        for (int i = 0; i < 400; ++i) {
            contact(a, b);
            v_a += dt * (a.sum()[1] - load) / m_a;
            v_b += dt * (b.sum()[1] + load) / m_b;
            a.move({0.0, dt * v_a});
            b.move({0.0, dt * v_b});
            largest = larger(largest, std::fabs(b.x[0][1] - a.x[2][1] - 0.01));
            if (largest > 0.009) return infinite;
        }
        return largest;
    }
};

TEST(PenaltyStep, IsAsLongAsSoftSpringsAllow) {
    EXPECT_NEAR(stable_step({1.0}, {0.0}, {2.0}, {2e-3}), 2.0 / std::sqrt(1e-3), 1e-12);
    EXPECT_NEAR(stable_step({4.0, 1.0}, {4e-5, 1e-6}, {2.0}, {4e-5}), 2.0 / std::sqrt(3e-5), 1e-10);
    EXPECT_EQ(stable_step({1.0}, {0.0}, {}, {}), infinite);
}

TEST(PenaltyStep, IsTheLargestStableOneOfAMassOnAWall) {
    EXPECT_NEAR(Oscillator().step_of_s5(), 2.0 * std::sqrt(2.0 / eps), 1e-12);
    for (const double factor : {0.5, 0.99}) {
        Oscillator x;
        EXPECT_LE(x.run(factor * x.step_of_s5()), 2e-4) << factor;
    }
    Oscillator x;
    EXPECT_EQ(x.run(1.01 * x.step_of_s5()), infinite);
}

TEST(PenaltyStep, IsTheLargestStableOneOfTwoMasses) {
    for (const double m_b : {0.5, 2.0, 7.0}) {
        Oscillator stable, unstable;
        stable.m_b = unstable.m_b = m_b;
        const double step = stable.step_of_s5();
        EXPECT_NEAR(step, 2.0 / std::sqrt(eps * (1.0 / 2.0 + 1.0 / m_b)), 1e-12);
        EXPECT_LE(stable.run(0.99 * step), 2e-4) << m_b;
        EXPECT_EQ(unstable.run(1.01 * step), infinite) << m_b;
    }
}

TEST(PenaltyStep, CountsTheStifferOfBothSprings) {
    Surface a = punch(-0.5, 0.5, 0.01, 1), b = ground(-2.0, 2.0, 1);
    Contact contact(eps, 0.5, 0.3);
    contact.options.tangential_stiffness = 4.0 * eps;
    contact(a, b);
    EXPECT_NEAR(a.stiffness[2], 4.0 * eps * 0.5, 1e-6);
    EXPECT_NEAR(b.stiffness[0], 4.0 * eps * 0.5, 1e-6);
    contact.options.tangential_stiffness = 0.25 * eps;
    contact(a, b);
    EXPECT_NEAR(a.stiffness[2], eps * 0.5, 1e-6);
}

TEST(PenaltyStep, IsUnlimitedWithoutContactAndTakesTheWorstNode) {
    EXPECT_EQ(stable_step({1.0}, {0.0}, {}, {}), infinite);
    EXPECT_EQ(stable_step({}, {}, {}, {}), infinite);
    EXPECT_EQ(stable_step({0.0, 4.0, 1.0}, {0.0, 1.0, 4.0}, {}, {}), 1.0);
    EXPECT_EQ(stable_step({}, {}, {4.0, 1.0}, {1.0, 4.0}), 1.0);
}

TEST(PenaltyStep, BeforeAnyContactIsThatOfFlushContact) {
    Surface line(std::vector<Point>{{0.0, 0.0}, {1.0, 0.0}, {4.0, 0.0}});
    const grit_penalty_surface view = line.view();
    Contact contact(eps);
    ASSERT_EQ(grit_penalty_flush_stiffness(&contact.options, &view, nullptr), GRIT_OK);
    EXPECT_EQ(line.stiffness, (std::vector<double>{0.5 * eps, 2.0 * eps, 1.5 * eps}));
    line.clear();
    contact.options.axisymmetric = 1;  // integrals of r over the halves
    ASSERT_EQ(grit_penalty_flush_stiffness(&contact.options, &view, nullptr), GRIT_OK);
    EXPECT_NEAR(line.stiffness[0], eps * 0.125, 1e-6);
    EXPECT_NEAR(line.stiffness[1], eps * (0.375 + 0.5 * (2.5 * 2.5 - 1.0)), 1e-6);
    EXPECT_NEAR(line.stiffness[2], eps * 0.5 * (16.0 - 2.5 * 2.5), 1e-6);
}

TEST(PenaltyStep, OfAClosedLineCountsTheSegmentThatClosesIt) {
    Surface line(std::vector<Point>{{0.0, 0.0}, {3.0, 0.0}, {0.0, 4.0}}, true);
    const grit_penalty_surface view = line.view();
    const Contact contact(eps);
    ASSERT_EQ(grit_penalty_flush_stiffness(&contact.options, &view, nullptr), GRIT_OK);
    EXPECT_EQ(line.stiffness, (std::vector<double>{3.5 * eps, 4.0 * eps, 4.5 * eps}));
}

TEST(PenaltyStiffness, IsAMultipleOfTheModulusOverTheCell) {
    double eps_n = 0.0;
    EXPECT_EQ(grit_penalty_stiffness(3.0, 2e7, 0.05, &eps_n), GRIT_OK);
    EXPECT_DOUBLE_EQ(eps_n, 1.2e9);
    EXPECT_EQ(grit_penalty_stiffness(0.0, 2e7, 0.05, &eps_n), GRIT_OK);
    EXPECT_DOUBLE_EQ(eps_n, 4e8);
    const double nan = std::nan("");
    for (const auto& bad : {std::array<double, 3>{-1, 1, 1},
                            {1, 0, 1},
                            {1, 1, 0},
                            {1, nan, 1},
                            {nan, 1, 1},
                            {1, 1, nan},
                            {1, infinite, 1},
                            {1e7, 1, 1}})
        EXPECT_EQ(grit_penalty_stiffness(bad[0], bad[1], bad[2], &eps_n), GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_stiffness(1.0, 1.0, 1.0, nullptr), GRIT_BAD_CALL);
    EXPECT_DOUBLE_EQ(eps_n, 4e8);
}

// A block falls on a ground at rest and leaves with the speed it came with.
TEST(PenaltyImpact, WithoutFrictionConservesEnergy) {
    for (const int parts : {1, 4, 9}) {
        Surface a = punch(-0.5, 0.5, -1e-9, parts), b = ground(-2.0, 2.0, 7);
        Contact contact(eps, 10.0);
        const double m = 2.0, dt = 1e-3 * 2.0 * std::sqrt(m / eps);
        double v = -1.0, largest = 0.0;
        int steps = 0;
        do {
            contact(a, b);
            const double v_before = v;
            v += dt * a.sum()[1] / m;
            const double kinetic = 0.5 * m * v_before * v;  // at the time of the forces
            largest = larger(largest, std::fabs(kinetic + contact.totals.energy_normal - 1.0));
            a.move({0.0, dt * v});
        } while (++steps < 100000 && (v < 0.0 || contact.totals.contacts_a > 0));
        EXPECT_LE(largest, 2e-3) << parts;
        EXPECT_NEAR(v, 1.0, 1e-3) << parts;
        EXPECT_NEAR(steps * dt, 3.14159265 * std::sqrt(m / eps), 1e-2 * 3.14 * std::sqrt(m / eps));
    }
}

// Sliding with friction: what kinetic energy loses is stored or dissipated.
TEST(PenaltyImpact, WithFrictionLosesWhatFrictionTakes) {
    Surface a = punch(-0.5, 0.5, 0.01, 3), b = ground(-5.0, 5.0, 1);
    Contact contact(eps, 10.0, 0.3);
    const double m = 100.0, dt = 1e-4;
    contact.options.time_step = dt;
    double u = 3.0, x = 0.0, lost = 0.0;
    for (int i = 0; i < 200000 && u > 0.0; ++i) {
        for (Point& v : a.v) v = {u, 0.0};
        a.move({dt * u, 0.0});
        x += dt * u;
        contact(a, b);
        lost += contact.totals.dissipation;
        u += dt * a.sum()[0] / m;
    }
    const double deceleration = 0.3 * eps * 0.01 / m;
    EXPECT_NEAR(x, 9.0 / (2.0 * deceleration), 0.01 * x);
    EXPECT_NEAR(lost + contact.totals.energy_tangential, 0.5 * m * 9.0, 0.01 * 450.0);
}

}  // namespace
