// SPDX-License-Identifier: BSD-3-Clause
// Two bodies through the routine for many: bit for bit what the routine for a pair gives, with
// everything that a host may ask for.
#include "support/nodes.hpp"

namespace {

using namespace tests;

struct AsMany {
    Nodes nodes;
    grit_contact_options options;
    grit_contact_bodies bodies{};
    grit_contact_pair pair{};

    grit_status correct() {
        const grit_contact_nodes q = nodes.views();
        const grit_view mass[] = {q.mass_a, q.mass_b};
        const grit_mutable_view velocity[] = {q.velocity_a, q.velocity_b};
        const grit_mutable_view acceleration[] = {q.acceleration_a, q.acceleration_b};
        const grit_view previous[] = {q.previous_velocity_a, q.previous_velocity_b};
        bodies.struct_size = sizeof bodies;
        bodies.components = options.components;
        bodies.count = 2;
        bodies.mass = mass;
        bodies.velocity = velocity;
        bodies.acceleration = acceleration;
        bodies.previous_velocity = previous;
        bodies.position = q.position;
        pair.struct_size = sizeof pair;
        pair.a = 0;
        pair.b = 1;
        pair.options = &options;
        pair.normal = q.normal;
        pair.distance = q.distance;
        pair.cell_size = q.cell_size;
        pair.gap = q.gap;
        pair.contact_area = q.contact_area;
        pair.pore_impulse = q.pore_impulse;
        nodes.reports.assign(nodes.node.size(), {});
        return grit_contact_correct_many(&bodies, 1, &pair, nodes.size(), nodes.reports.data(),
                                         &nodes.sums, &nodes.error);
    }
};

grit_contact_options everything(int components) {
    grit_contact_options options = options_with(components);
    options.friction_coefficient = 0.4;
    options.adhesion = 50.0;
    options.time_step = 1e-3;
    return options;
}

Nodes prepared(int components) {
    Nodes nodes = random_nodes(3000, components, 71);
    nodes.gated = nodes.accelerated = nodes.remembered = nodes.saturated = true;
    Random random(72);
    for (Node& x : nodes.node) x.pore_impulse = random.uniform(-1.0, 1.0) * x.m_r();
    for (std::size_t i = 0; i < 100; ++i) nodes.node[i].m_a = 0.0;
    return nodes;
}

void are_a_pair_in_everything(double relaxation_time, double contact_stiffness) {
    for (const int components : {2, 3})
        for (const int rigid :
             {GRIT_CONTACT_NONE_RIGID, GRIT_CONTACT_A_RIGID, GRIT_CONTACT_B_RIGID}) {
            AsMany many{prepared(components), everything(components)};
            many.options.rigid = rigid;
            many.options.relaxation_time = relaxation_time;
            many.options.contact_stiffness = contact_stiffness;
            Nodes pair = many.nodes;
            ASSERT_EQ(many.correct(), GRIT_OK) << many.nodes.error.message;
            ASSERT_EQ(pair.correct(many.options), GRIT_OK);
            EXPECT_TRUE(same_bits(many.nodes.node, pair.node));
            EXPECT_EQ(std::memcmp(many.nodes.reports.data(), pair.reports.data(),
                                  pair.reports.size() * sizeof pair.reports[0]),
                      0);
            EXPECT_EQ(std::memcmp(&many.nodes.sums, &pair.sums, sizeof pair.sums), 0);
        }
}

TEST(ManyBodies, OfTwoAreAPairInEverything) { are_a_pair_in_everything(0.0, 0.0); }
TEST(ManyBodies, OfTwoAreAPairWithARelaxationTime) { are_a_pair_in_everything(0.02, 0.0); }
TEST(ManyBodies, OfTwoAreAPairWithASpring) { are_a_pair_in_everything(0.02, 1e4); }

TEST(ManyBodies, HaveTheInstructionSetOfTheirCallNotOfTheirPairs) {
    AsMany many{prepared(3), everything(3)};
    many.options.instruction_set = 99;
    EXPECT_EQ(many.correct(), GRIT_OK) << many.nodes.error.message;
    many.options.instruction_set = 0;
    many.bodies.instruction_set = 99;
    EXPECT_EQ(many.correct(), GRIT_BAD_CALL);
}

TEST(ManyBodies, ValidateOnlyChangesNothing) {
    AsMany many{prepared(3), everything(3)};
    const std::vector<Node> before = many.nodes.node;
    many.bodies.validate_only = 1;
    ASSERT_EQ(many.correct(), GRIT_OK);
    EXPECT_TRUE(same_bits(many.nodes.node, before));
}

TEST(ManyBodies, AreServedToCallersOfOtherVersions) {
    // A caller compiled with a longer pair, and one without its last view.
    struct Longer {
        grit_contact_pair pair;
        double unknown[2];
    };
    const std::size_t shorter = offsetof(grit_contact_pair, contact_area);
    for (const std::size_t size : {sizeof(Longer), shorter}) {
        alignas(grit_contact_pair) unsigned char memory[3 * sizeof(Longer)] = {};
        double m[3] = {1.0, 1.0, 1.0}, v[3][2] = {{1.0, 0.0}, {0.0, 0.0}, {-1.0, 0.0}};
        const double n[2] = {1.0, 0.0}, s = 0.0, d = 1.0;
        grit_view mass[3];
        grit_mutable_view velocity[3];
        for (int b = 0; b < 3; ++b) {
            mass[b] = grit_view_of(&m[b], 1, 1);
            velocity[b] = grit_mutable_view_of(v[b], 2, 1);
        }
        for (int p = 0; p < 2; ++p) {
            grit_contact_pair pair{};
            pair.struct_size = size;
            pair.a = p;
            pair.b = p + 1;
            pair.normal = grit_view_of(n, 0, 1);
            pair.distance = grit_view_of(&s, 0, 1);
            pair.cell_size = grit_view_of(&d, 0, 1);
            std::memcpy(memory + static_cast<std::size_t>(p) * size, &pair,
                        std::min(size, sizeof pair));
        }
        grit_contact_bodies bodies{};
        bodies.struct_size = sizeof bodies;
        bodies.components = 2;
        bodies.count = 3;
        bodies.mass = mass;
        bodies.velocity = velocity;
        grit_error error{};
        EXPECT_EQ(grit_contact_correct_many(&bodies, 2,
                                            reinterpret_cast<grit_contact_pair*>(memory), 1,
                                            nullptr, nullptr, &error),
                  GRIT_OK)
            << error.message;
        for (const auto& corrected : v) EXPECT_NEAR(corrected[0], 0.0, 1e-12);
    }
}

}  // namespace
