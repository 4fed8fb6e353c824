// SPDX-License-Identifier: BSD-3-Clause
// Sand whose pores are full of water (W1-W4).
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <sstream>
#include <string>
#include <utility>

#include <adapters/mpm/case/initial_state.hpp>
#include <adapters/mpm/run/measures.hpp>
#include <adapters/mpm/run/run.hpp>
#include <grit/sand_operators.h>

#include "support/goes_on.hpp"
#include "support/lausitz.hpp"
#include "support/one_particle.hpp"
#include "support/plans.hpp"
#include "support/pressed_column.hpp"
#include "support/saturated_column.hpp"
#include "support/saturated_disk.hpp"
#include "support/wet_cell.hpp"

namespace {

using namespace mpm_test;

using Column = SaturatedColumn;

TEST(UndrainedSand, CarriesWavesAtTheSpeedOfSkeletonAndWater) {
    for (const bool axisymmetric : {false, true}) {
        const Wave wave = standing_wave({.cells = 64, .axisymmetric = axisymmetric}, 1.0);
        EXPECT_NEAR(wave.speed, 1664.0, 0.005 * 1664.0);
        EXPECT_NEAR(wave.residual, 0.0, 1e-3);
        EXPECT_NEAR(wave.dt, 0.4 * Column::height / 64 / Column::c_u(), 1e-3 * wave.dt);
    }
}

// ... of skeleton and water together, from the first step on.
TEST(SaturatedSand, TakesTheStepThatItsWavesAllow) {
    for (const double k : {0.0, 1e-3}) {
        BuiltCase built = build_case(Column{.cells = 16, .conductivity = k}.plan());
        const double c = k > 0.0 ? std::sqrt(Column::sum()) : Column::c_u();
        const double step = 0.4 * Column::height / 16 / c;
        built.simulation->step();
        EXPECT_NEAR(built.simulation->time(), step, 1e-9 * step) << k;
        EXPECT_NEAR(built.simulation->next_step(), step, 1e-9 * step) << k;
    }
}

TEST(FlowingWater, CarriesTwoWavesWhereNothingDragsIt) {
    for (const double c : {Column::c_1(), Column::c_2()}) {
        const double ratio =
            Column::K_w * (1.0 - Column::n) / Column::n / (c * c * Column::rho_w - Column::K_w);
        const Wave wave = standing_wave({.cells = 64, .conductivity = 1e5}, ratio);
        EXPECT_NEAR(wave.speed, c, 0.005 * c);
        EXPECT_NEAR(wave.residual, 0.0, 1e-3);
    }
    EXPECT_NEAR(Column::c_1(), 1857.0, 0.5);
    EXPECT_NEAR(Column::c_2(), 63.35, 0.005);
}

TEST(FlowingWater, IsUndrainedWhereDragHoldsIt) {
    for (const double k : {1e-7, 1e-9}) {
        const Wave wave = standing_wave({.cells = 64, .conductivity = k}, 1.0);
        EXPECT_NEAR(wave.speed, Column::c_u(), 0.005 * Column::c_u());
    }
}

TEST(FlowingWater, TakesTheSameStepWhateverItsConductivity) {
    const auto step = [](double conductivity) {
        Column column{.cells = 16, .conductivity = conductivity, .load = 1e4, .ramp = 1e-3};
        BuiltCase built = build_case(column.plan());
        for (int i = 0; i < 2000; ++i) built.simulation->step();
        EXPECT_LT(built.simulation->energy().kinetic, 1.0);
        return built.simulation->next_step();
    };
    const double coarse = step(1e-2);
    for (const double k : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
        EXPECT_NEAR(step(k), coarse, 1e-3 * coarse) << k;
}

TEST(FlowingWater, ConsolidatesAsTerzaghiSays) {
    for (const Consolidation& now :
         consolidate({.cells = 16, .conductivity = 1e-3}, {0.1, 0.2, 0.5})) {
        EXPECT_NEAR(now.pressure, now.exact_pressure, 0.005 * now.exact_pressure) << now.T;
        EXPECT_NEAR(now.settlement, now.exact_settlement, 0.005 * now.exact_settlement) << now.T;
        EXPECT_LT(now.alternating, 0.001);
        EXPECT_NEAR(now.residual, 0.0, 1e-3);
    }
}

TEST(FlowingWater, LeavesByADrainedSideThatHoldsTheGrains) {
    for (const Consolidation& now :
         consolidate({.cells = 32, .conductivity = 2e-4, .drained_bottom = true}, {0.2})) {
        EXPECT_NEAR(now.pressure, now.exact_pressure, 0.005 * now.exact_pressure) << now.T;
        EXPECT_NEAR(now.settlement, now.exact_settlement, 0.005 * now.exact_settlement) << now.T;
        EXPECT_NEAR(now.residual, 0.0, 1e-3);
    }
}

// Its pressure rises by 18 % before it falls.
TEST(FlowingWater, LeavesADiskAsDeLeeuwSays) {
    for (const SaturatedDisk::Result& now : SaturatedDisk{}.run({0.05, 0.1, 0.2})) {
        EXPECT_NEAR(now.pressure, now.exact, 0.007 * now.exact) << now.T;
        EXPECT_NEAR(now.residual, 0.0, 1e-3);
    }
}

class UnderAPiston : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Pressure, UnderAPiston, testing::Bool(), [](const auto& of) {
    return std::string(of.param ? "Implicit" : "Explicit");
});

TEST_P(UnderAPiston, WaterPressesBesideTheEffectiveStress) {
    for (const double k : {1e-3, 1e-6}) {
        const Column column{.conductivity = k, .implicit = GetParam()};
        Runner runner(under_a_piston(column));
        Simulation& simulation = runner.simulation();
        double borne = 0.0, p_w = 0.0;
        int count = 0;
        while (simulation.time() < 0.04) {
            runner.step();
            if (simulation.time() < 0.03) continue;
            borne -=
                (simulation.pore_faces(0).along_z[1] + simulation.contact(0).faces().along_z[1]) /
                column.cell();
            p_w += pore_pressures(simulation, column.cells)[8];
            ++count;
        }
        // The node below the piston is its own as well: one cell moves with it.
        const double strain = 15e-6 / (column.height - column.cell());
        EXPECT_NEAR(p_w / count, Column::K_w / Column::n * strain, 0.005 * p_w / count);
        const double expected = p_w / count + Column::E * strain;
        EXPECT_NEAR(borne / count, expected, 0.001 * expected);
        EXPECT_NEAR(simulation.energy().residual(), 0.0, 1e-3 * simulation.energy().rigid_work);
        EXPECT_NEAR(contact_forces(simulation, 1).tip[1],
                    -simulation.pore_faces(0).along_z[1] - simulation.contact(0).faces().along_z[1],
                    1e-9 * p_w / count);
    }
}

// Of an approach w a step leaves (1 - f) w, in whatever part the pressure comes of a solution: at a node of mass m half a cell in front
// of a piston that comes at v for long, sand at rest, v = (1 - f)(v + P dt/m), f = 1 - 0.5^(dt/tau).
TEST_P(UnderAPiston, GivesWayAsTheGeoContactLetsIt) {
    constexpr double v = 1e-3, tau = 1e-4, from = 0.02, until = 0.03;
    for (const double k : {0.0, 1e-6, 1e-3}) {
        const Column column{.conductivity = k, .implicit = GetParam()};
        const double h = column.cell();
        Case plan = under_a_piston(column, false, {{0.0, 0.005}, {0.0, -v}});
        make_geo(plan.contacts[0], 1.0);
        plan.contacts[0].relaxation_time = tau;
        for (auto& corner : plan.bodies[1].outlines[0].corners) corner[1] += 0.5 * h;
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        double borne = 0.0, dt = 0.0;
        while (simulation.time() < until) {
            const double t = simulation.time();
            simulation.step();
            dt = simulation.time() - t;
            if (t < from) continue;
            borne -=
                (simulation.pore_faces(0).along_z[1] + simulation.contact(0).faces().along_z[1]) *
                dt / h / (until - from);
        }
        // The piston has come nearer by v t, the sand has hardly moved.
        const double s = 0.5 - (0.5 * (from + until) - 0.0025) * v / h;
        const double expected = 0.5 * h * Column::rho * v * (std::pow(s, -dt / tau) - 1.0) / dt;
        EXPECT_NEAR(borne, expected, 0.01 * expected) << k;
        EXPECT_EQ(dt > 5e-5, GetParam());
    }
}

// Two of them beside each other at the same nodes, the first nine tenths of a cell in front of these: the one that takes all is what holds.
TEST_P(UnderAPiston, IsHeldByTheContactThatTakesMost) {
    const Column column{.cells = 16, .implicit = GetParam()};
    const double h = column.cell();
    for (const bool far_first : {false, true}) {
        Case plan = under_a_piston(column);
        BodyPlan& near = plan.bodies[1];
        BodyPlan far = near;
        far.name = "far";
        for (auto& corner : far.outlines[0].corners)
            corner = {0.5 * corner[0], corner[1] + 0.9 * h};
        for (auto& corner : near.outlines[0].corners) corner[0] = 0.5 * (h + corner[0]);
        plan.bodies.push_back(far);
        plan.contacts.push_back(contact_with("far", "sand", false));
        for (ContactPlan& contact : plan.contacts) make_geo(contact, 1.0);
        if (far_first) std::swap(plan.contacts[0], plan.contacts[1]);
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        double p_w = 0.0, time = 0.0;
        while (simulation.time() < 0.04) {
            const double t = simulation.time();
            simulation.step();
            if (t < 0.03) continue;
            p_w += pore_pressures(simulation, column.cells)[8] * (simulation.time() - t);
            time += simulation.time() - t;
        }
        // The nodes below are a cell away: f = 0.
        const double expected = Column::K_w / Column::n * 15e-6 / column.height;
        EXPECT_NEAR(p_w / time, expected, 0.002 * expected) << far_first;
    }
}

TEST(PoreWater, DoesNotRub) {
    const double dry = rubbing_force({});
    EXPECT_NEAR(dry, 0.3 * 10e6 * 2e-4 / (0.5 - 0.125), 0.02 * dry);  // a cell moves with the plate
    for (const auto& [drainage, k] : {std::pair{Drainage::undrained, 0.0},
                                      {Drainage::flow, 1e-9},
                                      {Drainage::flow, 1e-5},
                                      {Drainage::flow, 1e-3}}) {
        WaterPlan water;
        water.drainage = drainage;
        water.conductivity = k;
        EXPECT_NEAR(rubbing_force(water), dry, 0.04 * dry) << k;
    }
}

// Mean pore pressure of a body in its cells beside the surface at 0.5 m, where the other one may be [Pa].
double pressure_at_the_plate(Simulation& simulation, std::size_t which) {
    Body& body = simulation.body(which);
    const ParticleView q = body.particles.view();
    double sum = 0.0, count = 0.0;
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        if (q[column::z][p] < 0.375 || std::fabs(q[column::r][p] - 0.5) > 0.25) continue;
        sum += body.water->pressure(q, p);
        count += 1.0;
    }
    return sum / count;
}

// Where both are wet it is the mean of both that bears. Normals are those of the block: the plate's corners would plough.
TEST(PoreWater, OfBothBodiesDoesNotRub) {
    constexpr double load = 1e4, L = 1.0, width = 0.5 * L;
    WaterPlan water;
    water.drainage = Drainage::undrained;
    Case plan = plate_on_a_block(water);
    BodyPlan &plate = plan.bodies[1], &block = plan.bodies[0];
    plate.outlines = {Outline{
        {{0.25 * L, 0.5 * L}, {0.75 * L, 0.5 * L}, {0.75 * L, 0.625 * L}, {0.25 * L, 0.625 * L}}}};
    plate.material = block.material;
    plate.water = block.water;
    plate.density = block.density;
    plan.contacts[0].normal = GRIT_CONTACT_NORMAL_OF_B;
    const auto traction = [&](const grit::Vector2& direction, double from, double most) {
        plan.tractions.push_back({.body = "plate",
                                  .edge = Edge::top,
                                  .direction = direction,
                                  .stress = TimeTable{{from, from + 0.1}, {0.0, most}}});
    };
    traction({0.0, -1.0}, 0.0, load);
    traction({1.0, 0.0}, 0.1, 0.28 * load);
    BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    double force = 0.0, borne = 0.0;
    int count = 0;
    while (simulation.time() < 0.23) {
        simulation.step();
        if (simulation.time() < 0.2) continue;
        const ContactForces forces = contact_forces(simulation, 1);
        force -= forces.tip[0] + forces.shaft[0];
        borne += 0.5 * width *
                 (pressure_at_the_plate(simulation, 0) + pressure_at_the_plate(simulation, 1));
        ++count;
    }
    EXPECT_GT(borne / count, 0.3 * load * width);
    const double expected = 0.3 * (load * width - borne / count);
    EXPECT_NEAR(force / count, expected, 0.03 * expected);
}

TEST_P(UnderAPiston, GoesOnFromACheckpointBitForBit) {
    const Case plan = under_a_piston({.cells = 16, .conductivity = 1e-4, .implicit = GetParam()});
    Runner all(plan), first(plan), second(plan);
    for (int i = 0; i < 300; ++i) all.step();
    for (int i = 0; i < 150; ++i) first.step();
    second.resume(first.state());
    std::ostringstream out;
    save(first.simulation(), out);
    std::istringstream in(out.str());
    restore(second.simulation(), in);
    EXPECT_EQ(contact_forces(second.simulation(), 1).tip[1],
              contact_forces(first.simulation(), 1).tip[1]);
    EXPECT_EQ(first.simulation().pore_faces(0).along_z[1] != 0.0, GetParam());
    for (int i = 0; i < 150; ++i) second.step();
    std::ostringstream ours, theirs;
    save(second.simulation(), ours);
    save(all.simulation(), theirs);
    EXPECT_TRUE(ours.str() == theirs.str());
}

TEST(FlowingWater, IsConductedAsKozenyAndCarmanSay) {
    PoreWater water{.flows = true, .conductivity = 1e-4};
    EXPECT_EQ(water.conductivity_of(0.9), 1e-4);
    water.conductivity_at = 0.6;
    EXPECT_EQ(water.conductivity_of(0.6), 1e-4);
    EXPECT_NEAR(water.conductivity_of(0.9), 1e-4 * (0.729 / 1.9) / (0.216 / 1.6), 1e-16);
    // n² ρ g/k
    EXPECT_NEAR(water.drag(0.6), 0.375 * 0.375 * 9810.0 / 1e-4, 1e-4);
}

// Over a whole number of periods, after a load that comes slowly.
TEST(UndrainedSand, SharesALoadWithItsWater) {
    constexpr double load = 1e4, ramp = 0.02;
    Column column{.load = load, .ramp = ramp};
    BuiltCase built = build_case(column.plan());
    Simulation& simulation = *built.simulation;
    while (simulation.time() < ramp) simulation.step();
    double sum = 0.0;
    int count = 0;
    while (simulation.time() < ramp + 0.01) {
        simulation.step();
        for (const double p : pore_pressures(simulation, column.cells)) sum += p;
        count += column.cells;
    }
    EXPECT_NEAR(sum / count, Column::p_0(load), 0.005 * Column::p_0(load));
}

TEST(SaturatedColumn, UnderItsWaterTableStaysAtRest) {
    for (const double k : {0.0, 1e-3, 1e-6})
        for (const bool axisymmetric : {false, true}) {
            Column column{.conductivity = k, .axisymmetric = axisymmetric, .gravity = 9.81};
            const Case plan = column.plan();
            BuiltCase built = build_case(plan);
            apply_stage(plan, plan.stages[0], *built.simulation);
            Simulation& simulation = *built.simulation;
            for (int i = 0; i < 2000; ++i) simulation.step();
            const std::vector<double> p = pore_pressures(simulation, column.cells);
            for (int i = 0; i < column.cells; ++i)
                EXPECT_NEAR(p[static_cast<std::size_t>(i)],
                            Column::rho_w * 9.81 * (1.0 - (i + 0.5) / column.cells), 0.01);
            const Particles& q = simulation.body(0).particles;
            for (std::ptrdiff_t i = 0; i < q.size(); ++i)
                EXPECT_NEAR(q(column::S_zz, i),
                            -(Column::rho - Column::rho_w) * 9.81 * (1.0 - q(column::z, i)), 1.0);
            EXPECT_LT(simulation.energy().kinetic, 1e-15);
        }
}

TEST(UndrainedSand, DoesNotLockInAThickCylinder) {
    for (const bool implicit : {false, true}) {
        const SaturatedCylinder cylinder = inflate_saturated_cylinder(implicit);
        EXPECT_NEAR(cylinder.widening, 1.0, 0.003);
        EXPECT_LT(cylinder.pressure_error, 0.002);
    }
}

TEST(ImplicitPressure, TakesTheStepOfTheGrainsWithTheResultOfTheExplicitOne) {
    constexpr double load = 1e4;
    for (const double k : {0.0, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
        Column column{.cells = 16, .conductivity = k, .load = load, .ramp = 0.02};
        const Loaded in_short_steps = after_a_load(column);
        column.implicit = true;
        const Loaded now = after_a_load(column);
        EXPECT_GT(now.dt, 20.0 * in_short_steps.dt) << k;
        EXPECT_LT(now.alternating, 0.01 * load) << k;
        EXPECT_NEAR(now.residual, 0.0, 5e-4) << k;
        // The explicit one still swings by 2 %.
        if (k < 1e-3) EXPECT_NEAR(now.lowest_cell, Column::p_0(load), 1e-3 * load) << k;
        else EXPECT_NEAR(now.lowest_cell, in_short_steps.lowest_cell, 0.01 * load) << k;
        EXPECT_NEAR(now.settlement, in_short_steps.settlement,
                    0.01 * load * column.height / Column::E)
            << k;
    }
}

TEST(ImplicitPressure, ConsolidatesAsTerzaghiSays) {
    for (const Consolidation& now :
         consolidate({.cells = 32, .conductivity = 1e-3, .implicit = true}, {0.1, 0.2, 0.5, 1.0})) {
        EXPECT_NEAR(now.pressure, now.exact_pressure, 0.005 * now.exact_pressure) << now.T;
        EXPECT_NEAR(now.settlement, now.exact_settlement, 0.005 * now.exact_settlement) << now.T;
        EXPECT_LT(now.alternating, 0.001);
        EXPECT_NEAR(now.residual, 0.0, 1e-3);
    }
}

// In a block that stands still there is nothing to be found: what is left is judged by the pressures that are there.
TEST(ImplicitPressure, IsNotSoughtInRoundoff) {
    constexpr int cells = 64, steps = 20;
    const Column column{.cells = cells, .conductivity = 0.0, .implicit = true, .gravity = 9.81};
    Case plan = column.plan();
    plan.r = {0.0, {{column.height, cells, 1.0}}};
    plan.bodies[0].outlines[0].corners = {
        {0.0, 0.0}, {column.height, 0.0}, {column.height, column.height}, {0.0, column.height}};
    BuiltCase built = build_case(plan);
    apply_stage(plan, plan.stages[0], *built.simulation);
    for (int i = 0; i < steps; ++i) built.simulation->step();
    EXPECT_LT(built.simulation->pore_water().iterations(0), 20 * steps);
}

// Each step begins with what the two before lead to: a consolidation needs little more than that.
TEST(ImplicitPressure, GoesOnFromTheStepsBefore) {
    constexpr int steps = 200;
    const Column column{
        .cells = 32, .conductivity = 1e-3, .implicit = true, .load = 1e4, .ramp = 0.02};
    BuiltCase built = build_case(column.plan());
    for (int i = 0; i < steps; ++i) built.simulation->step();
    const long begun = built.simulation->pore_water().iterations(0);
    for (int i = 0; i < steps; ++i) built.simulation->step();
    EXPECT_LT(built.simulation->pore_water().iterations(0) - begun, 20 * steps);  // 32 from nothing
}

// Damping comes before the pressure, or it would take the volume's balance away again.
TEST(ImplicitPressure, IsStableWithLocalDamping) {
    constexpr double load = 1e4;
    for (const double k : {0.0, 1e-5, 1e-3})
        for (const double damping : {0.3, 0.5, 0.7}) {
            const Column column{.cells = 16,
                                .conductivity = k,
                                .implicit = true,
                                .load = load,
                                .ramp = 0.02,
                                .damping = damping};
            const Loaded now = after_a_load(column);
            EXPECT_LT(now.largest_pressure, 1.01 * load) << k << ", " << damping;
            EXPECT_NEAR(now.residual, 0.0, 1e-4) << k << ", " << damping;
        }
}

TEST(FlowingWater, KeepsTheBalanceOfEnergyWithLocalDamping) {
    for (const double k : {1e-3, 1e-5, 1e-6, 1e-7}) {
        const Column column{
            .cells = 16, .conductivity = k, .load = 1e4, .ramp = 0.02, .damping = 0.7};
        EXPECT_NEAR(after_a_load(column).residual, 0.0, 2e-4) << k;
    }
}

// In steps as short as the explicit ones it carries waves at their speed, and takes from them what it tells.
// Where nothing flows, what the PIC share takes is no loss to drag.
TEST(FlowingWater, LosesToDragWhatDragTakes) {
    Case plan = Column{.cells = 16, .conductivity = 1e-9, .load = 1e4}.plan();
    plan.settings.pic_rate = 1e4;
    BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    while (simulation.time() < 0.01) simulation.step();
    const Energy energy = simulation.energy();
    EXPECT_GT(energy.pic, 0.01 * energy.external_work);
    EXPECT_NEAR(energy.drag, 0.0, 0.01 * energy.pic);
    EXPECT_NEAR(energy.transfer, energy.pic, 0.25 * energy.pic);
    EXPECT_NEAR(energy.residual(), 0.0, 1e-3 * energy.external_work);
}

// What meets at a node moves alike across, in a frictional contact the body's own, too: water of the other one as its grains, though
// nothing drags it there.
TEST(ImplicitPressure, MovesTheWaterOfWhatItPressesOn) {
    WaterPlan free;
    free.drainage = Drainage::flow;
    free.conductivity = 10.0;
    free.porosity = 0.4;
    free.grain_density = 2650.0;
    for (const double power : {0.0, 2.0}) {
        BuiltCase built = hit_by_a_block({.cells = 16, .conductivity = 0.0, .implicit = true},
                                         false, free, power);
        Simulation& simulation = *built.simulation;
        const double before = momentum_z(simulation, 0) + momentum_z(simulation, 1);
        simulation.step();
        double grains = 0.0, seepage = 0.0;
        const Body& block = simulation.body(1);
        const ParticleView q = simulation.body(1).particles.view();
        for (std::ptrdiff_t p = 0; p < block.particles.size(); ++p) {
            grains = std::max(grains, std::fabs(q[column::v_z][p] + 0.1));
            seepage = std::max(seepage, std::fabs(q[block.water->velocity_column() + 1][p]));
        }
        EXPECT_GT(grains, 1e-3) << power;
        EXPECT_LT(seepage, 1e-12 * grains) << power;
        EXPECT_NEAR(momentum_z(simulation, 0) + momentum_z(simulation, 1), before, 1e-3 * -before);
    }
}

TEST(ImplicitPressure, CarriesWavesInShortSteps) {
    const double share = std::sqrt(Column::E / Column::rho) / Column::c_u();
    const Wave wave = standing_wave({.cells = 64, .cfl = 0.1 * share, .implicit = true}, 1.0);
    EXPECT_NEAR(wave.speed, Column::c_u(), 0.005 * Column::c_u());
    EXPECT_NEAR(wave.residual, 0.0, 1e-3);
}

// A dry block hits a saturated one, both free: across nodes that they share the pressure moves both.
TEST(ImplicitPressure, KeepsMomentumAndEnergyWhereBodiesMeet) {
    for (const auto& [k, power] : {std::pair{0.0, 0.0}, {1e-4, 0.0}, {0.0, 2.0}, {1e-4, 2.0}}) {
        BuiltCase built =
            hit_by_a_block({.cells = 16, .conductivity = k, .implicit = true}, false, {}, power);
        Simulation& simulation = *built.simulation;
        const auto momentum = [&](std::size_t body) { return momentum_z(simulation, body); };
        const double before = momentum(0) + momentum(1);
        while (simulation.time() < 0.004) simulation.step();
        SCOPED_TRACE(std::to_string(k) + ", power " + std::to_string(power));
        EXPECT_GT(std::fabs(momentum(0)), 0.1 * std::fabs(before));
        EXPECT_NE(simulation.pore_faces(0).along_z[1], 0.0);
        // What water weighs in a particle is that of the moment.
        EXPECT_NEAR(momentum(0) + momentum(1), before, (k > 0.0 ? 1e-3 : 1e-12) * -before);
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 0.01 * energy.kinetic_0);
        EXPECT_GT(energy.implicit, 0.0);
    }
}

// Pulled by twice what the water bears, and let go: where a cavity closes the water hits.
TEST(ImplicitPressure, CavitatesAndBearsAgainOnceTheCavityHasClosed) {
    for (const double k : {0.0, 1e-6}) {
        double hit[2];
        for (const bool implicit : {false, true}) {
            Column column{.cells = 16, .conductivity = k, .implicit = implicit, .load = 1.0};
            Case plan = column.plan();
            plan.tractions[0].stress = TimeTable{{0.0, 0.02, 0.04, 0.06}, {0.0, -2e5, -2e5, 1e5}};
            BuiltCase built = build_case(plan);
            Simulation& simulation = *built.simulation;
            while (simulation.time() < 0.04) simulation.step();
            for (const double p : pore_pressures(simulation, column.cells)) EXPECT_GE(p, -1e5);
            EXPECT_LT(pore_pressures(simulation, column.cells)[0], -0.99e5);
            double largest = 0.0;
            while (simulation.time() < 0.2) {
                simulation.step();
                for (const double p : pore_pressures(simulation, column.cells))
                    largest = std::max(largest, p);
            }
            hit[implicit ? 1 : 0] = largest;
            const Energy energy = simulation.energy();
            EXPECT_NEAR(energy.residual(), 0.0, 5e-3 * energy.external_work) << k;
            if (!implicit) continue;  // the explicit one still swings
            EXPECT_NEAR(pore_pressures(simulation, column.cells)[0], 1e5, 0.02e5) << k;
        }
        EXPECT_GT(hit[1], 1e6) << k;
        EXPECT_LT(hit[1], hit[0]) << k;
    }
}

// Sand that is looser at the top: its effective stress is the buoyant weight of what lies above.
TEST(SaturatedSand, StartsWithItsBuoyantWeight) {
    Case plan = column_case();
    BodyPlan& body = plan.bodies[0];
    SandPlan sand = lausitz_plan(0.75);
    sand.at_zero_pressure = true;
    body.material = sand;
    body.geostatic = Geostatic{.surface = 1.0, .surcharge = 1000.0};
    body.water = WaterPlan{.grain_density = 2650.0, .table = 1.0};
    plan.tractions = {{.body = "column", .edge = Edge::top, .stress = TimeTable{{0.0}, {1000.0}}}};
    BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    const Particles& q = simulation.body(0).particles;
    // Sums over the particles above, row by row from the top.
    double weight = 0.0;
    int row = 0;
    for (int j = 39; j >= 0; --j, ++row) {
        const std::ptrdiff_t p = simulation.find(0, 8 * j);
        const double e = q(Sand::state + GRIT_SAND_VOID_RATIO, p);
        const double density = (2650.0 + e * 1000.0) / (1.0 + e);
        EXPECT_NEAR(q(column::mass, p), density * q(column::V0, p), 1e-12 * q(column::mass, p));
        const double half = 0.5 * (density - 1000.0) * 9.81 * 2.0 * q(column::l_z, p);
        weight += half;
        EXPECT_NEAR(q(column::S_zz, p), -(1000.0 + weight), 0.5);
        weight += half;
    }
    EXPECT_EQ(row, 40);
    apply_stage(plan, plan.stages[0], simulation);
    for (int i = 0; i < 500; ++i) simulation.step();
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        EXPECT_NEAR(q(Sand::work + 1, p), 1000.0 * 9.81 * (1.0 - q(column::z, p)), 20.0);
}

// Weight of grains and water above, less what the water bears there: no more than its tension where it has cavitated,
// nothing without a table; and free water above the surface presses on it.
TEST(SaturatedSand, StartsInBalanceWhereverItsTableIs) {
    struct Start {
        std::optional<double> table;
        double largest_tension;
    };
    for (const auto& [table, tension] : {Start{0.4, 1e5}, Start{0.4, 2e3}, Start{0.4, 0.0},
                                         Start{std::nullopt, 1e5}, Start{1.5, 1e5}}) {
        Case plan = column_case();
        BodyPlan& body = plan.bodies[0];
        body.material = lausitz_plan(0.75);
        body.geostatic = Geostatic{.surface = 1.0, .surcharge = 1000.0};
        body.water = WaterPlan{.grain_density = 2650.0, .table = table};
        body.water->largest_tension = tension;
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        Particles& q = simulation.body(0).particles;
        const double above = table && *table > 1.0 ? 1000.0 * 9.81 * (*table - 1.0) : 0.0;
        const double unit_weight = (2650.0 + 0.75 * 1000.0) / 1.75 * 9.81;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            const double borne = simulation.body(0).water->pressure(q.view(), p);
            const double whole = 1000.0 + above + unit_weight * (1.0 - q(column::z, p));
            EXPECT_NEAR(borne - q(column::S_zz, p), whole, 0.5) << table.value_or(-1.0) << tension;
        }
    }
}

// Pores that are open as far as they go: the water that is cavitated in them bears again where they close, whatever its cell
// has opened by in between.
TEST(PoreWater, BearsAgainWhereItsPoresCloseFromTheCap) {
    PoreWater water;
    water.void_ratio_column = column::own;
    water.opening_cap = 1.2;
    water.first = column::own + 1;
    water.largest_tension = 1e3;
    Particles particles(2);
    particles.add({0.5, 0.5, 0.5, 0.5, 1.0}, false);
    const ParticleView q = particles.view();
    constexpr std::int64_t volume = std::int64_t{1} << 40;
    WaterSums sums;
    const auto open = [&](double e, double strain) {
        WaterCell cell{};
        cell.volume = volume;
        cell.weighted = static_cast<std::int64_t>(std::ldexp(strain, 40));
        const WaterPlace place{1.0, e, 0};
        update_pressures(q, 0, 1, water, &cell, &place, 1.0, nullptr, false, sums);
        return q[water.first][0];
    };
    q[water.first][0] = 0.0;
    const double at_cap = open(1.1, 0.01);
    EXPECT_LT(at_cap, -water.largest_tension);
    EXPECT_EQ(open(1.2, 0.5), at_cap);
    EXPECT_EQ(open(1.3, 0.5), at_cap);
    EXPECT_GT(open(1.2, -0.02), 0.0);                  // closes
    EXPECT_LT(open(1.2, 1e-7), open(1.1, 0.0) + 1.0);  // what bears opens
    EXPECT_GT(open(1.1, -1e-3), open(1.1, 1e-3));
    // Nor does what other particles of the cell bear, half of which those take that are not open.
    const ImplicitCell implicit{0.0, 500.0, water.stiffness(1.1), 0.5};
    const auto beside = [&](double e) {
        WaterCell cell{};
        cell.volume = volume;
        const WaterPlace place{1.0, e, 0};
        q[water.first][0] = at_cap;
        update_pressures(q, 0, 1, water, &cell, &place, 1.0, &implicit, false, sums);
        return q[water.first][0];
    };
    EXPECT_EQ(beside(1.2), at_cap);
    EXPECT_EQ(beside(1.1), at_cap + 0.5 * (implicit.pressure + water.largest_tension));
}

// Between particles of unlike pores, one of which has a cavity: what flows from one to the other is neither made nor lost.
TEST(PoreWater, OfACellComesTogetherWithoutLoss) {
    PoreWater water;
    water.void_ratio_column = column::own;
    water.first = column::own + 1;
    water.largest_tension = 1e3;
    constexpr double e[] = {0.6, 0.8, 1.1}, V[] = {1.0, 2.0, 0.5}, p_w[] = {5e3, -2e2, -9e3};
    Particles particles(2);
    WaterPlace places[3];
    ImplicitCell cell{.stiffness = 0.0, .together = 0.5};
    for (int p = 0; p < 3; ++p) {
        particles.add({0.5, 0.5, 0.5, 0.5, V[p]}, false);
        places[p] = {V[p], e[p], 0};
        cell.pressure += V[p] / 3.5 * std::max(p_w[p], -water.largest_tension);
        cell.stiffness += V[p] / 3.5 * water.stiffness(e[p]);
    }
    const ParticleView q = particles.view();
    for (int p = 0; p < 3; ++p) q[water.first][p] = p_w[p];
    WaterCell still{};
    still.volume = std::int64_t{1} << 40;
    WaterSums sums;
    update_pressures(q, 0, 3, water, &still, places, 1.0, &cell, false, sums);
    double gone = 0.0, size = 0.0;
    for (int p = 0; p < 3; ++p) {
        const double compressed = V[p] * (q[water.first][p] - p_w[p]) / water.stiffness(e[p]);
        gone += compressed;
        size += std::fabs(compressed);
    }
    EXPECT_NEAR(gone, 0.0, 1e-14 * size);
    EXPECT_LT(q[water.first][0], p_w[0]);
    EXPECT_GT(q[water.first][2], p_w[2]);
}

// Whatever the porosity does: under a hydrostatic pressure water stays where it is, and under an even one all do.
TEST(FlowingWater, StaysAtRestInSandOfUnevenPorosity) {
    for (const double gravity : {0.0, 9.81}) {
        Case plan = column_case();
        plan.gravity = gravity;
        plan.z = {0.0, {{1.0, 20, 1.0}}};
        plan.boundary[static_cast<int>(Side::top)] = Boundary::roller;
        BodyPlan& body = plan.bodies[0];
        body.material = lausitz_plan(0.75);
        body.water =
            WaterPlan{.drainage = Drainage::flow, .grain_density = 2650.0, .conductivity = 1e-3};
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        apply_stage(plan, plan.stages[0], simulation);
        const PoreWater& water = *simulation.body(0).water;
        const ParticleView q = simulation.body(0).particles.view();
        const std::ptrdiff_t count = simulation.body(0).particles.size();
        double above = 1e5;  // effective stress at the top of a row
        for (std::ptrdiff_t p = count - 1; p >= 0; --p) {
            const double z = q[column::z][p];
            double& e = q[Sand::state + GRIT_SAND_VOID_RATIO][p];
            e = 0.6 + 0.3 * z * (gravity > 0.0 ? 1.0 : q[column::r][p] / 0.2);
            q[column::mass][p] = 2650.0 / (1.0 + e) * q[column::V0][p];
            const double half = 1650.0 / (1.0 + e) * gravity * q[column::l_z][p];
            for (const int c : {column::S_rr, column::S_zz, column::S_tt})
                q[c][p] = -(above + half);
            if (p % 8 == 0) above += 2.0 * half;  // eight particles a row
            q[water.first][p] = 1e6 + 1000.0 * gravity * (1.0 - z);
        }
        for (int i = 0; i < 300; ++i) simulation.step();
        for (std::ptrdiff_t p = 0; p < count; ++p) {
            EXPECT_NEAR(q[water.velocity_column() + 1][p], 0.0, 1e-6);
            if (gravity > 0.0) continue;
            EXPECT_NEAR(q[water.first][p], 1e6, 1e-2);
            EXPECT_NEAR(q[column::v_z][p], 0.0, 1e-9);
        }
    }
}

// Particles of a cell move to and fro, in turn with more and with less water, which goes with them: nothing flows.
TEST(FlowingWater, GoesWithUnlikeGrainsOfACell) {
    Case plan = column_case();
    plan.gravity = 0.0;
    plan.z = {0.0, {{1.0, 20, 1.0}}};
    plan.boundary[static_cast<int>(Side::top)] = Boundary::roller;
    BodyPlan& body = plan.bodies[0];
    body.material = lausitz_plan(0.75);
    body.water =
        WaterPlan{.drainage = Drainage::flow, .grain_density = 2650.0, .conductivity = 1e-9};
    BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    apply_stage(plan, plan.stages[0], simulation);
    const ParticleView q = simulation.body(0).particles.view();
    for (std::ptrdiff_t p = 0; p < simulation.body(0).particles.size(); ++p) {
        double& e = q[Sand::state + GRIT_SAND_VOID_RATIO][p];
        e = p % 2 == 0 ? 0.6 : 0.9;
        q[column::mass][p] = 2650.0 / (1.0 + e) * q[column::V0][p];
        for (const int c : {column::S_rr, column::S_zz, column::S_tt}) q[c][p] = -1e5;
        q[column::v_z][p] = p % 2 == 0 ? 0.01 : -0.01;
    }
    for (int i = 0; i < 200; ++i) simulation.step();
    const Energy energy = simulation.energy();
    EXPECT_NEAR(energy.drag, 0.0, 1e-4 * energy.kinetic_0);
    EXPECT_NEAR(energy.residual(), 0.0, 1e-3 * energy.kinetic_0);
}

// Water that flows to and fro between the particles of a cell, which no node sees.
TEST(FlowingWater, IsDraggedWithinACellToo) {
    Column column{.cells = 16, .conductivity = 1e-6, .closed = true};
    BuiltCase built = build_case(column.plan());
    Simulation& simulation = *built.simulation;
    Body& body = simulation.body(0);
    const ParticleView q = body.particles.view();
    const int w_z = body.water->velocity_column() + 1;
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) q[w_z][p] = p % 2 == 0 ? 0.1 : -0.1;
    for (int i = 0; i < 20; ++i) simulation.step();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) EXPECT_NEAR(q[w_z][p], 0.0, 1e-6);
    const Energy energy = simulation.energy();
    EXPECT_GT(energy.drag, 0.8 * energy.kinetic_0);
    EXPECT_NEAR(energy.residual(), 0.0, 1e-4 * energy.kinetic_0);
}

TEST(InstructionSets, ChangeNoBitOfTheKernelsOfWater) {
    std::mt19937 generator(4);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int sample = 0; sample < 30; ++sample)
        for (const bool axisymmetric : {true, false})
            for (const Shape shape :
                 {Shape::cpdi, Shape::cpdi_published, Shape::ugimp, Shape::point}) {
                const OneParticle q = OneParticle::random(generator, axisymmetric);
                Particles start(4);
                std::vector<double> row;
                for (int c = 0; c < column::own; ++c) row.push_back(q.particles(c, 0));
                for (int c = 0; c < 3; ++c) row.push_back(any(generator));
                row.push_back(1.0 + std::fabs(any(generator)));  // mass of water
                start.add(0, row.data());
                const std::size_t n = q.node_count();
                const GridView grid = q.grid();
                std::vector<NodeMotion> motions[3];
                for (std::vector<NodeMotion>& of : motions) {
                    of.resize(n);
                    for (NodeMotion& m : of)
                        for (double& x : m.value) x = any(generator);
                }
                const PoreWater water{.flows = true,
                                      .largest_tension = 10.0,
                                      .porosity = 0.95,
                                      .conductivity = 1e-3,
                                      .conductivity_at = 0.6,
                                      .first = column::own};
                std::vector<NodeRecord> records[2];
                std::vector<WaterCell> strains[2];
                Particles moved[2] = {start, start};
                const Kernels* sets[2] = {&kernels(), &baseline_kernels};
                for (const std::size_t k : {0u, 1u}) {
                    records[k].assign(n, NodeRecord{});
                    strains[k].resize(n);
                    std::vector<WaterCell> pressures(n);
                    add_pressures(grid, moved[k].view(), 0, 1, water, 1.0, pressures.data());
                    std::vector<NodeRecord> of_grains(n, NodeRecord{});
                    const WaterScatter scattered{&water, pressures.data(), records[k].data()};
                    sets[k]->scatter(shape, axisymmetric,
                                     {.grid = grid,
                                      .particles = moved[k].view(),
                                      .begin = 0,
                                      .end = 1,
                                      .nodes = of_grains.data(),
                                      .parts = part::all,
                                      .water = &scattered});
                    WaterPlace place{};
                    WaterSums sums;
                    const WaterGather gathered{&water,
                                               motions[0].data(),
                                               motions[2].data(),
                                               strains[k].data(),
                                               &place,
                                               1.0,
                                               &sums};
                    Increments increments{};
                    GatherSums of_grains_too;
                    sets[k]->gather(shape, axisymmetric,
                                    {.grid = grid,
                                     .particles = moved[k].view(),
                                     .begin = 0,
                                     .end = 1,
                                     .nodes = motions[1].data(),
                                     .dt = 1e-3,
                                     .pic = 0.1,
                                     .tasks = task::velocity,
                                     .water = &gathered},
                                    increments, of_grains_too);
                }
                EXPECT_EQ(std::memcmp(records[0].data(), records[1].data(), n * sizeof(NodeRecord)),
                          0);
                EXPECT_EQ(std::memcmp(strains[0].data(), strains[1].data(), n * sizeof(WaterCell)),
                          0);
                for (int c = 0; c < moved[0].column_count(); ++c)
                    EXPECT_EQ(moved[0](c, 0), moved[1](c, 0));
            }
}

TEST(UndrainedSand, OfACellFollowsTheUndrainedPathToLiquefactionAndBack) {
    const grit_sand sand = lausitz();
    const grit_sand_options options = sand_options();
    WetCell cell(1e5, 5e4);
    cell.set_rates(-1.0, 1.0);
    const PoreWater& water = *cell.simulation->body(0).water;
    ParticleView q = cell.particles();
    const double K_w = water.bulk_modulus;
    // The same strains, given to the library alone.
    double stress[4] = {-1e5, -1e5, -1e5, 0.0}, state[GRIT_SAND_STATE_SIZE], F[2] = {1.0, 1.0};
    for (int k = 0; k < GRIT_SAND_STATE_SIZE; ++k) state[k] = q[Sand::state + k][0];
    double p_w = 5e4, least_pressure = 1e5, most_p_w = 0.0;
    for (int i = 0; i < 600; ++i) {
        if (i == 300) cell.set_rates(1.0, -1.0);
        cell.simulation->step();
        q = cell.particles();
        double strain[4] = {};
        for (const int k : {0, 1}) {
            const double now = q[k == 0 ? column::F_rr : column::F_zz][0], L = now / F[k] - 1.0;
            strain[k] = L / (1.0 + 0.5 * L);
            F[k] = now;
        }
        const double e = state[GRIT_SAND_VOID_RATIO];
        grit_sand_points points{};
        points.struct_size = sizeof points;
        points.components = 4;
        points.stress = grit_mutable_view_of(stress, 1, 1);
        points.state = grit_mutable_view_of(state, 1, 1);
        points.strain_increment = grit_view_of(strain, 1, 1);
        ASSERT_EQ(grit_sand_update(&sand, &options, 1, &points, nullptr, nullptr), GRIT_OK);
        p_w -= K_w * std::log(state[GRIT_SAND_VOID_RATIO] / e);  // grains keep their volume
        ASSERT_NEAR(q[water.first][0], p_w, 1e-6 * std::fabs(p_w)) << i;
        for (int k = 0; k < 4; ++k) ASSERT_NEAR(q[column::S_rr + k][0], stress[k], 1e-6 * 1e5) << i;
        least_pressure = std::min(least_pressure, -(stress[0] + stress[1] + stress[2]) / 3.0);
        most_p_w = std::max(most_p_w, p_w);
    }
    EXPECT_LT(least_pressure, 1e4);
    EXPECT_GT(most_p_w, 1e6);
}

TEST(UndrainedSand, CavitatesAndBearsAgainOnceTheCavityHasClosed) {
    WetCell cell(1e5, 0.0);
    cell.set_rates(1.0, 1.0);
    Simulation& simulation = *cell.simulation;
    const PoreWater& water = *simulation.body(0).water;
    double J = 0.0;
    for (int i = 0; i < 50; ++i) simulation.step();
    EXPECT_EQ(water.pressure(cell.particles(), 0), -1e5);
    cell.set_rates(-1.0, -1.0);
    while (water.pressure(cell.particles(), 0) < 0.0) {
        simulation.step();
        J = cell.particles().J(0);
    }
    EXPECT_NEAR(J, 1.0, 3e-4);  // of one step
}

Case loaded(double conductivity, int threads, bool implicit = false) {
    Column column{.cells = 40,
                  .conductivity = conductivity,
                  .threads = threads,
                  .axisymmetric = true,
                  .implicit = implicit,
                  .load = 1e4,
                  .ramp = 1e-3,
                  .gravity = 9.81};
    return column.plan();
}

TEST(SaturatedSand, IsTheSameWhateverTheThreads) {
    for (const bool implicit : {false, true})
        for (const double k : {0.0, 1e-3}) {
            std::string one;
            for (const int threads : {1, 2, 3}) {
                BuiltCase built = build_case(loaded(k, threads, implicit));
                for (int i = 0; i < 300; ++i) built.simulation->step();
                const std::string now = saved(*built.simulation);
                if (threads == 1) one = now;
                EXPECT_TRUE(now == one) << k << ", " << threads << " threads";
            }
        }
}

TEST(SaturatedSand, GoesOnFromACheckpointBitForBit) {
    for (const auto& [k, implicit] :
         {std::pair{0.0, false}, {1e-3, false}, {0.0, true}, {1e-3, true}}) {
        const Case plan = loaded(k, 1, implicit);
        SCOPED_TRACE(k);
        expect_goes_on(plan, 150);
    }
}

TEST(SaturatedSand, RefusesTheCheckpointOfOtherWater) {
    const Case plan = loaded(0.0, 1);
    Case other = plan;
    other.bodies[0].water->bulk_modulus = 1e9;
    expect_refused(plan, other);
}

}  // namespace
