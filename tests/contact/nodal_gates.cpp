// SPDX-License-Identifier: BSD-3-Clause
// When a node is in contact, and what the routine leaves alone.
#include <limits>

#include "support/nodes.hpp"

namespace {

using namespace tests;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A left of B, the normal from A to B is +1; speeds along it.
Node meeting(double v_a, double v_b) {
    Node x;
    x.m_a = 2.0;
    x.m_b = 3.0;
    x.v_a = {v_a, 0.0, 0.0};
    x.v_b = {v_b, 0.0, 0.0};
    return x;
}

int state_of(Node& x, const grit_contact_options& options = options_with(), bool gated = false) {
    Nodes nodes({x});
    nodes.gated = gated;
    EXPECT_EQ(nodes.correct(options), GRIT_OK) << nodes.error.message;
    x = nodes.node[0];
    return nodes.reports[0].state;
}

TEST(NodalContact, StopsABodyThatApproaches) {
    Node x = meeting(1.0, -1.0);
    EXPECT_EQ(state_of(x), GRIT_CONTACT_SLIP);  // no friction
    EXPECT_NEAR(x.v_a[0], -0.2, 1e-15);         // (2 - 3) / 5
    EXPECT_NEAR(x.v_b[0], -0.2, 1e-15);
}

TEST(NodalContact, LeavesABodyThatParts) {
    Node x = meeting(-1.0, 1.0);
    const Node before = x;
    EXPECT_EQ(state_of(x), GRIT_CONTACT_OPEN);
    EXPECT_TRUE(same_bits({x}, {before}));
}

TEST(NodalContact, LeavesBodiesThatMoveTogether) {
    Node x = meeting(0.3, 0.3);
    const Node before = x;
    EXPECT_EQ(state_of(x), GRIT_CONTACT_OPEN);
    EXPECT_TRUE(same_bits({x}, {before}));
}

TEST(NodalContact, TakesTheNormalFromAToB) {
    Node x = meeting(1.0, -1.0);
    x.n = {-1.0, 0.0, 0.0};  // A right of B: they part
    EXPECT_EQ(state_of(x), GRIT_CONTACT_OPEN);
}

TEST(NodalContact, LeavesANodeOfOneBodyAlone) {
    for (const auto& [m_a, m_b] : {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.0, 0.0)}) {
        Node x = meeting(1.0, std::nan(""));  // velocities of no mass may be anything
        x.m_a = m_a;
        x.m_b = m_b;
        x.n = {0.0, 0.0, 0.0};
        x.d = -1.0;
        const Node before = x;
        EXPECT_EQ(state_of(x), GRIT_CONTACT_INACTIVE);
        EXPECT_TRUE(same_bits({x}, {before}));
    }
}

TEST(NodalContact, IgnoresATraceOfMass) {
    Node x = meeting(1.0, -1.0);
    x.m_a = 1e-11 * x.m_b;
    for (const bool swapped : {false, true}) {
        if (swapped) std::swap(x.m_a, x.m_b);
        grit_contact_options options = options_with();
        options.mass_tolerance = 1e-10;
        Node trace = x;
        EXPECT_EQ(state_of(trace, options), GRIT_CONTACT_INACTIVE);
        options.mass_tolerance = 1e-12;
        trace = x;
        EXPECT_EQ(state_of(trace, options), GRIT_CONTACT_SLIP);
    }
}

TEST(NodalContact, TakesMassesThatAreNoneForNone) {
    Node x = meeting(1.0, -1.0);
    x.m_a = x.m_b = 1e-309;
    const Node before = x;
    EXPECT_EQ(state_of(x), GRIT_CONTACT_INACTIVE);
    EXPECT_TRUE(same_bits({x}, {before}));
}

TEST(GapGate, WaitsUntilTheSurfacesMeet) {
    for (const auto& [gap, state] :
         {std::pair(1e-9, GRIT_CONTACT_OPEN), std::pair(0.0, GRIT_CONTACT_SLIP),
          std::pair(-0.1, GRIT_CONTACT_SLIP), std::pair(infinity, GRIT_CONTACT_OPEN)}) {
        Node x = meeting(1.0, -1.0);
        x.gap = gap;
        EXPECT_EQ(state_of(x, options_with(), true), state) << gap;
    }
}

TEST(GapGate, KnowsATolerance) {
    grit_contact_options options = options_with();
    options.gap_tolerance = 0.01;
    Node x = meeting(1.0, -1.0);
    x.gap = 0.01;
    EXPECT_EQ(state_of(x, options, true), GRIT_CONTACT_SLIP);
    x = meeting(1.0, -1.0);
    x.gap = 0.0101;
    EXPECT_EQ(state_of(x, options, true), GRIT_CONTACT_OPEN);
}

TEST(GeoContact, LeavesANodeBeyondACellBitwise) {
    for (const double s : {1.0, 1.5, infinity}) {
        Node x = meeting(1.0, -1.0);
        x.v_a[1] = -0.0;
        x.s = s;
        const Node before = x;
        EXPECT_EQ(state_of(x), GRIT_CONTACT_OPEN) << s;
        EXPECT_TRUE(same_bits({x}, {before}));
    }
    Nodes nodes = random_nodes(100000, 3, 5);
    for (Node& x : nodes.node) x.s = x.d;
    const std::vector<Node> before = nodes.node;
    nodes.correct(options_with());
    EXPECT_TRUE(same_bits(nodes.node, before));
}

TEST(GeoContact, BecomesFrictionalContactAsThePowerGrows) {
    Nodes geo = random_nodes(100000, 3, 6);
    for (Node& x : geo.node) x.s = std::fmod(std::fabs(x.s), 0.999 * x.d);
    Nodes frictional = geo;
    grit_contact_options options = options_with();
    options.friction_coefficient = 0.3;
    options.penalty_power = 1e6;
    geo.correct(options);
    options.law = GRIT_CONTACT_FRICTIONAL;
    frictional.correct(options);
    for (std::size_t i = 0; i < geo.node.size(); ++i)
        EXPECT_LE(norm(geo.node[i].v_a - frictional.node[i].v_a), 0.0);
}

TEST(GeoContact, DoesNotReadDistancesWhenFrictional) {
    Node x = meeting(1.0, -1.0);
    x.s = std::nan("");
    x.d = 0.0;
    grit_contact_options options = options_with();
    options.law = GRIT_CONTACT_FRICTIONAL;
    EXPECT_EQ(state_of(x, options), GRIT_CONTACT_SLIP);
}

TEST(GeoContact, MeasuresTheCellAlongTheNormal) {
    Nodes nodes({meeting(1.0, -1.0)});
    Node& x = nodes.node[0];
    x.n = {0.6, 0.8, 0.0};
    x.v_a = x.n;
    x.v_b = -1.0 * x.n;
    x.s = 0.5;
    const double spacing[2] = {0.5, 2.0};
    grit_contact_nodes q = nodes.views();
    q.cell_size = {};
    q.spacing = grit_view_of(spacing, 0, 1);
    grit_contact_options options = options_with(2);
    options.penalty_power = 1.0;
    ASSERT_EQ(nodes.correct(options, q, 1), GRIT_OK);
    // 1/d = sqrt((0.6/0.5)^2 + (0.8/2)^2) = sqrt 1.6
    EXPECT_NEAR(nodes.reports[0].penalty_factor, 1.0 - 0.5 * std::sqrt(1.6), 1e-15);
    // The largest.
    const double largest[2] = {1e100, 1e100};
    nodes.node[0] = meeting(1.0, -1.0);
    nodes.node[0].s = 0.5 * largest[0];
    q.spacing = grit_view_of(largest, 0, 1);
    ASSERT_EQ(nodes.correct(options, q, 1), GRIT_OK);
    EXPECT_NEAR(nodes.reports[0].penalty_factor, 0.5, 1e-15);
}

TEST(GeoContact, ScalesByThePenaltyFactorOfTheDistance) {
    const auto f_p = [](double s, double d, double k) {
        double f = -1.0;
        EXPECT_EQ(grit_contact_penalty_factor(s, d, k, &f), GRIT_OK);
        return f;
    };
    EXPECT_EQ(f_p(0.0, 1.0, 1e-3), 1.0);  // 0^k = 0
    EXPECT_EQ(f_p(-3.0, 1.0, 2.0), 1.0);
    EXPECT_EQ(f_p(2.0, 2.0, 6.0), 0.0);
    EXPECT_EQ(f_p(infinity, 2.0, 6.0), 0.0);
    EXPECT_DOUBLE_EQ(f_p(0.5, 1.0, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(f_p(1.0, 2.0, 2.0), 0.75);
    EXPECT_DOUBLE_EQ(f_p(0.5, 1.0, 6.0), 1.0 - 1.0 / 64.0);
    EXPECT_EQ(f_p(0.99, 1.0, 1e6), 1.0);
    double f = 7.0;
    for (const auto& [s, d, k] :
         {std::tuple(std::nan(""), 1.0, 2.0), std::tuple(0.5, 0.0, 2.0), std::tuple(0.5, -1.0, 2.0),
          std::tuple(0.5, 1.0, 0.0), std::tuple(0.5, 1.0, -2.0), std::tuple(0.5, 1.0, 2e6),
          std::tuple(0.5, infinity, 2.0), std::tuple(0.5, 1e-310, 2.0),
          std::tuple(0.5, 1.0, std::nan(""))})
        EXPECT_EQ(grit_contact_penalty_factor(s, d, k, &f), GRIT_BAD_CALL);
    EXPECT_EQ(f, 7.0);
}

TEST(GeoContact, DriftsUnderASustainedLoadAsARelaxation) {
    // w <- (1 - f_p)(w + g dt) settles at g dt (1 - f_p)/f_p, and J/dt carries the load m_r g.
    const double g = 9.81, dt = 1e-3;
    Node x = meeting(0.0, 0.0);
    x.s = 0.8;
    grit_contact_options options = options_with();
    options.penalty_power = 2.0;
    options.time_step = dt;
    Nodes nodes({x});
    for (int step = 0; step < 100; ++step) {
        nodes.node[0].v_a[0] += g * dt;
        nodes.correct(options);
    }
    const double f_p = 1.0 - 0.64;
    EXPECT_NEAR(nodes.node[0].w()[0], g * dt * (1.0 - f_p) / f_p, 1e-6 * g * dt);
    EXPECT_NEAR(nodes.reports[0].force[0], 1.2 * g, 1e-6 * g);
}

TEST(RigidBody, KeepsItsVelocityBitwise) {
    for (const int rigid : {GRIT_CONTACT_A_RIGID, GRIT_CONTACT_B_RIGID}) {
        Nodes nodes = random_nodes(100000, 3, 7);
        const std::vector<Node> before = nodes.node;
        grit_contact_options options = options_with();
        options.rigid = rigid;
        options.friction_coefficient = 0.4;
        options.law = GRIT_CONTACT_FRICTIONAL;
        nodes.correct(options);
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Node &x = before[i], &y = nodes.node[i];
            const bool a = rigid == GRIT_CONTACT_A_RIGID;
            EXPECT_TRUE(same_bits(a ? y.v_a : y.v_b, a ? x.v_a : x.v_b));
            if (dot(x.w(), x.n) <= 0.0) continue;
            EXPECT_NEAR(dot(y.w(), x.n), 0.0, 1e-14);
            const double m = a ? x.m_b : x.m_a;  // (C5): the free body's
            const grit_contact_report& r = nodes.reports[i];
            const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]};
            EXPECT_NEAR(dot(J, x.n), m * dot(x.w(), x.n), 1e-13 * m * norm(x.w()));
        }
    }
}

TEST(RigidBody, MayHaveOneVelocityForAllNodes) {
    std::vector<Node> list(20, meeting(1.0, 0.0));
    Nodes nodes(list);
    double wall[3] = {0.5, 0.0, 0.0};
    grit_contact_nodes q = nodes.views();
    q.velocity_b = grit_mutable_view_of(wall, 0, 1);
    grit_contact_options options = options_with();
    options.rigid = GRIT_CONTACT_B_RIGID;
    ASSERT_EQ(nodes.correct(options, q, 20), GRIT_OK) << nodes.error.message;
    for (const Node& x : nodes.node) EXPECT_EQ(x.v_a[0], 0.5);
}

TEST(Adhesion, HoldsBesideFriction) {
    Node x = meeting(1.0, -1.0);
    x.v_a[1] = 10.0;
    x.area = 0.25;
    grit_contact_options options = options_with();
    options.friction_coefficient = 0.5;
    options.adhesion = 8.0;
    options.time_step = 0.1;
    Nodes nodes({x});
    ASSERT_EQ(nodes.correct(options), GRIT_OK);
    EXPECT_EQ(nodes.reports[0].state, GRIT_CONTACT_SLIP);
    EXPECT_DOUBLE_EQ(nodes.reports[0].impulse[0], 1.2 * 2.0);
    EXPECT_DOUBLE_EQ(nodes.reports[0].impulse[1], 0.5 * 2.4 + 8.0 * 0.25 * 0.1);
}

TEST(ZeroNormal, LeavesTheNodeOpenWhereAllowed) {
    Node x = meeting(1.0, -1.0);
    x.n = {0.0, 0.0, 0.0};
    const Node before = x;
    grit_contact_options options = options_with();
    options.allow_zero_normal = 1;
    EXPECT_EQ(state_of(x, options), GRIT_CONTACT_OPEN);
    EXPECT_TRUE(same_bits({x}, {before}));
}

}  // namespace
