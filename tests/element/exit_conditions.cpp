// SPDX-License-Identifier: BSD-3-Clause
#include <element/exit_condition.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <element/errors.hpp>

#include "support/elastic.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

std::string complaint_about(const std::string& condition) {
    try {
        when(condition);
    } catch (const BadCase& error) {
        return error.what();
    }
    return "";
}

Record some_record() {
    Record record;
    record.stress << -4.0, -2.0, -1.0, 0.5, 0.25, 0.125;
    record.strain << 0.04, 0.02, -0.01, 0.005, 0.006, 0.007;
    record.state = {11.0, 12.0};
    record.pore_pressure = 3.0;
    record.time = 9.0;
    return record;
}

double value(const std::string& name) {
    return incremental_driver_words({"void_ratio", "rho"})(name)(some_record());
}

TEST(ExitCondition, ReadsLinearCombinationsOfQuantities) {
    const Condition c = when(" -s1 + 2.5*s3 - g12 > -4d2 ");
    ASSERT_EQ(c.sum.size(), 3u);
    EXPECT_EQ(c.sum[0].factor, -1.0);
    EXPECT_EQ(c.sum[1].factor, 2.5);
    EXPECT_EQ(c.sum[2].factor, -1.0);
    EXPECT_EQ(c.comparison, Comparison::greater);
    EXPECT_EQ(c.limit, -400.0);
    EXPECT_NEAR(excess(c, some_record()), 4.0 - 2.5 - 0.005 + 400.0, 1e-12);
}

TEST(ExitCondition, KnowsTheQuantitiesOfIncrementalDriver) {
    EXPECT_EQ(value("s2"), -2.0);
    EXPECT_EQ(value("s13"), 0.25);
    EXPECT_EQ(value("e3"), -0.01);
    EXPECT_EQ(value("g23"), 0.007);
    EXPECT_NEAR(value("p"), 7.0 / 3.0, 1e-15);
    EXPECT_NEAR(value("P"), 7.0 / std::sqrt(3.0), 1e-14);
    EXPECT_EQ(value("q"), 3.0);
    EXPECT_EQ(value("Q"), 3.0);
    EXPECT_NEAR(value("ev"), -0.05, 1e-15);
    EXPECT_NEAR(value("eq"), -2.0 / 3.0 * 0.05, 1e-15);
    EXPECT_NEAR(value("eP"), -0.05 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(value("eQ"), -std::sqrt(2.0 / 3.0) * 0.05, 1e-15);
    EXPECT_EQ(value("v2"), 12.0);
    EXPECT_EQ(value("rho"), 12.0);
    EXPECT_EQ(value("pw"), 3.0);
    EXPECT_EQ(value("time"), 9.0);
    EXPECT_NEAR(value("sI") + value("sII") + value("sIII"), -7.0, 1e-14);
    EXPECT_GT(value("sI"), value("sIII"));
}

TEST(ExitCondition, SaysWhereItCannotBeRead) {
    EXPECT_EQ(complaint_about("s1 = 3"), "condition \"s1 = 3\": expected < or > at character 4");
    EXPECT_EQ(complaint_about("2 s1 < 3"), "condition \"2 s1 < 3\": expected * at character 3");
    EXPECT_EQ(complaint_about("s1 < x"), "condition \"s1 < x\": expected a number at character 6");
    EXPECT_EQ(complaint_about("s1 < 3 kPa"),
              "condition \"s1 < 3 kPa\": expected the end at character 8");
    EXPECT_EQ(complaint_about("< 3"), "condition \"< 3\": expected a quantity at character 1");
    EXPECT_THROW(value("s4"), BadCase);
    EXPECT_THROW(value("v3"), BadCase);
}

// Elastic, E = 1000: stress -10 at the end.
Step compression(const std::string& condition, bool exactly = false) {
    Step step = triaxial_drained(-0.01);
    step.increments = 20;
    step.exit.any_of = {when(condition)};
    step.exit.exactly = exactly;
    return step;
}

TEST(ExitCondition, EndsAStepAfterTheIncrementWhereItHolds) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    const History history =
        simulate(law, sample, {compression("s1 < -3.2"), triaxial_drained(0.001)});
    EXPECT_EQ(history.exits, std::vector<std::string>{"step 1, increment 7: s1 < -3.2"});
    EXPECT_NEAR(history.records[7].stress[0], -3.5, 1e-9);
    EXPECT_EQ(history.records[8].step, 2);
    EXPECT_NEAR(sample.point.stress[0], -2.5, 1e-9);
}

TEST(ExitCondition, IsFoundToTheDotWhenAskedFor) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    Step step = compression("s1 < -3.2", true);
    step.duration = 100.0;
    const History history = simulate(law, sample, {step});
    EXPECT_NEAR(sample.point.stress[0], -3.2, 1e-8);
    EXPECT_NEAR(sample.strain[0], -0.0032, 1e-11);
    EXPECT_NEAR(sample.time, 32.0, 1e-6);
}

TEST(ExitCondition, StopsSandWhereTheLaboratoryWouldReverse) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.6);
    Step step = triaxial_drained(-0.05);
    step.exit.any_of = {when("e1 < -0.04"), when("q > 150")};
    step.exit.exactly = true;
    const History history = simulate(law, sample, {step});
    ASSERT_FALSE(history.failure) << history.failure->message;
    EXPECT_NEAR(sample.point.stress[2] - sample.point.stress[0], 150.0, 1e-5);
    EXPECT_EQ(history.exits.size(), 1u);
}

TEST(ExitCondition, OfARepetitionEndsAllOfItWhicheverStepIsGoingOn) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    Step down = triaxial_drained(-0.01), up = triaxial_drained(0.002);
    down.increments = up.increments = 10;
    Step pair;
    pair.kind = Repetition{{down, up}, 5};
    pair.exit.any_of = {when("s1 < -15.5")};
    Step outer;
    outer.kind = Repetition{{pair}, 2};
    const History history = simulate(law, sample, {outer, up});
    EXPECT_EQ(history.exits, (std::vector<std::string>{"step 3, increment 8: s1 < -15.5",
                                                       "step 4, increment 1: s1 < -15.5"}));
    EXPECT_NEAR(sample.point.stress[0], -16.0 - 1.0 + 2.0, 1e-9);
    EXPECT_EQ(history.records.back().step, 5);
}

TEST(ExitCondition, LeavesARecordWhereItEndsTheStepHoweverRareRecordsAre) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    Step step = compression("s1 < -3.2");
    step.every = 5;
    step.record_end = false;
    const History history = simulate(law, sample, {step});
    EXPECT_EQ(history.records.back().increment, 7);
    EXPECT_EQ(history.records.back().strain, sample.strain);
}

TEST(ExitCondition, CannotEndProbesThatAreUndone) {
    Perturbations kind;
    kind.rows = mixed_control({});
    Step step;
    step.kind = kind;
    step.exit.any_of = {when("s1 < 0")};
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    EXPECT_THROW(simulate(law, sample, {step}), BadCase);
}

TEST(ExitCondition, KnowsStateVariablesWithoutANameOfTheirOwn) {
    Record record;
    record.state = {1.0, 2.0};
    const Condition c =
        parse_condition("2*statev(2) > 1", incremental_driver_words({"statev(1)", "statev(2)"}));
    EXPECT_EQ(excess(c, record), 3.0);
}

}  // namespace
