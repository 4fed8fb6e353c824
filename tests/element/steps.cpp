// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "support/runs.hpp"

namespace {

using namespace tests;
using namespace element;

TEST(Step, IsDividedEvenlyOrGeometrically) {
    const auto strains = [](const Step& s) {
        std::vector<double> out;
        for (const Record& r : run_elastic({s}).history.records) out.push_back(r.strain[0]);
        return out;
    };
    Step step = oedometer_strain(-0.01);
    step.increments = 4;
    EXPECT_NEAR(strains(step)[1], -0.0025, 1e-15);
    step.first_share = 1.0 / 15.0;  // 1 2 4 8
    EXPECT_NEAR(strains(step)[2], -0.01 * 3.0 / 15.0, 1e-12);
    EXPECT_EQ(strains(step).size(), 5u);
}

TEST(Step, IsRecordedEachSoManyIncrementsAndAtItsEnd) {
    Step step = oedometer_strain(-0.01);
    step.increments = 25;
    step.every = 10;
    const auto numbers = [](const Step& s) {
        std::vector<int> out;
        for (const Record& r : run_elastic({s}).history.records) out.push_back(r.increment);
        return out;
    };
    EXPECT_EQ(numbers(step), (std::vector<int>{0, 10, 20, 25}));
    step.record_end = false;
    EXPECT_EQ(numbers(step), (std::vector<int>{0, 10, 20}));
    step.record_first = true;
    EXPECT_EQ(numbers(step), (std::vector<int>{0, 1, 11, 21}));
    step.every = 1;
    EXPECT_EQ(numbers(step).size(), 26u);
}

TEST(Step, MayAimAtAValueInsteadOfAChange) {
    const auto to = [](double stress) {
        Step step = oedometer_stress(stress);
        std::get<Linear>(step.kind).absolute[0] = true;
        return step;
    };
    const Finished out = run_sand({to(-200.0), to(-20.0), to(-400.0)});
    EXPECT_NEAR(out.history.records[100].stress[0], -200.0, 1e-6);
    EXPECT_NEAR(out.history.records[200].stress[0], -20.0, 1e-6);
    EXPECT_NEAR(out.sample.point.stress[0], -400.0, 1e-6);
    EXPECT_NEAR(out.sample.strain[1], 0.0, 1e-14);
}

TEST(Repetition, EqualsTheStepsWrittenOutAndMayBeNested) {
    const Step down = oedometer_strain(-0.002), up = oedometer_strain(0.001);
    const Step pair = step_of(Repetition{{down, up}, 2}, 1);
    const Step nested = step_of(Repetition{{pair, down}, 2}, 1);
    const Finished a = run_sand({nested});
    const Finished b = run_sand({down, up, down, up, down, down, up, down, up, down});
    ASSERT_EQ(a.history.records.size(), b.history.records.size());
    EXPECT_EQ(a.history.records.size(), 1001u);
    EXPECT_EQ(a.sample.point.stress, b.sample.point.stress);
    EXPECT_EQ(a.history.records.back().step, 10);
    EXPECT_EQ(count_steps({nested}), 10);
    EXPECT_EQ(count_increments({nested}), 1000);
}

TEST(RestSteps, LetTimePassAndHoldWhatTheirNameSays) {
    const Finished out = run_sand({triaxial_drained(-0.005), relaxation(60.0), creep(30.0)});
    EXPECT_NEAR(out.sample.time, 90.0, 1e-9);
    EXPECT_EQ(out.sample.strain, out.history.records[100].strain);  // sand does not creep
    EXPECT_LE((out.sample.point.stress - out.history.records[100].stress).norm(), 1e-6);
}

TEST(Listener, SeesEveryIncrementAndMayStopTheRun) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    std::vector<long> seen;
    const Step step = oedometer_strain(-0.01);
    const auto watch = [&](const Progress& p) {
        EXPECT_EQ(p.steps, 2);
        EXPECT_EQ(p.increments, 200);
        EXPECT_EQ(p.record->strain, sample.strain);
        seen.push_back(p.increment);
        return p.increment < 130;
    };
    Step rare = step;
    rare.every = 100;
    const History history = simulate(law, sample, {rare, rare}, {}, {watch, {}});
    EXPECT_EQ(seen.size(), 130u);
    ASSERT_TRUE(history.failure);
    EXPECT_EQ(history.failure->step, 2);
    EXPECT_EQ(history.failure->increment, 30);
    EXPECT_EQ(history.records.back().increment, 30);
}

TEST(Listener, OfRecordsTakesThemInsteadOfTheHistory) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    int count = 0;
    const History history = simulate(law, sample, {oedometer_strain(-0.01)}, {},
                                     {{}, [&](const Record& record) { count += 1 + record.step; }});
    EXPECT_EQ(count, 1 + 2 * 100);
    EXPECT_TRUE(history.records.empty());
}

}  // namespace
