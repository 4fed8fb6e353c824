// SPDX-License-Identifier: BSD-3-Clause
// One bad node among good ones: it is untouched and named, the others are corrected.
#include <functional>
#include <limits>

#include "support/nodes.hpp"

namespace {

using namespace tests;

const double nan = std::nan("");
constexpr double infinity = std::numeric_limits<double>::infinity();

grit_contact_options strict() {
    grit_contact_options options = options_with();
    options.adhesion = 1.0;
    options.time_step = 1e-3;
    return options;
}

void expect_bad_node(const std::function<void(Node&)>& spoil, const std::string& message) {
    for (const std::size_t n : {std::size_t(1), std::size_t(13), std::size_t(16)}) {
        const std::size_t bad = n / 2;
        Nodes nodes = random_nodes(n, 3, 31);
        nodes.gated = nodes.accelerated = nodes.remembered = nodes.saturated = true;
        Nodes good = nodes;
        spoil(nodes.node[bad]);
        const Node before = nodes.node[bad];
        good.correct(strict());
        EXPECT_EQ(nodes.correct(strict()), GRIT_BAD_STATE) << message;
        EXPECT_EQ(nodes.error.point, static_cast<std::ptrdiff_t>(bad));
        EXPECT_EQ(nodes.error.message, "node " + std::to_string(bad) + ": " + message);
        EXPECT_TRUE(same_bits({nodes.node[bad]}, {before})) << message;
        grit_contact_report failed{};
        failed.status = GRIT_BAD_STATE;
        EXPECT_EQ(std::memcmp(&nodes.reports[bad], &failed, sizeof failed), 0);
        for (std::size_t i = 0; i < n; ++i)
            if (i != bad) {
                EXPECT_TRUE(same_bits({nodes.node[i]}, {good.node[i]}));
            }
        grit_contact_totals totals{};
        totals.struct_size = sizeof totals;
        grit_contact_sums_read(&nodes.sums, &totals);
        EXPECT_EQ(totals.failed, 1);
    }
}

TEST(BadNode, OfANegativeOrInfiniteMassIsNamed) {
    expect_bad_node([](Node& x) { x.m_a = -1.0; }, "mass_a must be in [0, 1e100] [mass], got -1");
    expect_bad_node([](Node& x) { x.m_b = nan; }, "mass_b must be in [0, 1e100] [mass], got nan");
    expect_bad_node([](Node& x) { x.m_b = infinity; },
                    "mass_b must be in [0, 1e100] [mass], got inf");
    expect_bad_node(
        [](Node& x) {
            x.m_a = 0.0;  // not even where the other body is alone
            x.m_b = -2.0;
        },
        "mass_b must be in [0, 1e100] [mass], got -2");
}

TEST(BadNode, OfANonUnitNormalIsNamed) {
    const std::string text =
        "normal must be a unit vector, |n|^2 within 1e-06 of 1 [-], got |n| = ";
    expect_bad_node([](Node& x) { x.n = {2.0, 0.0, 0.0}; }, text + "2");
    expect_bad_node([](Node& x) { x.n = {0.0, 0.0, 0.0}; }, text + "0");
    expect_bad_node([](Node& x) { x.n = {0.0, 1.001, 0.0}; }, text + "1.001");
    expect_bad_node([](Node& x) { x.n[1] = nan; }, text + "nan");
}

TEST(BadNode, OfADistanceThatIsNoNumberIsNamed) {
    expect_bad_node([](Node& x) { x.s = nan; }, "distance must be >= -1e100 [length], got nan");
    expect_bad_node([](Node& x) { x.s = -infinity; },
                    "distance must be >= -1e100 [length], got -inf");
    expect_bad_node([](Node& x) { x.gap = nan; }, "gap must be >= -1e100 [length], got nan");
}

TEST(BadNode, OfACellWithoutSizeIsNamed) {
    const std::string text = "cell_size must be in [1e-100, 1e100] [length], got ";
    expect_bad_node([](Node& x) { x.d = 0.0; }, text + "0");
    expect_bad_node([](Node& x) { x.d = -0.5; }, text + "-0.5");
    expect_bad_node([](Node& x) { x.d = nan; }, text + "nan");
    Nodes nodes = random_nodes(3, 3, 32);
    const double spacing[3] = {1.0, -1.0, 1.0};
    grit_contact_nodes q = nodes.views();
    q.cell_size = {};
    q.spacing = grit_view_of(spacing, 0, 1);
    const std::vector<Node> before = nodes.node;
    EXPECT_EQ(nodes.correct(strict(), q, 3), GRIT_BAD_STATE);
    EXPECT_STREQ(nodes.error.message,
                 "node 0: spacing component 1 must be in [1e-100, 1e100] [length], got -1");
    EXPECT_TRUE(same_bits(nodes.node, before));
}

TEST(BadNode, OfANegativeAreaIsNamed) {
    expect_bad_node([](Node& x) { x.area = -1.0; },
                    "contact_area must be in [0, 1e100] [area], got -1");
}

TEST(BadNode, OfAPoreImpulseThatIsNotFiniteIsNamed) {
    expect_bad_node([](Node& x) { x.pore_impulse = nan; },
                    "pore_impulse must be in [-1e100, 1e100] [mass velocity], got nan");
}

TEST(BadNode, OfAVectorThatIsNotFiniteIsNamed) {
    const std::string limit = " must be finite, |components| at most 1e100 in sum ";
    expect_bad_node([](Node& x) { x.v_a[2] = nan; },
                    "velocity_a" + limit + "[velocity], component 2 is nan");
    expect_bad_node([](Node& x) { x.v_b[0] = infinity; },
                    "velocity_b" + limit + "[velocity], component 0 is inf");
    expect_bad_node([](Node& x) { x.v_b[1] = -1e101; },
                    "velocity_b" + limit + "[velocity], component 1 is -1e+101");
    expect_bad_node([](Node& x) { x.a_a[1] = nan; },
                    "acceleration_a" + limit + "[acceleration], component 1 is nan");
    expect_bad_node([](Node& x) { x.a_b[1] = nan; },
                    "acceleration_b" + limit + "[acceleration], component 1 is nan");
    expect_bad_node([](Node& x) { x.old_a[0] = nan; },
                    "previous_velocity_a" + limit + "[velocity], component 0 is nan");
    expect_bad_node([](Node& x) { x.old_b[0] = nan; },
                    "previous_velocity_b" + limit + "[velocity], component 0 is nan");
    expect_bad_node([](Node& x) { x.x[1] = nan; },
                    "position" + limit + "[length], component 1 is nan");
}

TEST(BadNode, IsTheFirstOfSeveral) {
    Nodes nodes = random_nodes(40, 3, 33);
    nodes.node[37].m_a = nodes.node[17].m_a = nodes.node[22].s = nan;
    EXPECT_EQ(nodes.correct(strict()), GRIT_BAD_STATE);
    EXPECT_EQ(nodes.error.point, 17);
    EXPECT_EQ(nodes.reports[37].status, GRIT_BAD_STATE);
    EXPECT_EQ(nodes.reports[22].status, GRIT_BAD_STATE);
}

}  // namespace
