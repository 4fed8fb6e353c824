// SPDX-License-Identifier: BSD-3-Clause
// A checkerboard of pore pressures, which moves no node, drains between its cells.
#include <gtest/gtest.h>

#include <cmath>

#include <adapters/mpm/run/measures.hpp>

#include "support/saturated_column.hpp"

namespace {

using namespace mpm_test;

// A closed block of so many cells along each side, p_w plus and minus 1 kPa from cell to cell.
struct Checkerboard {
    static constexpr int cells = 12, beside = 4;  // of its sides, whose nodes feel it
    static constexpr double size = 1e3;           // [Pa]
    double conductivity;                          // [m/s]; 0: undrained
    double cfl = 0.4;

    BuiltCase build() const {
        const SaturatedColumn column{.cells = cells,
                                     .conductivity = conductivity,
                                     .cfl = cfl,
                                     .closed = true,
                                     .implicit = true};
        Case plan = column.plan();
        plan.r = {0.0, {{1.0, cells, 1.0}}};
        plan.bodies[0].outlines = {Outline{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}}};
        BuiltCase built = build_case(plan);
        Body& body = built.simulation->body(0);
        const ParticleView q = body.particles.view();
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
            q[body.water->first][p] = size * sign(q, p);
        return built;
    }
    static double sign(const ParticleView& q, std::ptrdiff_t p) {
        const int i = static_cast<int>(q[column::r][p] * cells);
        return (i + static_cast<int>(q[column::z][p] * cells)) % 2 == 0 ? 1.0 : -1.0;
    }
    // The mean of what is left of it away from the sides, by what there was.
    static double left(Simulation& simulation) {
        Body& body = simulation.body(0);
        const ParticleView q = body.particles.view();
        const auto is_beside = [](double x) {
            return x * cells < beside || x * cells > cells - beside;
        };
        double sum = 0.0;
        int count = 0;
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            if (is_beside(q[column::r][p]) || is_beside(q[column::z][p])) continue;
            sum += sign(q, p) * q[body.water->first][p] / size;
            ++count;
        }
        return sum / count;
    }
};

// As Darcy has it between cells, 8/h^2 k/(rho_w g) K_w/n a second, where steps are so short that the inertia of the flow is
// nothing beside the compressibility of the pores.
TEST(CompactFlow, DrainsACheckerboardAsBetweenCells) {
    const Checkerboard problem{.conductivity = 1e-7, .cfl = 0.004};
    BuiltCase built = problem.build();
    Simulation& simulation = *built.simulation;
    const double rate = 8.0 * Checkerboard::cells * Checkerboard::cells * problem.conductivity /
                        (SaturatedColumn::rho_w * standard_gravity) * SaturatedColumn::K_w /
                        SaturatedColumn::n;
    const double before = water_mass(simulation);
    for (int i = 0; i < 20; ++i) simulation.step();
    EXPECT_NEAR(-std::log(Checkerboard::left(simulation)), rate * simulation.time(),
                0.05 * rate * simulation.time());
    EXPECT_NEAR(water_mass(simulation), before, 1e-13 * before);
    const Energy energy = simulation.energy();
    EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * std::fabs(energy.pore_water));
}

// Where no water goes through the grains what is there stays.
TEST(CompactFlow, LeavesUndrainedPressuresWhereTheyAre) {
    BuiltCase built = Checkerboard{.conductivity = 0.0}.build();
    for (int i = 0; i < 50; ++i) built.simulation->step();
    EXPECT_NEAR(Checkerboard::left(*built.simulation), 1.0, 0.05);
}

}  // namespace
