// SPDX-License-Identifier: BSD-3-Clause
// Stick, slip, release, and the energy that friction stores and takes.
#include "support/penalty.hpp"

namespace {

using namespace tests;

constexpr double eps = 1e6, depth = 0.01, mu = 0.4, dt = 1e-3;

struct Slider {
    Surface a{chain({{-0.5, -depth}, {0.5, -depth}}, {1})};
    Surface b = ground(-2.0, 2.0, 1);
    Contact contact{eps, 0.5, mu};

    void step(double slip) {
        for (Point& v : a.v) v = {slip / dt, 0.0};
        contact(a, b);
    }
    double traction() const { return -a.history[0][GRIT_PENALTY_TANGENTIAL_TRACTION]; }
};

TEST(PenaltyFriction, SticksElasticallyThenSlipsAtCoulombsLimit) {
    Slider x;
    const double limit = mu * eps * depth;  // reached after a slip of mu depth
    for (int i = 1; i <= 10; ++i) {
        x.step(0.1 * mu * depth);
        EXPECT_NEAR(x.a.sum()[0], -std::min(0.1 * i, 1.0) * limit, 1e-12 * limit);
        EXPECT_NEAR(x.contact.totals.energy_tangential, 0.005 * i * i * limit * mu * depth,
                    1e-12 * limit);
    }
    x.step(mu * depth);
    EXPECT_EQ(x.a.reports[0].state, GRIT_PENALTY_SLIP);
    EXPECT_EQ(x.contact.totals.slips, 2);
    EXPECT_NEAR(x.a.sum()[0], -limit, 1e-12 * limit);
    EXPECT_NEAR(x.contact.totals.dissipation, limit * mu * depth, 1e-12 * limit);
    x.step(-0.5 * mu * depth);  // back: elastic at once
    EXPECT_EQ(x.a.reports[0].state, GRIT_PENALTY_STICK);
    EXPECT_EQ(x.contact.totals.slips, 0);
    EXPECT_NEAR(x.a.sum()[0], -0.5 * limit, 1e-12 * limit);
    EXPECT_NEAR(x.contact.totals.dissipation, 0.0, 1e-12 * limit);
}

TEST(PenaltyFriction, HasItsOwnStiffness) {
    Slider x;
    x.contact.options.tangential_stiffness = 0.25 * eps;
    x.step(0.001);
    EXPECT_NEAR(x.a.sum()[0], -0.25 * eps * 0.001, 1e-9);
    EXPECT_NEAR(x.contact.totals.energy_tangential, 0.125 * eps * 1e-6, 1e-9);
}

TEST(PenaltyFriction, IsForgottenOnRelease) {
    Slider x;
    x.step(0.5 * mu * depth);
    EXPECT_NE(x.traction(), 0.0);
    x.a.move({0.0, 2.0 * depth});
    x.step(0.0);
    for (const Point& h : x.a.history) EXPECT_EQ(norm(h), 0.0);
    EXPECT_EQ(x.contact.totals.energy_tangential, 0.0);
    x.a.move({0.0, -2.0 * depth});
    x.step(0.0);
    EXPECT_EQ(x.a.sum()[0], 0.0);
    EXPECT_NEAR(x.a.sum()[1], eps * depth, 1e-9);
}

TEST(PenaltyFriction, FollowsTheNormalTractionDown) {
    Slider x;
    x.step(mu * depth);
    x.a.move({0.0, 0.75 * depth});
    x.step(0.0);
    EXPECT_NEAR(x.a.sum()[0], -0.25 * mu * eps * depth, 1e-9);
    EXPECT_EQ(x.contact.totals.slips, 2);
}

// In the step of the touch only the way after it counts: here the last quarter.
TEST(PenaltyFriction, CountsFromTheTouchOn) {
    Slider x;
    for (Point& v : x.a.v) v = {0.002 / dt, -4.0 * depth / dt};
    x.contact(x.a, x.b);
    EXPECT_NEAR(x.a.sum()[0], -eps * 0.0005, 1e-9);
    x.contact(x.a, x.b);  // now in contact
    EXPECT_NEAR(x.a.sum()[0], -eps * 0.0025, 1e-9);
}

TEST(PenaltyFriction, ObeysCoulombEverywhere) {
    std::mt19937_64 random(421);
    int slips = 0, sticks = 0;
    for (int i = 0; i < 200; ++i) {
        Surface a = blob(random, {0.0, 0.0}, 40), b = blob(random, {1.7, 0.3}, 30);
        Contact contact(eps, 0.4, mu);
        for (int step = 0; step < 5; ++step) {
            stir(random, a, 30.0);
            stir(random, b, 30.0);
            contact(a, b);
            for (const Surface* body : {&a, &b})
                for (const auto& r : body->reports) {
                    if (r.state == GRIT_PENALTY_OPEN) continue;
                    const double limit = mu * r.normal_traction;
                    EXPECT_LE(std::fabs(r.tangential_traction), limit * (1.0 + 1e-12));
                    EXPECT_TRUE(r.state == GRIT_PENALTY_STICK ||
                                std::fabs(r.tangential_traction) >= limit * (1.0 - 1e-12));
                    (r.state == GRIT_PENALTY_SLIP ? slips : sticks) += 1;
                }
        }
    }
    EXPECT_GT(slips, 500);
    EXPECT_GT(sticks, 500);
}

// Work of friction = stored + dissipated, in every step of any path at constant depth.
TEST(PenaltyFriction, StoresOrDissipatesWhatItIsGiven) {
    std::mt19937_64 random(422);
    Slider x;
    double work = 0.0, dissipated = 0.0, before = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const double slip = uniform(random, -1.0, 1.0) * mu * depth;
        x.step(slip);
        EXPECT_GE(x.contact.totals.energy_tangential, 0.0);
        EXPECT_GE(x.contact.totals.dissipation, 0.0);
        dissipated += x.contact.totals.dissipation;
        // the elastic part of the way at the mean of both tractions, the rest at the limit
        const double now = -x.a.sum()[0], elastic = (now - before) / eps;
        work += 0.5 * (now + before) * elastic + now * (slip - elastic);
        before = now;
        EXPECT_NEAR(work, x.contact.totals.energy_tangential + dissipated,
                    1e-10 * (1.0 + dissipated));
    }
    EXPECT_GT(dissipated, 1.0);
}

TEST(PenaltyFriction, StoresNoNegativeEnergyOnRandomPathsInBothGeometries) {
    std::mt19937_64 random(423);
    for (const int axisymmetric : {0, 1})
        for (int i = 0; i < 100; ++i) {
            Surface a = blob(random, {3.0, 0.0}, 40), b = blob(random, {4.7, 0.3}, 30);
            Contact contact(eps, 0.4, mu);
            contact.options.axisymmetric = axisymmetric;
            for (int step = 0; step < 20; ++step) {
                const Point u{uniform(random, -0.02, 0.02), uniform(random, -0.02, 0.02)};
                for (Point& v : a.v) v = (1.0 / dt) * u;
                a.move(u);
                contact(a, b);
                EXPECT_GE(contact.totals.energy_tangential, 0.0);
                EXPECT_GE(contact.totals.energy_normal,
                          contact.totals.energy_tangential / mu / mu * (1.0 - 1e-12));
                EXPECT_GE(contact.totals.dissipation, 0.0);
            }
        }
}

// In a re-entrant corner of which one side turns, the corner turns half as fast.
TEST(PenaltyFriction, InACornerSlipsAgainstTheMeanOfBothSides) {
    Surface corner(std::vector<Point>{{4.0, 2.0}, {2.0, 2.0}, {2.0, 4.0}});
    Surface probe(std::vector<Point>{{0.8, 2.7}, {1.8, 1.8}, {2.7, 0.8}});
    const double omega = 3.0;
    corner.v[2] = {-2.0 * omega, 0.0};
    Contact contact(eps, 0.4, mu);
    contact(probe, corner);
    ASSERT_EQ(contact.totals.contacts_a, 1);
    EXPECT_NEAR(probe.reports[1].gap, -0.2 * std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(probe.reports[1].slip_rate, 0.2 * std::sqrt(2.0) * 0.5 * omega, 1e-14);
}

}  // namespace
