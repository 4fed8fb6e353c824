// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <element/errors.hpp>

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

GritLaw wet_law(double K_w, double largest_tension, double tolerance = 1e-8) {
    GritLawOptions options;
    options.tolerance = tolerance;
    options.water_bulk_modulus = K_w;
    options.largest_tension = largest_tension;
    return GritLaw(lausitz(), options);
}

Sample wet_sample(const GritLaw& law, double p, double e, double p_w) {
    Sample sample;
    sample.point = law.start(-p * unit_tensor(), e, p_w);
    law.mobilise(sample.point, -unit_tensor(), 1.0);
    return sample;
}

TEST(PoreWater, OfItsOwnBulkModulusIsCompressedWithThePores) {
    const double K_w = 2.2e6;
    const GritLaw law = wet_law(K_w, std::numeric_limits<double>::infinity());
    Sample sample = wet_sample(law, 100.0, 0.75, 200.0);
    const History history = simulate(law, sample, {triaxial_drained(-0.01)});
    ASSERT_FALSE(history.failure) << history.failure->message;
    EXPECT_GT(history.records.back().pore_pressure, 210.0);
    for (const Record& r : history.records) {
        EXPECT_NEAR(r.total_stress[2], -300.0, 1e-6);
        EXPECT_NEAR(r.pore_pressure, 200.0 - K_w * std::log(r.void_ratio / 0.75), 1e-6);
        EXPECT_NEAR((r.effective_stress - r.total_stress)[0], r.pore_pressure, 1e-9);
    }
}

// Dense sand dilates: once the water bears no more, the sand drains into its cavities at a constant effective stress
// around it, and what was total stress is effective stress and the largest tension.
TEST(PoreWater, CavitatesInDenseSandAndThenHoldsItsTension) {
    const GritLaw law = wet_law(2.2e6, 100.0);
    Sample sample = wet_sample(law, 100.0, 0.55, 0.0);
    const History history = simulate(law, sample, {triaxial_drained(-0.2)});
    ASSERT_FALSE(history.failure) << history.failure->message;
    const Record& end = history.records.back();
    EXPECT_EQ(end.pore_pressure, -100.0);
    EXPECT_NEAR(end.effective_stress[2], -200.0, 1e-6);
    EXPECT_NEAR(end.total_stress[2], -100.0, 1e-6);
    EXPECT_GT(end.void_ratio, 0.552);
    EXPECT_LT(end.state[GritLaw::pore_pressure_index], -1000.0);  // the cavity
    const History back =
        simulate(law, sample, {isotropic_strain(1.05 * std::log(1.55 / (1.0 + end.void_ratio)))});
    ASSERT_FALSE(back.failure) << back.failure->message;
    EXPECT_GT(back.records.back().pore_pressure, 0.0);
}

TEST(PoreWater, HasOneStiffnessAndAPressureOnlyWhereItIs) {
    GritLawOptions options;
    options.water_stiffness = options.water_bulk_modulus = 1e6;
    EXPECT_THROW(GritLaw(lausitz(), options), BadCase);
    EXPECT_THROW(wet_law(-1.0, 100.0), BadCase);
    EXPECT_THROW(wet_law(1.0, -100.0), BadCase);
    EXPECT_THROW(lausitz_law().start(-unit_tensor(), 0.6, 10.0), BadCase);
}

}  // namespace
