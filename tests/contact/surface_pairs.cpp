// SPDX-License-Identifier: BSD-3-Clause
// Surface contacts of bodies that touch more than one other, solved together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "support/meeting_grids.hpp"

namespace {

using namespace tests;

struct PairsCall {
    struct One {
        grit_surface a, b;
        SurfaceCall call;
    };
    std::vector<One> pairs;
    std::vector<double> workspace;
    grit_error error{};

    void add(const grit_surface& a, const grit_surface& b, const SurfaceCall& call) {
        pairs.push_back({a, b, call});
        pairs.back().call.reports.resize(static_cast<std::size_t>(a.facets));
    }
    std::vector<grit_surface_pair> given() {
        std::vector<grit_surface_pair> out;
        for (One& p : pairs)
            out.push_back({&p.call.options, &p.a, &p.b, p.call.reports.data(), &p.call.totals});
        return out;
    }
    grit_status operator()() {
        const std::vector<grit_surface_pair> all = given();
        const auto n = static_cast<std::ptrdiff_t>(all.size());
        std::size_t needed = grit_surface_pairs_workspace_size(all.data(), n);
        grit_status status = GRIT_OK;
        do {
            workspace.resize(needed / sizeof(double) + 1);
            status = grit_surface_correct_pairs(all.data(), n, workspace.data(),
                                                workspace.size() * sizeof(double), &needed, &error);
        } while (needed > 0);
        return status;
    }
    std::ptrdiff_t sweeps(std::size_t i) const { return pairs[i].call.totals.sweeps; }
};

// A body between two others, a seventh of a cell thick or more: nodes of one serve both of its surfaces.
struct Sandwich {
    GridBody below, plate, above;
    // Vertices of both of the plate's surfaces, in the memory of one body.
    GridBody plate_from_above;

    Sandwich(int components, std::uint64_t seed, double thickness, double mass_spread,
             double highest = 0.1) {
        std::mt19937_64 random(seed);
        const auto dice = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        const double level = dice(3.0, 4.0), high = dice(0.0, highest), phase = dice(0.0, 6.0);
        const auto wave = [=](double x, double y) {
            return level + high * std::sin(0.9 * x + 0.7 * y + phase);
        };
        const auto top = [=](double x, double y) { return wave(x, y) + thickness; };
        for (GridBody* body : {&below, &plate, &above, &plate_from_above})
            body->components = components;
        const int n = components == 2 ? 11 : 4;
        add_face(below, false, 0.5, 6.4, n, wave);
        add_face(plate, true, 0.2, 6.1, n - 1, wave);
        add_face(plate_from_above, false, 0.2, 6.1, n - 1, top);
        add_face(above, true, 0.4, 6.3, n, top);
        for (GridBody* body : {&below, &plate, &above}) body->fill(random, 1.0, mass_spread);
        plate_from_above.mass = plate.mass;
        plate_from_above.v = plate.v;
        plate_from_above.v_old = plate.v_old;
        plate_from_above.fixed = plate.fixed;
    }
    // The plate's nodes once for both pairs, or copies of them with numbers.
    std::vector<std::ptrdiff_t> number;
    grit_surface plate_below() {
        grit_surface s = plate.surface();
        s.body = 7;
        return s;
    }
    grit_surface plate_above(bool copied) {
        grit_surface s = plate_from_above.surface();
        s.body = 7;
        if (copied) return s;
        s.velocity = grit_mutable_view_of(plate.v.data(), plate.components, 1);
        return s;
    }
    grit_status together(double mu, PairsCall& call, bool copied = false) {
        call.add(below.surface(), plate_below(), SurfaceCall(plate.components, mu));
        call.add(plate_above(copied), above.surface(), SurfaceCall(plate.components, mu));
        return call();
    }
    // What still approaches in either pair, by calls that only look.
    double left() {
        double largest = 0.0;
        for (const int which : {0, 1}) {
            SurfaceCall call(plate.components);
            call.options.validate_only = 1;
            GridBody& a = which == 0 ? below : plate_from_above;
            plate_from_above.v = plate.v;
            EXPECT_EQ(call(a, which == 0 ? plate : above), GRIT_OK) << call.error.message;
            largest = std::max(largest, call.totals.largest_approach);
        }
        return largest;
    }
    double kinetic() const { return below.kinetic() + plate.kinetic() + above.kinetic(); }
    std::array<double, 3> momentum() const {
        std::array<double, 3> sum = below.momentum();
        for (const GridBody* body : {&plate, &above})
            for (std::size_t c = 0; c < 3; ++c) sum[c] += body->momentum()[c];
        return sum;
    }
};

TEST(SurfacePairs, LeaveNothingThatApproachesABodyBetweenTwoOthers) {
    int left_by_calls_in_turn = 0;
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < 6; ++seed)
            for (const double thickness : {0.15, 0.5, 1.4}) {
                Sandwich together(components, seed, thickness, 0.5, 0.0);
                const double before = together.left();
                ASSERT_GT(before, 0.01);
                PairsCall call;
                ASSERT_EQ(together.together(0.0, call), GRIT_OK) << call.error.message;
                EXPECT_LT(together.left(), 1e-9 * before) << seed << ", " << thickness;

                Sandwich in_turn(components, seed, thickness, 0.5, 0.0);
                SurfaceCall first(components), second(components);
                ASSERT_EQ(first(in_turn.below, in_turn.plate), GRIT_OK);
                in_turn.plate_from_above.v = in_turn.plate.v;
                ASSERT_EQ(second(in_turn.plate_from_above, in_turn.above), GRIT_OK);
                in_turn.plate.v = in_turn.plate_from_above.v;
                left_by_calls_in_turn += in_turn.left() > 1e-2 * before;
            }
    EXPECT_GT(left_by_calls_in_turn, 18);
}

// Whatever pair is named first: of four bodies on top of each other the pair of the upper two is, and the body in common of
// the lower two is found before the other.
TEST(SurfacePairs, OfFourBodiesAreSolvedTogetherInAnyOrder) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        Sandwich lower(2, seed, 0.5, 0.5, 0.0);
        const double top = lower.above.position[1] + 0.4;
        GridBody under_lid, lid;
        add_face(under_lid, false, 0.2, 6.1, 10, [&](double, double) { return top; });
        add_face(lid, true, 0.4, 6.3, 11, [&](double, double) { return top; });
        std::mt19937_64 random(seed + 100);
        lid.fill(random, 1.0, 0.5);
        under_lid.mass = lower.above.mass;
        under_lid.v = under_lid.v_old = lower.above.v;
        under_lid.fixed = lower.above.fixed;
        grit_surface upper = under_lid.surface(), above = lower.above.surface();
        upper.velocity = above.velocity;
        upper.body = above.body = 9;
        PairsCall call;
        call.add(upper, lid.surface(), SurfaceCall(2));
        call.add(lower.below.surface(), lower.plate_below(), SurfaceCall(2));
        call.add(lower.plate_above(false), above, SurfaceCall(2));
        ASSERT_EQ(call(), GRIT_OK) << call.error.message;
        under_lid.v = lower.above.v;
        SurfaceCall look(2);
        look.options.validate_only = 1;
        ASSERT_EQ(look(under_lid, lid), GRIT_OK) << look.error.message;
        EXPECT_LT(look.totals.largest_approach, 1e-9) << seed;
        EXPECT_LT(lower.left(), 1e-9) << seed;
    }
}

TEST(SurfacePairs, KeepMomentumAndMakeNoEnergyHoweverEarlyTheirSweepsEnd) {
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            Sandwich bodies(components, seed, 0.4, 3.0);
            const double energy = bodies.kinetic();
            const auto momentum = bodies.momentum();
            PairsCall call;
            call.add(bodies.below.surface(), bodies.plate_below(), SurfaceCall(components, 0.6));
            call.add(bodies.plate_above(false), bodies.above.surface(),
                     SurfaceCall(components, seed % 2 == 0 ? 0.3 : 0.0));
            for (auto& pair : call.pairs)
                pair.call.options.sweep_limit = static_cast<int>(1 + seed % 5);
            ASSERT_EQ(call(), GRIT_OK) << call.error.message;
            EXPECT_LT(bodies.kinetic(), energy * (1.0 + 1e-12)) << seed;
            double taken = 0.0;
            for (const auto& pair : call.pairs)
                taken +=
                    pair.call.totals.dissipation_normal + pair.call.totals.dissipation_tangential;
            EXPECT_NEAR(taken, energy - bodies.kinetic(), 1e-10 * energy) << seed;
            double scale = 0.0;
            for (std::size_t i = 0; i < bodies.plate.mass.size(); ++i)
                scale += bodies.plate.mass[i] + bodies.below.mass[i] + bodies.above.mass[i];
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(bodies.momentum()[c], momentum[c], 1e-12 * scale) << seed;
        }
}

TEST(SurfacePairs, AreAlikeInMemoryOfTheirOwnAndInCommon) {
    Sandwich common(2, 3, 0.5, 1.0), copied(2, 3, 0.5, 1.0);
    PairsCall of_common, of_copied;
    ASSERT_EQ(common.together(0.4, of_common), GRIT_OK);
    // Numbers that are not places: nodes of the copy are turned round.
    std::vector<std::ptrdiff_t>& number = copied.number;
    const std::ptrdiff_t n = copied.plate.nodes();
    for (std::ptrdiff_t i = 0; i < n; ++i) number.push_back(1000 + i);
    std::vector<std::ptrdiff_t> back(number.rbegin(), number.rend());
    GridBody& other = copied.plate_from_above;
    for (std::ptrdiff_t& node : other.node) node = n - 1 - node;
    std::reverse(other.mass.begin(), other.mass.end());
    std::reverse(other.fixed.begin(), other.fixed.end());
    for (std::vector<double>* v : {&other.v, &other.v_old})
        for (std::ptrdiff_t i = 0; i < n / 2; ++i)
            std::swap_ranges(v->begin() + 2 * i, v->begin() + 2 * i + 2,
                             v->begin() + 2 * (n - 1 - i));
    grit_surface below = copied.plate_below(), above = copied.plate_above(true);
    below.number = number.data();
    above.number = back.data();
    of_copied.add(copied.below.surface(), below, SurfaceCall(2, 0.4));
    of_copied.add(above, copied.above.surface(), SurfaceCall(2, 0.4));
    ASSERT_EQ(of_copied(), GRIT_OK) << of_copied.error.message;
    EXPECT_EQ(copied.above.v, common.above.v);
    EXPECT_EQ(copied.below.v, common.below.v);
    const auto is_used = [](const GridBody& body, std::ptrdiff_t node) {
        for (std::size_t k = 0; k < body.node.size(); ++k)
            if (body.node[k] == node && body.weight[k] != 0.0) return true;
        return false;
    };
    int used_by_both = 0;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const bool below_uses = is_used(copied.plate, i), above_uses = is_used(other, n - 1 - i);
        used_by_both += below_uses && above_uses;
        for (const std::ptrdiff_t c : {0, 1}) {
            const double v = common.plate.v[static_cast<std::size_t>(2 * i + c)];
            if (below_uses) {
                EXPECT_EQ(copied.plate.v[static_cast<std::size_t>(2 * i + c)], v) << i;
            }
            if (above_uses) {
                EXPECT_EQ(other.v[static_cast<std::size_t>(2 * (n - 1 - i) + c)], v) << i;
            }
        }
    }
    EXPECT_GT(used_by_both, 5);
}

TEST(SurfacePairs, ThatHaveNothingInCommonHaveTheBitsOfCallsOfTheirOwn) {
    std::vector<Meeting> alone, together;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        alone.emplace_back(2, seed);
        together.emplace_back(2, seed);
    }
    std::vector<std::vector<std::ptrdiff_t>> numbers(alone.size());
    PairsCall all;
    for (std::size_t i = 0; i < alone.size(); ++i) {
        SurfaceCall call(2, 0.3);
        call.options.sweep_limit = static_cast<int>(20 * (i + 1));
        grit_surface a = together[i].a.surface(), b = together[i].b.surface();
        // The same body with other nodes has nothing in common.
        if (i < 2) a.body = 3;
        std::vector<std::ptrdiff_t>& number = numbers[i];
        for (std::ptrdiff_t k = 0; k < a.nodes; ++k)
            number.push_back(static_cast<std::ptrdiff_t>(i) * 100000 + k);
        a.number = number.data();
        all.add(a, b, call);
        ASSERT_EQ(call(alone[i].a, alone[i].b), GRIT_OK);
    }
    ASSERT_EQ(all(), GRIT_OK) << all.error.message;
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(together[i].a.v, alone[i].a.v) << i;
        EXPECT_EQ(together[i].b.v, alone[i].b.v) << i;
        EXPECT_LE(all.sweeps(i), static_cast<std::ptrdiff_t>(20 * (i + 1)));
    }
}

// What holds in one pair alone, a rigid wall, is not moved by the other; the plate in between is held as well.
TEST(SurfacePairs, HoldAPlateBetweenARigidWallAndWhatRunsIntoIt) {
    Sandwich bodies(2, 1, 0.3, 0.0);
    bodies.below.rigid = true;
    std::fill(bodies.below.vertex_velocity.begin(), bodies.below.vertex_velocity.end(), 0.0);
    for (GridBody* body : {&bodies.plate, &bodies.plate_from_above, &bodies.above})
        for (std::size_t i = 0; i < body->v.size(); ++i)
            body->v[i] = body->v_old[i] = i % 2 == 0 || body != &bodies.above ? 0.0 : -1.0;
    PairsCall call;
    ASSERT_EQ(bodies.together(0.0, call), GRIT_OK) << call.error.message;
    EXPECT_LT(bodies.left(), 1e-9);
    EXPECT_LT(bodies.above.momentum()[1], 0.0);  // beside the plate
    const double at_wall = call.pairs[0].call.totals.impulse_on_b[1];
    EXPECT_GT(at_wall, 1.0);
    EXPECT_NEAR(bodies.plate.momentum()[1], at_wall + call.pairs[1].call.totals.impulse_on_a[1],
                1e-12);
    EXPECT_NEAR(bodies.above.momentum()[1] + static_cast<double>(bodies.above.nodes()),
                call.pairs[1].call.totals.impulse_on_b[1], 1e-12);
}

TEST(SurfacePairs, ChangeNothingWhereOneOfThemIsRefused) {
    const auto refused = [](const auto& spoil, const char* why) {
        Sandwich bodies(2, 0, 0.5, 0.0);
        const std::vector<double> before = bodies.plate.v;
        PairsCall call;
        call.add(bodies.below.surface(), bodies.plate_below(), SurfaceCall());
        call.add(bodies.plate_above(false), bodies.above.surface(), SurfaceCall());
        spoil(call);
        EXPECT_NE(call(), GRIT_OK) << why;
        EXPECT_NE(std::strstr(call.error.message, why), nullptr) << call.error.message;
        EXPECT_EQ(bodies.plate.v, before);
    };
    refused([](PairsCall& c) { c.pairs[1].call.options.reach = 0.0; }, "pair 1: reach");
    refused([](PairsCall& c) { c.pairs[1].call.options.components = 3; },
            "pair 1: components must be those of pair 0, 2, got 3");
    refused([](PairsCall& c) { c.pairs[0].a.body = c.pairs[0].b.body; },
            "pair 0: surface a and surface b are of the same body, 7");
    refused([](PairsCall& c) { c.pairs[1].b.body = -1; },
            "pair 1: surface b: body must be >= 0, got -1");
    const double huge = 1e31;
    refused([&](PairsCall& c) { c.pairs[1].b.mass = grit_view_of(&huge, 0, 1); },
            "pair 1: surface b node");
}

TEST(SurfacePairs, SayHowMuchMemoryTheyNeed) {
    Sandwich bodies(2, 0, 0.5, 0.0);
    PairsCall call;
    call.add(bodies.below.surface(), bodies.plate_below(), SurfaceCall());
    call.add(bodies.plate_above(false), bodies.above.surface(), SurfaceCall());
    const auto given = call.given();
    const std::vector<double> before = bodies.plate.v;
    std::vector<double> workspace(8);
    std::size_t needed = 0;
    EXPECT_EQ(grit_surface_correct_pairs(given.data(), 2, workspace.data(), 8 * sizeof(double),
                                         &needed, nullptr),
              GRIT_BAD_CALL);
    EXPECT_EQ(needed, grit_surface_pairs_workspace_size(given.data(), 2));
    workspace.resize(512);
    for (int tries = 0; tries < 20; ++tries) {
        const grit_status status = grit_surface_correct_pairs(
            given.data(), 2, workspace.data(), workspace.size() * sizeof(double), &needed, nullptr);
        if (status == GRIT_OK) break;
        EXPECT_EQ(bodies.plate.v, before);
        ASSERT_GT(needed, workspace.size() * sizeof(double));
        workspace.resize(needed / sizeof(double));
    }
    EXPECT_EQ(needed, 0U);
    EXPECT_NE(bodies.plate.v, before);
    EXPECT_EQ(grit_surface_correct_pairs(nullptr, 0, nullptr, 0, nullptr, nullptr), GRIT_OK);
    grit_error error{};
    EXPECT_EQ(grit_surface_correct_pairs(nullptr, -1, nullptr, 0, nullptr, &error), GRIT_BAD_CALL);
    EXPECT_NE(std::strstr(error.message, "-1"), nullptr) << error.message;
    EXPECT_EQ(grit_surface_correct_pairs(nullptr, 2, workspace.data(), 4096, nullptr, &error),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_surface_pairs_workspace_size(nullptr, 2), 0U);
    error.point = 7;
    EXPECT_EQ(grit_surface_correct_pairs(given.data(), 2, workspace.data(), 4096, &needed, &error),
              GRIT_BAD_CALL);
    EXPECT_EQ(error.point, -1);  // of no facet
    EXPECT_NE(std::strstr(error.message, "workspace of 4096 bytes is too small"), nullptr);
    std::size_t of_each = 0;
    for (const grit_surface_pair& pair : given)
        of_each += grit_surface_workspace_size(pair.a, pair.b);
    EXPECT_GE(grit_surface_pairs_workspace_size(given.data(), 2), of_each);
}

}  // namespace
