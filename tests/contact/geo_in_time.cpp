// SPDX-License-Identifier: BSD-3-Clause
// Geo-contact that does not depend on the step, (C9): a relaxation time, and a spring against the overlap.
#include <cstring>

#include <grit/version.h>

#include "support/bodies_at_nodes.hpp"

namespace {

using namespace tests;

const double share = 0.8;  // s/d

grit_contact_options in_time(double dt, double tau, double stiffness = 0.0) {
    grit_contact_options options = options_with();
    options.penalty_power = 2.0;
    options.time_step = dt;
    options.relaxation_time = tau;
    options.contact_stiffness = stiffness;
    return options;
}

// One node of two bodies, and the overlap that its velocities make.
struct OneNode {
    Nodes nodes{{Node{}}};
    explicit OneNode(double approach) {
        Node& x = nodes.node[0];
        x.m_a = 2.0;
        x.m_b = 3.0;
        x.s = share;
        x.area = 0.5;
        x.v_a = {approach, 0.0, 0.0};
        nodes.gated = true;
    }
    double m_r() const { return nodes.node[0].m_r(); }
    double w() const { return nodes.node[0].w()[0]; }
    double overlap() const { return -nodes.node[0].gap; }
    double energy(double K) const {
        const double delta = std::max(overlap(), 0.0);
        return 0.5 * m_r() * w() * w() + 0.5 * K * delta * delta;
    }
    // g: relative acceleration of what lies on it.
    void step(const grit_contact_options& options, double g = 0.0) {
        nodes.node[0].v_a[0] += g * options.time_step;
        ASSERT_EQ(nodes.correct(options), GRIT_OK) << nodes.error.message;
        nodes.node[0].gap -= w() * options.time_step;
    }
};

TEST(GeoContactInTime, RelaxesExponentiallyWhateverTheStep) {
    const double tau = 0.01, time = 0.04, lambda = 2.0 / tau * std::log(1.0 / share);
    for (const int steps : {1, 4, 37, 1000}) {
        OneNode node(1.0);
        for (int i = 0; i < steps; ++i) node.step(in_time(time / steps, tau));
        EXPECT_NEAR(node.w(), std::exp(-lambda * time), 1e-12) << steps;
    }
}

TEST(GeoContactInTime, DriftsUnderALoadByItsOwnRate) {
    // g dt / (exp(lambda dt) - 1) -> g / lambda
    const double g = 9.81, tau = 0.01, lambda = 2.0 / tau * std::log(1.0 / share);
    for (const double dt : {1e-2, 1e-3, 1e-4}) {
        OneNode node(0.0);
        for (int i = 0; i * dt < 0.5; ++i) node.step(in_time(dt, tau), g);
        EXPECT_NEAR(node.w(), g * dt / std::expm1(lambda * dt), 1e-9 * g / lambda);
        EXPECT_NEAR(node.nodes.reports[0].force[0], node.m_r() * g, 1e-9 * node.m_r() * g);
    }
}

// The power of a step that is nothing of the relaxation time underflows to 0, where that of the time is small.
TEST(GeoContactInTime, DoesNothingInNoTime) {
    for (const double touching : {share, 0.0}) {
        OneNode node(1.0);
        node.nodes.node[0].s = touching;
        const double before = node.w();
        grit_contact_options options = in_time(1e-100, 1e100);
        options.penalty_power = 1e-200;
        node.step(options);
        EXPECT_NEAR(node.w(), touching > 0.0 ? before : 0.0, 1e-15);
    }
}

TEST(GeoContactInTime, OfTheStepIsThePublishedOneBitForBit) {
    for (const double k : {1.0, 2.0, 6.0, 2.5}) {
        Nodes published = random_nodes(20000, 3, 81), in_a_step = published;
        grit_contact_options options = options_with();
        options.penalty_power = k;
        options.friction_coefficient = 0.3;
        options.time_step = 1e-3;
        ASSERT_EQ(published.correct(options), GRIT_OK);
        options.relaxation_time = options.time_step;
        ASSERT_EQ(in_a_step.correct(options), GRIT_OK);
        EXPECT_TRUE(same_bits(published.node, in_a_step.node));
    }
}

// A spring of no stiffness is the dashpot alone: implicit, and with the time of the step the published one.
TEST(SpringAtANode, OfNoStiffnessAndTheTimeOfTheStepIsThePublishedContact) {
    Nodes published = random_nodes(20000, 3, 82), soft = published;
    published.gated = soft.gated = true;
    grit_contact_options options = options_with();
    options.friction_coefficient = 0.3;
    options.time_step = 1e-3;
    ASSERT_EQ(published.correct(options), GRIT_OK);
    options.contact_stiffness = 1e-100;
    ASSERT_EQ(soft.correct(options), GRIT_OK);
    for (std::size_t i = 0; i < soft.node.size(); ++i) {
        EXPECT_EQ(soft.reports[i].state, published.reports[i].state);
        EXPECT_LE(norm(soft.node[i].v_a - published.node[i].v_a), 1e-14);
        EXPECT_LE(norm(soft.node[i].v_b - published.node[i].v_b), 1e-14);
    }
}

TEST(SpringAtANode, CarriesALoadAtRestWithTheOverlapOfItsStiffness) {
    const double g = 9.81, epsilon = 4000.0;
    for (const double dt : {1e-4, 1e-3, 1e-2, 0.3}) {
        OneNode node(0.0);
        for (int i = 0; i < 20000; ++i) node.step(in_time(dt, 0.01, epsilon), g);
        const double K = epsilon * node.nodes.node[0].area;
        EXPECT_NEAR(node.w(), 0.0, 1e-9) << dt;
        EXPECT_NEAR(node.overlap(), node.m_r() * g / K, 1e-9) << dt;
        EXPECT_NEAR(node.nodes.reports[0].force[0], node.m_r() * g, 1e-6) << dt;
    }
}

TEST(SpringAtANode, IsTheImplicitSpringAndDashpot) {
    Random random(83);
    for (int i = 0; i < 10000; ++i) {
        const double dt = random.log_uniform(1e-5, 1e-1), tau = random.log_uniform(1e-4, 1e-1);
        const double epsilon = random.log_uniform(1.0, 1e8);
        OneNode node(random.uniform(-1.0, 1.0));
        Node& x = node.nodes.node[0];
        x.s = random.uniform(0.0, 1.0);
        x.gap = -random.uniform(0.0, 1e-2);
        const double f = 1.0 - x.s * x.s, m = node.m_r(), K = epsilon * x.area, w = node.w();
        const double C = m * f / ((1.0 - f) * tau), delta = -x.gap;
        const double J = dt * ((C + K * dt) * w + K * delta) / (1.0 + (C + K * dt) * dt / m);
        ASSERT_EQ(node.nodes.correct(in_time(dt, tau, epsilon)), GRIT_OK);
        EXPECT_NEAR(node.nodes.reports[0].impulse[0], std::max(J, 0.0),
                    1e-10 * (m * std::fabs(w) + std::fabs(J)));
    }
}

TEST(SpringAtANode, NeverCreatesEnergyWhateverTheStep) {
    Random random(84);
    for (int i = 0; i < 2000; ++i) {
        const double epsilon = random.log_uniform(1.0, 1e8), dt = random.log_uniform(1e-5, 1.0);
        OneNode node(random.uniform(-1.0, 1.0));
        node.nodes.node[0].gap = -random.uniform(0.0, 1e-2);
        const double K = epsilon * node.nodes.node[0].area;
        double before = node.energy(K);
        for (int step = 0; step < 20; ++step) {
            node.step(in_time(dt, 0.01, epsilon));
            const double after = node.energy(K);
            EXPECT_LE(after, before * (1.0 + 1e-12));
            before = after;
        }
    }
}

TEST(SpringAtANode, ThatIsRigidIsTheFrictionalContact) {
    for (const double k : {6.0, 1e6}) {
        Nodes geo = random_nodes(20000, 3, 85);
        geo.gated = true;
        for (Node& x : geo.node)
            x.s = k == 6.0 ? -std::fabs(x.s) : std::fmod(std::fabs(x.s), 0.9 * x.d);
        Nodes frictional = geo;
        grit_contact_options options = in_time(1e-3, 1e-3, 1e6);
        options.penalty_power = k;
        options.friction_coefficient = 0.3;
        ASSERT_EQ(geo.correct(options), GRIT_OK);
        grit_contact_options fca = options_with();
        fca.law = GRIT_CONTACT_FRICTIONAL;
        fca.friction_coefficient = 0.3;
        ASSERT_EQ(frictional.correct(fca), GRIT_OK);
        EXPECT_TRUE(same_bits(geo.node, frictional.node));
    }
}

TEST(SpringAtANode, KeepsMomentumAndObeysCoulomb) {
    Nodes nodes = random_nodes(50000, 3, 86);
    nodes.gated = true;
    const std::vector<Node> before = nodes.node;
    grit_contact_options options = in_time(1e-3, 1e-2, 1e5);
    options.friction_coefficient = 0.3;
    ASSERT_EQ(nodes.correct(options), GRIT_OK);
    int pushed_apart = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Node &x = before[i], &y = nodes.node[i];
        const grit_contact_report& r = nodes.reports[i];
        const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]};
        const double size = x.m_a * norm(x.v_a) + x.m_b * norm(x.v_b) + norm(J);
        EXPECT_LE(norm(y.momentum() - x.momentum()), 1e-14 * size);
        const double J_n = dot(J, x.n);
        EXPECT_GE(J_n, -1e-14 * norm(J));
        EXPECT_LE(norm(J - J_n * x.n), 0.3 * J_n + 1e-13 * norm(J));
        if (x.gap > 0.0) {
            EXPECT_TRUE(same_bits({x}, {y}));
        }
        pushed_apart += r.state >= GRIT_CONTACT_STICK && dot(x.w(), x.n) < 0.0;
    }
    EXPECT_GT(pushed_apart, 1000);
}

TEST(SpringAtANode, IsTheSameAloneInAPackAndBetweenManyBodies) {
    Nodes together = random_nodes(301, 3, 87);
    together.gated = true;
    const std::vector<Node> before = together.node;
    grit_contact_options options = in_time(1e-3, 1e-2, 1e5);
    options.friction_coefficient = 0.3;
    for (int isa = GRIT_ISA_BASELINE; isa <= grit_instruction_set(); ++isa) {
        options.instruction_set = isa;
        together.node = before;
        ASSERT_EQ(together.correct(options), GRIT_OK);
        for (std::size_t i = 0; i < before.size(); ++i) {
            Nodes alone({before[i]});
            alone.gated = true;
            ASSERT_EQ(alone.correct(options), GRIT_OK);
            EXPECT_TRUE(same_bits(alone.node, {together.node[i]}));
        }
    }
}

// A row of bodies: at the end each pair's impulse is that of its own law for what the others leave.
TEST(SpringAtANode, BetweenManyBodiesIsThatOfWhatTheOthersLeave) {
    BodiesAtNodes bodies(3, 500, 88);
    for (auto& o : bodies.options) {
        o = in_time(1e-3, 1e-2, 1e5);
        o.friction_coefficient = 0.0;
    }
    static const double area = 0.5, gap = -1e-3;
    bodies.area = grit_view_of(&area, 0, 1);
    bodies.gap = grit_view_of(&gap, 0, 1);
    const auto before = bodies.node;
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    int several = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const grit_contact_report* r = &bodies.reports[3 * i];
        int pressed = 0;
        for (std::size_t p = 0; p < 3; ++p) {
            const auto [a, b] = bodies.who[p];
            const auto& x = before[i];
            // Velocities without this pair's impulse.
            const auto J_of = [&](std::size_t q) {
                return Vec{r[q].impulse[0], r[q].impulse[1], r[q].impulse[2]};
            };
            const Vec left = bodies.node[i].v[a] - bodies.node[i].v[b];
            const Vec without = left + (1.0 / x.m[a] + 1.0 / x.m[b]) * J_of(p);
            const double w = dot(without, x.n[p]), m = x.m[a] * x.m[b] / (x.m[a] + x.m[b]);
            const double s = std::max(x.s[p], 0.0), f = 1.0 - s * s;
            const double J = dot(J_of(p), x.n[p]);
            if (s >= 1.0) {
                EXPECT_EQ(J, 0.0);
                continue;
            }
            pressed += J > 0.0;
            const double K = 1e5 * area, dt = 1e-3,
                         yield = (1.0 - f) / (f * dt / 1e-2 + (1.0 - f) * K * dt * dt / m);
            const double push = yield * K * dt * 1e-3 / m;
            EXPECT_NEAR(J, std::max(0.0, m * (w + push) / (1.0 + yield)), 1e-6 * (1.0 + m)) << i;
        }
        several += pressed > 1;
    }
    EXPECT_GT(several, 50);
}

TEST(SpringAtANode, ThatNothingCompressesIsOpen) {
    OneNode node(0.0);
    ASSERT_EQ(node.nodes.correct(in_time(1e-3, 1e-2, 1e5)), GRIT_OK);
    EXPECT_EQ(node.nodes.reports[0].state, GRIT_CONTACT_OPEN);
    EXPECT_EQ(node.w(), 0.0);
}

TEST(SpringAtANode, NeedsStepGapAndAreaAndTheGeoLaw) {
    const auto expect = [](const grit_contact_options& options, auto change, const char* text) {
        Nodes nodes = random_nodes(3, 3, 89);
        nodes.gated = true;
        grit_contact_nodes q = nodes.views();
        change(q);
        EXPECT_EQ(nodes.correct(options, q, 3), GRIT_BAD_CALL);
        EXPECT_NE(std::strstr(nodes.error.message, text), nullptr) << nodes.error.message;
    };
    const auto nothing = [](grit_contact_nodes&) {};
    const double nan = std::nan("");
    for (const double tau : {-1.0, nan, 1e-200, 1e200})
        expect(in_time(1e-3, tau), nothing,
               "relaxation_time must be in [1e-100, 1e100] [time], or 0 for the step, got");
    for (const double stiffness : {-1.0, nan, 1e200})
        expect(in_time(1e-3, 0.0, stiffness), nothing,
               "contact_stiffness must be in [0, 1e100] [stress/length], got");
    expect(in_time(0.0, 1.0), nothing, "relaxation_time 1 needs time_step > 0 [time], got 0");
    expect(in_time(0.0, 0.0, 5.0), nothing,
           "contact_stiffness 5 needs time_step > 0 [time], got 0");
    expect(
        in_time(1e-3, 0.0, 5.0), [](grit_contact_nodes& q) { q.gap = {}; }, "gap has no base");
    expect(
        in_time(1e-3, 0.0, 5.0), [](grit_contact_nodes& q) { q.contact_area = {}; },
        "contact_area has no base");
    for (const double tau : {0.0, 1.0}) {
        grit_contact_options options = in_time(1e-3, tau, tau > 0.0 ? 0.0 : 5.0);
        options.law = GRIT_CONTACT_FRICTIONAL;
        expect(options, nothing, "belongs to GRIT_CONTACT_GEO, got law 1");
    }
}

TEST(SpringAtANode, OfANegativeAreaIsNamed) {
    Nodes nodes = random_nodes(3, 3, 90);
    nodes.gated = true;
    nodes.node[1].area = -1.0;
    EXPECT_EQ(nodes.correct(in_time(1e-3, 0.0, 5.0)), GRIT_BAD_STATE);
    EXPECT_STREQ(nodes.error.message, "node 1: contact_area must be in [0, 1e100] [area], got -1");
}

}  // namespace
