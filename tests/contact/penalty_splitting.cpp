// SPDX-License-Identifier: BSD-3-Clause
// The same bodies, cut into other segments.
#include "support/penalty.hpp"

namespace {

using namespace tests;

constexpr double eps = 1e6, depth = 0.01;

// Plane and axisymmetric, straight and turned, grids that match and that do not.
TEST(PenaltySplitting, OfAFlatPunchAndOfTheGroundChangesNoResultant) {
    for (const int axisymmetric : {0, 1})
        for (const int n_a : {1, 2, 3, 5, 8, 50})
            for (const int n_b : {1, 2, 3, 7, 10, 31, 64, 1000})
                for (const double width : {0.5, 0.37}) {
                    Surface a = punch(axisymmetric ? 0.0 : -width, width, depth, n_a);
                    Surface b = ground(axisymmetric ? 0.0 : -2.0, 2.0, n_b);
                    if (!axisymmetric) {
                        a.turn(0.7);
                        b.turn(0.7);
                    }
                    Contact contact(eps);
                    contact.options.axisymmetric = axisymmetric;
                    contact(a, b);
                    const double area = axisymmetric ? 0.5 * width * width : 2.0 * width;
                    EXPECT_NEAR(norm(a.sum()), eps * depth * area, 1e-11 * eps * depth)
                        << n_a << " " << n_b << " " << width;
                    for (const auto& bodies : {a.reports, b.reports})
                        for (const auto& report : bodies)
                            EXPECT_TRUE(report.state == GRIT_PENALTY_OPEN ||
                                        std::fabs(report.normal_traction - eps * depth) <=
                                            1e-9 * eps);
                }
}

// A tilted base: the gap is linear, so is the pressure.
TEST(PenaltySplitting, OfATiltedPunchChangesNoResultant) {
    for (const int n_a : {1, 2, 5, 16})
        for (const int n_b : {1, 3, 17, 64}) {
            Surface a(chain({{-0.5, 3.0}, {-0.5, -0.02}, {0.5, -0.01}, {0.5, 3.0}}, {2, n_a, 2}));
            Surface b = ground(-2.0, 2.0, n_b);
            Contact contact(eps);
            contact(a, b);
        }
}

// A cone and the ground, each much finer or coarser than the other.
TEST(PenaltySplitting, OfAConeConverges) {
    const double slope = 0.5, R = 0.2, down = 0.05;
    const auto resultant = [&](int n_a, int n_b, int axisymmetric) {
        Surface a(axisymmetric
                      ? chain({{0.0, 0.0}, {R, slope * R}, {R, 2.0}}, {n_a, 4})
                      : chain({{-R, 2.0}, {-R, slope * R}, {0.0, 0.0}, {R, slope * R}, {R, 2.0}},
                              {4, n_a, n_a, 4}));
        a.move({0.0, -down});
        Surface b = ground(axisymmetric ? 0.0 : -1.0, 1.0, n_b);
        Contact contact(eps, 0.2);
        contact.options.axisymmetric = axisymmetric;
        contact(a, b);
        return a.sum()[1];
    };
    for (const int axisymmetric : {0, 1}) {
        // the overlap's depth times its width, as a ground without vertices there sees it ...
        const double exact = axisymmetric ? eps * down * 0.01 / 6.0 : eps * down * 0.1;
        EXPECT_NEAR(resultant(80, 1, axisymmetric), exact, (axisymmetric ? 0.3 : 0.01) * exact);
        // ... and half of it, half as the cone's faces see it: normal, depth and width are inclined
        const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        const double both = 0.5 * (1.0 + cosine * cosine * cosine) * exact;
        for (const int n_a : {20, 80, 320})
            for (const int n_b : {200, 1000})
                EXPECT_NEAR(resultant(n_a, n_b, axisymmetric), both, 0.01 * both)
                    << n_a << " " << n_b;
        for (const int n_b : {1, 2, 5, 13, 40}) {
            EXPECT_GE(resultant(20, n_b, axisymmetric), 0.8 * exact) << n_b;
            EXPECT_LE(resultant(20, n_b, axisymmetric), 1.3 * exact) << n_b;
        }
    }
}

// Coincident lines are the case of equal halves: each view has half the stiffness.
TEST(PenaltySplitting, HalvesTheStiffnessWhereBothSeeTheSamePair) {
    Surface a(chain({{-0.5, -depth}, {0.5, -depth}}, {4})), b = ground(-0.5, 0.5, 4);
    Contact contact(eps);
    contact(a, b);
    for (std::size_t v = 0; v < 5; ++v) {
        const double area = v % 4 == 0 ? 0.125 : 0.25;
        EXPECT_NEAR(a.reports[v].area, 0.5 * area, 1e-14);
        EXPECT_NEAR(b.reports[v].area, 0.5 * area, 1e-14);
        EXPECT_NEAR(a.force[v][1], eps * depth * area, 1e-9);
        EXPECT_NEAR(b.force[v][1], -eps * depth * area, 1e-9);
        EXPECT_NEAR(a.stiffness[v], eps * area, 1e-6);
    }
}

// The view that appears does so from nothing: no force jumps while a tip goes past a vertex.
TEST(PenaltySplitting, LetsNoForceJumpWhenTheOtherViewSetsIn) {
    double before = 0.0, largest_step = 0.0;
    const int steps = 4000;
    for (int i = 0; i <= steps; ++i) {
        Surface a(std::vector<Point>{{-0.5, 0.25}, {0.0, 0.0}, {0.5, 0.25}});
        a.move({0.013, -0.1 * i / steps});
        Surface b = ground(-1.05, 1.0, 50);
        Contact contact(eps, 0.5);
        contact(a, b);
        largest_step = std::fmax(largest_step, std::fabs(a.sum()[1] - before));
        before = a.sum()[1];
    }
    EXPECT_LE(largest_step, 5.0 * before / steps);
}

}  // namespace
