// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/elastic.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

constexpr Control e = Control::strain, s = Control::stress;

History run(const Step& step, const Settings& settings = {}) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.7);
    History history = simulate(law, sample, {step}, settings);
    EXPECT_FALSE(history.failure) << history.failure->message;
    return history;
}

Step with_rows(const Restrictions& rows, const Vector6& change, int increments = 100) {
    Linear kind;
    kind.rows = rows;
    kind.change = change;
    Step step;
    step.kind = kind;
    step.increments = increments;
    return step;
}

void expect_same(const History& a, const History& b, double limit) {
    ASSERT_EQ(a.records.size(), b.records.size());
    for (std::size_t i = 0; i < a.records.size(); ++i) {
        const Record &x = a.records[i], &y = b.records[i];
        EXPECT_LE((x.stress - y.stress).norm(), limit * x.stress.norm()) << i;
        EXPECT_LE((x.strain - y.strain).norm(), limit) << i;
    }
}

TEST(Restrictions, ThatSayTheSameInOtherWordsGiveTheSamePath) {
    Vector6 change = Vector6::Zero();
    change[0] = -0.02;
    const Step drained = component_control({e, s, s, e, e, e}, change);
    Restrictions mixed = mixed_control({e, s, s, e, e, e});
    // Rows of each kind combined and scaled: the same six-dimensional set.
    mixed.strain.row(0) *= -7.0;
    mixed.stress.row(1) += 3.0 * mixed.stress.row(2);
    mixed.stress.row(2) -= 0.5 * mixed.stress.row(1);
    mixed.strain.row(3) += 2.0 * mixed.strain.row(4);
    Vector6 scaled = change;
    scaled[0] *= -7.0;
    Step step = with_rows(mixed, scaled);
    expect_same(run(drained), run(step), 1e-8);
}

TEST(Restrictions, MayMixStressAndStrainInOneRow) {
    // A spring along axis 22, as a membrane or a soft wall: d sigma_22 = -k d eps_22.
    constexpr double k = 5000.0;
    Restrictions rows = mixed_control({e, s, s, e, e, e});
    rows.strain(1, 1) = k;
    Vector6 change = Vector6::Zero();
    change[0] = -0.02;
    const History history = run(with_rows(rows, change));
    const Record& end = history.records.back();
    EXPECT_GT(end.strain[1], 1e-3);
    EXPECT_NEAR(end.stress[1] + 100.0, -k * end.strain[1], 1e-6);
    EXPECT_NEAR(end.stress[2], -100.0, 1e-6);
}

// The manual's example for *ObeyRestrictions.
TEST(Restrictions, HoldInTheFormThatIncrementalDriverKnows) {
    Restrictions rows = mixed_control({s, e, e, e, e, e});
    rows.stress.row(0) << -1.0, 1.0, 3.0, 0.0, 0.0, 0.0;  // -sd1 + sd2 + 3.0*sd3 = -10
    rows.strain.row(1) << 0.0, 1.0, -1.0, 0.0, 0.0, 0.0;  // ed2 - ed3 = 0
    rows.strain.row(2) << 1.0, -1.0, 0.0, 0.0, 0.0, 0.0;  // ed1 - ed2 = 1e-3
    Vector6 change;
    change << -10.0, 0.0, 1e-3, 0.0, 0.0, 0.0;
    const History history = run(with_rows(rows, change));
    const Vector6 stress = history.records.back().stress - history.records.front().stress;
    const Vector6 strain = history.records.back().strain;
    EXPECT_NEAR(-stress[0] + stress[1] + 3.0 * stress[2], -10.0, 1e-6);
    EXPECT_NEAR(strain[1] - strain[2], 0.0, 1e-12);
    EXPECT_NEAR(strain[0] - strain[1], 1e-3, 1e-12);
}

TEST(Restrictions, OfEachSetOfVariablesAreWorkConjugate) {
    Vector6 stress, strain;
    stress << -3.0, -1.0, -2.0, 0.5, 0.25, -0.75;
    strain << 0.01, -0.02, 0.005, 0.003, -0.002, 0.001;
    for (const Variables v :
         {Variables::cartesian, Variables::roscoe, Variables::roscoe_isomorph, Variables::rendulic})
        EXPECT_NEAR((stress_variables(v) * stress).dot(strain_variables(v) * strain),
                    stress.dot(strain), 1e-15);
}

TEST(Restrictions, OfRoscoeHoldMeanStressWhileTheSampleIsSheared) {
    Linear kind;
    kind.rows = mixed_control({s, e, s, e, e, e}, Variables::roscoe);
    kind.change[1] = 0.01;  // conjugate of q: -2/3 e1 + (e2+e3)/3
    Step step;
    step.kind = kind;
    const Record end = run(step).records.back();
    EXPECT_NEAR(end.stress.head<3>().sum() / 3.0, -100.0, 1e-6);
    EXPECT_NEAR(end.stress[1], end.stress[2], 1e-6);
    EXPECT_LT(end.stress[0], end.stress[1] - 50.0);
}

TEST(Restrictions, DoNotLetTheResidualsOfIncrementsAddUp) {
    Step step = triaxial_drained(-0.02);
    step.increments = 20000;
    Settings coarse;
    coarse.tolerance = 1e-5;
    const Record end = run(step, coarse).records.back();
    EXPECT_NEAR(end.stress[1], -100.0, 1e-5 * end.stress.norm());
    EXPECT_NEAR(end.strain[0], -0.02, 1e-14);
}

TEST(Restrictions, TakeAnElasticLawThereInOneIteration) {
    const Elastic law(1000.0, 0.25);
    Sample sample;
    sample.point = elastic_point();
    Step step = triaxial_drained(-0.01);
    step.increments = 1;
    const History history = simulate(law, sample, {step});
    EXPECT_EQ(history.records.back().iterations, 1);
    EXPECT_NEAR(sample.point.stress[0], -10.0, 1e-12);
    EXPECT_NEAR(sample.strain[2], 0.0025, 1e-15);
}

}  // namespace
