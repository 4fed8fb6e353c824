// SPDX-License-Identifier: BSD-3-Clause
#include <element/gradient.hpp>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

#include "support/elastic.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

Matrix3 rotation(double angle, const Eigen::Vector3d& axis) {
    return Matrix3(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix());
}

Step turned(const Matrix3& F, int increments, bool as_incremental_driver = false) {
    DeformationGradient kind;
    kind.F = F;
    if (as_incremental_driver) {
        kind.path = DeformationGradient::Path::linear;
        kind.increments = DeformationGradient::Increments::hughes_winget;
    }
    Step step;
    step.kind = kind;
    step.increments = increments;
    return step;
}

// Sheared, so that stress and h have no symmetry left to hide behind.
Sample sheared_sample(const GritLaw& law) {
    Sample sample = isotropic_sample(law, 100.0, 0.6);
    Vector6 change;
    change << -0.002, 0.0, 0.001, 0.0015, -0.0005, 0.001;
    simulate(law, sample, {component_control({}, change)});
    return sample;
}

Vector6 h_of(const Sample& sample) { return Vector6::Map(sample.point.state.data()); }

TEST(DeformationGradient, ThatOnlyRotatesTurnsStressAndMemoryAndStrainsNothing) {
    const GritLaw law = lausitz_law();
    const Sample start = sheared_sample(law);
    const Matrix3 R = rotation(std::acos(0.0), {1.0, 2.0, -0.5});
    for (const int increments : {10, 1000}) {
        for (const auto rule : {DeformationGradient::Increments::polar,
                                DeformationGradient::Increments::hughes_winget}) {
            Sample sample = start;
            Step step = turned(R, increments);
            std::get<DeformationGradient>(step.kind).increments = rule;
            const History history = simulate(law, sample, {step});
            ASSERT_FALSE(history.failure) << history.failure->message;
            const Matrix3 T = stress_tensor(sample.point.stress);
            const Matrix3 expected = R * stress_tensor(start.point.stress) * R.transpose();
            EXPECT_LE((T - expected).norm(), 1e-12 * expected.norm()) << increments;
            const Matrix3 h = strain_tensor(h_of(sample));
            const Matrix3 expected_h = R * strain_tensor(h_of(start)) * R.transpose();
            EXPECT_LE((h - expected_h).norm(), 1e-12 * expected_h.norm()) << increments;
            EXPECT_NEAR(sample.point.state[GRIT_SAND_VOID_RATIO],
                        start.point.state[GRIT_SAND_VOID_RATIO], 1e-12);
        }
    }
}

// Rotation by 90 degrees along the straight line of incrementalDriver passes through F = (1 + R)/2,
// which halves areas: the sample is compressed and released.
TEST(DeformationGradient, AlongAStraightLineIsAnotherMotionThanARotation) {
    const Matrix3 R = rotation(std::acos(0.0), {0.0, 0.0, 1.0});
    DeformationGradient kind = std::get<DeformationGradient>(turned(R, 1, true).kind);
    EXPECT_NEAR(gradient_at(kind, 0.5).determinant(), 0.5, 1e-12);
    EXPECT_NEAR((gradient_at(kind, 1.0) - R).norm(), 0.0, 1e-12);
}

TEST(DeformationGradient, LeadsToOneStressByEitherRuleAsIncrementsShrink) {
    Matrix3 F;
    F << 1.02, 0.10, 0.0, -0.05, 0.97, 0.02, 0.0, 0.01, 1.01;
    const Elastic law;
    const auto stress_after = [&](int increments, DeformationGradient::Increments rule) {
        Sample sample;
        sample.point = elastic_point();
        sample.point.stress << -5.0, -2.0, -1.0, 0.5, 0.0, 0.3;
        Step step = turned(F, increments, true);
        std::get<DeformationGradient>(step.kind).increments = rule;
        simulate(law, sample, {step});
        return sample.point.stress;
    };
    constexpr auto midpoint = DeformationGradient::Increments::hughes_winget;
    constexpr auto polar = DeformationGradient::Increments::polar;
    double last = 1e300;
    for (const int increments : {10, 100, 1000}) {
        const Vector6 a = stress_after(increments, midpoint), b = stress_after(increments, polar);
        EXPECT_LT((a - b).norm(), 0.11 * last);
        last = (a - b).norm();
    }
    EXPECT_LT(last, 1e-4 * stress_after(1000, polar).norm());
}

TEST(DeformationGradient, ThatStretchesAlongTheAxesIsLogarithmicStrain) {
    Matrix3 F = Matrix3::Identity();
    F.diagonal() << 0.95, 1.02, 1.01;
    const GritLaw law = lausitz_law(1e-10);
    Sample by_gradient = isotropic_sample(law, 100.0, 0.6), by_strain = by_gradient;
    Vector6 change = Vector6::Zero();
    change.head<3>() << std::log(0.95), std::log(1.02), std::log(1.01);
    simulate(law, by_gradient, {turned(F, 40)});
    Step strain = component_control({}, change);
    strain.increments = 40;
    simulate(law, by_strain, {strain});
    EXPECT_LE((by_gradient.strain - change).norm(), 1e-13);
    EXPECT_LE((by_gradient.point.stress - by_strain.point.stress).norm(),
              1e-8 * by_strain.point.stress.norm());
    // Void ratio: (1 + e) grows with det F.
    EXPECT_NEAR(1.0 + by_gradient.point.state[GRIT_SAND_VOID_RATIO], 1.6 * F.determinant(), 1e-12);
}

// F = R U: what was stretched along the axes lies along the turned axes at the end.
TEST(DeformationGradient, GivesStrainInTheConfigurationAtTheEnd) {
    const Matrix3 R = rotation(0.7, {1.0, -2.0, 3.0});
    const Eigen::Vector3d stretch(1.05, 0.97, 1.01);
    const Matrix3 F = R * Matrix3(stretch.asDiagonal());
    const Motion motion =
        motion_between(Matrix3::Identity(), F, DeformationGradient::Increments::polar);
    const Eigen::Vector3d logarithm = stretch.array().log();
    const Matrix3 expected = R * Matrix3(logarithm.asDiagonal()) * R.transpose();
    EXPECT_LE((strain_tensor(motion.strain) - expected).norm(), 1e-14);
    EXPECT_LE((motion.rotation - R).norm(), 1e-14);
}

TEST(DeformationGradient, TurnsTheTotalStrainToo) {
    const Elastic law;
    Sample sample;
    sample.point = elastic_point();
    simulate(law, sample,
             {oedometer_strain(-0.01), turned(rotation(std::acos(0.0), {0.0, 0.0, 1.0}), 10)});
    EXPECT_NEAR(sample.strain[0], 0.0, 1e-14);
    EXPECT_NEAR(sample.strain[1], -0.01, 1e-14);
    EXPECT_NEAR(sample.point.stress[1], law.C(0, 0) * -0.01, 1e-10);
}

TEST(DeformationGradient, StartsFromTheIdentityInEveryStep) {
    Matrix3 F = Matrix3::Identity();
    F(0, 0) = 0.99;
    const GritLaw law = lausitz_law();
    Sample sample = isotropic_sample(law, 100.0, 0.6);
    simulate(law, sample, {turned(F, 10), turned(F, 10)});
    EXPECT_NEAR(sample.strain[0], 2.0 * std::log(0.99), 1e-13);
}

}  // namespace
