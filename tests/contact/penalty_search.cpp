// SPDX-License-Identifier: BSD-3-Clause
// Who is found, and who is not.
#include "support/penalty.hpp"

namespace {

using namespace tests;

constexpr double eps = 1e6;

// Half of the pile's outline, from the axis: a flat or a conical tip of radius R at depth z = 0.
Surface half_pile(double R, double cone_height) {
    return Surface(std::vector<Point>{{0.0, 0.0}, {R, cone_height}, {R, 5.0 * R}});
}

Surface whole_pile(double R, double cone_height) {
    if (cone_height == 0.0)
        return Surface(std::vector<Point>{{-R, 5.0 * R}, {-R, 0.0}, {R, 0.0}, {R, 5.0 * R}});
    return Surface(std::vector<Point>{
        {-R, 5.0 * R}, {-R, cone_height}, {0.0, 0.0}, {R, cone_height}, {R, 5.0 * R}});
}

TEST(PenaltySearch, FindsATipThatIsDrivenThroughASegmentMuchLongerThanItself) {
    const double R = 0.15;
    for (const double cone_height : {0.0, 0.5 * R, 2.0 * R})
        for (const int axisymmetric : {0, 1})
            for (const int parts : {1, 2, 7, 100})
                for (double below = -0.02; below < 0.1; below += 0.00371) {
                    Surface pile =
                        axisymmetric ? half_pile(R, cone_height) : whole_pile(R, cone_height);
                    pile.move({0.0, -below});
                    Surface sand = ground(axisymmetric ? 0.0 : -100.0, 100.0, parts);
                    Contact contact(eps, 0.1);
                    contact.options.axisymmetric = axisymmetric;
                    contact(pile, sand);
                    // what overlaps: a slab, a triangle or a cone
                    const double w = cone_height == 0.0 ? R : std::min(R, below * R / cone_height);
                    const double slab = axisymmetric ? 0.5 * w * w : 2.0 * w;
                    const double least = cone_height == 0.0 ? 0.999 : axisymmetric ? 0.3 : 0.4;
                    if (below <= 0.0) {
                        EXPECT_EQ(contact.totals.normal_force, 0.0) << below;
                    } else {
                        EXPECT_GE(pile.sum()[1], least * eps * below * slab)
                            << below << " " << parts;
                    }
                }
}

TEST(PenaltySearch, FindsAVertexOfTheGroundInsideASegmentOfThePile) {
    Surface pile = whole_pile(1.0, 0.0);
    Surface sand(std::vector<Point>{{3.0, -2.0}, {0.2, 0.05}, {-3.0, -2.0}});  // a hump
    Contact contact(eps);
    contact(pile, sand);
    EXPECT_EQ(contact.totals.contacts_a, 0);
    EXPECT_EQ(contact.totals.contacts_b, 1);
    EXPECT_GT(pile.sum()[1], 0.0);
    EXPECT_NEAR(pile.force[2][1] / pile.sum()[1], 0.6, 1e-12);  // at x = 1, the hump at 0.2
}

// A small square anywhere inside, up to depth_max: at faces, at salient and at re-entrant corners.
TEST(PenaltySearch, HasNoDeadZoneAtCorners) {
    const std::vector<Point> l_shape = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
    std::mt19937_64 random(411);
    int tried = 0;
    for (int i = 0; i < 4000; ++i) {
        const Point centre{uniform(random, 0.0, 4.0), uniform(random, 0.0, 4.0)};
        const bool inside = centre[0] < 2.0 || centre[1] < 2.0;
        if (!inside) continue;
        // distance to the nearest wall and the way out
        double nearest = std::min({centre[0], centre[1], 4.0 - centre[0], 4.0 - centre[1]});
        if (centre[1] > 2.0) nearest = std::min(nearest, 2.0 - centre[0]);
        if (centre[0] > 2.0) nearest = std::min(nearest, 2.0 - centre[1]);
        if (centre[0] <= 2.0 && centre[1] <= 2.0)
            nearest = std::min(nearest, norm(centre - Point{2.0, 2.0}));
        if (nearest > 0.39 || nearest < 0.01) continue;
        ++tried;
        const double h = 0.002;
        Surface probe(std::vector<Point>{centre + Point{-h, -h}, centre + Point{h, -h},
                                         centre + Point{h, h}, centre + Point{-h, h}},
                      true);
        Surface body(l_shape, true);
        Contact contact(eps, 0.4);
        contact(probe, body);
        ASSERT_GE(contact.totals.contacts_a, 1) << centre[0] << " " << centre[1];
        const double force = norm(probe.sum());
        EXPECT_GE(force, 0.5 * eps * (nearest - 2 * h) * h) << centre[0] << " " << centre[1];
        EXPECT_LE(force, 2.0 * eps * (nearest + 2 * h) * 4 * h) << centre[0] << " " << centre[1];
    }
    EXPECT_GE(tried, 1000);
}

// Round a re-entrant corner the normal turns without a jump.
TEST(PenaltySearch, TurnsTheNormalContinuouslyAtAReEntrantCorner) {
    Surface body(std::vector<Point>{{4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
    Point before{0.0, 0.0};
    for (double s = -0.5; s <= 0.5; s += 0.001) {
        const Point p = Point{2.0 - 0.2, 2.0 - 0.2} + s * Point{1.0, -1.0};
        Surface probe(std::vector<Point>{p + Point{-1.0, 0.9}, p, p + Point{0.9, -1.0}});
        Contact contact(eps, 0.4);
        contact(probe, body);
        const auto& report = probe.reports[1];
        if (report.state == GRIT_PENALTY_OPEN) continue;
        const Point n{report.normal[0], report.normal[1]};
        EXPECT_NEAR(norm(n), 1.0, 1e-14);
        EXPECT_TRUE(norm(before) == 0.0 || norm(n - before) <= 0.01) << s;
        before = n;
    }
    EXPECT_GT(norm(before), 0.0);
}

TEST(PenaltySearch, LeavesBodiesAloneThatDoNotOverlap) {
    std::mt19937_64 random(412);
    for (int i = 0; i < 200; ++i) {
        Surface a = blob(random, {0.0, 0.0}, 30), b = blob(random, {2.4, 0.0}, 30);
        stir(random, a, 1.0);
        Contact contact(eps, 2.0, 0.5);
        contact(a, b);
        EXPECT_EQ(contact.totals.contacts_a + contact.totals.contacts_b, 0);
        EXPECT_EQ(a.largest_force(), 0.0);
        EXPECT_EQ(contact.totals.energy_normal, 0.0);
    }
}

// A plate of thickness 0.01, much less than depth_max: bodies on either side are outside.
TEST(PenaltySearch, HitsNoBackFaceOfAThinBody) {
    for (const double side : {1.0, -1.0}) {
        Surface plate(chain({{-2.0, 0.0}, {2.0, 0.0}, {2.0, 0.01}, {-2.0, 0.01}}, {8, 1, 8, 1}),
                      true);
        Surface block(chain({{-0.5, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {-0.5, 1.0}}, {4, 4, 4, 4}),
                      true);
        block.move({0.0, side > 0 ? 0.011 : -1.001});
        Contact contact(eps, 0.5);
        contact(block, plate);
        EXPECT_EQ(contact.totals.contacts_a + contact.totals.contacts_b, 0) << side;
        block.move({0.0, side > 0 ? -0.003 : 0.003});  // overlaps the near face by 0.002
        contact(block, plate);
        EXPECT_NEAR(block.sum()[1] * side, eps * 0.002 * 1.0, 1e-6);
    }
}

TEST(PenaltySearch, HitsNothingFromBehindAnOpenLineDeeperThanDepthMax) {
    for (const double depth : {0.0999, 0.1, 0.10000000005, 0.1001}) {
        Surface a = punch(-0.5, 0.5, depth, 3), b = ground(-2.0, 2.0, 5);
        Contact contact(eps, 0.1);
        contact(a, b);
        EXPECT_EQ(contact.totals.contacts_a, depth <= 0.1 ? 4 : 0) << depth;
        EXPECT_EQ(contact.totals.normal_force > 0.0, depth <= 0.1);
    }
}

TEST(PenaltySearch, EndsAtTheEndsOfAnOpenLine) {
    for (const double x : {-2.0, -2.001, 2.0, 2.001}) {
        Surface a(std::vector<Point>{{x - 0.1, 0.5}, {x, -0.01}, {x + 0.1, 0.5}}),
            b = ground(-2.0, 2.0, 3);
        Contact contact(eps);
        contact(a, b);
        EXPECT_EQ(contact.totals.contacts_a, std::fabs(x) == 2.0 ? 1 : 0) << x;
    }
}

// A vertex above a vertex of the ground: the lower segment is named, nothing is counted twice.
TEST(PenaltySearch, BreaksTiesByTheSegment) {
    Surface a = punch(-0.5, 0.5, 0.01, 2), b = ground(-2.0, 2.0, 4);
    Contact contact(eps);
    contact(a, b);
    EXPECT_EQ(a.reports[3].segment, 1);
    EXPECT_EQ(a.reports[3].place, 1.0);
    EXPECT_EQ(b.reports[2].segment, 2);
    EXPECT_EQ(b.reports[2].place, 1.0);
    EXPECT_NEAR(a.sum()[1], eps * 0.01, 1e-9);
}

struct Cost {
    double per_vertex;
    std::ptrdiff_t contacts;
};

// Two wavy lines that overlap all along, n segments each.
Cost cost_of(int n, double stretch_one) {
    const auto wave = [&](double depth, bool back) {
        std::vector<Point> points;
        double x = 0.0;
        for (int i = 0; i <= n; ++i) {
            points.push_back({x, std::sin(0.05 * i) - depth});
            x += i == n / 2 ? stretch_one : 1.0;
        }
        if (back) std::reverse(points.begin(), points.end());
        return Surface(points);
    };
    Surface a = wave(0.1, false), b = wave(0.0, true);
    Contact contact(eps, 0.5);
    contact(a, b);
    return {static_cast<double>(contact.totals.tests) / (2.0 * n),
            contact.totals.contacts_a + contact.totals.contacts_b};
}

TEST(PenaltySearch, LooksAtAsManySegmentsPerVertexHoweverManyThereAre) {
    const Cost few = cost_of(1000, 1.0);
    EXPECT_GE(few.contacts, 1900);
    for (const int n : {10000, 100000}) {
        const Cost many = cost_of(n, 1.0);
        EXPECT_GE(many.contacts, 19 * n / 10);
        EXPECT_LE(many.per_vertex, 1.1 * few.per_vertex) << n;
    }
}

TEST(PenaltySearch, IsNotUpsetByALongSegmentAmongShortOnes) {
    const Cost even = cost_of(10000, 1.0);
    for (const double length : {1e3, 1e6, 1e9})
        EXPECT_LE(cost_of(10000, length).per_vertex, 1.1 * even.per_vertex) << length;
}

TEST(PenaltySearch, NamesNoSegmentWhereNothingIsMet) {
    Surface a = ground(0.0, 4.0, 4), b = punch(1.0, 2.0, -5.0, 3);
    Contact contact(1e6, 0.5);
    contact(a, b);
    for (const Surface* surface : {&a, &b})
        for (const grit_penalty_report& report : surface->reports) {
            EXPECT_EQ(report.state, GRIT_PENALTY_OPEN);
            EXPECT_EQ(report.segment, -1);
        }
}

}  // namespace
