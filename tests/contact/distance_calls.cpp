// SPDX-License-Identifier: BSD-3-Clause
// The reduction of distances at the border: memory layouts, lists, bad input.
#include <functional>

#include "support/surfaces.hpp"

namespace {

using namespace tests;

struct Scene {
    Dice dice{70};
    Surfaces s = random_surfaces(3, 6, dice);
    Domains d = random_domains(3, 5, 6, dice);
    grit_error error{};

    bool says(const char* part) const {
        return std::string(error.message).find(part) != std::string::npos;
    }
};

Surfaces expected() {
    Scene x;
    EXPECT_EQ(add(x.s, x.d, B), GRIT_OK);
    return x.s;
}

TEST(DistanceCall, TakesStructureOfArraysMemoryAndListsOfOneLength) {
    Scene x;
    std::vector<double> position, normal, particle, side, surface(12);
    for (int c = 0; c < 3; ++c) {
        for (const Vec3& at : x.s.position) position.push_back(at[c]);
        for (const Vec3& n : x.s.normal) normal.push_back(n[c]);
        for (const Domain& p : x.d.particles) particle.push_back(p.x[c]);
    }
    for (std::size_t j = 0; j < 3; ++j)
        for (int c = 0; c < 3; ++c)
            for (const Domain& p : x.d.particles) side.push_back(p.r[j][c]);
    std::vector<std::ptrdiff_t> node(5 * 6, -1);
    for (std::size_t p = 0; p < 5; ++p)
        std::copy(x.d.particles[p].nodes.begin(), x.d.particles[p].nodes.end(),
                  node.begin() + static_cast<std::ptrdiff_t>(6 * p));
    grit_contact_surfaces s = x.s.views();
    s.position = grit_view_of(position.data(), 1, 6);
    s.normal = grit_view_of(normal.data(), 1, 6);
    s.surface = grit_mutable_view_of(surface.data(), 1, 6);
    s.centre.base = nullptr;
    ASSERT_EQ(grit_contact_surfaces_reset(&s, nullptr), GRIT_OK);
    grit_contact_domains d = x.d.views(B);
    d.offset = nullptr;
    d.nodes_each = 6;
    d.node = node.data();
    d.position = grit_view_of(particle.data(), 1, 5);
    d.side = grit_matrix_view_of(side.data(), 1, 15, 5);
    ASSERT_EQ(grit_contact_surfaces_add(&s, 5, &d, nullptr), GRIT_OK);
    const Surfaces same = expected();
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(surface[i], infinity);
        EXPECT_EQ(surface[6 + i], same.surface[2 * i + 1]);
    }
}

TEST(DistanceCall, LeavesOutABadParticleAndAddsTheOthers) {
    const auto expect_failure = [](const std::function<void(Scene&)>& spoil, grit_status status,
                                   const char* message) {
        Scene x, without;
        for (Domain& p : x.d.particles) p.nodes = {0, 1, 2, 3, 4, 5};
        x.d = Domains(3, x.d.particles);
        auto others = x.d.particles;
        others.erase(others.begin() + 2);
        Domains rest(3, others);
        ASSERT_EQ(add(without.s, rest, A), GRIT_OK);
        spoil(x);
        EXPECT_EQ(add(x.s, x.d, A, &x.error), status);
        EXPECT_EQ(x.error.status, status);
        EXPECT_EQ(x.error.point, 2);
        EXPECT_STREQ(x.error.message, message);
        EXPECT_TRUE(same_bits(x.s.surface, without.s.surface)) << message;
        EXPECT_TRUE(same_bits(x.s.centre, without.s.centre)) << message;
    };
    expect_failure([](Scene& x) { x.d.particles[2].x[1] = std::nan(""); }, GRIT_BAD_STATE,
                   "particle 2: position component 1 must be within 1e+100, got nan");
    expect_failure([](Scene& x) { x.d.particles[2].x[0] = -1e101; }, GRIT_BAD_STATE,
                   "particle 2: position component 0 must be within 1e+100, got -1e+101");
    expect_failure([](Scene& x) { x.d.particles[2].r[1][2] = infinity; }, GRIT_BAD_STATE,
                   "particle 2: component 2 of side 1 must be within 1e+100, got inf");
    expect_failure([](Scene& x) { x.d.node[17] = 6; }, GRIT_BAD_CALL,
                   "particle 2: node id must be in [0, 6), or -1, got 6");
    expect_failure([](Scene& x) { x.d.node[17] = -2; }, GRIT_BAD_CALL,
                   "particle 2: node id must be in [0, 6), or -1, got -2");
}

TEST(DistanceCall, RefusesParticlesAtBadNodesBeforeAnyNodeIsChanged) {
    const auto expect_failure = [](const std::function<void(Scene&)>& spoil, const char* message) {
        Scene x;
        Domains one(3, {{Vec3::Zero(), no_sides, {0, 1, 2}}});
        spoil(x);
        EXPECT_EQ(add(x.s, one, A, &x.error), GRIT_BAD_STATE);
        EXPECT_EQ(x.error.point, 0);
        EXPECT_STREQ(x.error.message, message);
        for (const double surface : x.s.surface) EXPECT_EQ(surface, infinity);
        for (const double centre : x.s.centre) EXPECT_EQ(centre, infinity);
    };
    expect_failure([](Scene& x) { x.s.position[2][0] = std::nan(""); },
                   "particle 0: position component 0 of node 2 must be within 1e+100, got nan");
    expect_failure([](Scene& x) { x.s.normal[2] = Vec3(0.0, 2.0, 0.0); },
                   "particle 0: |normal|^2 of node 2 must be within 1e-06 of 1, or 0, got 4");
    expect_failure([](Scene& x) { x.s.normal[2] = Vec3(std::nan(""), 0.0, 0.0); },
                   "particle 0: |normal|^2 of node 2 must be within 1e-06 of 1, or 0, got nan");
}

TEST(DistanceCall, RefusesListsThatDecrease) {
    Scene x;
    x.d.offset[2] = x.d.offset[3] + 1;
    EXPECT_EQ(add(x.s, x.d, A, &x.error), GRIT_BAD_CALL);
    EXPECT_EQ(x.error.point, 2);
    EXPECT_TRUE(x.says("offset must start at >= 0 and not decrease")) << x.error.message;
}

TEST(DistanceCall, ThatIsWrongAsAWholeAddsNothing) {
    using S = grit_contact_surfaces;
    using D = grit_contact_domains;
    const auto expect_bad = [](const std::function<void(S&, D&)>& spoil, const char* part) {
        Scene x;
        S s = x.s.views();
        D d = x.d.views(A);
        spoil(s, d);
        EXPECT_EQ(grit_contact_surfaces_add(&s, 5, &d, &x.error), GRIT_BAD_CALL) << part;
        EXPECT_EQ(x.error.point, -1);
        EXPECT_TRUE(x.says(part)) << x.error.message;
        for (const double surface : x.s.surface) EXPECT_EQ(surface, infinity);
    };
    expect_bad([](S& s, D&) { s.struct_size = 0; }, "grit_contact_surfaces.struct_size 0");
    expect_bad([](S& s, D&) { s.components = 1; }, "components must be 2 or 3, got 1");
    expect_bad([](S& s, D&) { s.reserved = 3; }, "reserved must be 0, got 3");
    expect_bad([](S& s, D&) { s.nodes = -1; }, "nodes must be >= 0, got -1");
    expect_bad([](S& s, D&) { s.surface.base = nullptr; }, "surface needs a base");
    expect_bad([](S& s, D&) { s.surface.point_stride = 0; }, "surface is written");
    expect_bad([](S& s, D&) { s.centre.point_stride = 0; }, "centre is written");
    expect_bad([](S& s, D&) { s.centre.component_stride = 0; }, "component_stride of centre");
    expect_bad([](S& s, D&) { s.position.base = nullptr; }, "position of the nodes needs");
    expect_bad([](S& s, D&) { s.normal.base = nullptr; }, "normal needs a base");
    expect_bad([](S&, D& d) { d.struct_size = 4; }, "grit_contact_domains.struct_size 4");
    expect_bad([](S&, D& d) { d.body = 2; }, "body must be 0 (A) or 1 (B), got 2");
    expect_bad([](S&, D& d) { d.sides = 4; }, "sides must be in [0, 3], got 4");
    expect_bad([](S&, D& d) { d.node = nullptr; }, "node is null");
    expect_bad([](S&, D& d) { d.position.base = nullptr; }, "position of the particles needs");
    expect_bad([](S&, D& d) { d.side.row_stride = 0; }, "side needs a base pointer");
    expect_bad(
        [](S&, D& d) {
            d.offset = nullptr;
            d.nodes_each = -1;
        },
        "nodes_each must be >= 0, got -1");
    Scene x;
    const S s = x.s.views();
    const D d = x.d.views(A);
    EXPECT_EQ(grit_contact_surfaces_add(nullptr, 1, &d, &x.error), GRIT_BAD_CALL);
    EXPECT_EQ(grit_contact_surfaces_add(&s, 1, nullptr, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_contact_surfaces_add(&s, -1, &d, &x.error), GRIT_BAD_CALL);
    EXPECT_TRUE(x.says("n must be >= 0, got -1"));
    EXPECT_EQ(grit_contact_surfaces_add(&s, 0, &d, nullptr), GRIT_OK);
    EXPECT_EQ(grit_contact_surfaces_reset(nullptr, nullptr), GRIT_BAD_CALL);
}

TEST(DistanceCall, MergesOnlyWhatBelongsTogether) {
    Scene x, y;
    grit_contact_surfaces into = x.s.views(), from = y.s.views();
    from.nodes = 5;
    EXPECT_EQ(grit_contact_surfaces_merge(&into, &from, &x.error), GRIT_BAD_CALL);
    EXPECT_TRUE(x.says("nodes must be the same to merge, got 6 and 5"));
    from.nodes = 6;
    from.centre.base = nullptr;
    EXPECT_EQ(grit_contact_surfaces_merge(&into, &from, &x.error), GRIT_BAD_CALL);
    EXPECT_TRUE(x.says("one of the surfaces to merge has no centre"));
    into.centre.base = nullptr;
    EXPECT_EQ(grit_contact_surfaces_merge(&into, &from, nullptr), GRIT_OK);
    EXPECT_EQ(grit_contact_surfaces_merge(&into, nullptr, nullptr), GRIT_BAD_CALL);
}

TEST(DistanceCall, FinishesTheNodesOfAListAndRefusesMinimaThatWereNeverReset) {
    Surfaces s = expected();
    s.surface[2 * 3] = std::nan("");
    s.centre[2 * 5 + 1] = -1.0;
    std::vector<double> distance(6, 9.0), gap(6, 9.0);
    const std::vector<std::ptrdiff_t> index = {4, 3, 5, 1};
    const grit_contact_surfaces surfaces = s.views();
    grit_contact_distances q{};
    q.struct_size = sizeof q;
    q.stiffer = B;
    q.index = index.data();
    q.distance = grit_mutable_view_of(distance.data(), 1, 1);
    q.gap = grit_mutable_view_of(gap.data(), 1, 1);
    grit_error error{};
    const auto finish_with = [&](std::ptrdiff_t n) {
        return grit_contact_surfaces_finish(&surfaces, n, &q, &error);
    };
    EXPECT_EQ(finish_with(4), GRIT_BAD_STATE);
    EXPECT_EQ(error.point, 1);
    EXPECT_STREQ(error.message,
                 (std::string("node 3: surface must be above -infinity, got nan and ") +
                  [&] {
                      char number[32];
                      std::snprintf(number, sizeof number, "%g", s.surface[7]);
                      return std::string(number);
                  }() +
                  ": never reset?")
                     .c_str());
    EXPECT_EQ(distance[3], 9.0);
    EXPECT_EQ(gap[3], 9.0);
    EXPECT_EQ(distance[0], 9.0);
    for (const std::size_t i : {4u, 5u, 1u}) EXPECT_EQ(distance[i], s.surface[2 * i + 1]);
    q.measure = GRIT_CONTACT_NEAREST_CENTRE;
    gap[5] = 9.0;
    EXPECT_EQ(finish_with(4), GRIT_BAD_STATE);
    s.surface[2 * 3] = infinity;
    EXPECT_EQ(finish_with(4), GRIT_BAD_STATE);
    EXPECT_STREQ(error.message, "node 5: centre must be >= 0, got -1: never reset?");
    EXPECT_EQ(gap[5], 9.0);
    const std::ptrdiff_t beyond = 6;
    q.index = &beyond;
    EXPECT_EQ(finish_with(1), GRIT_BAD_CALL);
    EXPECT_STREQ(error.message, "entry 0 of index must be in [0, 6), got 6");
}

TEST(DistanceCall, FinishesNothingIfItIsWrongAsAWhole) {
    using Q = grit_contact_distances;
    const auto expect_bad = [](const std::function<void(Q&, grit_contact_surfaces&)>& spoil,
                               const char* part) {
        Scene x;
        std::vector<double> distance(6, 9.0);
        grit_contact_surfaces s = x.s.views();
        Q q{};
        q.struct_size = sizeof q;
        q.distance = grit_mutable_view_of(distance.data(), 1, 1);
        spoil(q, s);
        EXPECT_EQ(grit_contact_surfaces_finish(&s, 6, &q, &x.error), GRIT_BAD_CALL) << part;
        EXPECT_EQ(x.error.point, -1);
        EXPECT_TRUE(x.says(part)) << x.error.message;
        for (const double each : distance) EXPECT_EQ(each, 9.0);
    };
    using S = grit_contact_surfaces;
    expect_bad([](Q& q, S&) { q.struct_size = 7; }, "grit_contact_distances.struct_size 7");
    expect_bad([](Q& q, S&) { q.distance.base = nullptr; }, "neither distance nor gap");
    expect_bad([](Q& q, S&) { q.distance.point_stride = 0; }, "distance is written");
    expect_bad([](Q& q, S&) { q.gap = {q.distance.base, 0, 0}; }, "gap is written");
    expect_bad([](Q& q, S&) { q.stiffer = 2; }, "stiffer must be 0 (A) or 1 (B), got 2");
    expect_bad([](Q& q, S&) { q.measure = 3; }, "measure must be GRIT_CONTACT_SUPPORT");
    expect_bad(
        [](Q& q, S& s) {
            q.measure = GRIT_CONTACT_NEAREST_CENTRE;
            s.centre.base = nullptr;
        },
        "GRIT_CONTACT_NEAREST_CENTRE needs centre");
    Scene x;
    const S s = x.s.views();
    EXPECT_EQ(grit_contact_surfaces_finish(&s, 1, nullptr, nullptr), GRIT_BAD_CALL);
    Q q{};
    q.struct_size = sizeof q;
    EXPECT_EQ(grit_contact_surfaces_finish(&s, -1, &q, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_contact_surfaces_finish(&s, 0, &q, nullptr), GRIT_OK);
}

}  // namespace
