// SPDX-License-Identifier: BSD-3-Clause
// A UMAT that ends the program: the user learns where, nothing half written stays, the status is 1.
#include <gtest/gtest.h>

#include "support/workplace.hpp"

namespace {

struct End {
    const char* props;
    const char* says;
};

class UmatThatEndsTheProgram : public testing::TestWithParam<End> {};

TEST_P(UmatThatEndsTheProgram, IsNamedWithThePlaceAndLeavesNothingBehind) {
    const Workplace here;
    here.write("case.toml", std::string("[umat]\nlibrary = \"" GRIT_ENDING_UMAT "\"\nprops = [") +
                                GetParam().props +
                                "]\nstatev = []\n[start]\npressure_kPa = 100\n[[stage]]\n"
                                "test = \"oedometer\"\naxial_strain = -0.01\n");
    const Answer answer = here.run("case");
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says("case: the UMAT " GRIT_ENDING_UMAT)) << answer.text;
    EXPECT_TRUE(answer.says(GetParam().says)) << answer.text;
    EXPECT_TRUE(answer.says("after step 1, increment 2")) << answer.text;
    EXPECT_EQ(here.files("out"), std::set<std::string>{});
}

TEST_P(UmatThatEndsTheProgram, IsNamedInARunOfIncrementalDriverFilesToo) {
    const Workplace here;
    here.write("parameters.inp", std::string("x\n1\n") + GetParam().props + "\n");
    here.write("initialconditions.inp", "3\n-100\n-100\n-100\n0\n");
    here.write("test.inp", "out.txt\n*OedometricE1\n10 5 1\n-0.01\n");
    const Answer answer = here.grit("element --incremental-driver . --umat " GRIT_ENDING_UMAT);
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says(GetParam().says)) << answer.text;
    EXPECT_EQ(here.files().size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(ByExitCrashOrAbort, UmatThatEndsTheProgram,
                         testing::Values(End{"0", "ended the program (exit or STOP)"},
                                         End{"1", "segmentation fault"},
                                         End{"2", "aborted the program"}));

TEST(UmatWithoutNamesOfItsState, HasConditionsOnItsStateAllTheSame) {
    const Workplace here;
    here.write("case.toml", "[umat]\nlibrary = \"" GRIT_ENDING_UMAT
                            "\"\nprops = [0]\nstatev = [3, 4]\n[start]\npressure_kPa = 100\n"
                            "[[stage]]\ntest = \"oedometer\"\naxial_strain = -0.01\n"
                            "until = \"statev(2) > 3\"\n");
    const Answer answer = here.run("case");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("increment 1: statev(2) > 3")) << answer.text;
}

}  // namespace
