// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/elastic.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

TEST(UndrainedStep, RecordsTheDifferenceOfTotalAndEffectiveStress) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.8);
    const History history = simulate(law, sample, {triaxial_undrained(-0.02)});
    ASSERT_FALSE(history.failure) << history.failure->message;
    for (const Record& r : history.records) {
        EXPECT_NEAR(r.total_stress[2], -100.0, 1e-6);
        EXPECT_NEAR(r.pore_pressure, r.effective_stress[2] + 100.0, 1e-6);
        EXPECT_NEAR(r.strain.head<3>().sum(), 0.0, 1e-15);
        EXPECT_NEAR(r.void_ratio, 0.8, 1e-12);
    }
    EXPECT_GT(history.records.back().pore_pressure, 10.0);  // loose sand contracts
    EXPECT_EQ(sample.pore_pressure, history.records.back().pore_pressure);
}

TEST(UndrainedStep, GivesTheEffectivePathOfConstantVolume) {
    const GritLaw law = lausitz_law(1e-10);
    Sample undrained = isotropic_sample(law, 100.0, 0.6), by_strain = undrained;
    simulate(law, undrained, {triaxial_undrained(-0.03)});
    simulate(law, by_strain, {constant_volume_triaxial(-0.03)});
    EXPECT_LE((undrained.point.stress - by_strain.point.stress).norm(),
              1e-8 * by_strain.point.stress.norm());
}

// Incompressible water: all of an isotropic load goes into it, Skempton's B = 1.
TEST(UndrainedStep, PutsAnIsotropicLoadIntoTheWater) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.6);
    Step step = isotropic_stress(-50.0);
    step.undrained = true;
    const History history = simulate(law, sample, {step});
    ASSERT_FALSE(history.failure) << history.failure->message;
    EXPECT_NEAR(sample.pore_pressure, 50.0, 1e-6);
    EXPECT_NEAR(sample.point.stress[0], -100.0, 1e-6);
}

// Elastic, undrained, axial total stress q: p_w = q/3.
TEST(UndrainedStep, SharesAnAxialLoadAsElasticityDoes) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    simulate(law, sample, {triaxial_undrained_stress(-9.0)});
    EXPECT_NEAR(sample.pore_pressure, 3.0, 1e-9);
    EXPECT_NEAR(sample.strain.head<3>().sum(), 0.0, 1e-15);
}

TEST(UndrainedStep, MayFollowAndPrecedeDrainedOnes) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.75);
    const History history = simulate(
        law, sample,
        {triaxial_undrained(-0.002), triaxial_drained(-0.002), triaxial_undrained(-0.002)});
    ASSERT_FALSE(history.failure) << history.failure->message;
    const auto& r = history.records;
    EXPECT_EQ(r[200].pore_pressure, r[100].pore_pressure);  // nobody opened a valve: kept
    EXPECT_NEAR(r[300].total_stress[2], r[200].total_stress[2], 1e-6);
}

TEST(DrainingStep, LetsTheWaterOutUnderTheTotalStressThatActs) {
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.8);
    const History history = simulate(law, sample, {triaxial_undrained(-0.01), drainage()});
    ASSERT_FALSE(history.failure) << history.failure->message;
    const Record &before = history.records[100], &half = history.records[150];
    const Record& after = history.records.back();
    EXPECT_GT(before.pore_pressure, 10.0);
    EXPECT_NEAR(half.pore_pressure, 0.5 * before.pore_pressure, 1e-9);
    EXPECT_EQ(after.pore_pressure, 0.0);
    EXPECT_LE((after.total_stress - before.total_stress).norm(), 1e-6);
    EXPECT_LT(after.strain.head<3>().sum(), -1e-4);  // it consolidates
    EXPECT_LE((after.effective_stress - after.total_stress).norm(), 0.0);
}

TEST(PoreWater, OfTheLawApproachesTheIncompressibleWaterOfTheDriver) {
    const GritLaw dry = lausitz_law(1e-8);
    Sample incompressible = isotropic_sample(dry, 100.0, 0.75);
    simulate(dry, incompressible, {triaxial_undrained(-0.01)});
    double last = 1e300;
    for (const double K_w : {1e5, 1e6, 1e7}) {
        GritLawOptions options;
        options.tolerance = 1e-8;
        options.water_stiffness = K_w;
        const GritLaw wet(lausitz(), options);
        Sample sample = isotropic_sample(wet, 100.0, 0.75);
        const History history = simulate(wet, sample, {triaxial_drained(-0.01)});
        ASSERT_FALSE(history.failure) << history.failure->message;
        const Record& end = history.records.back();
        EXPECT_NEAR(end.total_stress[2], -100.0, 1e-6);
        EXPECT_NEAR(end.pore_pressure, -K_w * end.strain.head<3>().sum(), 1e-6);
        EXPECT_LE(
            (end.effective_stress - end.total_stress - end.pore_pressure * unit_tensor()).norm(),
            1e-9);
        const double difference = std::abs(end.pore_pressure - incompressible.pore_pressure);
        EXPECT_LT(difference, 0.2 * last);
        last = difference;
    }
    EXPECT_LT(last, 0.05);  // kPa
}

}  // namespace
