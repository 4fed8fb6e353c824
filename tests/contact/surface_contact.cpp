// SPDX-License-Identifier: BSD-3-Clause
// What holds for any two bodies in surface contact: momentum, energy, complementarity, Coulomb, frames; and by hand.
#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

#include "support/meeting_grids.hpp"

namespace {

using namespace tests;

double largest(const std::array<double, 3>& x) {
    return std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
}

TEST(SurfaceContact, KeepsMomentumAndMakesNoEnergy) {
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < (components == 2 ? 200u : 40u); ++seed)
            for (const double mu : {0.0, 0.3, 5.0}) {
                Meeting m(components, seed);
                for (GridBody* body : {&m.a, &m.b})
                    std::fill(body->fixed.begin(), body->fixed.end(), 0);
                SurfaceCall call(components, mu);
                if (seed % 3 == 0) call.options.sweep_limit = 2;  // stopped early
                const double before = m.a.kinetic() + m.b.kinetic();
                const auto p_a = m.a.momentum(), p_b = m.b.momentum();
                ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
                const auto q_a = m.a.momentum(), q_b = m.b.momentum();
                double scale = 0.0;
                for (const double mass : m.a.mass) scale += mass;
                std::array<double, 3> lost{}, on_b{};
                for (std::size_t c = 0; c < 3; ++c) {
                    lost[c] = q_a[c] + q_b[c] - p_a[c] - p_b[c];
                    on_b[c] = q_b[c] - p_b[c] - call.totals.impulse_on_b[c];
                }
                EXPECT_LE(largest(lost), 1e-13 * scale);
                EXPECT_LE(largest(on_b), 1e-11 * scale);
                EXPECT_LE(m.a.kinetic() + m.b.kinetic(), before * (1.0 + 1e-13));
                // v_old = v: what friction and closing take is what is missing.
                EXPECT_NEAR(call.totals.dissipation_normal + call.totals.dissipation_tangential,
                            before - m.a.kinetic() - m.b.kinetic(), 1e-10 * before);
            }
}

// (V5): of sweeps that end early, too.
TEST(SurfaceContact, MakesNoEnergyHoweverEarlyItsSweepsEnd) {
    for (std::uint64_t seed = 0; seed < 300; ++seed)
        for (const double mu : {0.3, 1.0, 5.0, 50.0})
            for (const int limit : {1, 2, 3, 5}) {
                Meeting m(2, seed, 1.0);
                for (GridBody* body : {&m.a, &m.b})
                    std::fill(body->fixed.begin(), body->fixed.end(), 0);
                SurfaceCall call(2, mu);
                call.options.sweep_limit = limit;
                call.options.spacing = 0.7;
                const double before = m.a.kinetic() + m.b.kinetic();
                ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
                EXPECT_LE(m.a.kinetic() + m.b.kinetic(), before * (1.0 + 1e-13)) << seed;
            }
}

// The pressures are those of the quadratic program: no pressure pulls, none is where the gap stays open, and what is
// left of the approach closes the gap and no more. Solved again, nothing changes.
TEST(SurfaceContact, LeavesNothingThatApproaches) {
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < 60; seed += components == 2 ? 1 : 6) {
            Meeting m(components, seed, 1.0);
            SurfaceCall call(components);
            ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
            if (call.totals.points == 0) continue;
            EXPECT_LE(call.totals.residual, 1e-13 * call.totals.largest_approach);
            for (const grit_surface_report& r : call.reports) EXPECT_GE(r.normal_force, 0.0);
            EXPECT_EQ(call.totals.dissipation_tangential, 0.0);
        }
}

TEST(SurfaceContact, HoldsNodesThatAreHeldAndRigidBodies) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Meeting m(2, seed);
        m.a.rigid = true;
        const GridBody before_a = m.a, before_b = m.b;
        SurfaceCall call(2, 0.4);
        ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
        EXPECT_EQ(m.a.v, before_a.v);
        for (std::size_t i = 0; i < m.b.v.size(); ++i)
            if (m.b.fixed[i / 2] >> (i % 2) & 1) {
                EXPECT_EQ(m.b.v[i], before_b.v[i]);
            }
        EXPECT_EQ(call.totals.impulse_on_a[1], -call.totals.impulse_on_b[1]);
    }
}

TEST(SurfaceContact, ObeysCoulombInEveryFacetWhoseNormalIsThatOfAll) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        GridBody a, b;
        std::mt19937_64 random(seed);
        const auto flat = [](double, double) { return 3.4; };
        add_face(a, false, 0.5, 6.4, 9, flat);
        add_face(b, true, 0.2, 6.1, 7, flat);
        a.fill(random, 1.0, 2.0);
        b.fill(random, 1.0, 2.0);
        SurfaceCall call(2, 0.35);
        ASSERT_EQ(call(a, b), GRIT_OK);
        double slipping = 0.0;
        for (const grit_surface_report& r : call.reports) {
            EXPECT_LE(r.friction_force, 0.35 * r.normal_force * (1.0 + 1e-9) + 1e-12);
            slipping += r.friction_force;
        }
        if (call.totals.pressures > 0) {
            EXPECT_GT(slipping, 0.0);
        }
        EXPECT_GE(call.totals.dissipation_tangential, 0.0);
    }
}

// However little.
TEST(SurfaceContact, RubsAsMuchAsItsCoefficientSaysWhereAllSlips) {
    for (const double mu : {1e-6, 4e-3, 0.1}) {
        GridBody a, b;
        std::mt19937_64 random(1);
        const auto flat = [](double, double) { return 3.4; };
        add_face(a, false, 0.5, 6.4, 9, flat);
        add_face(b, true, 0.2, 6.1, 7, flat);
        a.fill(random, 0.0, 0.0);
        b.fill(random, 0.0, 0.0);
        for (std::size_t i = 0; i < b.v.size(); i += 2) {
            b.v[i] = 10.0;
            b.v[i + 1] = -1.0;
        }
        SurfaceCall call(2, mu);
        call.options.sweep_tolerance = 1.0;  // the largest
        ASSERT_EQ(call(a, b), GRIT_OK) << call.error.message;
        EXPECT_GT(call.totals.normal_impulse, 0.0);
        EXPECT_NEAR(call.totals.impulse_on_a[0], mu * call.totals.normal_impulse,
                    1e-9 * mu * call.totals.normal_impulse);
    }
}

// The same in space as in the plane where nothing varies along the third direction.
TEST(SurfaceContact, InSpaceIsThatOfThePlane) {
    GridBody a, b;
    std::mt19937_64 random(3);
    const auto slope = [](double x, double) { return 3.1 + 0.1 * x; };
    add_face(a, false, 1.0, 6.0, 5, slope);
    add_face(b, true, 1.0, 6.0, 5, slope);
    a.fill(random, 1.0, 0.0);
    b.fill(random, 1.0, 0.0);
    GridBody a3, b3;
    for (auto [plane, space, upper] : {std::tuple{&a, &a3, false}, std::tuple{&b, &b3, true}}) {
        space->components = 3;
        add_face(*space, upper, 1.0, 6.0, 5, [&](double x, double) { return slope(x, 0.0); });
        space->mass.assign(512, 1.0);
        space->fixed.assign(512, 2);  // nothing moves along y
        space->v.resize(3 * 512);
        for (std::size_t i = 0; i < 512; ++i) {
            const std::size_t of_plane = i % 8 + 8 * (i / 64);
            space->v[3 * i] = plane->v[2 * of_plane];
            space->v[3 * i + 2] = plane->v[2 * of_plane + 1];
        }
        space->v_old = space->v;
    }
    SurfaceCall flat(2), full(3);
    // In space as many pressures as vertices, in the plane too.
    flat.options.spacing = full.options.spacing = 0.5;
    ASSERT_EQ(flat(a, b), GRIT_OK);
    ASSERT_EQ(full(a3, b3), GRIT_OK) << full.error.message;
    EXPECT_NEAR(full.totals.smallest_gap, flat.totals.smallest_gap, 1e-12);
    EXPECT_GT(full.totals.normal_impulse, 0.0);
    EXPECT_LE(full.totals.residual, 1e-12 * full.totals.largest_approach);
    // Of a strip of breadth 1 in the plane; of breadth 5 with free ends in space.
    EXPECT_NEAR(full.totals.normal_impulse / 5.0, flat.totals.normal_impulse,
                0.3 * flat.totals.normal_impulse);
}

// A block of uniform velocity on a rigid floor stops all at once, whatever the facets, and each facet feels its share. The
// surface lies 0.3 of a cell above a row of nodes: its impulse per area is 2 / (0.7^2 + 0.3^2).
// In space shape functions are not linear on triangles: there it stops but for 8 %, at the corners.
TEST(SurfaceContact, StopsABlockWithItsWholeMomentum) {
    for (const int components : {2, 3}) {
        GridBody floor, block;
        floor.components = block.components = components;
        const auto level = [](double, double) { return 3.3; };
        add_face(floor, false, 0.0, 7.0, components == 2 ? 13 : 6, level);
        add_face(block, true, 0.5, 6.5, 12, level);
        floor.rigid = true;
        std::mt19937_64 random(1);
        block.fill(random, 0.0, 0.0);
        block.weigh(0.5, 6.5);
        constexpr double share = 0.7 * 0.7 + 0.3 * 0.3;
        for (std::size_t i = 0; i < block.v.size(); ++i)
            block.v[i] =
                i % static_cast<std::size_t>(components) == static_cast<std::size_t>(components - 1)
                    ? -2.0
                    : 0.0;
        block.v_old = block.v;
        SurfaceCall call(components);
        ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
        EXPECT_NEAR(call.totals.largest_approach, 2.0, 1e-12);
        EXPECT_NEAR(call.totals.area, components == 2 ? 6.0 : 36.0, 1e-9);
        const double error = components == 2 ? 1e-9 : 0.08;  // of velocities and impulses per area
        EXPECT_NEAR(call.totals.normal_impulse / call.totals.area, 2.0 / share, error);
        for (std::size_t v = 0; v < block.vertices(); ++v)
            EXPECT_NEAR(block.velocity_of_vertex(v), 0.0, 2.0 * error);
        for (std::size_t f = 0; f < call.reports.size(); ++f)
            EXPECT_NEAR(call.reports[f].normal_force * call.options.time_step,
                        2.0 * call.reports[f].area / share,
                        2.0 * error * call.reports[f].area / share);
    }
}

TEST(SurfaceContact, ClosesTheGapInTheStepAndNoMore) {
    auto [floor, block] = block_above_floor(7, 0.015, 2.0);
    SurfaceCall call(2);
    ASSERT_EQ(call(floor, block), GRIT_OK);
    EXPECT_NEAR(call.totals.smallest_gap, 0.015, 1e-12);
    EXPECT_EQ(call.totals.points, 2 * 7);
    for (std::size_t v = 0; v < block.vertices(); ++v)
        EXPECT_NEAR(block.velocity_of_vertex(v), -1.5, 1e-9);
    // 0.03 away it is not reached in this step.
    for (std::size_t i = 1; i < block.position.size(); i += 2) block.position[i] = 3.03;
    for (std::size_t i = 1; i < block.v.size(); i += 2) block.v[i] = -2.0;
    ASSERT_EQ(call(floor, block), GRIT_OK);
    EXPECT_EQ(call.totals.pressures, 0);
    EXPECT_EQ(call.totals.sweeps, 0);
    EXPECT_EQ(block.v[2 * 28 + 1], -2.0);
    // Beyond a fiftieth of the reach no point counts.
    for (std::size_t i = 1; i < block.position.size(); i += 2) block.position[i] = 3.06;
    ASSERT_EQ(call(floor, block), GRIT_OK);
    EXPECT_EQ(call.totals.points, 0);
}

TEST(SurfaceContact, IsTheSameInAMovingAndATurnedFrame) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Meeting m(2, seed, 1.0), moving(2, seed, 1.0);
        for (GridBody* body : {&m.a, &m.b, &moving.a, &moving.b})
            std::fill(body->fixed.begin(), body->fixed.end(), 0);
        for (GridBody* body : {&moving.a, &moving.b})
            for (std::size_t i = 0; i < body->v.size(); ++i) body->v[i] += i % 2 == 0 ? 3.0 : -2.0;
        SurfaceCall call(2, 0.3), other(2, 0.3);
        ASSERT_EQ(call(m.a, m.b), GRIT_OK);
        ASSERT_EQ(other(moving.a, moving.b), GRIT_OK);
        for (std::size_t i = 0; i < m.a.v.size(); ++i)
            EXPECT_NEAR(moving.a.v[i] - (i % 2 == 0 ? 3.0 : -2.0), m.a.v[i], 1e-9);
        // Turned by a right angle: (x, y) -> (-y, x).
        Meeting turned(2, seed, 1.0);
        for (GridBody* body : {&turned.a, &turned.b}) {
            std::fill(body->fixed.begin(), body->fixed.end(), 0);
            for (std::vector<double>* list : {&body->position, &body->v, &body->v_old})
                for (std::size_t i = 0; i < list->size(); i += 2) {
                    std::swap((*list)[i], (*list)[i + 1]);
                    (*list)[i] = -(*list)[i];
                }
        }
        ASSERT_EQ(other(turned.a, turned.b), GRIT_OK);
        for (std::size_t i = 0; i < m.b.v.size(); i += 2) {
            EXPECT_NEAR(turned.b.v[i], -m.b.v[i + 1], 1e-9);
            EXPECT_NEAR(turned.b.v[i + 1], m.b.v[i], 1e-9);
        }
    }
}

// Points of pressure are those of the shape, however it lies in space.
TEST(SurfaceContact, InSpaceIsTheSameInATurnedFrame) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    // About z, then about x.
    const auto turned = [&](const double* x) {
        const double y = s * x[0] + c * x[1];
        return std::array<double, 3>{c * x[0] - s * x[1], c * y - s * x[2], s * y + c * x[2]};
    };
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        // Oblong, of many facets a pressure.
        const auto meeting = [&] {
            BlockAndFloor out;
            const auto wave = [](double x, double y) {
                return 3.4 + 0.1 * std::sin(0.9 * x + 0.7 * y);
            };
            for (GridBody* body : {&out.floor, &out.block}) body->components = 3;
            add_face(out.floor, false, 0.5, 6.4, 12, wave);
            add_face(out.block, true, 0.2, 6.1, 7, wave);
            for (GridBody* body : {&out.floor, &out.block})
                for (std::size_t i = 0; i < body->position.size(); i += 3) body->position[i] *= 0.6;
            std::mt19937_64 random(seed);
            out.floor.fill(random, 1.0, 0.5);
            out.block.fill(random, 1.0, 0.5);
            return out;
        };
        BlockAndFloor m = meeting(), other = meeting();
        for (GridBody* body : {&other.floor, &other.block})
            for (std::vector<double>* list : {&body->position, &body->v, &body->v_old})
                for (std::size_t i = 0; i < list->size(); i += 3) {
                    const auto x = turned(&(*list)[i]);
                    std::copy(x.begin(), x.end(), list->begin() + static_cast<std::ptrdiff_t>(i));
                }
        SurfaceCall call(3), again(3);
        call.options.spacing = again.options.spacing = 1.0;
        ASSERT_EQ(call(m.floor, m.block), GRIT_OK) << call.error.message;
        ASSERT_EQ(again(other.floor, other.block), GRIT_OK) << again.error.message;
        EXPECT_EQ(again.totals.rows, call.totals.rows) << seed;
        for (std::size_t i = 0; i < m.block.v.size(); i += 3) {
            const auto v = turned(&m.block.v[i]);
            for (std::size_t d = 0; d < 3; ++d)
                EXPECT_NEAR(other.block.v[i + d], v[d], 1e-8) << seed;
        }
    }
}

TEST(SurfaceContact, BesideAStretchFarAwayHasTheSameBits) {
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            Meeting alone(components, seed), beside(components, seed);
            GridBody& body = beside.a;
            const auto first = static_cast<std::ptrdiff_t>(body.position.size());
            add_face(body, false, 0.5, 6.4, 6, [](double, double) { return 3.0; });
            std::for_each(body.position.begin() + first, body.position.end(),
                          [](double& x) { x -= 100.0; });
            SurfaceCall call(components, 0.3);
            call.options.spacing = 1.5;
            ASSERT_EQ(call(alone.a, alone.b), GRIT_OK) << call.error.message;
            ASSERT_EQ(call(beside.a, beside.b), GRIT_OK) << call.error.message;
            EXPECT_EQ(beside.a.v, alone.a.v) << components << ' ' << seed;
            EXPECT_EQ(beside.b.v, alone.b.v) << components << ' ' << seed;
        }
}

// A rigid floor of seven cells a side; a block of layers, of which the first touches it in so many cells.
struct LayersOnAFloor {
    GridBody floor, block;
    LayersOnAFloor(int components, int cells) {
        floor.components = block.components = components;
        add_face(floor, false, 0.0, 7.0, 7, [](double, double) { return 3.0; });
        add_face(block, true, 0.0, 7.0, cells, [](double, double) { return 3.0; });
        floor.rigid = true;
    }
};

// Two points of integration for each piece of a facet between ends of those above it; what roundoff leaves between ends of
// several layers is none.
TEST(SurfaceContact, HasTwoPointsForEachPieceOfAFacet) {
    LayersOnAFloor of(2, 5);
    auto& [floor, block] = of;
    add_face(block, true, 1e-11, 7.0 - 1e-11, 5, [](double, double) { return 3.5; });
    std::mt19937_64 random(1);
    block.fill(random, 1.0, 0.0);
    SurfaceCall call(2);
    ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
    EXPECT_EQ(call.totals.points, 2 * (7 + 4));
}

TEST(SurfaceContact, TakesTheSmallestAndTheLargestSpacing) {
    for (const double spacing : {1.0 / 1e30, 1e30}) {
        Meeting m(2, 2);
        SurfaceCall call;
        call.options.spacing = spacing;
        EXPECT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
        EXPECT_EQ(call.totals.rows > 0, spacing < 1.0);  // beside 1e30 facets are points
    }
}

// A rigid surface that moves, too: its vertices' velocities stand beside them.
TEST(SurfaceContact, OnARigidBodyIsTheSameInAMovingFrame) {
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            Meeting still(components, seed, 1.0), moving(components, seed, 1.0);
            for (Meeting* m : {&still, &moving}) {
                m->a.rigid = true;
                std::fill(m->b.fixed.begin(), m->b.fixed.end(), 0);
            }
            const auto n = static_cast<std::size_t>(components);
            const auto of_frame = [n](std::size_t i) { return i % n == 0 ? 3.0 : -2.0; };
            for (std::size_t i = 0; i < moving.b.v.size(); ++i) moving.b.v[i] += of_frame(i);
            for (std::size_t i = 0; i < moving.a.vertex_velocity.size(); ++i)
                moving.a.vertex_velocity[i] = of_frame(i);
            SurfaceCall call(components, 0.3), other(components, 0.3);
            call.options.spacing = other.options.spacing = 1.7;
            ASSERT_EQ(call(still.a, still.b), GRIT_OK) << call.error.message;
            ASSERT_EQ(other(moving.a, moving.b), GRIT_OK) << other.error.message;
            ASSERT_GT(call.totals.pressures, 0);
            for (std::size_t i = 0; i < still.b.v.size(); ++i)
                EXPECT_NEAR(moving.b.v[i] - of_frame(i), still.b.v[i], 1e-9);
        }
}

// Pressures are as far apart as the facets say, whatever the options do.
TEST(SurfaceContact, TakesTheSpacingOfFacetsBeforeThatOfTheOptions) {
    for (const int components : {2, 3}) {
        std::ptrdiff_t alike = 0, closer = 0;
        for (const unsigned seed : {1u, 2u, 3u, 4u}) {
            Meeting of_options(components, seed), of_facets = of_options, graded = of_options;
            SurfaceCall call(components, 0.3);
            of_facets.a.spacing.assign(of_options.a.facet.size(), call.options.spacing);
            graded.a.spacing.assign(of_options.a.facet.size(), 0.25 * call.options.spacing);
            ASSERT_EQ(call(of_options.a, of_options.b), GRIT_OK);
            alike += call.totals.pressures;
            call.options.spacing = 1e-3;
            ASSERT_EQ(call(of_facets.a, of_facets.b), GRIT_OK);
            EXPECT_EQ(of_facets.a.v, of_options.a.v);
            EXPECT_EQ(of_facets.b.v, of_options.b.v);
            ASSERT_EQ(call(graded.a, graded.b), GRIT_OK);
            closer += call.totals.pressures;
        }
        EXPECT_GT(closer, alike);
    }
}

// A face of seven spacings: what is next to its ends keeps away from them, what is between them does not.
TEST(SurfaceContact, KeepsItsPressuresAwayFromTheEndsOfAStretch) {
    for (const auto& [ends, rows] : {std::pair{1.0, 8}, {2.0, 6}, {3.0, 4}, {4.0, 3}}) {
        auto [floor, block] = block_above_floor(14, 0.0, 1.0);
        SurfaceCall call(2);
        call.options.spacing = 1.0;
        call.options.end_spacings = ends;
        ASSERT_EQ(call(floor, block), GRIT_OK);
        EXPECT_EQ(call.totals.rows, rows) << ends;
        for (std::size_t v = 0; v < block.vertices(); ++v)
            EXPECT_NEAR(block.velocity_of_vertex(v), 0.0, 1e-9) << ends;
    }
}

// What lies behind the nearest facet is not met.
TEST(SurfaceContact, MeetsTheNearestOfSeveralLayers) {
    for (const int components : {2, 3}) {
        LayersOnAFloor of(components, 7);
        GridBody &floor = of.floor, &block = of.block;
        add_face(block, true, 0.0, 7.0, 5, [](double, double) { return 3.005; });
        std::mt19937_64 random(1);
        block.fill(random, 0.0, 0.0);
        block.weigh(0.0, 7.0);
        const auto n = static_cast<std::size_t>(components);
        for (std::size_t i = n - 1; i < block.v.size(); i += n) block.v[i] = -1.0;
        SurfaceCall call(components);
        ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
        EXPECT_NEAR(call.totals.area, components == 2 ? 7.0 : 49.0, 1e-12);
        // Nodes of the layers' lines, at the middle and the ends of the first, along its height.
        const std::size_t plane = components == 2 ? 8 : 64, row = components == 2 ? 0 : 32;
        const auto at = [&](std::size_t x, std::size_t z) {
            return block.v[n * (x + row + z * plane) + n - 1];
        };
        for (const std::size_t x : {0u, 4u, 7u})
            EXPECT_NEAR(at(x, 3), 0.0, components == 2 ? 1e-9 : 0.08);
        EXPECT_EQ(at(4, 4), -1.0);  // of the other layer's upper line
    }
}

// As deep as the reach it still is in front.
TEST(SurfaceContact, MeetsWhatIsAsDeepAsTheReach) {
    for (const int components : {2, 3}) {
        LayersOnAFloor of(components, 7);
        auto& [floor, block] = of;
        add_face(block, true, 0.0, 7.0, 7, [](double, double) { return 2.0; });
        std::mt19937_64 random(1);
        block.fill(random, 0.0, 0.0);
        SurfaceCall call(components);
        ASSERT_EQ(call.options.reach, 1.0);
        ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
        EXPECT_NEAR(call.totals.area, components == 2 ? 7.0 : 49.0, 1e-12);
        EXPECT_EQ(call.totals.smallest_gap, -1.0);
    }
}

TEST(SurfaceContact, ChangesNothingWhereItIsRefusedOrOnlyValidates) {
    Meeting m(2, 2);
    const GridBody a = m.a, b = m.b;
    SurfaceCall call(2, 0.3);
    call.options.validate_only = 1;
    ASSERT_EQ(call(m.a, m.b), GRIT_OK);
    EXPECT_GT(call.totals.normal_impulse, 0.0);
    EXPECT_EQ(m.a.v, a.v);
    EXPECT_EQ(m.b.v, b.v);
    call.options.validate_only = 0;
    struct Bad {
        const char* text;
        grit_status status;
        void (*spoil)(Meeting&, SurfaceCall&);
    };
    const Bad all[] = {
        {"components must be 2 or 3", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.components = 4; }},
        {"axisymmetric needs components 2", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.axisymmetric = 1, c.options.components = 3; }},
        {"time_step must be in [1e-30, 1e30] (time), got 0", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.time_step = 0.0; }},
        {"spacing must be in [1e-30, 1e30] (length), got nan", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.spacing = std::nan(""); }},
        {"end_spacings must be in [1, 10], got 0.5", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.end_spacings = 0.5; }},
        {"contact_stiffness must be in [0, 1e30] (stress / length), got -1", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.contact_stiffness = -1.0; }},
        {"relaxation_time must be in [0, 1e30] (time), got nan", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.relaxation_time = std::nan(""); }},
        {"relaxation_time needs a contact_stiffness, got 2 without", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.relaxation_time = 2.0; }},
        {"surface a facet 4: spacing must be in [1e-30, 1e30] (length), got 0", GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall&) {
             x.a.spacing.assign(x.a.facet.size(), 1.0);
             x.a.spacing[4] = 0.0;
         }},
        {"reach must be", GRIT_BAD_CALL, [](Meeting&, SurfaceCall& c) { c.options.reach = -1.0; }},
        {"sweep_limit must be in [1, 100000], got 0", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.sweep_limit = 0; }},
        {"sweep_tolerance must be in (0, 1], got 0", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.sweep_tolerance = 0.0; }},
        {"friction_coefficient must be in [0, 1e6], got -1", GRIT_BAD_CALL,
         [](Meeting&, SurfaceCall& c) { c.options.friction_coefficient = -1.0; }},
        {"surface a: facet must be in [0, 12), got 12", GRIT_BAD_CALL,
         [](Meeting& x, SurfaceCall&) { x.a.facet[3] = 12; }},
        {"surface b: node must be in [0, 64), got 64", GRIT_BAD_CALL,
         [](Meeting& x, SurfaceCall&) { x.b.node[0] = 64; }},
        {"surface b vertex 0: the weights must add up to 1 within 1e-6", GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall&) { x.b.weight[0] *= 0.5; }},
        {"surface b vertex 0: weight must be in [0, 1], got -0.5", GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall&) { x.b.weight[0] = -0.5; }},
        {"surface b 3: vertex velocity 1 must be within +-1e30 (length / time), got nan",
         GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall&) {
             x.b.rigid = true;
             x.b.vertex_velocity[7] = std::nan("");
         }},
        {"surface a vertex 2: position 1 must be within +-1e30 (length), got inf", GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall&) {
             x.a.position[5] = std::numeric_limits<double>::infinity();
         }},
        {"mass must be in [1e-30, 1e30] (mass) where a vertex has weight, got 0", GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall&) { x.b.mass.assign(64, 0.0); }},
        {"velocity 0 must be within +-1e30 (length / time), got nan", GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall&) { x.a.v.assign(128, std::nan("")); }},
        {"surface a: fixed must be bits of 2 components in [0, 3], got 4", GRIT_BAD_CALL,
         [](Meeting& x, SurfaceCall&) { x.a.fixed.assign(64, 4); }},
        {"surface a and surface b are both rigid", GRIT_BAD_CALL,
         [](Meeting& x, SurfaceCall&) { x.a.rigid = x.b.rigid = true; }},
        {"r must be >= 0 (length) in axisymmetry", GRIT_BAD_STATE,
         [](Meeting& x, SurfaceCall& c) { c.options.axisymmetric = 1, x.a.position[0] = -0.1; }}};
    for (const Bad& bad : all) {
        Meeting x(2, 2);
        SurfaceCall refused(2, 0.3);
        bad.spoil(x, refused);
        const GridBody before = x.b;
        EXPECT_EQ(refused(x.a, x.b), bad.status) << bad.text;
        EXPECT_NE(std::string(refused.error.message).find(bad.text), std::string::npos)
            << refused.error.message;
        EXPECT_EQ(std::memcmp(x.b.v.data(), before.v.data(), x.b.v.size() * sizeof(double)), 0);
    }
}

TEST(SurfaceContact, RefusesMemoryThatWouldBeWrittenTwice) {
    Meeting m(2, 2);
    const grit_surface a = m.a.surface(), b = m.b.surface();
    SurfaceCall call(2);
    call.workspace.resize(grit_surface_workspace_size(&a, &b));
    const auto text_of = [&](const grit_surface& one, const grit_surface& other) {
        const std::vector<double> before = m.a.v;
        EXPECT_EQ(grit_surface_correct(&call.options, &one, &other, call.workspace.data(),
                                       call.workspace.size() * sizeof(double), nullptr, nullptr,
                                       nullptr, &call.error),
                  GRIT_BAD_CALL);
        EXPECT_EQ(m.a.v, before);
        return std::string(call.error.message);
    };
    grit_surface close = a;
    close.velocity.point_stride = 1;
    EXPECT_EQ(text_of(close, b),
              "surface a: velocity is written: strides of 1 (nodes) and 1 (components) put two of "
              "its numbers in one place");
    grit_surface same = b;
    same.velocity = a.velocity;
    EXPECT_EQ(text_of(a, same), "surface a and surface b: velocity is written to the same memory");
}

TEST(SurfaceContact, SaysHowMuchMemoryItNeeds) {
    Meeting m(2, 2);
    const GridBody before = m.b;
    const grit_surface a = m.a.surface(), b = m.b.surface();
    SurfaceCall call(2);
    std::vector<double> workspace(512);
    std::size_t needed = 0;
    ASSERT_EQ(grit_surface_correct(&call.options, &a, &b, workspace.data(), 4096, &needed, nullptr,
                                   nullptr, &call.error),
              GRIT_BAD_CALL);
    EXPECT_GT(needed, 4096u);
    EXPECT_NE(std::string(call.error.message).find("too small"), std::string::npos);
    EXPECT_EQ(m.b.v, before.v);
}

// A body whose vertices are nodes of their own.
struct FreeBody {
    std::vector<double> position, mass, v, weight;
    std::vector<double> facet_spacing = {};  // empty: that of the options
    std::vector<std::ptrdiff_t> facet, node;
    int components = 2;

    FreeBody(int of, std::vector<double> x, std::vector<std::ptrdiff_t> facets, double each)
        : position(std::move(x)), facet(std::move(facets)), components(of) {
        const std::size_t n = position.size() / static_cast<std::size_t>(components);
        mass.assign(n, each);
        weight.assign(n, 1.0);
        v.assign(position.size(), 0.0);
        for (std::size_t i = 0; i < n; ++i) node.push_back(static_cast<std::ptrdiff_t>(i));
    }
    void move(double along_last) {
        const auto c = static_cast<std::size_t>(components);
        for (std::size_t i = c - 1; i < v.size(); i += c) v[i] = along_last;
    }
    grit_surface surface() {
        grit_surface s{};
        s.struct_size = sizeof s;
        s.nodes_each = 1;
        s.vertices = s.nodes = static_cast<std::ptrdiff_t>(mass.size());
        s.facets = static_cast<std::ptrdiff_t>(facet.size()) / components;
        s.position = grit_view_of(position.data(), components, 1);
        s.facet = facet.data();
        s.node = node.data();
        s.weight = weight.data();
        s.mass = grit_view_of(mass.data(), 1, 1);
        s.velocity = grit_mutable_view_of(v.data(), components, 1);
        if (!facet_spacing.empty()) s.spacing = facet_spacing.data();
        return s;
    }
};

SurfaceCall call_of(int components, double spacing, double reach, double mu = 0.0) {
    SurfaceCall call(components, mu);
    call.options.spacing = spacing;
    call.options.reach = reach;
    return call;
}

TEST(SurfaceContact, LooksAtNoVertexOfNoFacet) {
    FreeBody a(2, {0, 0, 1, 0, 0, 0}, {1, 0}, 1.0), b(2, {0, 0, 1, 0}, {0, 1}, 1.0);
    a.node[2] = std::ptrdiff_t{1} << 40;
    a.position[4] = std::nan("");
    b.move(-1.0);
    SurfaceCall call = call_of(2, 1.0, 0.5);
    EXPECT_EQ(call(a, b), GRIT_OK) << call.error.message;
    EXPECT_GT(call.totals.normal_impulse, 0.0);
}

// Long sides of a wedge leave the reach of a plane; its tip does not.
TEST(SurfaceContact, MeetsTheTipOfAWedgeHoweverLongItsSidesAre) {
    for (const double side : {0.1, 0.4, 1.0, 100.0}) {
        FreeBody plane(2, {-500, 0, 500, 0}, {1, 0}, 10.0);
        FreeBody wedge(2, {-side, side - 0.05, 0, -0.05, side, side - 0.05}, {0, 1, 1, 2}, 1.0);
        wedge.move(-1.0);
        SurfaceCall call = call_of(2, 0.2, 0.1);
        ASSERT_EQ(call(plane, wedge), GRIT_OK) << call.error.message;
        EXPECT_GT(call.totals.points, 0) << side;
        EXPECT_GT(call.totals.normal_impulse, 0.0) << side;
    }
}

// (V2): a block in a corner presses on what it moves towards; along a smooth turn it would press on both sides.
TEST(SurfaceContact, HasPressuresOfItsOwnOnEachSideOfATurn) {
    const std::vector<double> x{0, 0, 1, 0, 0, 1};
    FreeBody corner(2, x, {1, 0, 0, 2}, 1e6), block(2, x, {0, 1, 2, 0}, 1.0);
    block.move(-1.0);
    SurfaceCall call = call_of(2, 2.0, 0.1);
    ASSERT_EQ(call(corner, block), GRIT_OK) << call.error.message;
    EXPECT_EQ(call.totals.rows, 4);
    EXPECT_EQ(call.totals.impulse_on_b[0], 0.0);
    EXPECT_NEAR(block.v[1], 0.0, 1e-5);
    EXPECT_NEAR(block.v[3], 0.0, 1e-5);
    EXPECT_EQ(block.v[5], -1.0);
}

// What a step may have: masses of 1e-30 to 1e30.
TEST(SurfaceContact, TakesTheSmallestAndTheLargestMass) {
    for (const double mass : {1e-30, 1e30}) {
        FreeBody floor(2, {0, 0, 1, 0}, {1, 0}, mass), block(2, {0, 0, 1, 0}, {0, 1}, mass);
        block.move(-1.0);
        SurfaceCall call = call_of(2, 1.0, 0.1);
        ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
        EXPECT_NEAR(block.v[1], -0.5, 1e-12);
        EXPECT_NEAR(floor.v[3], -0.5, 1e-12);
    }
}

// Nodes that are held have all of the weight but for roundoff: nothing is there that could give way, and what the rest
// would need is no impulse.
// Found by a fuzzer: with steps whose square underflows the compliance of a layer was no number.
TEST(SurfaceContact, OfALayerTakesTheShortestStepAndRefusesShorterOnes) {
    for (const double step : {1e-30, 1e30}) {
        Meeting meeting(2, 4, 0.0);
        SurfaceCall call;
        call.options.time_step = step;
        call.options.contact_stiffness = 1.0;
        ASSERT_EQ(call(meeting.a, meeting.b), GRIT_OK) << call.error.message;
        for (const double v : meeting.a.v) EXPECT_TRUE(std::isfinite(v)) << step;
        EXPECT_TRUE(std::isfinite(call.totals.normal_impulse));
        if (step < 1.0) {
            EXPECT_LT(call.totals.normal_impulse, 1e-25);
        }
    }
    Meeting meeting(2, 4, 0.0);
    SurfaceCall call;
    call.options.time_step = 1e-31;
    EXPECT_EQ(call(meeting.a, meeting.b), GRIT_BAD_CALL);
}

TEST(SurfaceContact, MovesNothingThatHangsOnByRoundoff) {
    auto [floor, block] = block_above_floor(7, 0.0, 1.0);
    for (std::size_t k = 0; k < block.weight.size(); ++k) {
        const auto node = static_cast<std::size_t>(block.node[k]);
        if (block.weight[k] > 0.0) {
            block.weight[k] *= 1.0 - 0x1p-53;
            block.fixed[node] = 3;
            block.v[2 * node] = block.v[2 * node + 1] = 0.0;
        } else {
            block.weight[k] = 1e-16;
        }
    }
    SurfaceCall call(2, 0.5);
    const std::vector<double> before = block.v;
    ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
    EXPECT_GT(call.totals.points, 0);
    EXPECT_EQ(block.v, before);
    EXPECT_EQ(call.totals.normal_impulse, 0.0);
}

// What moves along together approaches by roundoff alone, which no sweep makes less.
TEST(SurfaceContact, NeedsFewSweepsWhereNothingApproaches) {
    for (const int components : {2, 3}) {
        Meeting m(components, 2);
        const double speed[] = {0.7, 0.1, 0.3};
        for (GridBody* body : {&m.a, &m.b}) {
            std::fill(body->fixed.begin(), body->fixed.end(), 0);
            for (std::size_t i = 0; i < body->v.size(); ++i)
                body->v[i] = speed[i % static_cast<std::size_t>(components)];
            body->v_old = body->v;
        }
        SurfaceCall call(components, 0.3);
        ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
        EXPECT_GT(call.totals.points, 0);
        EXPECT_LT(call.totals.largest_approach, 1e-14);
        EXPECT_LE(call.totals.sweeps, 3);
        for (std::size_t i = 0; i < m.a.v.size(); ++i)
            EXPECT_NEAR(m.a.v[i], speed[i % static_cast<std::size_t>(components)], 1e-12);
    }
}

// Where spacings jump, points may have no pressure within reach; the nearest one has them then.
TEST(SurfaceContact, LeavesNoPointWithoutAPressureHoweverSpacingsJump) {
    constexpr int facets = 400;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> decades(-1.5, 0.5);
    for (int trial = 0; trial < 40; ++trial) {
        const int alike = 1 + trial % 40;
        std::vector<double> x, spacing;
        std::vector<std::ptrdiff_t> up, down;
        for (int i = 0; i <= facets; ++i) x.insert(x.end(), {0.01 * i, 0.0});
        for (int i = 0; i < facets; ++i) {
            up.insert(up.end(), {i + 1, i});
            down.insert(down.end(), {i, i + 1});
            spacing.push_back(i % alike == 0 ? std::pow(10.0, decades(random)) : spacing.back());
        }
        FreeBody floor(2, x, up, 1e6), block(2, x, down, 1.0);
        floor.facet_spacing = spacing;
        block.move(-1.0);
        SurfaceCall call = call_of(2, 1.0, 0.1);
        ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
        ASSERT_EQ(call.reports.size(), facets);
        for (const grit_surface_report& facet : call.reports)
            EXPECT_GT(facet.normal_force, 0.0) << trial;
    }
}

// Per radian: areas are integrals of r, also where r is small.
TEST(SurfaceContact, InAxisymmetryHasTheAreaOfARadianBesideTheAxisToo) {
    for (const double R : {0.02, 1.0, 50.0}) {
        FreeBody floor(2, {0, 0, R, 0}, {1, 0}, 1e6), block(2, {0, 0, R, 0}, {0, 1}, 1.0);
        block.move(-1.0);
        SurfaceCall call = call_of(2, R, 0.1 * R);
        call.options.axisymmetric = 1;
        ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
        EXPECT_NEAR(call.totals.area, 0.5 * R * R, 1e-12 * R * R);
        EXPECT_NEAR(block.v[3], 0.0, 1e-5);
    }
}

TEST(SurfaceContact, MeetsASmallFacetOnALargeOne) {
    FreeBody floor(3, {-100, -100, 0, 100, -100, 0, 0, 100, 0}, {0, 1, 2}, 10.0);
    FreeBody small(3, {0, 0, 0, 0.003, 0, 0, 0, 0.003, 0}, {0, 2, 1}, 1.0);
    small.move(-1.0);
    SurfaceCall call = call_of(3, 1.0, 0.1);
    ASSERT_EQ(call(floor, small), GRIT_OK) << call.error.message;
    EXPECT_NEAR(call.totals.area, 0.5 * 0.003 * 0.003, 1e-12);
    EXPECT_GT(call.totals.normal_impulse, 0.0);
}

// Small facets behind another, close to the middle of each of its sides: met beyond the side, and not within it.
TEST(SurfaceContact, InSpaceMeetsWhatLiesBehindAFacetBeyondItsSidesAlone) {
    constexpr double size = 1e-3, from_side = 0.004;  // legs [m]; share of the corner opposite
    for (const double sign : {1.0, -1.0}) {
        FreeBody floor(3, {-100, -100, 0, 100, -100, 0, 0, 100, 0}, {0, 1, 2}, 1.0);
        std::vector<double> x{0, 0, 0, 1, 0, 0, 0, 1, 0};
        std::vector<std::ptrdiff_t> facets{0, 2, 1};
        for (int side = 0; side < 3; ++side) {
            double share[3];
            for (int k = 0; k < 3; ++k)
                share[k] = k == side ? sign * from_side : 0.5 * (1.0 - sign * from_side);
            const double y[2] = {share[1] - size / 3.0, share[2] - size / 3.0};
            const auto first = static_cast<std::ptrdiff_t>(x.size() / 3);
            x.insert(x.end(), {y[0], y[1], 0.01, y[0] + size, y[1], 0.01, y[0], y[1] + size, 0.01});
            facets.insert(facets.end(), {first, first + 2, first + 1});
        }
        FreeBody layers(3, x, facets, 1.0);
        layers.move(-1.0);
        SurfaceCall call = call_of(3, 1.0, 0.1);
        ASSERT_EQ(call(floor, layers), GRIT_OK) << call.error.message;
        const double met = sign > 0.0 ? 0.5 : 0.5 + 3.0 * 0.5 * size * size;
        EXPECT_NEAR(call.totals.area, met, 1e-9);
    }
}

// Slivers, as surface meshes have them, carry next to nothing and disturb nothing.
TEST(SurfaceContact, InSpaceIsNotDisturbedBySlivers) {
    double impulse[2];
    for (const bool with : {false, true}) {
        FreeBody floor(3, {0, 0, 0, 3, 0, 0, 3, 3, 0, 0, 3, 0}, {0, 1, 2, 0, 2, 3}, 1.0);
        std::vector<double> x{0.5, 0.5, 0, 2.5, 0.5, 0, 2.5, 2.5, 0, 0.5, 2.5, 0};
        std::vector<std::ptrdiff_t> facets{0, 2, 1, 0, 3, 2};
        if (with) {  // 2 m by 5 nm below the edge from vertex 0 to 1
            x.insert(x.end(), {0.5, 0.5 - 5e-9, 0, 2.5, 0.5 - 5e-9, 0});
            facets.insert(facets.end(), {4, 0, 1, 4, 1, 5});
        }
        FreeBody plate(3, x, facets, 1.0);
        plate.mass.resize(4 + (with ? 2 : 0), 1.0);
        if (with) plate.mass[4] = plate.mass[5] = 1e-9;
        plate.move(-1.0);
        SurfaceCall call = call_of(3, 1.0, 0.5);
        ASSERT_EQ(call(floor, plate), GRIT_OK) << call.error.message;
        impulse[with] = call.totals.normal_impulse;
    }
    EXPECT_GT(impulse[0], 0.5);
    EXPECT_NEAR(impulse[1], impulse[0], 1e-3 * impulse[0]);
}

// Vertices and facets in another order, and facets from another corner on.
void shuffle(GridBody& body, std::mt19937_64& random) {
    const auto n = body.vertices(), each = static_cast<std::size_t>(body.corners());
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    const GridBody before = body;
    std::vector<std::ptrdiff_t> now(n);
    for (std::size_t v = 0; v < n; ++v) {
        const std::size_t old = order[v];
        now[old] = static_cast<std::ptrdiff_t>(v);
        for (std::size_t c = 0; c < 3; ++c) body.position[3 * v + c] = before.position[3 * old + c];
        for (std::size_t k = 0; k < each; ++k) {
            body.node[each * v + k] = before.node[each * old + k];
            body.weight[each * v + k] = before.weight[each * old + k];
        }
    }
    std::vector<std::array<std::ptrdiff_t, 3>> facets;
    for (std::size_t f = 0; f < body.facet.size(); f += 3) {
        std::array<std::ptrdiff_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = now[static_cast<std::size_t>(before.facet[f + k])];
        std::rotate(corners.begin(), corners.begin() + static_cast<int>(random() % 3),
                    corners.end());
        facets.push_back(corners);
    }
    std::shuffle(facets.begin(), facets.end(), random);
    for (std::size_t f = 0; f < facets.size(); ++f)
        std::copy(facets[f].begin(), facets[f].end(),
                  body.facet.begin() + 3 * static_cast<std::ptrdiff_t>(f));
}

// What is its own mirror image about the diagonal of the first two directions stays so, whatever the order of its parts.
// A step in a flat face that is thinner than any spacing bears nothing to the side.
TEST(SurfaceContact, DoesNotFeelFacetsThatAreAsThinAsRoundoff) {
    for (const int components : {2, 3})
        for (const double thin : {0.0, 1e-12, 1e-9, 1e-7}) {
            const double level = 3.3, x[4] = {0.5, 3.1, 3.1 + thin, 6.4};
            GridBody a, b;
            std::mt19937_64 random(3);
            a.components = b.components = components;
            const std::ptrdiff_t rows = components == 2 ? 1 : 2;
            for (std::ptrdiff_t row = 0; row < rows; ++row)
                for (int i = 0; i < 4; ++i) {
                    const double height = i < 2 ? level : level - thin;
                    const double across = row == 0 ? 0.5 : 6.4;
                    if (components == 2) a.add_vertex({x[i], height, 0.0});
                    else a.add_vertex({x[i], across, height});
                }
            for (std::ptrdiff_t i = 0; i < 3; ++i)
                if (components == 2) a.facet.insert(a.facet.end(), {i + 1, i});
                else a.facet.insert(a.facet.end(), {i, i + 1, i + 5, i, i + 5, i + 4});
            add_face(b, true, 0.2, 6.1, 4, [=](double, double) { return level; });
            for (GridBody* body : {&a, &b}) body->fill(random, 0.0, 1.0);
            for (std::size_t i = 0; i < b.v.size(); ++i) {
                const auto c = static_cast<int>(i) % components;
                b.v[i] = c == 0 ? -1.0 : c == components - 1 ? -0.1 : 0.0;
            }
            SurfaceCall call(components);
            ASSERT_EQ(call(a, b), GRIT_OK) << call.error.message;
            EXPECT_GT(call.totals.normal_impulse, 0.0);
            for (std::size_t i = 0; i < b.v.size(); i += static_cast<std::size_t>(components)) {
                EXPECT_NEAR(b.v[i], -1.0, 1e-9) << thin;
                EXPECT_NEAR(a.v[i], 0.0, 1e-9) << thin;
            }
        }
}

TEST(SurfaceContact, InSpaceIsTheSameOnBothSidesOfAMirror) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        std::mt19937_64 random(seed);
        const auto dice = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        const double phase = dice(0.0, 6.0);
        const auto wave = [&](double x, double y) {
            return 3.4 + 0.2 * std::sin(0.8 * (x + y) + phase) * std::cos(0.6 * (x - y));
        };
        GridBody a, b;
        a.components = b.components = 3;
        add_face(a, false, 0.5, 6.5, 6, wave);
        // Alike, so that corners and sides of the one lie on sides of the other; or not.
        if (seed % 3 == 0) add_face(b, true, 0.5, 6.5, 12, wave);
        else add_face(b, true, dice(0.1, 0.4), dice(6.0, 6.8), 5, wave);
        const std::ptrdiff_t size = a.size;
        const auto mirror = [size](std::ptrdiff_t node) {
            const std::ptrdiff_t i = node % size, j = node / size % size;
            return static_cast<std::size_t>(node - i - j * size + j + i * size);
        };
        for (GridBody* body : {&a, &b}) {
            body->fill(random, 1.0, 1.0);
            for (std::ptrdiff_t node = 0; node < body->nodes(); ++node) {
                const std::size_t to = mirror(node), from = static_cast<std::size_t>(node);
                body->mass[to] = body->mass[from];
                body->v[3 * to] = body->v[3 * from + 1];
                body->v[3 * to + 1] = body->v[3 * from];
                body->v[3 * to + 2] = body->v[3 * from + 2];
                if (to == from) body->v[3 * to] = body->v[3 * to + 1];
            }
            shuffle(*body, random);
        }
        SurfaceCall call(3, 0.3);
        call.options.spacing = dice(1.0, 2.5);
        ASSERT_EQ(call(a, b), GRIT_OK) << call.error.message;
        EXPECT_LT(call.totals.sweeps, call.options.sweep_limit);
        EXPECT_GT(call.totals.normal_impulse, 0.0);
        for (const GridBody* body : {&a, &b})
            for (std::ptrdiff_t node = 0; node < body->nodes(); ++node)
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_NEAR(body->v[3 * mirror(node) + c],
                                body->v[3 * static_cast<std::size_t>(node) + (c < 2 ? 1 - c : 2)],
                                1e-10)
                        << seed << ' ' << node << ' ' << c;
    }
}

// A round pile thinner than the spacing: its normals turn by more than a right angle around a point of pressure.
TEST(SurfaceContact, InSpaceHoldsFrictionOnARoundBodyThinnerThanTheSpacing) {
    constexpr int sides = 16;
    std::vector<double> x;
    std::vector<std::ptrdiff_t> facets;
    for (int i = 0; i < sides; ++i)
        for (const double z : {0.0, 1.0}) {
            const double angle = 6.283185307179586 * i / sides;
            x.insert(x.end(), {0.5 * std::cos(angle), 0.5 * std::sin(angle), z});
        }
    for (std::ptrdiff_t i = 0; i < sides; ++i) {
        const std::ptrdiff_t a = 2 * i, b = 2 * ((i + 1) % sides);
        facets.insert(facets.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
    for (const double mu : {0.0, 0.5}) {
        FreeBody pile(3, x, facets, 1e3);
        // A plate beside it, at x = 0.5, that presses against it and slides upwards.
        FreeBody plate(3, {0.49, -1, 0, 0.49, 1, 0, 0.49, 1, 1, 0.49, -1, 1}, {0, 2, 1, 0, 3, 2},
                       1.0);
        for (std::size_t i = 0; i < 4; ++i) plate.v[3 * i] = -1.0, plate.v[3 * i + 2] = 0.2;
        SurfaceCall call = call_of(3, 2.0, 0.3, mu);
        ASSERT_EQ(call(pile, plate), GRIT_OK) << call.error.message;
        EXPECT_GT(call.totals.normal_impulse, 0.0);
        for (const double J : call.totals.impulse_on_a) EXPECT_TRUE(std::isfinite(J));
        if (mu > 0.0) {
            EXPECT_GT(call.totals.impulse_on_a[2], 0.05 * call.totals.normal_impulse);
        } else {
            EXPECT_NEAR(call.totals.impulse_on_a[2], 0.0, 1e-12);
        }
    }
}

TEST(SurfaceContact, DoesNotFeelFacetsFarAway) {
    double impulse[2];
    for (const bool far : {false, true}) {
        std::vector<double> x, y;
        std::vector<std::ptrdiff_t> facets, opposite;
        for (int i = 0; i <= 64; ++i) {
            x.insert(x.end(), {i / 16.0, 0.0});
            y.insert(y.end(), {i / 16.0, 0.0});
            if (i == 0) continue;
            facets.insert(facets.end(), {i, i - 1});
            if (i <= 16) opposite.insert(opposite.end(), {i - 1, i});
        }
        if (far) {
            x.insert(x.end(), {1004.0, 0.0});
            facets.insert(facets.end(), {65, 64});
        }
        FreeBody a(2, x, facets, 1.0), b(2, y, opposite, 1.0);
        b.move(-1.0);
        SurfaceCall call = call_of(2, 0.25, 0.1);
        ASSERT_EQ(call(a, b), GRIT_OK) << call.error.message;
        impulse[far] = call.totals.normal_impulse;
    }
    EXPECT_GT(impulse[0], 0.0);
    EXPECT_NEAR(impulse[1], impulse[0], 1e-9 * impulse[0]);
}

TEST(SurfaceContact, SaysHowMuchMemoryToTryWhereThereIsNone) {
    FreeBody a(2, {0, 0, 1, 0}, {1, 0}, 1.0), b(2, {0, 0, 1, 0}, {0, 1}, 1.0);
    const grit_surface of_a = a.surface(), of_b = b.surface();
    const SurfaceCall call = call_of(2, 1.0, 0.5);
    double memory[8];
    std::size_t needed = 0;
    EXPECT_EQ(grit_surface_correct(&call.options, &of_a, &of_b, memory, sizeof memory, &needed,
                                   nullptr, nullptr, nullptr),
              GRIT_BAD_CALL);
    EXPECT_EQ(needed, grit_surface_workspace_size(&of_a, &of_b));
}

}  // namespace
