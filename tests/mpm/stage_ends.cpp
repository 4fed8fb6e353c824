// SPDX-License-Identifier: BSD-3-Clause
// What ends a stage or a run: blows that are counted, energy that comes from nothing.
#include <gtest/gtest.h>

#include <cmath>

#include <adapters/mpm/run/measures.hpp>
#include <adapters/mpm/run/run.hpp>

#include "support/plans.hpp"

namespace {

using namespace mpm_test;

TractionPlan pulses(const std::string& from_stage, double interval, double start, int count) {
    return {.body = "column",
            .edge = Edge::top,
            .direction = {0.0, -1.0},
            .stress = PulseTrain{1e3, PulseForm::half_sine, interval / 2.0, interval / 4.0,
                                 interval, start, count},
            .from_stage = from_stage};
}

Case blow_case(const std::vector<TractionPlan>& tractions, const std::vector<StageEnd>& ends) {
    Case plan = column_case();
    plan.tractions = tractions;
    plan.stages.clear();
    for (const StageEnd& end : ends)
        plan.stages.push_back(
            {.name = std::string(1, static_cast<char>('a' + plan.stages.size())), .end = end});
    return plan;
}

struct End {
    double time;  // since the stage began
    int blow;     // counted just before
    Ended how;
};

std::vector<End> ends_of(const Case& plan) {
    Runner runner(plan);
    std::vector<End> out;
    double began = 0.0;
    while (!runner.finished()) {
        const int stage = runner.state().stage, blow = runner.blow();
        runner.step();
        if (runner.state().stage == stage) continue;
        out.push_back({runner.simulation().time() - began, blow, runner.ended()});
        began = runner.simulation().time();
    }
    return out;
}

std::string refusal(const Case& plan) {
    try {
        const Runner runner(plan);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

constexpr double step = 2e-3;  // longer than those of the column [s]

TEST(Blows, AreThoseOfTheTrainThatBeginsWithTheStage) {
    const std::vector<End> ends = ends_of(blow_case(
        {pulses("a", 0.02, 0.005, 3), pulses("b", 0.03, 0.01, 2)}, {{.blows = 2}, {.blows = 2}}));
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_NEAR(ends[0].time, 0.045, step);
    EXPECT_NEAR(ends[1].time, 0.07, step);
    for (const End& end : ends) {
        EXPECT_EQ(end.blow, 2);
        EXPECT_EQ(end.how, Ended::by_blows);
    }
}

TEST(Blows, OfOneTrainAreCountedFromTheStageOn) {
    const std::vector<End> ends =
        ends_of(blow_case({pulses("", 0.02, 0.005, 5)}, {{.blows = 2}, {.blows = 3}}));
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_NEAR(ends[0].time, 0.045, step);
    EXPECT_NEAR(ends[1].time, 0.06, step);
    EXPECT_EQ(ends[1].blow, 5);
}

TEST(Blows, OfATrainThatHasNotBegunAreNotCounted) {
    const std::vector<End> ends = ends_of(blow_case(
        {pulses("b", 0.02, 0.0, 1), pulses("", 0.03, 0.0, 2)}, {{.blows = 1}, {.blows = 1}}));
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_NEAR(ends[0].time, 0.03, step);
    EXPECT_NEAR(ends[1].time, 0.02, step);
}

TEST(Blows, TellHowMuchOfTheirStageIsDone) {
    Runner runner(blow_case({pulses("", 0.02, 0.005, 5)}, {{.blows = 2}, {.blows = 3}}));
    while (runner.state().stage == 0) runner.step();
    EXPECT_NEAR(runner.share_done(), 0.0, step / 0.06);
    while (runner.simulation().time() < 0.075) runner.step();
    EXPECT_NEAR(runner.share_done(), 0.5, step / 0.06);
}

TEST(Blows, ThatNoTrainGivesAreRefused) {
    EXPECT_EQ(refusal(blow_case({pulses("", 0.02, 0.0, 3)}, {{.blows = 4}})),
              "stage a waits for 4 blows of a train of 3");
    EXPECT_EQ(refusal(blow_case({pulses("", 0.02, 0.0, 3)}, {{.blows = 2}, {.blows = 2}})),
              "stage b waits for 2 blows of a train of 3, of which earlier stages take 2");
    EXPECT_EQ(refusal(blow_case({pulses("b", 0.02, 0.0, 3)}, {{.blows = 1}, {.blows = 1}})),
              "stage a waits for 1 blow, but no traction with pulses has begun by then");
    EXPECT_EQ(refusal(blow_case({pulses("", 0.02, 0.0, 3)}, {{.blows = 1}, {.blows = 2}})),
              "accepted");
}

TEST(Blows, ThatAreOverBeforeTheStageEndTheRunInsteadOfWaitingForEver) {
    Runner runner(blow_case({pulses("", 0.02, 0.0, 3)}, {{.time = 0.05}, {.blows = 2}}));
    try {
        while (runner.simulation().time() < 1.0) runner.step();
        FAIL() << "it waits";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "stage b waits for 2 blows, but had 1 of the train's 3 and no "
                                   "more follow");
    }
    EXPECT_NEAR(runner.simulation().time(), 0.06, step);
    const std::vector<End> ends = ends_of(
        blow_case({pulses("", 0.02, 0.0, 3)}, {{.time = 0.05}, {.time = 0.03, .blows = 2}}));
    EXPECT_EQ(ends.back().how, Ended::by_time);
}

TEST(Interval, IsAMultipleAfterTheTimeHoweverShortItIs) {
    EXPECT_EQ(next_multiple(0.5, 0.0), 0.5);
    EXPECT_EQ(next_multiple(0.5, 0.5), 1.0);
    EXPECT_EQ(next_multiple(0.5, 1e6 + 0.3), 1e6 + 0.5);
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.1 * i, next = next_multiple(0.1, t);
        EXPECT_GT(next, t);
        EXPECT_LT(next, t + 0.1 + 1e-12);
    }
    EXPECT_EQ(next_multiple(1e-20, 2.0), 2.0);
    EXPECT_EQ(next_multiple(1e-320, 2.0), 2.0);
}

TEST(Interval, ThatNoStepCouldKeepIsRefused) {
    Case plan = column_case();
    plan.history.interval = 1e-20;
    EXPECT_TRUE(refusal(plan).starts_with("history.interval_s must be 0 or no less than 1.36"))
        << refusal(plan);
    EXPECT_NE(refusal(plan).find("shortest cell, got 1e-20"), std::string::npos);
    plan.history.interval = 1e-6;
    EXPECT_EQ(refusal(plan), "accepted");
}

std::string broken(const Energy& energy) { return imbalance(energy, 1.0, 0.05); }

TEST(EnergyBalance, IsBrokenByALossThatIsAGain) {
    const Energy sound{.kinetic = 300.0, .external_work = 1000.0, .contact = 700.0};
    EXPECT_EQ(broken(sound), "");
    const std::pair<double Energy::*, const char*> losses[] = {
        {&Energy::contact, "contact loss"},
        {&Energy::damping, "damping loss"},
        {&Energy::viscosity, "viscosity loss"},
        {&Energy::absorbed, "energy absorbed by sides"},
        {&Energy::pic, "loss to the PIC share"}};
    for (const auto& [loss, name] : losses) {
        Energy energy{.kinetic = 1694.0, .external_work = 1000.0};
        energy.*loss = energy.transfer = -694.0;  // which has the PIC share in it
        if (loss != &Energy::pic) energy.transfer = 0.0;
        EXPECT_EQ(energy.residual(), 0.0);
        EXPECT_EQ(broken(energy),
                  std::string("its ") + name +
                      " is -694 J, a gain of 69.4 % of the 1000 J that were there or came in, the "
                      "limit is 5 %");
        EXPECT_EQ(imbalance(energy, 1e5, 0.05), "");  // it does not matter
        energy.kinetic = 1040.0;
        energy.*loss = -40.0;
        if (loss == &Energy::pic) energy.transfer = -40.0;
        EXPECT_EQ(broken(energy), "");
        energy.*loss = NAN;
        EXPECT_NE(broken(energy), "");
    }
    for (double Energy::*start : {&Energy::kinetic_0, &Energy::stored_0, &Energy::rigid_work}) {
        Energy energy{.contact = -40.0};
        energy.*start = 1000.0;
        energy.kinetic = 40.0 + energy.rigid_work + energy.kinetic_0;
        energy.stored = energy.stored_0;
        EXPECT_EQ(broken(energy), "");
    }
}

// ... of which little has been done by then.
TEST(EnergyBalance, ClosesFromTheFirstStepsOfALoadOn) {
    Case plan = column_case();
    plan.gravity = 0.0;
    plan.settings.linear_viscosity = 3.0;
    plan.tractions = {{.body = "column",
                       .edge = Edge::top,
                       .direction = {0.0, -1.0},
                       .stress = TimeTable{{0.0}, {1e5}}}};
    Runner runner(plan);
    double largest = 0.0;
    while (!runner.finished()) {
        runner.step();
        if (runner.simulation().steps() % 20 != 0) continue;
        const double share = runner.row().residual_share;
        if (runner.simulation().steps() <= 100) largest = std::max(largest, std::abs(share));
    }
    EXPECT_LT(largest, 0.045);
    EXPECT_LT(std::abs(runner.row().residual_share), 0.01);
}

// A host's script may go on after such a refusal.
TEST(Stages, ThatAreRefusedAsTheyBeginLeaveTheRunAsItWas) {
    const StageEnd open{};
    const auto told = [](Runner& runner, const std::string& stage, int blows) {
        try {
            runner.begin(stage, [blows](const StagePlan& planned) {
                StagePlan out = planned;
                out.local_damping = 0.7;
                out.end.blows = blows;
                return out;
            });
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    Runner runner(blow_case({pulses("", 0.02, 0.0, 3)}, {open, open, open}));
    runner.step();
    for (const std::string stage : {"a", "b"})
        for (const int blows : {4, 100}) {
            EXPECT_NE(told(runner, stage, blows).find("of a train of 3"), std::string::npos);
            EXPECT_EQ(runner.state().stage, 0);
            for (const StagePlan& plan : runner.description().stages) {
                EXPECT_EQ(plan.end.blows, 0) << plan.name;
                EXPECT_EQ(plan.local_damping, 0.0) << plan.name;
            }
            runner.step();
        }
    EXPECT_EQ(told(runner, "b", 3), "accepted");
    EXPECT_EQ(runner.state().stage, 1);
    EXPECT_EQ(runner.description().stages[2].local_damping, 0.7);
}

}  // namespace
