// SPDX-License-Identifier: BSD-3-Clause
// Runs at the same time in one folder.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/workplace.hpp"

namespace {

// Long enough to be stopped on its way.
const std::string cycles = "[[stage]]\ntest = \"triaxial_undrained\"\n"
                           "axial_strain_amplitude = -1e-4\ncycles = 800\nrecord_every = 100\n";

class TwoRuns : public testing::Test {
  protected:
    TwoRuns() {
        here.write_case("x", cycles);
        EXPECT_EQ(here.grit("element --no-plot --quiet --out plain x.toml").status, 0);
    }
    void leave_the_result_of_one() const {
        EXPECT_EQ(here.text("out/x.csv"), here.text("plain/x.csv"));
        EXPECT_EQ(here.files("out"), here.files("plain"));
    }
    Workplace here;
    const std::string run = GRIT_CLI " element --no-plot --quiet --out out x.toml";
    // In the background, up to where its files are begun.
    const std::string begun =
        "sand list > /dev/null; " + run +
        " & for try in $(seq 100000); do set -- out/x.csv.*.part; [ -e $1 ] && break; done; ";
};

TEST_F(TwoRuns, OfOneCaseAreOneThatIsRefusedByName) {
    for (const std::string& first : std::vector<std::string>{
             "sand list > /dev/null; " + run + " & ", begun + "kill -STOP $!; "}) {
        const Answer answer =
            here.grit(first + run + "; second=$?; kill -CONT $!; wait $!; echo $? + $second;");
        EXPECT_TRUE(answer.says("0 + 1\n") || answer.says("1 + 0\n")) << answer.text;
        EXPECT_TRUE(answer.says("grit: out/x.csv: another run of grit is writing this file"))
            << answer.text;
        leave_the_result_of_one();
    }
}

TEST_F(TwoRuns, OfDifferentCasesDoNotDisturbEachOther) {
    here.write_case("y", cycles);
    const Answer answer =
        here.grit("sand list > /dev/null; " + run +
                  " & " GRIT_CLI " element --no-plot --quiet --out out y.toml && wait $!");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_EQ(here.text("out/x.csv"), here.text("plain/x.csv"));
    EXPECT_EQ(here.files("out"),
              (std::set<std::string>{"x.csv", "x_cycles.csv", "y.csv", "y_cycles.csv"}));
}

TEST_F(TwoRuns, AreNoneWhereTheFirstWasKilled) {
    const Answer answer = here.grit(begun + "kill -KILL $!; wait $!; ls -a out; " + run);
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says(".part\n")) << answer.text;
    leave_the_result_of_one();
}

#ifdef GRIT_MPM_CASES
TEST(TwoRunsOfMaterialPoints, AreOneThatIsRefusedByName) {
    const Workplace here;
    // Long enough to be stopped on its way.
    here.write("long.toml", "base = \"" GRIT_MPM_CASES "/every_key.toml\"\n[override]\n"
                            "\"stage.rest.until.time_s\" = 0.03\n");
    const std::string run = GRIT_CLI " mpm --no-plot --quiet --out ", of_long = " long.toml";
    const Answer answer = here.grit(
        "sand list > /dev/null; " + run + "out" + of_long +
        " & for try in $(seq 100000); do [ -e out/.grit-lock ] && break; done; "
        "kill -STOP $!; " +
        run + "out" + of_long + "; second=$?; kill -CONT $!; wait $!; echo $? + $second; " + run +
        "plain" + of_long);
    EXPECT_TRUE(answer.says("0 + 1\n") || answer.says("1 + 0\n")) << answer.text;
    EXPECT_TRUE(answer.says("grit: out/long.")) << answer.text;
    EXPECT_EQ(here.files("out"), here.files("plain"));
    for (const std::string& file : here.files("plain"))
        EXPECT_EQ(here.text("out/" + file), here.text("plain/" + file)) << file;
}
#endif

}  // namespace
