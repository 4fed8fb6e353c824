// SPDX-License-Identifier: BSD-3-Clause
// Saturated sand in contact at its surface, with explicit and implicit pressure.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "support/goes_on.hpp"
#include "support/pressed_column.hpp"

namespace {

using namespace mpm_test;
using Column = SaturatedColumn;

class WetSurface : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Pressure, WetSurface, testing::Bool(), [](const auto& of) {
    return std::string(of.param ? "Implicit" : "Explicit");
});

double borne(Simulation& simulation) { return contact_forces(simulation, 1).tip[1]; }

// The piston's whole way strains the column: no strip of it moves along.
TEST_P(WetSurface, BearsThePressureOfItsWaterBesideTheEffectiveStress) {
    for (const double k : {0.0, 1e-6, 1e-3}) {
        const Column column{.conductivity = k, .implicit = GetParam()};
        BuiltCase built = build_case(under_a_piston(column, true));
        Simulation& simulation = *built.simulation;
        double force = 0.0, p_w = 0.0, uneven = 0.0;
        int count = 0;
        while (simulation.time() < 0.04) {
            simulation.step();
            if (simulation.time() < 0.03) continue;
            const std::vector<double> pressures = pore_pressures(simulation, column.cells);
            force += borne(simulation) / column.cell();
            p_w += pressures[8];
            uneven += alternating(pressures);
            ++count;
        }
        const double strain = 15e-6 / column.height;
        EXPECT_NEAR(p_w / count, Column::K_w / Column::n * strain, 0.005 * p_w / count) << k;
        const double expected = p_w / count + Column::E * strain;
        EXPECT_NEAR(force / count, expected, 0.001 * expected) << k;
        EXPECT_LT(uneven / count, 0.01 * p_w / count) << k;
        EXPECT_NEAR(simulation.energy().residual(), 0.0, 1e-3 * simulation.energy().rigid_work);
    }
}

// Damping counts what contact has done on the velocities that it takes; pressures change what contact does after it.
TEST_P(WetSurface, KeepsItsEnergyBalanceWithLocalDamping) {
    for (const double k : {0.0, 1e-4}) {
        const Column column{.cells = 16, .conductivity = k, .implicit = GetParam(), .damping = 0.7};
        BuiltCase built = build_case(under_a_piston(column, true));
        Simulation& simulation = *built.simulation;
        while (simulation.time() < 0.03) simulation.step();
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 1e-4 * energy.rigid_work) << k;
        EXPECT_GT(energy.damping, 1e-4 * energy.rigid_work) << k;
    }
}

// Terzaghi's column upside down: a plate presses on it with its load, and its water leaves below.
TEST_P(WetSurface, ConsolidatesUnderAPlateAsTerzaghiSays) {
    for (const Consolidation& now : consolidate({.cells = 16,
                                    .conductivity = 1e-3,
                                    .drained_bottom = true,
                                    .implicit = GetParam(),
                                    .under_plate = true},
                                                {0.1, 0.2, 0.5})) {
        EXPECT_NEAR(now.pressure, now.exact_pressure, 0.006 * now.exact_pressure) << now.T;
        EXPECT_NEAR(now.settlement, now.exact_settlement, 0.006 * now.exact_settlement) << now.T;
        EXPECT_LT(now.alternating, 0.001);
        EXPECT_NEAR(now.residual, 0.0, 1e-3);
    }
}

TEST_P(WetSurface, RubsWithItsEffectiveStress) {
    const double dry = rubbing_force({}, true);
    EXPECT_NEAR(dry, 0.3 * 10e6 * 2e-4 / 0.5, 0.02 * dry);
    for (const double k : {0.0, 1e-9, 1e-5, 1e-3}) {
        WaterPlan water;
        water.drainage = k > 0.0 ? Drainage::flow : Drainage::undrained;
        water.conductivity = k;
        water.implicit = GetParam();
        EXPECT_NEAR(rubbing_force(water, true), dry, 0.02 * dry) << k;
    }
}

TEST_P(WetSurface, KeepsMomentumAndEnergyWhereABlockHits) {
    for (const double k : {0.0, 1e-6, 1e-4, 1e-2, 1e-1}) {
        BuiltCase built =
            hit_by_a_block({.cells = 16, .conductivity = k, .implicit = GetParam()}, true);
        Simulation& simulation = *built.simulation;
        const double before = momentum_z(simulation, 0) + momentum_z(simulation, 1);
        while (simulation.time() < 0.004) simulation.step();
        EXPECT_GT(std::fabs(momentum_z(simulation, 0)), 0.1 * std::fabs(before)) << k;
        // What water weighs in a particle is that of the moment.
        EXPECT_NEAR(momentum_z(simulation, 0) + momentum_z(simulation, 1), before,
                    (k > 0.0 ? 1e-3 : 1e-12) * -before)
            << k;
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, (GetParam() ? 1e-4 : 1e-3) * energy.kinetic_0) << k;
        EXPECT_GE(energy.contact, 0.0);
    }
}

// What leaves does so below; none of it passes the piston, however it presses.
TEST_P(WetSurface, LetsNoWaterThrough) {
    for (const double k : {1e-6, 1e-3, 1.0}) {
        const Column column{.cells = 16, .conductivity = k, .implicit = GetParam()};
        BuiltCase built = build_case(under_a_piston(column, true));
        Simulation& simulation = *built.simulation;
        simulation.step();
        const double start = water_mass(simulation);
        while (simulation.time() < 0.03) simulation.step();
        // Of the particles at the surface the strain is that of their cells, of which the piston cuts one.
        EXPECT_NEAR(water_mass(simulation), start, 1e-9 * start) << k;
    }
}

// In a single cell, whose lower nodes hold grains and let water out, in steps of the same length.
TEST(WetSurfaces, OfACellThatDrainsMoveAlikeUnderEitherPressure) {
    const auto pressed = [](bool implicit) {
        const Column column{
            .cells = 1,
            .conductivity = 1e-3,
            .cfl = 0.1 * (implicit ? std::sqrt(Column::E / Column::rho_d / Column::sum()) : 1.0),
            .drained_bottom = true,
            .implicit = implicit};
        BuiltCase built = build_case(under_a_piston(column, true));
        Simulation& simulation = *built.simulation;
        std::vector<double> out;
        for (const double t : {0.005, 0.01, 0.015, 0.02, 0.03}) {
            while (simulation.time() < t) simulation.step();
            out.push_back(pore_pressures(simulation, 1)[0]);
        }
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * energy.rigid_work);
        return out;
    };
    const std::vector<double> are = pressed(true), expected = pressed(false);
    EXPECT_GT(expected[1], 5e3);
    for (std::size_t i = 0; i < are.size(); ++i)
        EXPECT_NEAR(are[i], expected[i], 0.015 * expected[1]) << i;
}

// Drawn back, the piston pulls at nothing: the sand is left alone and drains; pressed again, it bears again.
TEST_P(WetSurface, LeavesAndComesBack) {
    for (const double k : {0.0, 1e-4}) {
        const Column column{.cells = 16, .conductivity = k, .implicit = GetParam()};
        const Case plan =
            under_a_piston(column, true,
                           {{0.0, 0.005, 0.015, 0.02, 0.025, 0.035, 0.04, 0.045, 0.055, 0.06},
                            {0.0, -1e-3, -1e-3, 0.0, 2e-3, 2e-3, 0.0, -3e-3, -3e-3, 0.0}});
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        double least = 0.0, pressed = 0.0, apart = 0.0, again = 0.0;
        while (simulation.time() < 0.08) {
            simulation.step();
            const double t = simulation.time(), now = borne(simulation) / column.cell();
            least = std::min(least, now);
            if (t < 0.02) pressed = std::max(pressed, now);
            if (t > 0.034 && t < 0.042) apart = std::max(apart, now);
            if (t > 0.06) again = std::max(again, now);
        }
        EXPECT_GT(pressed, 5e4) << k;
        EXPECT_GE(least, -1e-6 * pressed) << k;
        EXPECT_EQ(apart, 0.0) << k;
        EXPECT_GT(again, 5e4) << k;
        EXPECT_NEAR(simulation.energy().residual(), 0.0, 2e-3 * pressed * 15e-6);
    }
}

// In the plane, with friction.
Case slid(bool implicit, double conductivity, int threads) {
    WaterPlan water;
    water.drainage = conductivity > 0.0 ? Drainage::flow : Drainage::undrained;
    water.conductivity = conductivity;
    water.implicit = implicit;
    Case plan = plate_on_a_block(water, true);
    plan.settings.threads = threads;
    return plan;
}

TEST_P(WetSurface, IsTheSameWhateverTheThreads) {
    for (const double k : {0.0, 1e-4}) {
        std::string one;
        for (const int threads : {1, 2, 3}) {
            BuiltCase built = build_case(slid(GetParam(), k, threads));
            for (int i = 0; i < 200; ++i) built.simulation->step();
            const std::string now = saved(*built.simulation);
            if (threads == 1) one = now;
            EXPECT_TRUE(now == one) << k << ", " << threads << " threads";
        }
    }
}

TEST_P(WetSurface, GoesOnFromACheckpointBitForBit) {
    for (const double k : {0.0, 1e-4}) expect_goes_on(slid(GetParam(), k, 1), 100);
}

}  // namespace
