// SPDX-License-Identifier: BSD-3-Clause
// Forces know neither the observer nor the place.
#include <algorithm>

#include "support/penalty.hpp"

namespace {

using namespace tests;

constexpr double eps = 1e6, mu = 0.4;

struct Scene {
    Surface a, b;
    Contact contact{eps, 0.4, mu};

    explicit Scene(std::mt19937_64& random)
        : a(blob(random, {0.0, 0.0}, 40)), b(blob(random, {1.7, 0.3}, 30)) {
        contact.options.axisymmetric = 0;
        stir(random, a, 10.0);
        stir(random, b, 10.0);
        contact(a, b);  // a history to begin with
        stir(random, a, 10.0);
        stir(random, b, 10.0);
    }
    void run() { contact(a, b); }
};

void expect_equal(const Scene& one, const Scene& other, double angle, double tolerance) {
    const double largest = std::fmax(one.a.largest_force(), one.b.largest_force());
    const auto compare = [&](const Surface& x, const Surface& y) {
        for (std::size_t v = 0; v < x.x.size(); ++v) {
            EXPECT_LE(norm(rotated(angle, x.force[v]) - y.force[v]), tolerance * largest) << v;
            EXPECT_EQ(x.reports[v].state, y.reports[v].state) << v;
            EXPECT_NEAR(x.history[v][0], y.history[v][0], tolerance * eps) << v;
        }
    };
    compare(one.a, other.a);
    compare(one.b, other.b);
}

TEST(PenaltyInvariance, RotationOfEverythingRotatesForces) {
    std::mt19937_64 random(431);
    for (int i = 0; i < 100; ++i) {
        Scene one(random), other = one;
        const double angle = uniform(random, -3.0, 3.0);
        for (Surface* body : {&other.a, &other.b}) {
            body->turn(angle);
            for (Point& v : body->v) v = rotated(angle, v);
        }
        one.run();
        other.run();
        expect_equal(one, other, angle, 1e-12);
    }
}

TEST(PenaltyInvariance, TranslationChangesNothing) {
    std::mt19937_64 random(432);
    for (int i = 0; i < 100; ++i) {
        Scene one(random), other = one;
        const Point u{uniform(random, -10.0, 10.0), uniform(random, -10.0, 10.0)};
        other.a.move(u);
        other.b.move(u);
        one.run();
        other.run();
        expect_equal(one, other, 0.0, 1e-12);
    }
}

TEST(PenaltyInvariance, ACommonVelocityChangesNothing) {
    std::mt19937_64 random(433);
    for (int i = 0; i < 100; ++i) {
        Scene one(random), other = one;
        const Point u{uniform(random, -100.0, 100.0), uniform(random, -100.0, 100.0)};
        for (Surface* body : {&other.a, &other.b})
            for (Point& v : body->v) v = v + u;
        one.run();
        other.run();
        expect_equal(one, other, 0.0, 1e-11);
    }
}

// Which vertex of a closed line comes first: corners are hit among them, where the rates of both segments count.
TEST(PenaltyInvariance, TheFirstVertexOfAClosedLineChangesNothing) {
    std::mt19937_64 random(437);
    for (int i = 0; i < 20; ++i) {
        const Scene start(random);
        Scene one = start;
        one.run();
        for (std::ptrdiff_t first = 1; first < 30; ++first) {
            Scene other = start;
            const auto turn = [&](auto& list, std::ptrdiff_t by) {
                std::rotate(list.begin(), list.begin() + by, list.end());
            };
            turn(other.b.x, first);
            turn(other.b.v, first);
            turn(other.b.history, first);
            other.run();
            turn(other.b.force, 30 - first);
            turn(other.b.reports, 30 - first);
            turn(other.b.history, 30 - first);
            expect_equal(one, other, 0.0, 1e-12);
            for (std::size_t v = 0; v < one.a.x.size(); ++v)
                EXPECT_NEAR(one.a.reports[v].slip_rate, other.a.reports[v].slip_rate, 1e-11) << v;
        }
    }
}

// A common rotation is no slip, at faces and at corners.
TEST(PenaltyInvariance, ACommonRotationRateIsNoSlip) {
    std::mt19937_64 random(434);
    for (int i = 0; i < 100; ++i) {
        Scene scene(random);
        const double omega = uniform(random, -50.0, 50.0);
        for (Surface* body : {&scene.a, &scene.b})
            for (std::size_t v = 0; v < body->x.size(); ++v)
                body->v[v] = {-omega * body->x[v][1], omega * body->x[v][0]};
        scene.run();
        EXPECT_LE(scene.contact.totals.dissipation, 1e-6);  // J; the traction alone may not fit
        for (const Surface* body : {&scene.a, &scene.b})
            for (const auto& report : body->reports)
                EXPECT_LE(std::fabs(report.slip_rate), 1e-13 * 50.0);
    }
}

// Stored friction turns with the bodies: a quarter turn in a hundred steps.
TEST(PenaltyInvariance, StoredFrictionTurnsWithTheBodies) {
    Surface a = punch(-0.5, 0.5, 0.01, 3), b = ground(-2.0, 2.0, 4);
    Contact contact(eps, 0.4, mu);
    for (Point& v : a.v) v = {2.0, 0.0};
    contact(a, b);
    const Point start = a.sum();
    EXPECT_NEAR(start[0], -2.0 * eps * 1e-3, 1e-8);
    const double turn = 1.5707963267948966 / 100.0, omega = turn / contact.options.time_step;
    for (int i = 0; i < 100; ++i) {
        a.turn(turn);
        b.turn(turn);
        for (Surface* body : {&a, &b})
            for (std::size_t v = 0; v < body->x.size(); ++v)
                body->v[v] = {-omega * body->x[v][1], omega * body->x[v][0]};
        contact(a, b);
    }
    EXPECT_NEAR(a.sum()[0], -start[1], 1e-10 * start[1]);
    EXPECT_NEAR(a.sum()[1], start[0], 1e-10 * start[1]);
}

// A vertex that slides over from one segment of a bent line to the next takes its friction along.
TEST(PenaltyInvariance, StoredFrictionGoesRoundABend) {
    Surface b(std::vector<Point>{{2.0, -0.5}, {0.0, 0.0}, {-2.0, 0.0}});
    Surface a(std::vector<Point>{{-0.3, 0.3}, {-0.1, -0.01}, {0.2, -0.01}, {0.4, 0.3}});
    Contact contact(eps, 0.4, 10.0);
    for (Point& v : a.v) v = {1.0, 0.0};
    contact(a, b);
    const double before = a.history[1][GRIT_PENALTY_TANGENTIAL_TRACTION];
    ASSERT_EQ(a.reports[1].segment, 1);
    ASSERT_NE(before, 0.0);
    a.move({0.3, -0.08});
    for (Point& v : a.v) v = {0.0, 0.0};
    contact(a, b);
    ASSERT_EQ(a.reports[1].segment, 0);
    EXPECT_EQ(a.history[1][GRIT_PENALTY_TANGENTIAL_TRACTION], before);
    const auto& report = a.reports[1];
    const Point n{report.normal[0], report.normal[1]}, t{-n[1], n[0]};
    EXPECT_NEAR(dot(t, b.x[1] - b.x[0]), norm(b.x[1] - b.x[0]), 1e-14);
}

TEST(PenaltyInvariance, UnitsDoNotMatter) {
    std::mt19937_64 random(435);
    for (int i = 0; i < 20; ++i) {
        Scene one(random), other = one;  // kPa instead of Pa, mm instead of m
        for (Surface* body : {&other.a, &other.b})
            for (std::size_t v = 0; v < body->x.size(); ++v) {
                body->x[v] = 1e3 * body->x[v];
                body->v[v] = 1e3 * body->v[v];
                body->history[v] = 1e-3 * body->history[v];
            }
        other.contact.options.normal_stiffness *= 1e-6;
        other.contact.options.depth_max *= 1e3;
        one.run();
        other.run();
        for (std::size_t v = 0; v < one.a.x.size(); ++v)
            EXPECT_LE(norm(one.a.force[v] - other.a.force[v]), 1e-11 * one.a.largest_force());
    }
}

}  // namespace
