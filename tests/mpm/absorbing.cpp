// SPDX-License-Identifier: BSD-3-Clause
// Sides that take up waves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <adapters/mpm/run/measures.hpp>
#include <adapters/mpm/run/run.hpp>

#include "support/box.hpp"
#include "support/plans.hpp"

namespace {

using namespace mpm_test;

constexpr double E = 1e7, nu = 0.25, rho = 1000.0, L = 1.0;
constexpr double G = E / (2.0 * (1.0 + nu)), M = 2.0 * G * (1.0 - nu) / (1.0 - 2.0 * nu);
const double c_p = std::sqrt(M / rho), c_s = std::sqrt(G / rho);

// What is left of a pulse, 20 cells long, that ran down a column and would be back from its foot; as
// shares of the work that brought it there.
struct Remainder {
    double energy, absorbed, residual;
};

Remainder send_pulse(bool shear, bool absorbs) {
    constexpr int cells = 100;
    constexpr double width = 0.02, foot = 0.5;
    const double c = shear ? c_s : c_p, duration = 0.2 * L / c;
    Simulation simulation(Axis::uniform(0.0, width, 2), Axis::uniform(foot, foot + 1.1, 110),
                          {.axisymmetric = false, .cfl = 0.2});
    simulation.add_body(make_box({0.0, width, foot, foot + L, 4, 2 * cells, rho}, false,
                                 std::make_unique<LinearElastic>(E, nu)));
    for (int i = 0; i < 4; ++i)
        simulation.add_traction(
            {0, (2 * cells - 1) * 4 + i, Edge::top, [=](double t) {
                 const double pressure =
                     t < duration ? 1e3 * std::sin(std::numbers::pi * t / duration) : 0.0;
                 return shear ? grit::Vector2{pressure, 0.0} : grit::Vector2{0.0, -pressure};
             }});
    simulation.fix_above(shear ? 1 : 0, -1.0);  // nothing moves across the wave
    if (absorbs) simulation.absorb_first(1, {c_p, c_s});
    else simulation.fix_below(1, foot, Hold::both);
    while (simulation.time() < 1.6 * L / c) simulation.step();
    const Energy energy = simulation.energy();
    return {(energy.kinetic + energy.stored) / energy.external_work,
            energy.absorbed / energy.external_work, energy.residual() / energy.external_work};
}

TEST(AbsorbingSide, TakesUpPressureAndShearWaves) {
    for (const bool shear : {false, true}) {
        const Remainder there = send_pulse(shear, false), gone = send_pulse(shear, true);
        EXPECT_GT(there.energy, 0.9);
        EXPECT_EQ(there.absorbed, 0.0);
        EXPECT_LT(gone.energy, 1e-3);
        EXPECT_NEAR(gone.absorbed, 1.0, 0.02);
        EXPECT_NEAR(gone.residual, 0.0, 1e-4);
    }
}

TEST(AbsorbingSide, HoldsWhatRestsOnItAtTheStartHoweverLight) {
    for (const double density : {1000.0, 5.0}) {
        Case plan = column_case();
        plan.boundary[static_cast<int>(Side::right)] = Boundary::absorbing;
        plan.boundary[static_cast<int>(Side::bottom)] = Boundary::absorbing;
        plan.absorbing = {50.0, 30.0};
        plan.bodies[0].density = density;
        plan.bodies[0].geostatic = Geostatic{.surface = 1.0};
        Runner runner(plan);
        while (!runner.finished()) runner.step();
        const HistoryRow last = runner.row();
        const double weight = density * plan.gravity * std::numbers::pi * 0.2 * 0.2;
        EXPECT_NEAR(last.base_force, weight, 1e-9 * weight);
        const Particles& q = runner.simulation().body(0).particles;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p)
            EXPECT_LT(std::hypot(q(column::v_r, p), q(column::v_z, p)), 1e-12);
    }
}

TEST(AbsorbingSide, RefusesWeightThatNoStressCarriesYet) {
    Case plan = column_case();
    plan.boundary[static_cast<int>(Side::bottom)] = Boundary::absorbing;
    plan.absorbing = {50.0, 30.0};
    try {
        const Runner runner(plan);
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).find("body column has weight and reaches"), 0u);
    }
    plan.stages[0].gravity = false;
    EXPECT_NO_THROW(Runner{plan});
}

// Lifted off, it presses no longer.
TEST(AbsorbingSide, HoldsNothingOfABodyThatHasLeft) {
    Case plan = column_case();
    plan.boundary[static_cast<int>(Side::bottom)] = Boundary::absorbing;
    plan.absorbing = {50.0, 30.0};
    plan.bodies[0].geostatic = Geostatic{.surface = 1.0};
    plan.bodies[0].velocity = {0.0, 1.5};
    plan.stages[0].gravity = false;
    Runner runner(plan);
    while (!runner.finished()) runner.step();
    EXPECT_EQ(base_reaction(runner.simulation()), 0.0);
}

}  // namespace
