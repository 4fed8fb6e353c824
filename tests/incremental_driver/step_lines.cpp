// SPDX-License-Identifier: BSD-3-Clause
// Repetition, exit conditions, and what stands on the first two lines of any step.
#include <gtest/gtest.h>

#include "support/folder.hpp"

namespace {

TEST(IncrementalDriverSteps, RepetitionHoldsItsStepsAndCountsThem) {
    const auto test = parse("*OedometricE1\n10 5 1\n-0.01\n*Repetition\n2 3\n*OedometricE1\n"
                            "10 5 1\n-0.01\n*OedometricE1\n5 5 1 : 2\n0.01\n*PureCreep\n10 5 1\n"
                            "*End\nwhatever comes behind\n");
    ASSERT_EQ(test.program.size(), 3u);
    const auto repetition = std::get<element::Repetition>(test.program[1].kind);
    EXPECT_EQ(repetition.times, 3);
    EXPECT_EQ(repetition.steps.size(), 2u);
    ASSERT_EQ(test.notes.size(), 1u + 2u * 3u + 1u);
    EXPECT_EQ(repetition.steps[1].every, 2);
    EXPECT_EQ(test.notes[4].line, 10);
    EXPECT_EQ(test.notes[7].name, "*PureCreep");
}

TEST(IncrementalDriverSteps, ExitConditionsTimesEveryAndTemperatureAreRead) {
    const auto test = parse("*LinearLoad ? -s1 + 2*s3 > 100\n100 5 10 T 20 : 4 remark\n*Cartesian\n"
                            "0 0\n0 0\n0 0\n0 0\n0 0\n0 0\n*PureCreep ? v7 < 0.5\n"
                            "8 5 1 : 100 T -5\n");
    const element::Step& step = test.program[0];
    EXPECT_EQ(step.temperature_change, 20.0);
    EXPECT_EQ(step.every, 4);
    ASSERT_EQ(step.exit.any_of.size(), 1u);
    EXPECT_EQ(step.exit.any_of[0].limit, 100.0);
    element::Record point;
    point.stress << -30.0, 0.0, 40.0, 0.0, 0.0, 0.0;
    EXPECT_NEAR(excess(step.exit.any_of[0], point), 30.0 + 80.0 - 100.0, 1e-12);
    EXPECT_EQ(test.program[1].temperature_change, -5.0);
    EXPECT_EQ(test.program[1].every, 8);
}

TEST(IncrementalDriverSteps, OnlyFortyColumnsOfAKeywordLineCount) {
    const auto test = parse("*PureCreep                              here starts a remark, 40 on\n"
                            "10 5 1.0                                : 5\n");
    EXPECT_EQ(test.program.size(), 1u);
    EXPECT_EQ(test.program[0].every, 1);
}

TEST(IncrementalDriverSteps, WordsBehindAKeywordAreARemark) {
    const auto test =
        parse("*OedometricE1 to 1 percent\n10 5 1\n-0.01\n*PureCreep a day ? s1 < -2d2\n"
              "10 5 1\n");
    EXPECT_EQ(test.notes[0].name, "*OedometricE1");
    EXPECT_EQ(test.program[1].exit.any_of.at(0).limit, -200.0);
}

TEST(IncrementalDriverFile, MayBeginWithAByteOrderMark) {
    const Folder folder;
    folder.write("test.inp", "\xEF\xBB\xBFout\n*PureCreep\n10 5 1\n");
    EXPECT_EQ(incremental_driver::read_test(folder.path("test.inp"), {}).output, "out");
}

}  // namespace
