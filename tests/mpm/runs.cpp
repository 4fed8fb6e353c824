// SPDX-License-Identifier: BSD-3-Clause
// Cases run stage after stage.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <adapters/mpm/run/run.hpp>
#include <grit/contact.h>

#include "support/plans.hpp"

namespace {

using namespace mpm_test;

HistoryRow run(Runner& runner) {
    HistoryRow last = runner.row();
    while (!runner.finished()) {
        runner.step();
        if (runner.row_is_due()) last = runner.row();
    }
    return last;
}

TEST(Run, PressesAColumnUntilItRestsAndItsBaseCarriesLoadAndWeight) {
    Case plan = pressed_column_case();
    plan.stages[0] = {.name = "press",
                      .local_damping = 0.3,
                      .end = {.time = 5.0, .unbalanced_share = 1e-3, .kinetic_share = 1e-6}};
    plan.history.interval = 0.05;
    Runner runner(plan);
    const HistoryRow last = run(runner);
    EXPECT_EQ(runner.ended(), Ended::at_rest);
    EXPECT_LT(last.t, 2.0);
    const double area = std::numbers::pi * 0.04, weight = 1000.0 * 9.81 * area;
    EXPECT_NEAR(last.hammer_force, 1e4 * area, 0.01 * 1e4 * area);
    EXPECT_NEAR(last.base_force, last.hammer_force + weight, 0.005 * weight);
    EXPECT_LE(last.unbalanced_share, 1e-3);
    EXPECT_LT(std::abs(last.residual_share), 0.01);
}

TEST(Run, DoesNotTakeAFallingBodyForOneAtRestBesideAHeavyOne) {
    Case plan = column_case();
    plan.r = {0.0, {{2.0, 20, 1.0}}};
    plan.z = {-2.0, {{1.2, 32, 1.0}}};
    plan.bodies = {elastic_box("ball", 0.0, 0.1, 0.5, 0.6),
                   elastic_box("rock", 0.0, 2.0, -2.0, 0.0)};
    plan.bodies[1].geostatic = Geostatic{};
    plan.stages[0].end = {.time = 0.1, .unbalanced_share = 0.01, .kinetic_share = 1e-3};
    plan.history.body = "ball";
    Runner runner(plan);
    run(runner);
    EXPECT_EQ(runner.ended(), Ended::by_time);
}

TEST(Run, WithoutGravityLeavesAColumnAtRestUntilTheStageThatHasIt) {
    Case plan = column_case();
    plan.stages = {{.name = "nothing", .gravity = false, .end = {.time = 0.01}},
                   {.name = "weight", .cfl = 0.2, .end = {.time = 0.01}}};
    Runner runner(plan);
    double dt = 0.0;
    while (runner.state().stage == 0) {
        runner.step();
        dt = runner.state().last_dt;
        EXPECT_EQ(runner.simulation().energy().kinetic, 0.0);
    }
    EXPECT_EQ(runner.ended(), Ended::by_time);
    runner.step();
    EXPECT_NEAR(runner.state().last_dt, 0.5 * dt, 1e-3 * dt);
    EXPECT_GT(runner.simulation().energy().kinetic, 0.0);
}

TEST(Run, WritesARowAfterEachIntervalAndAtTheEndOfAStage) {
    Case plan = column_case();
    plan.history.interval = 0.03;
    Runner runner(plan);
    std::vector<double> times{runner.row().t};
    double dt = 0.0;
    while (!runner.finished()) {
        runner.step();
        dt = std::max(dt, runner.state().last_dt);
        if (runner.row_is_due()) times.push_back(runner.row().t);
    }
    ASSERT_EQ(times.size(), 5U);
    const double wanted[] = {0.0, 0.03, 0.06, 0.09, 0.1};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_GE(times[i], wanted[i] - 1e-12);
        EXPECT_LT(times[i], wanted[i] + dt);
    }
}

// A rigid plate that waits, then presses a confined column by 2 %, slowly.
Case plate_case() {
    Case plan = column_case();
    BodyPlan plate = elastic_box("plate", 0.0, 0.2, 1.0, 1.1);
    plate.material = RigidPlan{{{0.0, 0.1}, {0.0, -0.1}}, {{0.0}, {0.0}}, "push"};
    std::get<RigidPlan>(plate.material).velocity_z = {{0.0, 0.1}, {0.0, -0.1}};
    std::get<RigidPlan>(plate.material).velocity_r = {{0.0}, {0.0}};
    plan.bodies.push_back(plate);
    plan.contacts = {{.stiff = "plate", .soft = "column", .law = GRIT_CONTACT_FRICTIONAL}};
    plan.gravity = 0.0;
    plan.stages = {{.name = "wait", .end = {.time = 0.05}},
                   {.name = "push", .pic_rate = 50.0, .end = {.depth = 0.02}}};
    plan.history.body = "plate";
    plan.history.interval = 0.02;
    return plan;
}

TEST(Run, PushesARigidPlateFromItsStageOnAsDeepAsItSays) {
    Runner runner(plate_case());
    while (runner.state().stage == 0) {
        runner.step();
        EXPECT_EQ(runner.depth(), 0.0);
    }
    const HistoryRow last = run(runner);
    EXPECT_EQ(runner.ended(), Ended::by_depth);
    EXPECT_NEAR(last.depth, 0.02, 0.1 * last.dt);
    EXPECT_NEAR(last.velocity, 0.1, 1e-12);
    EXPECT_NEAR(last.t, 0.05 + 0.05 + 0.2, 0.01);  // ramp: 0.005 m, then 0.15 s ...
}

TEST(Run, TellsTheForceOfATipThatPressesFromThatOfAShaft) {
    Runner runner(plate_case());
    const HistoryRow last = run(runner);
    const double modulus = 1e6 * 0.7 / (1.3 * 0.4), area = std::numbers::pi * 0.04;
    EXPECT_NEAR(last.tip_force, modulus * 0.02 * area, 0.05 * modulus * 0.02 * area);
    EXPECT_NEAR(last.base_force, last.tip_force, 0.03 * last.tip_force);
    EXPECT_EQ(last.shaft_force, 0.0);
}

// An elastic pile that falls into a block and is hit: all forces on it, with their signs, are its
// momentum.
TEST(Run, KeepsTheBalanceOfMomentumOfTheDrivenBody) {
    Case plan = column_case();
    plan.r = {0.0, {{0.4, 8, 1.0}}};
    plan.bodies = {elastic_box("pile", 0.0, 0.1, 0.4, 0.9),
                   elastic_box("soil", 0.0, 0.4, 0.0, 0.4)};
    plan.bodies[0].density = 3000.0;
    plan.bodies[1].outlines.push_back(elastic_box("", 0.1, 0.4, 0.4, 0.6).outlines[0]);
    plan.bodies[0].velocity = {0.0, -0.5};
    plan.contacts = {{.stiff = "pile",
                      .soft = "soil",
                      .law = GRIT_CONTACT_FRICTIONAL,
                      .friction_coefficient = 0.5,
                      .gated = false}};
    plan.tractions = {{.body = "pile",
                       .edge = Edge::top,
                       .direction = {0.0, -1.0},
                       .stress = PulseTrain{5e4, PulseForm::half_sine, 0.01, 0.005, 0.02, 0.005, 2},
                       .from_stage = "stage"}};
    plan.stages[0].end = {.blows = 2};
    plan.history = {.body = "pile", .interval = 0.001};
    Runner runner(plan);
    const double mass = 3000.0 * std::numbers::pi * 0.01 * 0.5;
    HistoryRow before = runner.row();
    double impulse = 0.0, shaft = 0.0, hammer = 0.0;
    const double start = before.velocity;
    while (!runner.finished()) {
        runner.step();
        if (!runner.row_is_due()) continue;
        const HistoryRow now = runner.row();
        impulse += (now.t - before.t) *
                   (now.hammer_force + mass * plan.gravity - now.tip_force - now.shaft_force);
        shaft += (now.t - before.t) * now.shaft_force;
        hammer += (now.t - before.t) * now.hammer_force;
        before = now;
    }
    EXPECT_EQ(runner.ended(), Ended::by_blows);
    EXPECT_EQ(before.blow, 2);
    EXPECT_NEAR(before.t, 0.045, before.dt);
    const double area = std::numbers::pi * 0.01;
    EXPECT_NEAR(hammer, 2.0 * 5e4 * area * 0.01 * 2.0 / std::numbers::pi, 0.02 * hammer);
    EXPECT_GT(shaft, 0.01 * hammer);
    EXPECT_NEAR(mass * (before.velocity - start), impulse, 1e-6 * hammer);
}

TEST(Run, TellsTheWorkOfTractionsFromThatOfWeightAndWhatTheDrivenBodyHolds) {
    Case plan = column_case();
    const HistoryRow weight = [&plan] {
        Runner runner(plan);
        return run(runner);
    }();
    EXPECT_GT(weight.energy.external_work, 0.0);
    EXPECT_EQ(weight.energy.traction_work, 0.0);
    EXPECT_GT(weight.driven_stored, 0.0);
    EXPECT_EQ(weight.driven_stored, weight.energy.stored);

    plan.gravity = 0.0;
    plan.tractions = {{.body = "column",
                       .edge = Edge::top,
                       .direction = {0.0, -1.0},
                       .stress = TimeTable{{0.0}, {1e4}}}};
    Runner runner(plan);
    const HistoryRow load = run(runner);
    EXPECT_GT(load.energy.traction_work, 0.0);
    EXPECT_EQ(load.energy.traction_work, load.energy.external_work);
}

TEST(Run, FindsNothingStoredInARigidBody) {
    Runner runner(plate_case());
    const HistoryRow last = run(runner);
    EXPECT_EQ(last.driven_stored, 0.0);
    EXPECT_GT(last.energy.stored, 0.0);
}

TEST(Run, KnowsWhereTheTimeOfItsStepsWent) {
    Runner runner(plate_case());
    run(runner);
    const Seconds spent = runner.simulation().seconds();
    EXPECT_EQ(spent.steps, runner.simulation().steps());
    for (const double part : {spent.scatter, spent.nodes, spent.contact, spent.material})
        EXPECT_GT(part, 0.0);
    EXPECT_LT(spent.material, spent.gather);
}

TEST(Run, StopsWhereTheEnergyBalanceBreaksAndSaysWhere) {
    Case plan = column_case();
    plan.bodies[0].velocity = {0.0, -0.1};
    plan.stages[0].cfl = 1.3;  // unstable
    plan.stages[0].end.time = 10.0;
    Runner runner(plan);
    try {
        run(runner);
        FAIL() << "it went on";
    } catch (const std::runtime_error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("the energy balance is broken at t = "), std::string::npos) << text;
        EXPECT_NE(text.find("the limit is 5 %"), std::string::npos) << text;
    }
    EXPECT_LT(runner.simulation().time(), 1.0);
}

TEST(Run, StopsWhereAnEnergyIsNoNumberAndSaysWhich) {
    Energy energy{.kinetic = 1.0, .viscosity = 2.0};
    energy.check_finite(0.5);
    for (const double bad : {NAN, INFINITY}) {
        energy.viscosity = bad;
        try {
            energy.check_finite(0.5);
            FAIL() << "it went on";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(),
                         "the energy balance is broken at t = 0.500000 s: its term viscosity is "
                         "infinite or no number; is cfl too large?");
        }
    }
}

// How far the lowest particles of a column that is free at its sides bulge out [m].
double bulge(Boundary bottom) {
    Case plan = column_case();
    plan.r = {0.0, {{0.4, 8, 1.0}}};
    plan.boundary[static_cast<int>(Side::bottom)] = bottom;
    plan.gravity = 500.0;
    plan.stages[0].end.time = 0.02;
    Runner runner(plan);
    run(runner);
    double farthest = 0.0;
    const Particles& q = runner.simulation().body(0).particles;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        if (q(column::z, p) < 0.02) farthest = std::max(farthest, q(column::r, p));
    return farthest - 0.1875;
}

TEST(Boundary, IsARollerOrFixedAltogether) {
    const double on_rollers = bulge(Boundary::roller);
    EXPECT_GT(on_rollers, 0.005);
    EXPECT_LT(bulge(Boundary::fixed), 0.4 * on_rollers);
}

TEST(Depth, IsThatOfTheLowestPointOrOfTheCentreOfMass) {
    Case plan = column_case();
    plan.stages[0].end.time = 0.05;  // sags on its roller
    for (const DepthOf what : {DepthOf::lowest_point, DepthOf::centre_of_mass}) {
        plan.history.depth_of = what;
        Runner runner(plan);
        const HistoryRow last = run(runner);
        if (what == DepthOf::lowest_point) EXPECT_NEAR(last.depth, 0.0, 1e-12);
        else EXPECT_GT(last.depth, 1e-3);
    }
}

TEST(Run, RefusesWhatNamesNobody) {
    Case plan = column_case();
    plan.history.body = "pile";
    EXPECT_THROW(Runner{plan}, std::invalid_argument);
    plan = column_case();
    plan.stages.clear();
    EXPECT_THROW(Runner{plan}, std::invalid_argument);
    plan = column_case();
    plan.bodies[0].outlines[0].corners[2][1] = 1.3;
    EXPECT_THROW(Runner{plan}, std::invalid_argument);
}

}  // namespace
