// SPDX-License-Identifier: BSD-3-Clause
// Every kind of step of test.inp against what its description says, worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "support/folder.hpp"

namespace {

using element::Matrix6;
using element::Vector6;

Vector6 row(double a, double b, double c, double d = 0, double e = 0, double f = 0) {
    return (Vector6() << a, b, c, d, e, f).finished();
}

// Row r of the restrictions: factors of stress, of strain.
void expect_row(const element::Restrictions& rows, int r, const Vector6& stress,
                const Vector6& strain) {
    EXPECT_LT((rows.stress.row(r).transpose() - stress).norm(), 1e-15) << "stress, row " << r;
    EXPECT_LT((rows.strain.row(r).transpose() - strain).norm(), 1e-15) << "strain, row " << r;
}

const Vector6 none = Vector6::Zero();
Vector6 unit(int i) { return Vector6::Unit(i); }

element::Linear linear(const std::string& step) {
    return std::get<element::Linear>(parse_one(step).kind);
}

TEST(IncrementalDriverSteps, LinearLoadReadsSixComponents) {
    const element::Step step = parse_one("*LinearLoad\n100 7 2.5\n*Cartesian\n1 -10\n0 -0.01\n"
                                         "0 0.02\n1 3\n0 0\n0 1.d-3\n");
    EXPECT_EQ(step.increments, 100);
    EXPECT_EQ(step.duration, 2.5);
    EXPECT_EQ(step.name, "*LinearLoad");
    const auto load = std::get<element::Linear>(step.kind);
    EXPECT_EQ(load.change, row(-10, -0.01, 0.02, 3, 0, 1e-3));
    expect_row(load.rows, 0, unit(0), none);
    expect_row(load.rows, 1, none, unit(1));
    expect_row(load.rows, 3, unit(3), none);
    expect_row(load.rows, 5, none, unit(5));
}

TEST(IncrementalDriverSteps, OedometersKeepTheSidesStill) {
    const auto by_strain = linear("*OedometricE1\n10 5 1\n-0.05\n");
    EXPECT_EQ(by_strain.change, row(-0.05, 0, 0));
    EXPECT_EQ(by_strain.rows.strain, Matrix6::Identity());
    const auto by_stress = linear("*OedometricS1\n10 5 1\n-190\n");
    EXPECT_EQ(by_stress.change, row(-190, 0, 0));
    expect_row(by_stress.rows, 0, unit(0), none);
    for (int r = 1; r < 6; ++r) expect_row(by_stress.rows, r, none, unit(r));
}

TEST(IncrementalDriverSteps, TriaxialTestsKeepTheCellPressure) {
    const auto by_strain = linear("*TriaxialE1\n10 5 1\n-0.2\n");
    EXPECT_EQ(by_strain.change, row(-0.2, 0, 0));
    expect_row(by_strain.rows, 0, none, unit(0));
    expect_row(by_strain.rows, 1, unit(1), none);
    expect_row(by_strain.rows, 2, unit(2), none);
    expect_row(by_strain.rows, 3, none, unit(3));
    const auto by_stress = linear("*TriaxialS1\n10 5 1\n-50\n");
    for (int r = 0; r < 6; ++r)
        expect_row(by_stress.rows, r, r < 3 ? unit(r) : none, r < 3 ? none : unit(r));
}

TEST(IncrementalDriverSteps, UndrainedTriaxialTestsDriveDistortionOrDeviator) {
    const Vector6 volume = row(-1, -1, -1), distortion = row(-2.0 / 3, 1.0 / 3, 1.0 / 3),
                  side = row(0, -0.5, 0.5), deviator = row(-1, 0.5, 0.5);
    const auto by_strain = linear("*TriaxialUEq\n10 5 1\n0.03\n");
    EXPECT_EQ(by_strain.change, row(0, 0.03, 0));
    expect_row(by_strain.rows, 0, none, volume);
    expect_row(by_strain.rows, 1, none, distortion);
    expect_row(by_strain.rows, 2, none, side);
    const auto by_stress = linear("*TriaxialUq\n10 5 1\n40\n");
    EXPECT_EQ(by_stress.change, row(0, 40, 0));
    expect_row(by_stress.rows, 0, none, volume);
    expect_row(by_stress.rows, 1, deviator, none);
    expect_row(by_stress.rows, 2, none, side);
}

TEST(IncrementalDriverSteps, RelaxationKeepsStrainCreepKeepsStress) {
    EXPECT_EQ(linear("*PureRelaxation\n10 5 1\n").rows.strain, Matrix6::Identity());
    EXPECT_EQ(linear("*PureCreep\n10 5 1\n").rows.stress, Matrix6::Identity());
    const auto undrained = linear("*UndrainedCreep\n10 5 1\n");
    EXPECT_EQ(undrained.change, none);
    expect_row(undrained.rows, 0, none, row(-1, -1, -1));
    expect_row(undrained.rows, 1, row(-1, 0.5, 0.5), none);
    expect_row(undrained.rows, 2, row(0, -1, 1), none);
    for (int r = 3; r < 6; ++r) expect_row(undrained.rows, r, unit(r), none);
}

TEST(IncrementalDriverSteps, VariablesAreWorkConjugateAndIsomorphicOnesOrthonormal) {
    for (const char* name : {"*Cartesian", "*Roscoe", "*RoscoeIsomorph", "*Rendulic"}) {
        const std::string head = std::string("*LinearLoad\n1 5 1\n") + name + "\n";
        const Matrix6 stress = linear(head + "1 0\n1 0\n1 0\n1 0\n1 0\n1 0\n").rows.stress;
        const Matrix6 strain = linear(head + "0 0\n0 0\n0 0\n0 0\n0 0\n0 0\n").rows.strain;
        EXPECT_LT((stress.transpose() * strain - Matrix6::Identity()).norm(), 1e-15) << name;
        const bool orthonormal = (stress - strain).isZero(0.0);
        EXPECT_EQ(orthonormal, std::string(name) != "*Roscoe") << name;
    }
    const double s2 = std::sqrt(2.0), s3 = std::sqrt(3.0), s6 = std::sqrt(6.0);
    const std::string all = "1 0\n1 0\n1 0\n1 0\n1 0\n1 0\n";
    const auto isomorph = linear("*LinearLoad\n1 5 1\n*RoscoeIsomorph\n" + all).rows;
    expect_row(isomorph, 0, row(-1 / s3, -1 / s3, -1 / s3), none);
    expect_row(isomorph, 1, row(-2 / s6, 1 / s6, 1 / s6), none);
    expect_row(isomorph, 2, row(0, -1 / s2, 1 / s2), none);
    const auto rendulic = linear("*LinearLoad\n1 5 1\n*Rendulic\n" + all).rows;
    expect_row(rendulic, 0, row(-1, 0, 0), none);
    expect_row(rendulic, 1, row(0, -1 / s2, -1 / s2), none);
    expect_row(rendulic, 2, row(0, -1 / s2, 1 / s2), none);
}

TEST(IncrementalDriverSteps, CirculatingLoadReadsAmplitudePhaseAndDrift) {
    const auto load = std::get<element::Circulating>(
        parse_one("*CirculatingLoad\n100 5 1\n*Roscoe\n0 0 0 0\n1 20 1.5708 -3\n0 0 0 0\n0 0 0 0\n"
                  "0 0 0 0\n0 1e-3 0 0\n")
            .kind);
    EXPECT_EQ(load.amplitude, row(0, 20, 0, 0, 0, 1e-3));
    EXPECT_EQ(load.phase, row(0, 1.5708, 0));
    EXPECT_EQ(load.drift, row(0, -3, 0));
    EXPECT_EQ(load.cycles, 1.0);
    EXPECT_TRUE(load.rate_at_midpoint);
    expect_row(load.rows, 1, row(-1, 0.5, 0.5), none);
}

TEST(IncrementalDriverSteps, DeformationGradientComesAs112233122113312332) {
    const auto load = std::get<element::DeformationGradient>(
        parse_one("*DeformationGradient\n10 5 1\n1.1\n1.2\n1.3\n0.12\n0.21\n0.13\n0.31\n0.23\n"
                  "0.32\n")
            .kind);
    element::Matrix3 F;
    F << 1.1, 0.12, 0.13, 0.21, 1.2, 0.23, 0.31, 0.32, 1.3;
    EXPECT_EQ(load.F, F);
    EXPECT_EQ(load.path, element::DeformationGradient::Path::linear);
    EXPECT_EQ(load.increments, element::DeformationGradient::Increments::hughes_winget);
}

TEST(IncrementalDriverSteps, ObeyRestrictionsReadsAnySumOfStressAndStrain) {
    const auto load = linear("*ObeyRestrictions\n10 5 1\n"
                             "-sd1 + sd2 + 3.0*sd3 = -10 ! a remark = 3\n"
                             "1.0e-3 * sd1 - 2*ed1 = 0\n"
                             "ed2 - ed3 = - 0.25  # with a blank behind the sign\n"
                             "sd4=1\ned5 = 0\n 2.5d1*ed6+ed6 =0\n");
    expect_row(load.rows, 0, row(-1, 1, 3), none);
    expect_row(load.rows, 1, row(1e-3, 0, 0), row(-2, 0, 0));
    expect_row(load.rows, 2, none, row(0, 1, -1));
    expect_row(load.rows, 3, unit(3), none);
    expect_row(load.rows, 4, none, unit(4));
    expect_row(load.rows, 5, none, 26.0 * unit(5));
    EXPECT_EQ(load.change, row(-10, 0, -0.25, 1, 0, 0));
}

TEST(IncrementalDriverSteps, PerturbationsTurnInThePlaneOfTheFirstTwoVariables) {
    const auto by_stress = std::get<element::Perturbations>(
        parse_one("*PerturbationsS\n36 5 1\n*Rendulic\n2.0\n").kind);
    EXPECT_EQ(by_stress.first, row(2, 0, 0));
    EXPECT_EQ(by_stress.second, row(0, 2, 0));
    expect_row(by_stress.rows, 0, row(-1, 0, 0), none);
    const auto by_strain = std::get<element::Perturbations>(
        parse_one("*PerturbationsE\n36 5 1\n*RoscoeIsomorph\n1e-4\n").kind);
    EXPECT_EQ(by_strain.second, row(0, 1e-4, 0));
    EXPECT_EQ(by_strain.rows.stress, Matrix6::Zero());
}

TEST(IncrementalDriverSteps, RandomWalkReadsTheLargestIncrements) {
    const auto walk = std::get<element::RandomWalk>(
        parse_one("*RandomWalk\n50 5 1\n*Cartesian\n0 1e-4\n0 1e-4\n1 2\n0 0\n0 0\n0 -1e-5\n")
            .kind);
    EXPECT_EQ(walk.amplitude, row(1e-4, 1e-4, 2, 0, 0, 1e-5));
    expect_row(walk.rows, 2, unit(2), none);
}

}  // namespace
