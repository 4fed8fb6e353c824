// SPDX-License-Identifier: BSD-3-Clause
// Friction of what grains carry: the normal impulse less that of pore water.
#include "../larger.hpp"
#include "support/nodes.hpp"

namespace {

using namespace tests;

struct Trial {
    Nodes dry, wet;
    grit_contact_options options;
};

// The same nodes, with water that carries -0.5 ... 1.5 of their normal impulse.
Trial trial(int components, int law) {
    Trial t{random_nodes(20000, components, 91), {}, options_with(components)};
    t.options.law = law;
    t.options.friction_coefficient = 0.3;
    t.wet = t.dry;
    t.wet.saturated = true;
    EXPECT_EQ(t.dry.correct(t.options), GRIT_OK);
    Random random(92);
    for (std::size_t i = 0; i < t.wet.node.size(); ++i) {
        Node& x = t.wet.node[i];
        const double* J = t.dry.reports[i].impulse;
        x.pore_impulse = random.uniform(-0.5, 1.5) * dot({J[0], J[1], J[2]}, x.n);
    }
    return t;
}

TEST(PoreImpulse, IsTakenOffWhatRubs) {
    for (const int components : {2, 3})
        for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
            Trial t = trial(components, law);
            const std::vector<Node> before = t.wet.node;
            ASSERT_EQ(t.wet.correct(t.options), GRIT_OK) << t.wet.error.message;
            double worst = 0.0;
            std::ptrdiff_t slipping = 0, liquefied = 0;
            for (std::size_t i = 0; i < before.size(); ++i) {
                const grit_contact_report& r = t.wet.reports[i];
                if (r.state < GRIT_CONTACT_STICK) continue;
                const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]}, n = before[i].n;
                const double J_n = dot(J, n), J_t = norm(J - J_n * n);
                const double limit = 0.3 * std::max(J_n - before[i].pore_impulse, 0.0);
                worst = larger(worst, (J_t - limit) / J_n);
                if (r.state != GRIT_CONTACT_SLIP) continue;
                worst = larger(worst, std::fabs(J_t - limit) / J_n);
                ++slipping;
                liquefied += limit == 0.0;
            }
            EXPECT_LE(worst, 1e-9);
            EXPECT_GT(slipping, 1000);
            EXPECT_GT(liquefied, 500);
        }
}

TEST(PoreImpulse, LeavesTheNormalImpulse) {
    Trial t = trial(3, GRIT_CONTACT_GEO);
    ASSERT_EQ(t.wet.correct(t.options), GRIT_OK);
    double worst = 0.0;
    for (std::size_t i = 0; i < t.wet.node.size(); ++i) {
        const auto normal = [&](const Nodes& nodes) {
            const double* J = nodes.reports[i].impulse;
            return dot({J[0], J[1], J[2]}, nodes.node[i].n);
        };
        EXPECT_EQ(t.wet.reports[i].state >= GRIT_CONTACT_STICK,
                  t.dry.reports[i].state >= GRIT_CONTACT_STICK);
        worst = larger(worst, std::fabs(normal(t.wet) - normal(t.dry)) /
                                  (std::fabs(normal(t.dry)) + 1e-300));
    }
    EXPECT_LE(worst, 1e-8);  // of tangential impulses 1e7 times as large
}

TEST(PoreImpulse, OfNoWaterChangesNoBit) {
    Trial t = trial(3, GRIT_CONTACT_GEO);
    Nodes of_none = random_nodes(20000, 3, 91);
    of_none.saturated = true;
    ASSERT_EQ(of_none.correct(t.options), GRIT_OK);
    EXPECT_TRUE(same_bits(of_none.node, t.dry.node));
}

}  // namespace
