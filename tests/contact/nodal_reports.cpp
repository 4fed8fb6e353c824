// SPDX-License-Identifier: BSD-3-Clause
// What a report says, held against the change of the nodes.
#include "support/nodes.hpp"

namespace {

using namespace tests;

double energy(double m, const Vec& v) { return 0.5 * m * dot(v, v); }

grit_contact_options rough(int components) {
    grit_contact_options options = options_with(components);
    options.friction_coefficient = 0.4;
    options.time_step = 1e-3;
    return options;
}

template <class Check> void on_contacts(const Check& check) {
    for (const int components : {2, 3}) {
        Nodes nodes = random_nodes(50000, components, 11);
        nodes.remembered = nodes.accelerated = true;
        const std::vector<Node> before = nodes.node;
        ASSERT_EQ(nodes.correct(rough(components)), GRIT_OK) << nodes.error.message;
        for (std::size_t i = 0; i < before.size(); ++i)
            if (nodes.reports[i].state >= GRIT_CONTACT_STICK)
                check(before[i], nodes.node[i], nodes.reports[i]);
    }
}

TEST(ContactReport, GivesTheImpulseThatBodyBReceived) {
    on_contacts([](const Node& x, const Node& y, const grit_contact_report& r) {
        const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]};
        EXPECT_LE(norm(x.m_b * (y.v_b - x.v_b) - J), 1e-14 * x.m_b * (norm(x.v_b) + norm(y.v_b)));
        EXPECT_LE(norm(x.m_a * (y.v_a - x.v_a) + J), 1e-14 * x.m_a * (norm(x.v_a) + norm(y.v_a)));
        const Vec F = {r.force[0], r.force[1], r.force[2]};
        EXPECT_LE(norm(1e-3 * F - J), 1e-15 * norm(J));
    });
}

TEST(ContactReport, CorrectsAccelerationsByTheForce) {
    on_contacts([](const Node& x, const Node& y, const grit_contact_report& r) {
        const Vec F = {r.force[0], r.force[1], r.force[2]};
        EXPECT_LE(norm(x.m_b * (y.a_b - x.a_b) - F), 1e-14 * (norm(F) + x.m_b * norm(y.a_b)));
        EXPECT_LE(norm(x.m_a * (y.a_a - x.a_a) + F), 1e-14 * (norm(F) + x.m_a * norm(y.a_a)));
    });
}

TEST(ContactReport, GivesTheEnergyTakenFromTheTrialVelocities) {
    on_contacts([](const Node& x, const Node& y, const grit_contact_report& r) {
        const double before = energy(x.m_r(), x.w()), after = energy(x.m_r(), y.w());
        EXPECT_GE(r.trial_energy_normal, 0.0);
        EXPECT_GE(r.trial_energy_tangential, 0.0);
        EXPECT_NEAR(r.trial_energy_normal + r.trial_energy_tangential, before - after,
                    1e-14 * (before + x.m_r() * (dot(x.v_a, x.v_a) + dot(x.v_b, x.v_b))));
    });
}

TEST(ContactReport, GivesTheWorkOfTheImpulseOnTheMeanVelocity) {
    on_contacts([](const Node& x, const Node& y, const grit_contact_report& r) {
        const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]};
        const Vec mean = 0.5 * ((x.old_a - x.old_b) + y.w());
        const double normal = dot(J, x.n) * dot(mean, x.n);
        const double scale = norm(J) * (norm(x.old_a) + norm(x.old_b) + norm(x.v_a) + norm(x.v_b));
        EXPECT_NEAR(r.dissipation_normal, normal, 1e-14 * scale);
        EXPECT_NEAR(r.dissipation_tangential, dot(J, mean) - normal, 1e-14 * scale);
    });
}

TEST(ContactReport, ClosesTheBalanceOfALeapfrogStepWhereTheTrialEnergyDoesNot) {
    // A body pressed onto the ground by its weight for a second: nothing moves, nothing is lost.
    grit_contact_options options = options_with();
    options.rigid = GRIT_CONTACT_B_RIGID;
    options.time_step = 1e-3;
    Node x;
    x.m_a = 1000.0;
    Nodes nodes({x});
    nodes.remembered = true;
    double trial = 0.0, leapfrog = 0.0;
    for (int step = 0; step < 1000; ++step) {
        nodes.node[0].old_a = nodes.node[0].v_a;
        nodes.node[0].v_a[0] += 9.81 * options.time_step;
        nodes.correct(options);
        trial += nodes.reports[0].trial_energy_normal;
        leapfrog += nodes.reports[0].dissipation_normal;
    }
    EXPECT_NEAR(trial, 1000 * 0.5 * 1000.0 * 9.81e-3 * 9.81e-3, 1e-9);
    EXPECT_EQ(leapfrog, 0.0);
}

TEST(ContactReport, IsEmptyWhereNothingHappens) {
    Node apart;
    apart.v_a = {-1.0, 0.0, 0.0};
    Nodes nodes({apart});
    nodes.correct(rough(3));
    grit_contact_report expected{};
    expected.state = GRIT_CONTACT_OPEN;
    EXPECT_EQ(std::memcmp(&nodes.reports[0], &expected, sizeof expected), 0);
}

TEST(ContactReport, GivesNoForceWithoutATimeStep) {
    Node x;
    x.v_a = {1.0, 0.0, 0.0};
    Nodes nodes({x});
    nodes.correct(options_with());
    EXPECT_EQ(nodes.reports[0].impulse[0], 0.5);
    EXPECT_EQ(nodes.reports[0].force[0], 0.0);
}

}  // namespace
