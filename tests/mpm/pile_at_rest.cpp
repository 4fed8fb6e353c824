// SPDX-License-Identifier: BSD-3-Clause
// V11: the pile of R 0.15 m and L 5 m, its weight and the hammer on its head.
#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace {

using namespace mpm_test;

constexpr double R = 0.15, L = 5.0, rho = 8000.0, g = 9.81;
constexpr double hammer_stress = 1e6;                   // [Pa]
constexpr double full_circle = 2.0 * std::numbers::pi;  // per radian -> all of it
constexpr int across = 4, along = 100;                  // particles

// Softer than steel, for fewer steps: what rests does not know.
Body make_pile(double nu = 0.3) {
    return make_box({0.0, R, 0.0, L, across, along, rho}, true,
                    std::make_unique<LinearElastic>(1e9, nu));
}

void strike(Simulation& simulation, std::size_t pile, double stress) {
    for (int i = 0; i < across; ++i)
        simulation.add_traction({pile, (along - 1) * across + i, Edge::top, [stress](double) {
                                     return grit::Vector2{0.0, -stress};
                                 }});
}

TEST(Pile, FeelsTheHammerWithItsStressTimesItsHead) {
    Simulation simulation(Axis::uniform(0.0, 0.225, 3), Axis::uniform(-0.5, 5.5, 60),
                          {.axisymmetric = true});
    simulation.add_body(make_pile(0.0));  // its head keeps its area
    strike(simulation, 0, hammer_stress);
    while (simulation.time() < 0.02) simulation.step();
    const CentreOfMass now = centre_of_mass(simulation.body(0).particles);
    const double force = -now.mass * now.v_z / simulation.time();
    EXPECT_NEAR(force, 11.25e3, 1.0);
    EXPECT_NEAR(full_circle * force, 70.69e3, 10.0);
    EXPECT_NEAR(full_circle * now.mass * g, 27.74e3, 10.0);
}

// Upwards, of the lowest row of nodes, which is fixed.
double reaction(const Simulation& simulation, int nodes_r) {
    double sum = 0.0;
    for (int i = 0; i < nodes_r; ++i) {
        const NodeRecord& n = simulation.records(0)[static_cast<std::size_t>(i)];
        sum += n[record::m] * g - n[record::f_z];
    }
    return sum;
}

TEST(Pile, AtRestPressesItsFixedBaseWithItsWeightAndThatOfTheHammer) {
    for (const double stress : {0.0, hammer_stress}) {
        Simulation simulation(
            Axis::uniform(0.0, 0.225, 3), Axis::uniform(0.0, 5.2, 52),
            {.axisymmetric = true, .cfl = 0.6, .local_damping = 0.5, .gravity_z = -g});
        simulation.add_body(make_pile());
        simulation.fix_below(1, 0.0);
        strike(simulation, 0, stress);
        while (simulation.time() < 0.35) simulation.step();
        const double expected = 27.737e3 + stress * 0.5 * full_circle * R * R;
        EXPECT_NEAR(full_circle * reaction(simulation, 4), expected, 0.005 * expected);
    }
}

// Local damping must not carry a share of what rests on a contact.
TEST(Pile, AtRestOnARigidBodyPressesItAsMuch) {
    for (const double stress : {0.0, hammer_stress}) {
        Simulation simulation(
            Axis::uniform(0.0, 0.225, 3), Axis::uniform(-0.1, 5.2, 53),
            {.axisymmetric = true, .cfl = 0.6, .local_damping = 0.5, .gravity_z = -g});
        simulation.add_body(make_floor({0.0, 0.225, -0.1, 0.0, 3, 1, rho}, true));
        simulation.add_body(make_pile());
        simulation.add_contact(contact_law(GRIT_CONTACT_GEO, 0.3));
        strike(simulation, 1, stress);
        while (simulation.time() < 0.3) simulation.step();
        const double start = simulation.time();
        double impulse = 0.0;
        while (simulation.time() < start + 0.05) {
            const double before = simulation.time();
            simulation.step();
            const double dt = simulation.time() - before;
            impulse += dt * simulation.contact(0).totals().force_on_b[1];
        }
        const double expected = 27.737e3 + stress * 0.5 * full_circle * R * R;
        EXPECT_NEAR(full_circle * impulse / (simulation.time() - start), expected,
                    0.005 * expected);
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 0.005 * energy.external_work);
    }
}

}  // namespace
