// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include <element/errors.hpp>

#include "support/elastic.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

std::string complaint_about(const Program& program, const Settings& settings = {}) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    try {
        simulate(law, sample, program, settings);
    } catch (const BadCase& error) {
        return error.what();
    }
    return "";
}

TEST(CutBack, HalvesWhatTheLawRefusesAndArrives) {
    Elastic law;
    law.largest_increment = 1.5e-3;
    Sample sample;
    sample.point = elastic_point();
    Step step = oedometer_strain(-0.04);
    step.increments = 4;
    const History history = simulate(law, sample, {step});
    ASSERT_FALSE(history.failure) << history.failure->message;
    EXPECT_NEAR(sample.strain[0], -0.04, 1e-14);
    EXPECT_EQ(history.records.size(), 5u);
    EXPECT_GE(history.records[1].cut_backs, 3);
}

TEST(CutBack, GrowsAgainOnceTheHardPartIsOver) {
    Elastic law;
    law.largest_increment = 1.5e-3;
    law.hard_increments = 2.0;
    Sample sample;
    sample.point = elastic_point();
    Step step = oedometer_strain(-0.04);
    step.increments = 1;
    const History history = simulate(law, sample, {step});
    ASSERT_FALSE(history.failure) << history.failure->message;
    EXPECT_LE(sample.point.state[0], 8.0);  // 32 if every part stayed as small as the first
}

TEST(CutBack, GivesUpWithStepIncrementAndReason) {
    Elastic law;
    law.largest_increment = 1e-12;
    Sample sample;
    sample.point = elastic_point();
    Step step = oedometer_strain(-0.04);
    step.name = "consolidation";
    const History history = simulate(law, sample, {step});
    ASSERT_TRUE(history.failure);
    EXPECT_EQ(history.failure->message,
              "step 1 (consolidation), increment 1 of 100, at strain 0 0 0 0 0 0: increment must "
              "be small");
    EXPECT_EQ(history.records.size(), 1u);
}

TEST(CutBack, IsNotTriedWhereItCannotHelp) {
    Elastic law;
    law.strength = 20.0;
    Sample sample;
    sample.point = elastic_point();
    const History history = simulate(law, sample, {oedometer_strain(-0.04)});
    ASSERT_TRUE(history.failure);
    EXPECT_LE(sample.point.stress.norm(), 20.0);
    EXPECT_EQ(history.records.size(), static_cast<std::size_t>(history.failure->increment));
}

// More than sand can carry: drained, axial stress beyond the peak.
TEST(Failure, OfSandBeyondItsPeakKeepsTheRecordsBefore) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.6);
    const History history = simulate(law, sample, {triaxial_drained_stress(-1000.0)});
    ASSERT_TRUE(history.failure);
    EXPECT_GT(history.records.size(), 10u);
    EXPECT_NE(history.failure->message.find("step 1, increment "), std::string::npos);
    EXPECT_EQ(history.records.back().strain, sample.strain);
    EXPECT_NE(history.failure->message.find("the prescribed stress cannot be reached"),
              std::string::npos)
        << history.failure->message;
    const double q = history.records.back().stress[2] - history.records.back().stress[0];
    EXPECT_GT(q, 200.0);
    EXPECT_LT(q, 400.0);
}

TEST(Failure, LeavesARecordOfTheLastStateHoweverRareRecordsAre) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.6);
    Step step = triaxial_drained_stress(-1000.0);
    step.every = 1000;
    const History history = simulate(law, sample, {step});
    ASSERT_TRUE(history.failure);
    ASSERT_EQ(history.records.size(), 2u);
    EXPECT_EQ(history.records.back().stress, sample.point.stress);
    EXPECT_GT(history.records.back().iterations, history.failure->increment);
}

TEST(Program, ThatMakesNoSenseIsRefusedBeforeAnythingIsComputed) {
    Step step = triaxial_drained(-0.01);
    step.increments = 0;
    EXPECT_EQ(complaint_about({step}), "step 1: increments must be in [1, 10000000], got 0");
    step = triaxial_drained(-0.01);
    step.every = 0;
    EXPECT_EQ(complaint_about({step}), "step 1: every must be >= 1, got 0");
    step = triaxial_drained(NAN);
    EXPECT_EQ(complaint_about({step}), "step 1: changes must be finite");
    step = triaxial_drained(-0.01);
    step.first_share = 0.5;
    EXPECT_EQ(complaint_about({step}),
              "step 1: the first increment must be <= 1/100 of the path, got 0.5 of it");
    step = simple_shear_constant_volume(0.01);
    step.undrained = true;
    EXPECT_NE(complaint_about({step}).find("the pore pressure stays unknown"), std::string::npos);
    Step repetition;
    repetition.kind = Repetition{{}, 3};
    EXPECT_EQ(complaint_about({repetition}),
              "step 1: a repetition needs steps and at least one time");
    step = triaxial_drained(-0.01);
    step.duration = -1.0;
    repetition.kind = Repetition{{triaxial_drained(-0.01), step}, 3};
    EXPECT_EQ(complaint_about({repetition}), "step 1, step 2: duration must be >= 0, got -1");
}

TEST(Program, OfMoreIncrementsThanALifetimeIsRefused) {
    Step repetition;
    repetition.kind = Repetition{{triaxial_drained(-0.01)}, 10000000};
    repetition.kind = Repetition{{repetition}, 10000000};
    EXPECT_EQ(complaint_about({repetition}), "a run has at most 1000000000 increments, got 1e+16");
}

TEST(Program, WithRestrictionsThatRepeatOneAnotherIsRefused) {
    Linear kind;
    kind.rows = mixed_control({});
    Step step;
    step.kind = kind;
    std::get<Linear>(step.kind).rows.strain.row(2) = 2.0 * kind.rows.strain.row(1);
    EXPECT_EQ(complaint_about({step}), "step 1: the six restrictions say only 5 different things");
    std::get<Linear>(step.kind).rows.strain.row(2).setZero();
    EXPECT_EQ(complaint_about({step}), "step 1: restriction 3 has neither stress nor strain");
}

TEST(Program, WithAMirroringOrPartialTableIsRefused) {
    DeformationGradient mirror;
    mirror.F(0, 0) = -1.0;
    Step step;
    step.kind = mirror;
    EXPECT_EQ(complaint_about({step}), "step 1: det F must be > 0, got -1");
    Imported history;
    history.rows = mixed_control({});
    history.table = {{0.0, 1.0}, {1.0, 2.0}};
    history.columns[0].index = 2;
    step.kind = history;
    EXPECT_EQ(complaint_about({step}),
              "step 1: an imported history has 2 columns, there is no column 3");
}

TEST(Settings, OutOfRangeAreRefused) {
    Settings settings;
    settings.tolerance = 0.5;
    EXPECT_EQ(complaint_about({triaxial_drained(-0.01)}, settings),
              "tolerance must be in [1e-14, 1e-2], got 0.5");
}

TEST(Law, RefusesParametersByName) {
    grit_sand_parameters parameters = lausitz();
    parameters.critical_friction_angle = 33.0;
    EXPECT_THROW(GritLaw{parameters}, BadCase);
    EXPECT_THROW(lausitz_law(1e-15), BadCase);
    const GritLaw law = lausitz_law();
    EXPECT_THROW(law.start(Vector6::Zero(), -0.1), BadCase);
}

}  // namespace
