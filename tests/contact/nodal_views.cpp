// SPDX-License-Identifier: BSD-3-Clause
// Whatever way a host keeps its nodes and cuts them into calls, a node's result has the same bits.
#include <algorithm>

#include <grit/version.h>

#include "support/nodes.hpp"

namespace {

using namespace tests;

grit_contact_options rough(int components) {
    grit_contact_options options = options_with(components);
    options.friction_coefficient = 0.4;
    options.adhesion = 0.1;
    options.time_step = 1e-3;
    return options;
}

constexpr std::size_t count = 1003;

Nodes prepared(int components) {
    Nodes nodes = random_nodes(count, components, 21);
    nodes.gated = nodes.accelerated = nodes.remembered = true;
    return nodes;
}

TEST(ContactViews, ServeStructuresOfArrays) {
    for (const int components : {2, 3}) {
        Nodes nodes = prepared(components);
        const auto c = static_cast<std::size_t>(components);
        std::vector<double> n(c * count), v_a(c * count), v_b(c * count), scalars[6];
        for (std::size_t i = 0; i < count; ++i) {
            const Node& x = nodes.node[i];
            for (std::size_t k = 0; k < c; ++k) {
                n[k * count + i] = x.n[k];
                v_a[k * count + i] = x.v_a[k];
                v_b[k * count + i] = x.v_b[k];
            }
            const double values[] = {x.m_a, x.m_b, x.s, x.d, x.gap, x.area};
            for (int k = 0; k < 6; ++k) scalars[k].push_back(values[k]);
        }
        grit_contact_nodes q{};
        q.struct_size = sizeof q;
        const auto scalar = [&](int k) { return grit_view_of(scalars[k].data(), 1, 0); };
        q.mass_a = scalar(0);
        q.mass_b = scalar(1);
        q.distance = scalar(2);
        q.cell_size = scalar(3);
        q.gap = scalar(4);
        q.contact_area = scalar(5);
        q.normal = grit_view_of(n.data(), 1, count);
        q.velocity_a = grit_mutable_view_of(v_a.data(), 1, count);
        q.velocity_b = grit_mutable_view_of(v_b.data(), 1, count);
        const grit_contact_options options = rough(components);
        ASSERT_EQ(grit_contact_correct(&options, count, &q, nullptr, nullptr, nullptr), GRIT_OK);
        ASSERT_EQ(nodes.correct(options), GRIT_OK);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < c; ++k) {
                EXPECT_EQ(nodes.node[i].v_a[k], v_a[k * count + i]);
                EXPECT_EQ(nodes.node[i].v_b[k], v_b[k * count + i]);
            }
    }
}

TEST(ContactViews, GiveANodeTheSameBitsInAnyCompany) {
    for (const int components : {2, 3})
        for (int isa = GRIT_ISA_BASELINE; isa <= grit_instruction_set(); ++isa) {
            grit_contact_options options = rough(components);
            options.instruction_set = isa;
            Nodes together = prepared(components);
            const Nodes start = together;
            ASSERT_EQ(together.correct(options), GRIT_OK);
            for (const std::size_t piece : {1, 2, 3, 7, 8, 9, 64}) {
                Nodes cut = start;
                std::vector<grit_contact_report> reports(count);
                for (std::size_t first = 0; first < count; first += piece) {
                    Nodes part({cut.node.begin() + first,
                                cut.node.begin() + std::min(first + piece, count)});
                    part.gated = part.accelerated = part.remembered = true;
                    ASSERT_EQ(part.correct(options), GRIT_OK);
                    std::copy(part.node.begin(), part.node.end(), cut.node.begin() + first);
                    std::copy(part.reports.begin(), part.reports.end(), reports.begin() + first);
                    grit_contact_sums_add(&cut.sums, &part.sums);
                }
                EXPECT_TRUE(same_bits(cut.node, together.node)) << piece;
                EXPECT_EQ(
                    std::memcmp(reports.data(), together.reports.data(), count * sizeof reports[0]),
                    0);
                EXPECT_EQ(std::memcmp(&cut.sums, &together.sums, sizeof cut.sums), 0);
            }
        }
}

TEST(ContactViews, TakeNodesByIndex) {
    Nodes all = prepared(3), chosen = all;
    std::vector<ptrdiff_t> index;
    for (std::size_t i = 0; i < count; i += 3) index.push_back(static_cast<ptrdiff_t>(i));
    std::reverse(index.begin(), index.end());
    const std::vector<Node> before = all.node;
    all.correct(rough(3));
    grit_contact_nodes q = chosen.views();
    q.index = index.data();
    ASSERT_EQ(chosen.correct(rough(3), q, static_cast<ptrdiff_t>(index.size())), GRIT_OK);
    for (std::size_t i = 0; i < count; ++i)
        EXPECT_TRUE(same_bits({chosen.node[i]}, {i % 3 == 0 ? all.node[i] : before[i]})) << i;
    for (std::size_t i = 0; i < index.size(); ++i)  // reports come in the order of the index
        EXPECT_EQ(chosen.reports[i].state, all.reports[static_cast<std::size_t>(index[i])].state);
}

TEST(ContactViews, AgreeBetweenInstructionSets) {
    grit_contact_options options = rough(3);
    options.instruction_set = GRIT_ISA_BASELINE;
    Nodes baseline = prepared(3);
    Nodes best = baseline;
    baseline.correct(options);
    options.instruction_set = GRIT_ISA_BEST;
    best.correct(options);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_LE(norm(baseline.node[i].v_a - best.node[i].v_a), 1e-14);
        EXPECT_EQ(baseline.reports[i].state, best.reports[i].state);
    }
}

TEST(ContactViews, ValidateOnlyReportsAndChangesNothing) {
    Nodes nodes = prepared(3), dry = nodes;
    const std::vector<Node> before = dry.node;
    grit_contact_options options = rough(3);
    nodes.correct(options);
    options.validate_only = 1;
    ASSERT_EQ(dry.correct(options), GRIT_OK);
    EXPECT_TRUE(same_bits(dry.node, before));
    EXPECT_EQ(
        std::memcmp(dry.reports.data(), nodes.reports.data(), count * sizeof nodes.reports[0]), 0);
}

TEST(ContactViews, NoNodesAreNoError) {
    grit_contact_nodes q{};
    q.struct_size = sizeof q;
    EXPECT_EQ(grit_contact_correct(nullptr, 0, &q, nullptr, nullptr, nullptr), GRIT_OK);
}

}  // namespace
