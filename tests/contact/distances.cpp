// SPDX-License-Identifier: BSD-3-Clause
// Distance s and gap from particle domains.
#include <algorithm>

#include "support/surfaces.hpp"

namespace {

using namespace tests;

// Boxes of half-sides 0.25 on the x axis, seen by the one node there is.
Domains boxes(const std::vector<double>& centres) {
    std::vector<Domain> particles;
    for (const double x : centres)
        particles.push_back(
            {{x, 0.1, 0.0}, {Vec3(0.25, 0.0, 0.0), Vec3(0.0, 0.25, 0.0), Vec3::Zero()}, {0}});
    return {2, particles};
}

Distances of_boxes(const std::vector<double>& a, const std::vector<double>& b, const Vec3& n,
                   int stiffer, int measure = GRIT_CONTACT_SUPPORT) {
    Surfaces s(2, {{1.0, 0.1, 0.0}}, {n});
    Domains of_a = boxes(a), of_b = boxes(b);
    EXPECT_EQ(add(s, of_a, A), GRIT_OK);
    EXPECT_EQ(add(s, of_b, B), GRIT_OK);
    return finish(s, stiffer, measure);
}

TEST(ContactDistance, IsThatOfTheStifferBodysOutermostCornerToTheNode) {
    const Vec3 right = Vec3::UnitX(), left = -Vec3::UnitX();
    // A reaches to 0.75, B begins at 1.125, the node is at 1
    const Distances by_a = of_boxes({0.5, 0.0}, {1.375, 2.0}, right, A);
    EXPECT_EQ(by_a.distance[0], 0.25);
    EXPECT_EQ(by_a.gap[0], 0.375);
    const Distances by_b = of_boxes({0.5, 0.0}, {1.375, 2.0}, right, B);
    EXPECT_EQ(by_b.distance[0], 0.125);
    EXPECT_EQ(by_b.gap[0], 0.375);
    // the same with the names of the bodies swapped
    EXPECT_EQ(of_boxes({1.375, 2.0}, {0.5, 0.0}, left, B).distance[0], 0.25);
    EXPECT_EQ(of_boxes({1.375, 2.0}, {0.5, 0.0}, left, A).distance[0], 0.125);
    EXPECT_EQ(of_boxes({1.375, 2.0}, {0.5, 0.0}, left, A).gap[0], 0.375);
}

TEST(ContactDistance, IsNegativeInsideTheBodyAndTheGapInAnOverlap) {
    const Distances found = of_boxes({0.875}, {1.125}, Vec3::UnitX(), A);
    EXPECT_EQ(found.distance[0], -0.125);
    EXPECT_EQ(found.gap[0], -0.25);
    EXPECT_EQ(of_boxes({0.875}, {1.125}, Vec3::UnitX(), B).distance[0], -0.125);
}

TEST(ContactDistance, CanBeThatOfTheEdgeOrOfTheNearestCentre) {
    const std::vector<double> a = {0.875, 0.5}, b = {1.5, 1.25};
    const Vec3 n = Vec3::UnitX();
    EXPECT_EQ(of_boxes(a, b, n, A, GRIT_CONTACT_EDGE).distance[0], 0.125);
    EXPECT_EQ(of_boxes(a, b, n, B, GRIT_CONTACT_EDGE).distance[0], 0.0);
    EXPECT_EQ(of_boxes(a, b, n, A, GRIT_CONTACT_NEAREST_CENTRE).distance[0], 0.125);
    EXPECT_EQ(of_boxes(a, b, n, B, GRIT_CONTACT_NEAREST_CENTRE).distance[0], 0.25);
    EXPECT_EQ(of_boxes(a, b, n, B, GRIT_CONTACT_NEAREST_CENTRE).gap[0], -0.125);
}

TEST(ContactDistance, IsInfiniteWhereABodyHasNoParticle) {
    const Vec3 n = Vec3::UnitX();
    Surfaces s(2, {{1.0, 0.1, 0.0}}, {n});
    EXPECT_EQ(finish(s, A).distance[0], infinity);
    EXPECT_EQ(finish(s, A).gap[0], infinity);
    EXPECT_EQ(finish(s, A, GRIT_CONTACT_EDGE).distance[0], infinity);
    EXPECT_EQ(finish(s, B, GRIT_CONTACT_NEAREST_CENTRE).distance[0], infinity);
    Domains of_b = boxes({1.5});
    ASSERT_EQ(add(s, of_b, B), GRIT_OK);
    EXPECT_EQ(finish(s, B).distance[0], 0.25);
    EXPECT_EQ(finish(s, A).distance[0], infinity);
    EXPECT_EQ(finish(s, B).gap[0], infinity);
}

TEST(ContactDistance, LeavesTheSurfacesAloneWhereTheNormalIsUndefined) {
    Surfaces s(2, {{1.0, 0.1, 0.0}}, {Vec3::Zero()});
    Domains of_a = boxes({0.5});
    ASSERT_EQ(add(s, of_a, A), GRIT_OK);
    EXPECT_EQ(s.surface[0], infinity);
    EXPECT_EQ(finish(s, A).distance[0], infinity);
    EXPECT_EQ(finish(s, A).gap[0], infinity);
    EXPECT_EQ(finish(s, A, GRIT_CONTACT_NEAREST_CENTRE).distance[0], 0.5);
}

// Every corner of every domain, one after the other.
void expect_brute_force(int components, Surfaces& s, const Domains& of_a, const Domains& of_b) {
    const Domains* const bodies[] = {&of_a, &of_b};
    for (std::size_t i = 0; i < s.position.size(); ++i)
        for (const int body : {A, B}) {
            double surface = infinity, centre = infinity;
            const Vec3 outward = body == A ? s.normal[i] : -s.normal[i];
            for (const Domain& p : bodies[body]->particles) {
                if (!std::count(p.nodes.begin(), p.nodes.end(), static_cast<std::ptrdiff_t>(i)))
                    continue;
                centre = std::min(centre, (p.x - s.position[i]).norm());
                for (int corner = 0; corner < 1 << components; ++corner) {
                    Vec3 x = p.x;
                    for (int j = 0; j < components; ++j)
                        x += (corner >> j & 1 ? 1.0 : -1.0) * p.r[static_cast<std::size_t>(j)];
                    surface = std::min(surface, (s.position[i] - x).dot(outward));
                }
            }
            const auto at = 2 * i + static_cast<std::size_t>(body);
            if (surface == infinity) EXPECT_EQ(s.surface[at], infinity);
            else EXPECT_NEAR(s.surface[at], surface, 1e-15);
            if (centre == infinity) EXPECT_EQ(s.centre[at], infinity);
            else EXPECT_NEAR(s.centre[at], centre, 1e-15);
        }
}

TEST(ContactDistance, IsThatOfTheNearestCornerOfAnyParallelogramOrParallelepiped) {
    Dice dice(60);
    for (const int components : {2, 3})
        for (int k = 0; k < 100; ++k) {
            Surfaces s = random_surfaces(components, 8, dice);
            Domains of_a = random_domains(components, 1 + k % 7, 8, dice);
            Domains of_b = random_domains(components, 1 + k % 5, 8, dice);
            ASSERT_EQ(add(s, of_a, A), GRIT_OK);
            ASSERT_EQ(add(s, of_b, B), GRIT_OK);
            expect_brute_force(components, s, of_a, of_b);
        }
}

TEST(ContactDistance, OfSwappedBodiesAndTheOppositeNormalIsTheSameBitwise) {
    Dice dice(61);
    Surfaces s = random_surfaces(3, 8, dice), t = s;
    for (Vec3& n : t.normal) n = -n;
    Domains p = random_domains(3, 6, 8, dice), q = random_domains(3, 6, 8, dice);
    ASSERT_EQ(add(s, p, A) + add(s, q, B) + add(t, p, B) + add(t, q, A), GRIT_OK);
    EXPECT_TRUE(same_bits(finish(s, A).distance, finish(t, B).distance));
    EXPECT_TRUE(same_bits(finish(s, A).gap, finish(t, A).gap));
}

TEST(ContactDistance, HasTheSameBitsInAnyOrderOneByOneAndMergedFromParts) {
    Dice dice(62);
    for (const int components : {2, 3}) {
        Surfaces start = random_surfaces(components, 8, dice);
        Domains of_a = random_domains(components, 20, 8, dice);
        Domains of_b = random_domains(components, 20, 8, dice);
        Surfaces batch = start, single = start, first = start, second = start;
        ASSERT_EQ(add(batch, of_a, A) + add(batch, of_b, B), GRIT_OK);
        const grit_contact_surfaces s = single.views();
        for (std::ptrdiff_t k = 0; k < 20; ++k) {
            const std::ptrdiff_t p = (7 * k + 5) % 20;  // an order of its own
            Domains one_b(components, {of_b.particles[static_cast<std::size_t>(p)]});
            const grit_contact_domains b = one_b.views(B);
            ASSERT_EQ(grit_contact_surfaces_add(&s, 1, &b, nullptr), GRIT_OK);
            grit_contact_domains a = of_a.views(A);
            a.index = &p;
            ASSERT_EQ(grit_contact_surfaces_add(&s, 1, &a, nullptr), GRIT_OK);
            Surfaces& part = k % 3 ? first : second;
            ASSERT_EQ(add(part, one_b, B), GRIT_OK);
            const grit_contact_surfaces views = part.views();
            ASSERT_EQ(grit_contact_surfaces_add(&views, 1, &a, nullptr), GRIT_OK);
        }
        const grit_contact_surfaces into = first.views(), from = second.views();
        ASSERT_EQ(grit_contact_surfaces_merge(&into, &from, nullptr), GRIT_OK);
        EXPECT_TRUE(same_bits(batch.surface, single.surface));
        EXPECT_TRUE(same_bits(batch.centre, single.centre));
        EXPECT_TRUE(same_bits(batch.surface, first.surface));
        EXPECT_TRUE(same_bits(batch.centre, first.centre));
    }
}

TEST(ContactDistance, MergesTheMinimaOfTwoBodiesAndNothingBesideThem) {
    std::vector<double> mine{3.0, 5.0, 7.0, 1.0, 2.0, 7.0}, other{4.0, 2.0, 6.0, 0.5, 3.0, 6.0};
    Dice dice(1);
    Surfaces x = random_surfaces(2, 2, dice);
    grit_contact_surfaces into = x.views(), from = x.views();
    into.surface = into.centre = grit_mutable_view_of(mine.data(), 3, 1);
    from.surface = from.centre = grit_mutable_view_of(other.data(), 3, 1);
    ASSERT_EQ(grit_contact_surfaces_merge(&into, &from, nullptr), GRIT_OK);
    EXPECT_EQ(mine, (std::vector<double>{3.0, 2.0, 7.0, 0.5, 2.0, 7.0}));
}

TEST(ContactDistance, OfParticlesWithoutASizeIsThatOfTheirCentres) {
    Surfaces s(3, {{1.0, 2.0, 3.0}}, {Vec3::UnitZ()});
    Domains points(0, {{{0.0, 0.0, 2.5}, no_sides, {0}}, {{1.0, 2.0, 2.0}, no_sides, {0}}});
    ASSERT_EQ(add(s, points, A), GRIT_OK);
    EXPECT_EQ(finish(s, A).distance[0], 0.5);
    EXPECT_EQ(finish(s, A, GRIT_CONTACT_NEAREST_CENTRE).distance[0], 1.0);
}

}  // namespace
