// SPDX-License-Identifier: BSD-3-Clause
// Water that stands before a body at a pressure, or comes in across a side of the grid: Darcy's flow through a column.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <adapters/mpm/run/measures.hpp>

#include "support/goes_on.hpp"
#include "support/saturated_column.hpp"

namespace {

using namespace mpm_test;

using Column = SaturatedColumn;

constexpr double pressure = 1e4;  // [Pa]

Column column(bool implicit) { return {.cells = 8, .conductivity = 1e-3, .implicit = implicit}; }

// Water of this pressure before an edge of the column, which comes within 0.2 s.
TractionPlan water_before(Edge edge) {
    return {.body = "sand",
            .edge = edge,
            .direction = {0.0, edge == Edge::top ? -1.0 : 1.0},
            .stress = TimeTable{{0.0, 0.2}, {0.0, pressure}},
            .on_mixture = true};
}

BuiltCase after(const Case& plan, double time) {
    BuiltCase out = build_case(plan);
    while (out.simulation->time() < time) out.simulation->step();
    return out;
}

double residual(Simulation& simulation) {
    const Energy energy = simulation.energy();
    return energy.residual() / std::max(energy.external_work, energy.drag);
}

// n (v_w - v_s) of all particles: the mean, and how far any is from it.
struct Seepage {
    double mean = 0.0, scatter = 0.0;
};
Seepage seepage(Simulation& simulation) {
    Body& sand = simulation.body(0);
    const ParticleView q = sand.particles.view();
    const auto of = [&](std::ptrdiff_t p) {
        return PoreWater::porosity_of(sand.water->void_ratio(q, p)) *
               q[sand.water->velocity_column() + 1][p];
    };
    Seepage out;
    for (std::ptrdiff_t p = 0; p < sand.particles.size(); ++p)
        out.mean += of(p) / static_cast<double>(sand.particles.size());
    for (std::ptrdiff_t p = 0; p < sand.particles.size(); ++p)
        out.scatter = std::max(out.scatter, std::fabs(of(p) - out.mean));
    return out;
}

class SidesOfWater : public testing::TestWithParam<bool> {};

// It fills the pores and presses on no grain.
TEST_P(SidesOfWater, StandingWaterIsInTheEndThePorePressure) {
    Case plan = column(GetParam()).plan();
    plan.tractions = {water_before(Edge::top)};
    BuiltCase built = after(plan, 4.0);
    Simulation& simulation = *built.simulation;
    for (const double p : pore_pressures(simulation, 8)) EXPECT_NEAR(p, pressure, 1e-3 * pressure);
    const ParticleView q = simulation.body(0).particles.view();
    for (std::ptrdiff_t p = 0; p < simulation.body(0).particles.size(); ++p)
        EXPECT_NEAR(q[column::S_zz][p], 0.0, 1e-3 * pressure);
    EXPECT_NEAR(residual(simulation), 0.0, 1e-3);
}

void expect_darcy(Simulation& simulation, double tolerance) {
    const std::vector<double> p = pore_pressures(simulation, 8);
    for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(p[static_cast<std::size_t>(i)], pressure * (1.0 - (i + 0.5) / 8.0),
                    tolerance * pressure);
    const Seepage found = seepage(simulation);
    const double q = 1e-3 * pressure / (Column::rho_w * standard_gravity * Column::height);
    EXPECT_NEAR(found.mean, q, tolerance * q);
    EXPECT_LT(found.scatter, tolerance * q);
    EXPECT_NEAR(residual(simulation), 0.0, 1e-3);
}

// Where the side holds the grains, too.
TEST_P(SidesOfWater, APressureDrivesDarcysFlow) {
    Column drained = column(GetParam());
    drained.drained_bottom = true;
    Case plan = drained.plan();
    plan.tractions = {water_before(Edge::bottom)};
    BuiltCase built = after(plan, 4.0);
    expect_darcy(*built.simulation, 4e-3);
    // It lifts what rests on the side, the grains by their share and the water's by drag.
    EXPECT_NEAR(base_reaction(*built.simulation), -pressure * drained.cell(),
                4e-3 * pressure * drained.cell());
}

// Sides that hold grains hold no water along them: no node of this column has grains that are free.
TEST_P(SidesOfWater, LetWaterFlowAlongGrainsThatAreFixed) {
    Column drained = column(GetParam());
    drained.drained_bottom = true;
    Case plan = drained.plan();
    for (const Side side : {Side::left, Side::right})
        plan.boundary[static_cast<int>(side)] = Boundary::fixed;
    plan.tractions = {water_before(Edge::bottom)};
    BuiltCase built = after(plan, 4.0);
    expect_darcy(*built.simulation, 4e-3);
}

TEST_P(SidesOfWater, AnInflowIsDarcysFlow) {
    Case plan = column(GetParam()).plan();
    const double q = 1e-3 * pressure / (Column::rho_w * standard_gravity * Column::height);
    plan.inflows = {{.side = Side::bottom, .speed = TimeTable{{0.0, 0.2}, {0.0, q}}}};
    BuiltCase built = after(plan, 4.0);
    expect_darcy(*built.simulation, 4e-3);
}

// Nothing leaves a closed column: what comes in is what its pores and its water give way by.
TEST_P(SidesOfWater, WhatComesInIsThere) {
    Column closed = column(GetParam());
    closed.closed = true;
    Case plan = closed.plan();
    constexpr double q = 1e-6, time = 0.5;
    plan.inflows = {{.side = Side::top, .speed = TimeTable{{0.0}, {q}}}};
    BuiltCase built = after(plan, time);
    Simulation& simulation = *built.simulation;
    double mean = 0.0;
    for (const double p : pore_pressures(simulation, 8)) mean += p / 8.0;
    const double expected = Column::K_w / Column::n * q * simulation.time() / Column::height;
    EXPECT_NEAR(mean, expected, 1e-3 * expected);
    EXPECT_NEAR(residual(simulation), 0.0, 1e-3);
}

// Two of a side add up.
TEST_P(SidesOfWater, InflowsOfOneSideAddUp) {
    SaturatedColumn closed = column(GetParam());
    closed.closed = true;
    Case plan = closed.plan();
    plan.inflows = {{.side = Side::top, .speed = TimeTable{{0.0}, {1e-6}}}};
    plan.inflows.push_back({.side = Side::top, .speed = TimeTable{{0.0}, {0.0}}});
    BuiltCase built = after(plan, 0.2);
    double mean = 0.0;
    for (const double p : pore_pressures(*built.simulation, 8)) mean += p / 8.0;
    const double expected = Column::K_w / Column::n * 1e-6 * built.simulation->time();
    EXPECT_NEAR(mean, expected, 2e-3 * expected);
}

// No more leaves a particle than was in it.
TEST_P(SidesOfWater, EndTheRunWhereNoWaterIsLeft) {
    SaturatedColumn closed = column(GetParam());
    closed.closed = true;
    Case plan = closed.plan();
    plan.inflows = {{.side = Side::bottom, .speed = TimeTable{{0.0}, {-0.5}}}};
    std::string told;
    try {
        after(plan, 2.0);
    } catch (const std::runtime_error& error) {
        told = error.what();
    }
    EXPECT_NE(told.find("pore water of sand at t = "), std::string::npos) << told;
    EXPECT_NE(told.find("has no water left"), std::string::npos) << told;
}

TEST_P(SidesOfWater, GoOnFromACheckpointBitForBit) {
    Column drained = column(GetParam());
    drained.drained_bottom = true;
    Case plan = drained.plan();
    plan.drained[static_cast<int>(Side::bottom)] = false;
    plan.tractions = {water_before(Edge::top)};
    plan.inflows = {{.side = Side::bottom, .speed = TimeTable{{0.0, 0.2}, {0.0, 1e-3}}}};
    expect_goes_on(plan, 100);
    Case other = plan;
    other.inflows.clear();
    expect_refused(plan, other);
    other = plan;
    other.inflows[0].side = Side::top;
    expect_refused(plan, other);
    other = plan;
    other.tractions[0].on_mixture = false;
    expect_refused(plan, other);
    other = plan;
    other.tractions[0].edge = Edge::bottom;
    expect_refused(plan, other);
}

INSTANTIATE_TEST_SUITE_P(Pressures, SidesOfWater, testing::Bool(),
                         [](const auto& it) { return it.param ? "Implicit" : "Explicit"; });

}  // namespace
