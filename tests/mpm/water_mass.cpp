// SPDX-License-Identifier: BSD-3-Clause
// Water is neither made nor lost: what particles have less of has crossed surfaces and sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include <adapters/mpm/run/measures.hpp>

#include "support/leaving_water.hpp"
#include "support/pressed_sand.hpp"
#include "support/saturated_column.hpp"
#include "support/shapes.hpp"

namespace {

using namespace mpm_test;

// Returns the share of the mass that is missing at the end. least: of it, what crosses surfaces and sides at least.
double expect_kept(Simulation& simulation, std::size_t body, int steps, double share = 1e-13,
                   double least = 1e-9) {
    const double start = water_mass(simulation);
    double gone = 0.0, turned_over = 0.0;
    for (int i = 0; i < steps; ++i) {
        const std::vector<NodeRecord> surface = areas(simulation, body);
        const double t = simulation.time();
        simulation.step();
        const double now = left(simulation, body, surface, simulation.time() - t);
        gone += now;
        turned_over += std::fabs(now);
    }
    if (least > 0.0) {
        EXPECT_GT(turned_over, least * start);
    }
    const double missing = (start - water_mass(simulation) - gone) / start;
    EXPECT_NEAR(missing, 0.0, share);
    return missing;
}

// Under a block that hits it, in axisymmetry.
TEST(WaterMass, IsKeptUnderABlow) {
    for (const bool implicit : {false, true})
        for (const auto& [fixed_point, at_surfaces] :
             {std::pair{false, false}, {true, false}, {false, true}}) {
            PressedSand problem;
            problem.at_surfaces = at_surfaces;
            problem.settings.fixed_point = fixed_point;
            problem.water = PressedSand::soft_water(true, implicit);
            const auto simulation = problem.build();
            expect_kept(*simulation, 1, 200);
        }
}

// A body that is driven into sand by more than a cell, with stiff water and implicit pressure: 2000 steps.
TEST(WaterMass, IsKeptOverADrive) {
    for (const bool at_surfaces : {false, true}) {
        PressedSand problem;
        problem.settings.local_damping = 0.0;
        problem.ring = false;
        problem.block_velocity = -10.0;
        problem.at_surfaces = at_surfaces;
        problem.water = PoreWater{.flows = true, .implicit = true, .conductivity = 1e-4};
        const auto simulation = problem.build();
        const double start = centre_of_mass(simulation->body(0).particles).z;
        const double missing = expect_kept(*simulation, 1, 2000, 1e-12);
        const double way = start - centre_of_mass(simulation->body(0).particles).z;
        EXPECT_GT(way, 0.05);
        std::printf("driven by %.0f mm, contact at %s: of the water's mass %.1e are missing\n",
                    1e3 * way, at_surfaces ? "surfaces" : "nodes", missing);
    }
}

// Of what is turned over, with steps a quarter as long as usual: at 10 m/s each of those strains sand by percents. What water takes
// along where sand loses pores is two to six times the limit.
TEST(WaterEnergy, BalancesOverADrive) {
    for (const bool implicit : {false, true})
        for (const bool at_surfaces : {false, true}) {
            SCOPED_TRACE(testing::Message() << implicit << at_surfaces);
            PressedSand problem;
            problem.settings.local_damping = 0.0;
            problem.settings.cfl = 0.1;
            problem.ring = false;
            problem.hyperelastic = true;
            problem.at_surfaces = at_surfaces;
            problem.water = PoreWater{.flows = true, .implicit = implicit, .conductivity = 1e-4};
            if (!implicit) problem.water->bulk_modulus = 2.2e7;
            const auto simulation = problem.build();
            while (simulation->time() < 0.02) simulation->step();
            const Energy energy = simulation->energy();
            EXPECT_GT(energy.drag, 0.02 * energy.kinetic_0);
            EXPECT_GT(std::fabs(energy.carried), 1.5e-3 * energy.kinetic_0);
            EXPECT_NEAR(energy.residual(), 0.0, 1e-3 * energy.kinetic_0);
        }
}

// Through a column, from a side to a surface.
TEST(WaterMass, IsKeptWhereItComesInAndLeaves) {
    for (const bool implicit : {false, true}) {
        const SaturatedColumn column{.cells = 8, .conductivity = 1e-3, .implicit = implicit};
        Case plan = column.plan();
        plan.inflows = {{.side = Side::bottom, .speed = TimeTable{{0.0, 0.2}, {0.0, 1e-3}}}};
        BuiltCase built = build_case(plan);
        expect_kept(*built.simulation, 0, 500);
    }
}

// Of a cell all particles lose as much of their volume: one by one a steady flow would empty some and fill others.
TEST(WaterMass, LeavesTheParticlesOfACellAlike) {
    PressedSand problem;
    problem.water = PressedSand::soft_water(true, false);
    const auto simulation = problem.build();
    Particles& q = simulation->body(1).particles;
    const int content = simulation->body(1).water->content_column();
    for (int i = 0; i < 100; ++i) simulation->step();
    const GridView grid{simulation->axis_r().view(), simulation->axis_z().view()};
    struct Before {
        int id, cell;
        double volume, content;
    };
    std::vector<Before> before;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        before.push_back({q.ids()[p],
                          static_cast<int>(grid.cell_of(q(column::r, p), q(column::z, p))),
                          q(column::V0, p) * q.view().J(p), q(content, p)});
    simulation->step();
    std::map<int, std::vector<double>> lost;
    double most = 0.0;
    for (const Before& b : before) {
        const double share = (b.content - q(content, simulation->find(1, b.id))) / b.volume;
        lost[b.cell].push_back(share);
        most = std::max(most, std::fabs(share));
    }
    EXPECT_GT(most, 0.0);
    int shared = 0;
    for (const auto& [cell, of] : lost) {
        shared += of.size() > 1 ? 1 : 0;
        const auto [least, largest] = std::minmax_element(of.begin(), of.end());
        EXPECT_NEAR(*least, *largest, 1e-6 * most) << cell;
    }
    EXPECT_GT(shared, 10);
}

// In a closed box to the last digits, whatever swings in it, and particles at its rim are 60 000 times as large as at its axis.
TEST(WaterMass, IsThatOfTheStartInAClosedBox) {
    for (const bool graded : {false, true})
        for (const bool implicit : {false, true}) {
            SCOPED_TRACE(testing::Message() << graded << implicit);
            const SaturatedColumn column{.cells = 16,
                                         .conductivity = 1e-3,
                                         .axisymmetric = graded,
                                         .closed = true,
                                         .implicit = implicit};
            Case plan = column.plan();
            if (graded) {
                plan.r = {0.0, {{1.0, 8, 2.0}}};
                plan.bodies[0].outlines = {Outline{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
            }
            BuiltCase built = build_case(plan);
            Simulation& simulation = *built.simulation;
            namespace c = grit::mpm::column;
            const ParticleView q = simulation.body(0).particles.view();
            double least = 1.0, most = 0.0;
            for (std::ptrdiff_t p = 0; p < simulation.body(0).particles.size(); ++p) {
                q[c::v_z][p] = 0.01 * std::sin(3.0 * q[c::z][p]);
                if (graded) q[c::v_r][p] = 0.01 * std::sin(100.0 * q[c::r][p]);
                least = std::min(least, q[c::V0][p]);
                most = std::max(most, q[c::V0][p]);
            }
            EXPECT_GT(most, graded ? 6e4 * least : 0.99 * least);
            const double start = water_mass(simulation);
            expect_kept(simulation, 0, 1000, 1e-14, 0.0);
            if (!graded) {
                EXPECT_NEAR(water_mass(simulation), start, 1e-13 * start);
            }
        }
}

}  // namespace
