// SPDX-License-Identifier: BSD-3-Clause
// Rigid plates on sides of the grid.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "support/goes_on.hpp"
#include "support/mandel_slab.hpp"
#include "support/plans.hpp"

namespace {

using namespace mpm_test;

// Two blocks beside each other under a platen, the second four times as stiff; the load is on the first.
Case two_blocks() {
    Case out;
    out.name = "blocks";
    out.settings.axisymmetric = false;
    out.gravity = 0.0;
    out.r = {0.0, {{0.8, 8, 1.0}}};
    out.z = {0.0, {{0.5, 5, 1.0}}};
    for (const Side side : {Side::left, Side::right, Side::bottom})
        out.boundary[static_cast<int>(side)] = Boundary::roller;
    out.boundary[static_cast<int>(Side::top)] = Boundary::platen;
    out.platen_level[static_cast<int>(Side::top)] = 0.4;
    out.bodies = {elastic_box("soft", 0.0, 0.4, 0.0, 0.4),
                  elastic_box("stiff", 0.4, 0.8, 0.0, 0.4)};
    out.bodies[0].material = ElasticPlan{1e6, 0.0};
    out.bodies[1].material = ElasticPlan{4e6, 0.0};
    out.tractions = {{.body = "soft",
                      .edge = Edge::top,
                      .direction = {0.0, -1.0},
                      .stress = TimeTable{{0.0, 0.05}, {0.0, 1e3}}}};
    out.stages = {StagePlan{.name = "stage", .end = {.time = 1.0}}};
    out.history.body = "soft";
    return out;
}

double top_speed(const Simulation& simulation, std::size_t body, int i) {
    const auto row = static_cast<std::size_t>(simulation.axis_r().nodes());
    const std::size_t node = 4 * row + static_cast<std::size_t>(i);
    return simulation.motions(body)[node][motion::v_z];
}

TEST(Platen, MovesAllBodiesAsOne) {
    Case plan = two_blocks();
    plan.settings.cfl = 0.1;  // the residual is that of half a step
    BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    double fastest = 0.0;
    while (simulation.time() < 0.2) {
        simulation.step();
        const double v = top_speed(simulation, 0, 0);
        fastest = std::max(fastest, std::fabs(v));
        for (int i = 1; i <= 4; ++i) EXPECT_EQ(top_speed(simulation, 0, i), v);
        for (int i = 4; i <= 8; ++i) EXPECT_EQ(top_speed(simulation, 1, i), v);
    }
    EXPECT_GT(fastest, 1e-3);
    const Energy energy = simulation.energy();
    EXPECT_NEAR(energy.residual(), 0.0, 1e-3 * energy.external_work);
    EXPECT_GE(energy.contact, 0.0);
}

// E1 w1 + E2 w2 over the height, whatever is loaded. Without a tie after damping 7e-3 are missing.
TEST(Platen, SharesItsLoadByStiffness) {
    Case plan = two_blocks();
    plan.settings.local_damping = 0.5;
    BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    while (simulation.time() < 0.6) simulation.step();
    const double strain = -1e3 * 0.4 / (1e6 * 0.4 + 4e6 * 0.4);
    for (const std::size_t body : {std::size_t{0}, std::size_t{1}}) {
        const ParticleView q = simulation.body(body).particles.view();
        const double E = body == 0 ? 1e6 : 4e6;
        for (std::ptrdiff_t p = 0; p < simulation.body(body).particles.size(); ++p)
            EXPECT_NEAR(q[column::S_zz][p], E * strain, 4e-3 * E * -strain);
    }
}

// Whatever the last digits of its level and of the grid's lines.
TEST(Platen, BeginsAtTheNearestLineOfTheGrid) {
    for (const auto& [end, cells, level] :
         {std::tuple{0.3, 3, 0.2}, {0.9, 9, 0.8}, {0.9, 9, 0.1}, {0.7, 7, 0.3}}) {
        Case plan = two_blocks();
        plan.z = {0.0, {{end, cells, 1.0}}};
        plan.platen_level[static_cast<int>(Side::top)] = level;
        for (BodyPlan& body : plan.bodies)
            for (grit::Vector2& corner : body.outlines[0].corners)
                if (corner[1] > 0.0) corner[1] = level;
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        for (int i = 0; i < 5; ++i) simulation.step();
        const auto row = static_cast<std::size_t>(std::lround(level / (end / cells)));
        const auto speed = [&](std::size_t body, std::size_t i) {
            return simulation.motions(body)[row * 9 + i][motion::v_z];
        };
        EXPECT_NE(speed(1, 8), 0.0) << level;
        EXPECT_EQ(speed(0, 0), speed(1, 8)) << level;
    }
    Case plan = two_blocks();
    plan.platen_level[static_cast<int>(Side::top)] = 0.37;
    EXPECT_THROW(build_case(plan), std::invalid_argument);
}

// With damping, and where an implicit pressure moves it once more.
TEST(Platen, KeepsTheBalanceOfEnergyOfDampedWater) {
    for (const double damping : {0.3, 0.7})
        for (const bool implicit : {false, true}) {
            Case plan = two_blocks();
            plan.settings.local_damping = damping;
            plan.bodies = {elastic_box("soft", 0.0, 0.8, 0.0, 0.4)};
            plan.bodies[0].material = ElasticPlan{1e7, 0.0};
            plan.bodies[0].density = 1590.0;
            plan.bodies[0].water = WaterPlan{.drainage = Drainage::flow,
                                             .grain_density = 2650.0,
                                             .porosity = 0.4,
                                             .conductivity = 1e-4,
                                             .implicit = implicit};
            plan.tractions[0].r[1] = 0.4;
            BuiltCase built = build_case(plan);
            Simulation& simulation = *built.simulation;
            while (simulation.time() < 0.1) simulation.step();
            const Energy energy = simulation.energy();
            EXPECT_NEAR(energy.residual(), 0.0, 1e-4 * energy.external_work);
            EXPECT_GT(energy.damping, 0.0);
        }
}

TEST(Platen, EndsTheRunWhereItsNodesAreNoLongerTheSurface) {
    Case plan = two_blocks();
    plan.tractions[0].stress = TimeTable{{0.0, 0.05}, {0.0, 5e5}};
    BuiltCase built = build_case(plan);
    std::string told;
    try {
        while (built.simulation->time() < 0.2) built.simulation->step();
    } catch (const std::runtime_error& error) {
        told = error.what();
    }
    EXPECT_NE(told.find("a platen has moved by -0.02"), std::string::npos) << told;
}

TEST(Platen, GoesOnFromACheckpointBitForBit) {
    const Case plan = two_blocks();
    expect_goes_on(plan, 50);
    Case other = plan;
    other.platen_level[static_cast<int>(Side::top)] = 0.5;
    expect_refused(plan, other);
}

// Its pressure rises by 10 % before it falls.
TEST(Platen, PressesASlabAsMandelSays) {
    for (const bool implicit : {false, true}) {
        const MandelSlab slab{.cells = implicit ? 16 : 8,
                              .conductivity = implicit ? 5e-5 : 1e-4,
                              .implicit = implicit};
        for (const MandelSlab::Result& now : slab.run({0.1, 0.2, 0.5})) {
            EXPECT_NEAR(now.pressure, now.exact, (implicit ? 2.5e-3 : 9e-3) * now.exact) << now.T;
            EXPECT_NEAR(now.residual, 0.0, 1e-3);
        }
    }
}

}  // namespace
