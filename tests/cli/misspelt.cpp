// SPDX-License-Identifier: BSD-3-Clause
// Command lines with a letter wrong.
#include <gtest/gtest.h>

#include "support/workplace.hpp"

namespace {

void expect_answer(const std::string& arguments, const std::string& words) {
    const Workplace here;
    const Answer answer = here.grit(arguments);
    EXPECT_EQ(answer.status, 2) << answer.text;
    EXPECT_TRUE(answer.says(words)) << "expected " << words << "\ngot " << answer.text;
}

TEST(Misspelt, CommandsHaveTheirNearestName) {
    expect_answer("elment x.toml", "grit: there is no command \"elment\"; nearest: element\n");
    expect_answer("sand shwo lausitz", "grit sand: there is no command \"shwo\"; nearest: show\n");
    expect_answer("help elment", "grit: there is no command \"elment\"; nearest: element\n");
    expect_answer("12345", "grit: there is no command \"12345\"; known here: ");
}

TEST(Misspelt, OptionsHaveTheirNearestName) {
    expect_answer("element x.toml --no-plto",
                  "grit element: there is no option --no-plto; nearest: --no-plot\n");
    expect_answer("element --outt=here x.toml",
                  "grit element: there is no option --outt; nearest: --out\n");
}

TEST(Misspelt, OptionsOfOneLetterAreToldByTheirWord) {
    expect_answer("mpm -o here x.toml", "grit mpm: there is no option -o; nearest: --out\n");
    expect_answer("mpm -z x.toml", "grit mpm: there is no option -z\n");
}

TEST(Misspelt, ValuesHaveTheirNearestWordOrTheirLimits) {
    expect_answer("sand show lausitz --props clasic",
                  "--props: there is no \"clasic\"; nearest: classic\n");
    expect_answer("mpm --keys hist", "--keys: there is no \"hist\"; nearest: history\n");
    expect_answer("completion zsj", "there is no \"zsj\"; nearest: zsh\n");
    expect_answer("sand show lausitz --props classic --void-ratio 99",
                  "--void-ratio: must be in [0.01, 10], got 99\n");
    expect_answer("sand show lausitz --props classic --void-ratio 6",
                  "grit: --void-ratio must be at most 1, e_i0 of lausitz, got 6\n");
    expect_answer("mpm x.toml --threads 5000", "--threads: must be in [1, 1024], got 5000\n");
    expect_answer("mpm x.toml --threads few", "--threads: must be in [1, 1024], got few\n");
}

TEST(Misspelt, CasesOfTheOtherCommandAreToldSo) {
    Workplace here;
    here.write("a.toml", "[grid]\ngeometry = \"axisymmetric\"\n");
    here.write("b.toml", "[sand]\nname = \"lausitz\"\n[start]\nvoid_ratio = 0.6\n");
    EXPECT_TRUE(here.grit("element a.toml").says("a.toml:1: grid: this is a case of grit mpm"));
    EXPECT_TRUE(here.grit("mpm b.toml").says("b.toml:3: start: this is a case of grit element"));
}

TEST(Misspelt, HelpAndVersionAreWordsToo) {
    const Workplace here;
    EXPECT_TRUE(here.grit("help element").says("Usage: grit element"));
    EXPECT_TRUE(here.grit("help").says("Usage: grit "));
    EXPECT_EQ(here.grit("version").text, here.grit("--version").text);
    EXPECT_EQ(here.grit("help element").status, 0);
}

TEST(Misspelt, WhatIsKnownKeepsItsOwnWords) {
    expect_answer("", "A subcommand is required");
    expect_answer("element --out", "--out: 1 required");
}

}  // namespace
