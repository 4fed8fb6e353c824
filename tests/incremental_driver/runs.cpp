// SPDX-License-Identifier: BSD-3-Clause
// Steps carried out: strains, stresses and rows that can be worked out without the law.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include <element/incremental_driver/run.hpp>

#include "support/folder.hpp"

namespace {

// Columns of the output.
enum : std::size_t { time_1 = 0, time_2 = 1, stran = 2, stress = 8, statev = 14 };

struct Result {
    incremental_driver::Report report;
    Table rows;
};

Result run(const std::string& steps) {
    const Folder folder;
    Folder::fill(folder);
    folder.write("test.inp", "result.out\n" + steps);
    Result out;
    out.report = incremental_driver::run({folder.path(), {}, {}});
    out.rows = read_table(folder.path("result.out"));
    return out;
}

double pressure(const std::vector<double>& row) {
    return -(row[stress] + row[stress + 1] + row[stress + 2]) / 3.0;
}

TEST(IncrementalDriverOutput, HasNamesHeadingStartAndColumnsOfEqualWidth) {
    const Folder folder;
    Folder::fill(folder);
    folder.write("test.inp", "result.out # dense sand\n*PureRelaxation\n2 5 8.0\n");
    incremental_driver::run({folder.path(), {}, {}});
    std::ifstream file(folder.path("result.out"));
    std::string names, heading, first;
    std::getline(file, names);
    std::getline(file, heading);
    std::getline(file, first);
    EXPECT_EQ(heading, " dense sand");
    EXPECT_EQ(names.size(), first.size());
    EXPECT_EQ(names.size(), 22u * (2 + 6 + 6 + 14));
    for (const char* name : {"time(1)", "time(2)", "stran(6)", "stress(6)", "statev(14)"})
        EXPECT_NE(names.find(name), std::string::npos) << name;
    const Table rows = read_table(folder.path("result.out"), 2);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0][stress], -100.0);
    EXPECT_EQ(rows[0][statev + 6], 0.7);
    EXPECT_EQ(rows[2][time_1], 8.0);
    EXPECT_EQ(rows[2][time_2], 8.0);
}

TEST(IncrementalDriverOutput, KeepsTheFirstOfEvery) {
    const Table rows = run("*OedometricE1\n10 5 10 : 4\n-0.001\n").rows;
    ASSERT_EQ(rows.size(), 1u + 3u);  // start, increments 1, 5, 9
    EXPECT_NEAR(rows[1][stran], -1e-4, 1e-15);
    EXPECT_NEAR(rows[3][stran], -9e-4, 1e-15);
}

TEST(IncrementalDriverRun, CreepAndRelaxationLeaveARateIndependentSandAlone) {
    const Table rows =
        run("*PureCreep\n2 5 1\n*PureRelaxation\n2 5 1\n*UndrainedCreep\n2 5 1\n").rows;
    for (const auto& row : rows)
        for (std::size_t c = stran; c < statev; ++c) EXPECT_NEAR(row[c], rows[0][c], 1e-9);
}

TEST(IncrementalDriverRun, RepeatedCyclesComeBackToTheStrainTheyStartedFrom) {
    const Table rows = run("*Repetition\n2 3\n*OedometricE1\n5 5 1\n-1e-3\n*OedometricE1\n5 5 1\n"
                           "1e-3\n")
                           .rows;
    ASSERT_EQ(rows.size(), 31u);
    for (std::size_t cycle = 0; cycle < 3; ++cycle) {
        EXPECT_NEAR(rows[10 * cycle + 5][stran], -1e-3, 1e-15);
        EXPECT_NEAR(rows[10 * cycle + 10][stran], 0.0, 1e-15);
    }
    EXPECT_NEAR(rows[30][time_2], 6.0, 1e-12);
}

TEST(IncrementalDriverRun, UndrainedTriaxialKeepsTheVolume) {
    const Table rows = run("*TriaxialUEq\n20 5 1\n0.002\n*TriaxialUq\n20 10 1\n5\n").rows;
    EXPECT_NEAR(rows[20][stran], -0.002, 1e-12);
    EXPECT_NEAR(rows[20][stran + 1], 0.001, 1e-12);
    const auto q = [&](std::size_t i) { return -rows[i][stress] + rows[i][stress + 1]; };
    EXPECT_NEAR(q(40) - q(20), 5.0, 1e-6);
    for (const auto& row : rows)
        EXPECT_NEAR(row[stran] + row[stran + 1] + row[stran + 2], 0.0, 1e-12);
}

TEST(IncrementalDriverRun, RestrictionsHoldThePressure) {
    const Table rows = run("*ObeyRestrictions\n40 10 1\nsd1 + sd2 + sd3 = 0\nsd2 - sd3 = 0\n"
                           "ed1 = -0.01\ned4 = 0\ned5 = 0\ned6 = 0\n")
                           .rows;
    EXPECT_NEAR(rows.back()[stran], -0.01, 1e-12);
    for (const auto& row : rows) EXPECT_NEAR(pressure(row), 100.0, 1e-6);
}

// The rate in the middle of each increment makes the amplitude larger by x/sin x, x = pi/ninc.
TEST(IncrementalDriverRun, CirculatingLoadGoesRoundOnce) {
    const Table rows = run("*CirculatingLoad\n40 5 1\n*Cartesian\n0 0 0 0\n0 0 0 0\n0 0 0 0\n"
                           "0 1e-3 0 0\n0 1e-3 1.5707963267948966 4e-4\n0 0 0 0\n")
                           .rows;
    const double x = std::numbers::pi / 40, larger = x / std::sin(x);
    EXPECT_NEAR(rows[10][stran + 3], 1e-3 * larger, 1e-15);
    EXPECT_NEAR(rows[30][stran + 3], -1e-3 * larger, 1e-15);
    EXPECT_NEAR(rows[40][stran + 3], 0.0, 1e-15);
    EXPECT_NEAR(rows[20][stran + 4], -2e-3 * larger + 2e-4, 1e-15);
    EXPECT_NEAR(rows[40][stran + 4], 4e-4, 1e-15);
}

TEST(IncrementalDriverRun, EveryDeformationGradientStartsFromOne) {
    const std::string stretch = "*DeformationGradient\n100 5 1\n0.99\n1\n1\n0\n0\n0\n0\n0\n0\n";
    const Table rows = run(stretch + stretch).rows;
    // Midpoint rule of ln, error (dF)^2/12 of each step's strain
    EXPECT_NEAR(rows[100][stran], std::log(0.99), 1e-10);
    EXPECT_NEAR(rows[200][stran], 2.0 * std::log(0.99), 1e-10);
}

TEST(IncrementalDriverRun, ARigidRotationTurnsStressAndStrainsNothingMuch) {
    const Table rows =
        run("*TriaxialE1\n20 10 1\n-0.005\n*DeformationGradient\n100 5 1\n1\n1\n1\n0.1\n-0.1\n"
            "0\n0\n0\n0\n")
            .rows;
    // 1 + x W is a rotation and a stretch by sqrt(1 + x^2 w^2).
    const double angle = std::atan(0.1), stretch = 0.5 * std::log(1.01);
    const auto &before = rows[20], &after = rows[120];
    const double turned = before[stran] * std::pow(std::cos(angle), 2) +
                          before[stran + 1] * std::pow(std::sin(angle), 2);
    EXPECT_NEAR(after[stran], turned + stretch, 1e-8);
    EXPECT_NE(after[stress + 3], 0.0);
}

TEST(IncrementalDriverRun, PerturbationsAreUndoneBeforeTheNext) {
    const Result result = run("*PerturbationsE\n4 5 1\n*Rendulic\n1e-4\n*PureRelaxation\n1 5 1\n");
    const Table& rows = result.rows;
    ASSERT_EQ(rows.size(), 6u);
    const double side = 1e-4 / std::sqrt(2.0);
    EXPECT_NEAR(rows[1][stran], -1e-4, 1e-15);
    EXPECT_NEAR(rows[1][stran + 1], 0.0, 1e-15);
    EXPECT_NEAR(rows[2][stran + 1], -side, 1e-15);
    EXPECT_NEAR(rows[2][stran + 2], -side, 1e-15);
    EXPECT_NEAR(rows[3][stran], 1e-4, 1e-15);
    for (std::size_t c = stran; c < statev; ++c) EXPECT_NEAR(rows[5][c], rows[0][c], 1e-12);
}

TEST(IncrementalDriverRun, StressPerturbationsReachTheStressTheyAskFor) {
    const Table rows = run("*PerturbationsS\n4 10 1\n*RoscoeIsomorph\n0.5\n").rows;
    EXPECT_NEAR(std::sqrt(3.0) * (pressure(rows[1]) - 100.0), 0.5, 1e-6);
    EXPECT_NEAR(std::sqrt(3.0) * (pressure(rows[3]) - 100.0), -0.5, 1e-6);
    const double q = -rows[2][stress] + 0.5 * (rows[2][stress + 1] + rows[2][stress + 2]);
    EXPECT_NEAR(std::sqrt(2.0 / 3.0) * q, 0.5, 1e-6);
}

TEST(IncrementalDriverRun, RandomWalkStaysWithinItsStridesAndIsTheSameAgain) {
    const std::string walk = "*RandomWalk\n30 10 1\n*Cartesian\n0 1e-4\n0 1e-4\n0 0\n0 2e-4\n0 0\n"
                             "0 0\n";
    const Table rows = run(walk).rows;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_LE(std::abs(rows[i][stran] - rows[i - 1][stran]), 1e-4);
        EXPECT_LE(std::abs(rows[i][stran + 3] - rows[i - 1][stran + 3]), 2e-4);
        EXPECT_EQ(rows[i][stran + 2], 0.0);
    }
    EXPECT_NE(rows[1][stran], rows[1][stran + 1]);
    EXPECT_EQ(run(walk).rows, rows);
}

TEST(IncrementalDriverRun, AnExitConditionEndsItsStepOnly) {
    const Result result = run("*OedometricE1 ? s1 < -200\n400 5 1\n-0.05\n*OedometricE1\n2 5 1\n"
                              "1e-6\n");
    const Table& rows = result.rows;
    ASSERT_EQ(result.report.exits.size(), 1u);
    EXPECT_LT(rows.size(), 400u);
    EXPECT_LT(rows[rows.size() - 3][stress], -200.0);
    EXPECT_GT(rows[rows.size() - 4][stress], -200.0);
}

TEST(IncrementalDriverRun, KeepsTheRowsBeforeAFailureAndSaysTheLine) {
    const Result result = run("*PureRelaxation\n2 5 1\n*TriaxialS1\n100 10 1\n-1000\n");
    EXPECT_NE(result.report.failure.find("test.inp:4: step 2 (*TriaxialS1)"), std::string::npos)
        << result.report.failure;
    EXPECT_GT(result.rows.size(), 10u);
    EXPECT_LT(result.rows.size(), 103u);
    EXPECT_LT(result.rows.back()[stress], -200.0);
}

TEST(IncrementalDriverOutput, EndsWithTheRowWhereAConditionHeldHoweverRareRowsAre) {
    const Result result = run("*OedometricE1 ? s1 < -200\n400 5 1 : 30\n-0.05\n");
    ASSERT_EQ(result.report.exits.size(), 1u);
    EXPECT_LT(result.rows.back()[stress], -200.0);
    EXPECT_NEAR(result.rows.back()[stran],
                -0.05 / 400 * static_cast<double>(result.report.increments), 1e-12);
}

TEST(IncrementalDriverOutput, EndsWithTheStateReachedWhereTheRunFails) {
    const Result result = run("*TriaxialS1\n100 10 1 : 1000\n-1000\n");
    EXPECT_FALSE(result.report.failure.empty());
    ASSERT_EQ(result.rows.size(), 3u);
    EXPECT_LT(result.rows.back()[stress], -300.0);
}

TEST(IncrementalDriverOutput, MayLieInAFolderBelow) {
    const Folder folder;
    Folder::fill(folder);
    folder.write("test.inp", "below/result.out\n*PureCreep\n2 5 1\n");
    incremental_driver::run({folder.path(), {}, {}});
    EXPECT_EQ(read_table(folder.path("below/result.out")).size(), 3u);
}

}  // namespace
