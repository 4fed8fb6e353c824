// SPDX-License-Identifier: BSD-3-Clause
// Standard input, output and error that are full, closed or read by nobody.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/workplace.hpp"

namespace {

const std::string compression = "[[stage]]\ntest = \"oedometer\"\naxial_strain = -0.01\n";
// Long enough for a line of progress every second.
const std::string long_run = "[[stage]]\ntest = \"triaxial_undrained\"\n"
                             "axial_strain_amplitude = -1e-4\ncycles = 1500\nrecord_every = 1000\n";

class StandardStreams : public testing::Test {
  protected:
    StandardStreams() { here.write_case("x", compression); }
    Workplace here;
};

const std::vector<std::string> talkative = {"sand list",
                                            "sand show lausitz",
                                            "element --no-plot --out out x.toml",
                                            "element --no-plot --residuals --out out x.toml",
                                            "--help",
                                            "--version",
                                            "element --help"};

TEST_F(StandardStreams, ThatAreFullMakeEveryCommandFailWithAWord) {
    for (const std::string& command : talkative) {
        const Answer answer = here.grit(command + " > /dev/full");
        EXPECT_EQ(answer.status, 1) << command;
        EXPECT_TRUE(answer.says("grit: standard output did not take all that was said: "
                                "No space left on device"))
            << command << ": " << answer.text;
    }
}

TEST_F(StandardStreams, ThatAreClosedMakeEveryCommandFailWithAWord) {
    for (const std::string& command : talkative) {
        const Answer answer = here.grit(command + " >&-");
        EXPECT_EQ(answer.status, 1) << command;
        EXPECT_TRUE(answer.says("grit: standard output did not take all that was said: "
                                "Bad file descriptor"))
            << command << ": " << answer.text;
    }
}

TEST_F(StandardStreams, ThatNobodyReadsMakeEveryCommandFailWithAWord) {
    for (const std::string& command : talkative) {
        const Answer answer = here.grit("sand list > /dev/null; { { sleep 0.2; " GRIT_CLI " " +
                                        command + "; echo status $? >&2; } 2>&3 | true; } 3>&1");
        EXPECT_TRUE(answer.says("status 1\n")) << command << ": " << answer.text;
        EXPECT_TRUE(answer.says("Broken pipe")) << command << ": " << answer.text;
    }
}

TEST_F(StandardStreams, ThatFailLeaveTheResultsWhole) {
    here.write_case("y", compression);
    EXPECT_EQ(here.grit("element --no-plot --out plain x.toml y.toml").status, 0);
    for (const std::string how : {"> /dev/full", ">&-", ">&- 2>&-", "> /dev/full 2> /dev/full"}) {
        EXPECT_EQ(here.grit("element --residuals --no-plot --out out x.toml y.toml " + how).status,
                  1)
            << how;
        EXPECT_EQ(here.text("out/x.csv"), here.text("plain/x.csv")) << how;
        EXPECT_EQ(here.text("out/y.csv"), here.text("plain/y.csv")) << how;
    }
}

#ifdef GRIT_MPM_CASES
TEST_F(StandardStreams, OfErrorsThatNobodyTakesEndNoRunOfMaterialPoints) {
    const std::string run =
        "mpm --threads 1000 --no-plot " GRIT_MPM_CASES "/every_key_override.toml --out ";
    EXPECT_EQ(here.grit(run + "plain").status, 0);
    for (const std::string how : {"2> /dev/full", "2>&-"}) {
        EXPECT_EQ(here.grit(run + "out " + how).status, 0) << how;
        EXPECT_EQ(here.text("out/every_key_override.csv"),
                  here.text("plain/every_key_override.csv"))
            << how;
    }
    const Answer answer = here.grit("mpm --keys cases > /dev/full");
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says("grit: standard output did not take all that was said")) << answer.text;
}
#endif

TEST_F(StandardStreams, ThatAreClosedNeverEndUpInAResult) {
    here.write_case("long", long_run);
    const std::string command = "element --quiet --no-plot --out ";
    EXPECT_EQ(here.grit(command + "plain long.toml").status, 0);
    const std::string plain = here.text("plain/long.csv");
    for (const std::string how : {"2>&-", "<&- >&- 2>&-", "2> /dev/full"}) {
        EXPECT_EQ(here.grit(command + "out long.toml " + how).status, 0) << how;
        EXPECT_EQ(here.text("out/long.csv"), plain) << how;
    }
}

TEST_F(StandardStreams, ThatAreClosedChangeNoRefusal) {
    for (const std::string how : {"2>&-", ">&- 2>&-", "<&- >&- 2>&-", "> /dev/full 2> /dev/full"})
        EXPECT_EQ(here.grit("element nothing.toml " + how).status, 2) << how;
}

}  // namespace
