// SPDX-License-Identifier: BSD-3-Clause
// What guides a user: doctor, completions, the manual page.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "support/workplace.hpp"

namespace {

// Says so where it is not.
bool there_is(const char* program) {
    if (std::system((std::string("command -v ") + program + " > /dev/null").c_str()) == 0)
        return true;
    std::printf("not tested: no %s, script/test --all installs it\n", program);
    return false;
}

// Says so where none can be opened, as where /dev/pts is not mounted.
bool there_is_a_terminal() {
    const int first = posix_openpt(O_RDWR | O_NOCTTY);
    const bool is_there = first >= 0;
    if (is_there) close(first);
    else std::printf("not tested: no pseudo terminal can be opened\n");
    return is_there;
}

// What SHELL prints of SCRIPT, in a folder with its completion in the file words.
std::string of_shell(const std::string& shell, const std::string& script) {
    const Workplace here;
    EXPECT_EQ(here.grit("completion " + shell + " > words").status, 0);
    here.write("script", script);
    EXPECT_EQ(
        std::system(
            ("cd " + here.path(".").string() + " && " + shell + " script > answer 2>&1").c_str()),
        0)
        << here.text("answer");
    return here.text("answer");
}

std::string bash_offers(const std::string& line) {
    return of_shell(
        "bash", ". ./words\nCOMP_WORDS=(" + line +
                    ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_grit\necho \"${COMPREPLY[*]}\"\n");
}

TEST(Guide, DoctorTellsWhatIsMissingAndWhatBringsIt) {
    const Workplace here;
    const Answer answer = here.grit("doctor");
    EXPECT_EQ(answer.status, 0);
    EXPECT_TRUE(answer.says("instruction set")) << answer.text;
    EXPECT_EQ(std::system(("cd " + here.path(".").string() +
                           " && PATH=/nowhere " GRIT_CLI " doctor > alone 2>&1")
                              .c_str()),
              0);
    const std::string alone = here.text("alone");
    EXPECT_NE(alone.find("missing; no pictures, data only: apt-get install gnuplot-nox"),
              std::string::npos)
        << alone;
    EXPECT_NE(alone.find("grit itself needs none of them"), std::string::npos) << alone;
    EXPECT_EQ(alone.find("not found"), std::string::npos) << alone;
    EXPECT_NE(alone.find("documentation    "), std::string::npos) << alone;
}

TEST(Guide, BashCompletesCommandsOptionsValuesAndSands) {
    EXPECT_EQ(bash_offers("grit pl"), "plot\n");
    EXPECT_EQ(bash_offers("grit sand s"), "show\n");
    EXPECT_EQ(bash_offers("grit element --no-p"), "--no-plot\n");
    EXPECT_EQ(bash_offers("grit element --layout ra"), "radian\n");
    EXPECT_EQ(bash_offers("grit element --sand lau"), "lausitz\n");
    EXPECT_EQ(bash_offers("grit element --out r"), "\n");  // files, which bash knows by itself
    EXPECT_NE(bash_offers("grit sand show l").find("lausitz"), std::string::npos);
}

TEST(Guide, FishCompletes) {
    if (!there_is("fish")) return;
    const auto offers = [](const std::string& line) {
        return of_shell(
            "fish",
            "set -x XDG_CONFIG_HOME $PWD; set -x XDG_DATA_HOME $PWD\nsource words\ncomplete -C '" +
                line + "'\n");
    };
    EXPECT_EQ(offers("grit pl"), "plot\tDraw results and laboratory data together\n");
    EXPECT_EQ(offers("grit sand sh"), "show\tParameters and source of one sand\n");
    EXPECT_EQ(offers("grit element --no-p"), "--no-plot\tData only\n");
    EXPECT_NE(offers("grit element --layout ").find("radian"), std::string::npos);
    EXPECT_NE(offers("grit sand show la").find("lausitz"), std::string::npos);
    EXPECT_NE(offers("grit element --sand la").find("lausitz"), std::string::npos);
    EXPECT_EQ(offers("grit completion "), "bash\nfish\nzsh\n");  // no files
}

// In a terminal of its own: zsh completes nowhere else.
TEST(Guide, ZshCompletes) {
    if (!there_is("zsh") || !there_is_a_terminal()) return;
    // What the terminal shows after a tab, until it has the words or twenty seconds are over.
    const auto shown = [](const std::string& line, const std::string& words) {
        return of_shell(
            "zsh",
            "zmodload zsh/zpty\nzpty z zsh -f\n"
            "zpty -w z 'PS1=; autoload -U compinit; compinit -u -D; . ./words; setopt nobeep; "
            "bindkey \"^I\" expand-or-complete; echo rea\"\"dy'\nall=\n"
            "read_until() { repeat 100; do while zpty -r -t z more; do all+=$more; done; "
            "[[ $all == *$1* ]] && return; sleep 0.2; done }\n"
            "read_until ready\nzpty -w -n z '" +
                line + "'$'\\t'\nread_until '" + words + "'\nprint -r -- $all\n");
    };
    const auto completes = [&](const std::string& line, const std::string& words) {
        const std::string all = shown(line, words);
        EXPECT_NE(all.find(words), std::string::npos) << all;
    };
    completes("grit pl", "grit plot");
    completes("grit element --no-p", "--no-plot");
    completes("grit sand sh", "sand show");
    completes("grit element --sand laus", "sand lausitz");
}

TEST(Guide, TheManualPageHasAllThatHelpHas) {
    const Workplace here;
    ASSERT_EQ(here.grit("man > grit.1").status, 0);
    std::string page = here.text("grit.1");
    for (std::size_t at; (at = page.find("\\-")) != std::string::npos;) page.erase(at, 1);
    int options = 0;
    for (const char* command : {"element", "mpm", "plot", "sand show", "calibrate", "completion"}) {
        const std::string help = here.grit(std::string(command) + " --help").text;
        EXPECT_NE(page.find(std::string(".SS grit ") + command), std::string::npos) << command;
        for (std::size_t at = 0; (at = help.find("\n  --", at)) != std::string::npos; ++at) {
            const std::size_t from = at + 3, to = help.find_first_of(" \n,", from);
            EXPECT_NE(page.find("\\fB" + help.substr(from, to - from) + "\\fR"), std::string::npos)
                << help.substr(from, to - from);
            ++options;
        }
    }
    EXPECT_GT(options, 20);
    EXPECT_NE(page.find(".B grit sand show\n.I NAME \n"), std::string::npos) << page;
    if (!there_is("groff")) return;
    EXPECT_EQ(
        std::system(("cd " + here.path(".").string() +
                     " && groff -ww -man -Tutf8 grit.1 > set 2> complaints && test ! -s complaints")
                        .c_str()),
        0)
        << here.text("complaints");
}

}  // namespace
