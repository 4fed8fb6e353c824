// SPDX-License-Identifier: BSD-3-Clause
// Forces by hand, and what holds for any two bodies.
#include "support/penalty.hpp"

namespace {

using namespace tests;

constexpr double eps = 1e6, depth = 0.01;

// One vertex at a quarter of a segment: F = eps g A, three quarters of the reaction to the near end.
TEST(PenaltyForce, OfAFlatPunchByHand) {
    Surface a = punch(-0.5, 0.5, depth, 1), b = ground(-2.0, 2.0, 1);
    Contact contact(eps);
    contact(a, b);
    EXPECT_EQ(contact.totals.contacts_a, 2);
    EXPECT_EQ(contact.totals.contacts_b, 0);
    const double F = eps * depth * 0.5;  // half of the base belongs to each corner
    for (const std::size_t v : {2, 3}) {
        EXPECT_NEAR(a.force[v][0], 0.0, 1e-12 * F);
        EXPECT_NEAR(a.force[v][1], F, 1e-12 * F);
        EXPECT_NEAR(a.reports[v].area, 0.5, 1e-14);
        EXPECT_NEAR(a.reports[v].gap, -depth, 1e-15);
        EXPECT_NEAR(a.reports[v].normal[1], 1.0, 1e-15);
        EXPECT_EQ(a.reports[v].segment, 0);
    }
    EXPECT_NEAR(a.reports[2].place, 0.625, 1e-15);  // the ground travels to the left
    EXPECT_NEAR(b.force[0][1], -F, 1e-12 * F);
    EXPECT_NEAR(b.force[1][1], -F, 1e-12 * F);
    EXPECT_NEAR(contact.totals.energy_normal, 0.5 * eps * depth * depth, 1e-10);
    EXPECT_NEAR(contact.totals.largest_penetration, depth, 1e-15);
    EXPECT_NEAR(contact.totals.contact_area, 1.0, 1e-13);
    EXPECT_NEAR(contact.totals.normal_force, eps * depth, 1e-9);
    EXPECT_NEAR(contact.totals.force_on_a[1], eps * depth, 1e-9);
    EXPECT_NEAR(contact.totals.force_on_b[1], -eps * depth, 1e-9);
}

// A wedge of slope s: overlap s-wide, the depth falls to nothing along w = depth / s on either side;
// what is less than half as deep counts less: three quarters of w.
TEST(PenaltyForce, OfAWedgeByHandReactsAtTheEndsByTheLeverRule) {
    Surface a(std::vector<Point>{{0.9, 0.1}, {1.0, -depth}, {1.1, 0.1}}), b = ground(0.0, 4.0, 1);
    Contact contact(eps);
    contact(a, b);
    const double w = 0.1 * depth / (0.1 + depth);
    const double F = eps * depth * 2.0 * 0.75 * w;
    EXPECT_NEAR(a.force[1][1], F, 1e-12 * F);
    EXPECT_NEAR(b.force[0][1], -0.25 * F, 1e-12 * F);  // at x = 4
    EXPECT_NEAR(b.force[1][1], -0.75 * F, 1e-12 * F);  // at x = 0
}

// Per radian: the ring from R/2 to R for the pile's corner, the disk of R/2 for its vertex on the axis,
// the disk of R for the ground's vertex there; each view has half; in sum R^2/2.
TEST(PenaltyForce, PerRadianOfAPileByHand) {
    const double R = 0.3;
    Surface a = punch(0.0, R, depth, 1), b = ground(0.0, 3.0, 1);
    Contact contact(eps);
    contact.options.axisymmetric = 1;
    contact(a, b);
    const double p = eps * depth;
    EXPECT_NEAR(a.reports[0].area, 0.5 * R * R / 8.0, 1e-14);
    EXPECT_NEAR(a.reports[1].area, 0.5 * 3.0 * R * R / 8.0, 1e-14);
    EXPECT_NEAR(b.reports[1].area, 0.5 * R * R / 2.0, 1e-14);
    EXPECT_NEAR(a.force[0][1], 0.5 * p * (R * R / 8.0 + R * R / 2.0), 1e-12 * p);
    EXPECT_NEAR(a.force[1][1], 0.5 * p * 3.0 * R * R / 8.0, 1e-12 * p);
    EXPECT_NEAR(b.force[0][1], -0.1 * 0.5 * p * 3.0 * R * R / 8.0, 1e-12 * p);  // at r = 10 R
    EXPECT_NEAR(contact.totals.force_on_a[1], p * R * R / 2.0, 1e-12 * p);
    EXPECT_NEAR(contact.totals.energy_normal, 0.5 * p * depth * R * R / 2.0, 1e-12 * p);
    EXPECT_EQ(contact.totals.moment_on_a, 0.0);
}

// A shaft of radius R and height 1 in a borehole that is too narrow by depth.
TEST(PenaltyForce, PerRadianOfAShaftByHand) {
    const double R = 0.3;
    Surface shaft(chain({{R, 0.0}, {R, 1.0}}, {4})),
        hole(chain({{R - depth, 1.0}, {R - depth, 0.0}}, {4}));
    Contact contact(eps);
    contact.options.axisymmetric = 1;
    contact(shaft, hole);
    const double F = eps * depth * 1.0;
    EXPECT_NEAR(shaft.sum()[0], -F * 0.5 * (R + R - depth), 1e-11 * F);  // half from each view
    EXPECT_NEAR(shaft.sum()[1], 0.0, 1e-12 * F);
    EXPECT_EQ(contact.totals.contacts_a, 5);
    EXPECT_EQ(contact.totals.contacts_b, 5);
}

TEST(PenaltyForce, ActionEqualsReaction) {
    std::mt19937_64 random(401);
    for (int i = 0; i < 300; ++i) {
        Surface a = blob(random, {0.0, 0.0}, 20 + i % 60),
                b = blob(random, {1.7, 0.3}, 70 - i % 50);
        stir(random, a, 10.0);
        stir(random, b, 10.0);
        Contact contact(eps, 0.4, 0.3);
        contact(a, b);
        ASSERT_GT(contact.totals.contacts_a + contact.totals.contacts_b, 0);
        const double largest = std::fmax(a.largest_force(), b.largest_force());
        const Point sum = a.sum() + b.sum();
        EXPECT_LE(norm(sum),
                  1e-14 * largest *
                      std::sqrt(1.0 * (contact.totals.contacts_a + contact.totals.contacts_b)));
        EXPECT_NEAR(a.sum()[0], contact.totals.force_on_a[0], 1e-13 * largest * 30);
        EXPECT_NEAR(b.sum()[1], contact.totals.force_on_b[1], 1e-13 * largest * 30);
        EXPECT_NEAR(a.moment(), contact.totals.moment_on_a, 1e-12 * largest * 30);
        EXPECT_NEAR(b.moment(), contact.totals.moment_on_b, 1e-12 * largest * 30);
    }
}

TEST(PenaltyForce, MomentsBalanceWithoutFriction) {
    std::mt19937_64 random(402);
    for (int i = 0; i < 100; ++i) {
        Surface a = blob(random, {0.0, 0.0}, 40), b = blob(random, {1.7, 0.3}, 30);
        Contact contact(eps, 0.4);
        contact(a, b);
        EXPECT_NEAR(a.moment() + b.moment(), 0.0, 1e-13 * a.largest_force() * 30);
    }
}

// Friction's two forces act |g| apart: that moment is what a node on a segment cannot balance.
TEST(PenaltyForce, FrictionLeavesTheMomentOfItsOffset) {
    Surface a = punch(-0.5, 0.5, depth, 1), b = ground(-2.0, 2.0, 1);
    for (Point& v : a.v) v = {1.0, 0.0};
    Contact contact(eps, 0.5, 0.4);
    contact(a, b);
    const double t_t = eps * 1.0 * contact.options.time_step;  // sticks
    EXPECT_NEAR(a.sum()[0], -t_t, 1e-9);
    EXPECT_NEAR(a.moment() + b.moment(), -depth * t_t, 1e-9);
}

TEST(PenaltyForce, IsTheSameWhoeverComesFirst) {
    std::mt19937_64 random(403);
    for (int i = 0; i < 100; ++i) {
        Surface a = blob(random, {0.0, 0.0}, 40), b = blob(random, {1.7, 0.3}, 30);
        stir(random, a, 1.0);
        stir(random, b, 1.0);
        Surface a_2 = a, b_2 = b;
        Contact contact(eps, 0.4, 0.5), swapped = contact;
        contact(a, b);
        swapped(b_2, a_2);
        for (std::size_t v = 0; v < a.x.size(); ++v)
            EXPECT_LE(norm(a.force[v] - a_2.force[v]), 1e-14 * a.largest_force() * 4);
        EXPECT_TRUE(same_bits(a.history, a_2.history));
        EXPECT_TRUE(same_bits(b.history, b_2.history));
        EXPECT_EQ(contact.totals.contacts_a, swapped.totals.contacts_b);
    }
}

TEST(PenaltyForce, IsAddedToWhatIsThere) {
    Surface a = punch(-0.5, 0.5, depth, 1), b = ground(-2.0, 2.0, 1);
    Contact contact(eps);
    contact(a, b);
    const Surface once_a = a, once_b = b;
    ASSERT_EQ(contact.call(a.view(), b.view()), GRIT_OK);
    for (std::size_t v = 0; v < a.x.size(); ++v) {
        EXPECT_EQ(a.force[v][1], 2.0 * once_a.force[v][1]);
        EXPECT_EQ(a.stiffness[v], 2.0 * once_a.stiffness[v]);
    }
    EXPECT_EQ(b.force[0][1], 2.0 * once_b.force[0][1]);
}

TEST(PenaltyForce, GoesThroughAnyStrides) {
    std::mt19937_64 random(404);
    Surface a = blob(random, {0.0, 0.0}, 40), b = blob(random, {1.7, 0.3}, 30);
    stir(random, a, 1.0);
    Contact contact(eps, 0.4, 0.5);
    Surface strided = a;
    contact(a, b);
    b.clear();
    b.history.assign(30, {0.0, 0.0});
    const auto n = static_cast<std::ptrdiff_t>(a.x.size());
    std::vector<double> x(2 * 40), v(2 * 40), history(2 * 40),
        force(2 * 40);  // component by component
    for (std::size_t i = 0; i < 40; ++i)
        for (std::size_t c = 0; c < 2; ++c) {
            x[40 * c + i] = strided.x[i][c];
            v[40 * c + i] = strided.v[i][c];
        }
    grit_penalty_surface view = strided.view();
    view.position = grit_view_of(x.data(), 1, n);
    view.velocity = grit_view_of(v.data(), 1, n);
    view.history = grit_mutable_view_of(history.data(), 1, n);
    view.force = grit_mutable_view_of(force.data(), 1, n);
    ASSERT_EQ(contact.call(view, b.view()), GRIT_OK);
    for (std::size_t i = 0; i < 40; ++i)
        for (std::size_t c = 0; c < 2; ++c) {
            EXPECT_EQ(force[40 * c + i], a.force[i][c]);
            EXPECT_EQ(history[40 * c + i], a.history[i][c]);
        }
}

TEST(PenaltyForce, IsNotWrittenWhenOnlyValidated) {
    Surface a = punch(-0.5, 0.5, depth, 1), b = ground(-2.0, 2.0, 1);
    Contact contact(eps, 0.5, 0.3);
    contact.options.validate_only = 1;
    contact(a, b);
    EXPECT_NEAR(contact.totals.normal_force, eps * depth, 1e-9);
    EXPECT_EQ(a.contacts(), 2);
    EXPECT_EQ(a.largest_force(), 0.0);
    EXPECT_EQ(b.largest_force(), 0.0);
    EXPECT_EQ(a.stiffness[2], 0.0);
    EXPECT_EQ(a.history[2][GRIT_PENALTY_NORMAL_TRACTION], 0.0);
}

TEST(PenaltyForce, NeedsNoVelocityAndNoHistoryWithoutFriction) {
    Surface a = punch(-0.5, 0.5, depth, 1), b = ground(-2.0, 2.0, 1);
    grit_penalty_surface a_view = a.view(), b_view = b.view();
    for (grit_penalty_surface* view : {&a_view, &b_view}) {
        view->velocity.base = nullptr;
        view->history.base = nullptr;
        view->stiffness.base = nullptr;
        view->reports = nullptr;
    }
    Contact contact(eps);
    EXPECT_EQ(contact.call(a_view, b_view), GRIT_OK) << contact.error.message;
    EXPECT_NEAR(a.sum()[1], eps * depth, 1e-9);
}

}  // namespace
