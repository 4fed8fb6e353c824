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
    expect_answer("12345", "grit: there is no command \"12345\"; known here: ");
}

TEST(Misspelt, OptionsHaveTheirNearestName) {
    expect_answer("element x.toml --no-plto",
                  "grit element: there is no option --no-plto; nearest: --no-plot\n");
    expect_answer("element --outt=here x.toml",
                  "grit element: there is no option --outt; nearest: --out\n");
}

TEST(Misspelt, WhatIsKnownKeepsItsOwnWords) {
    expect_answer("", "A subcommand is required");
    expect_answer("element --out", "--out: 1 required");
}

}  // namespace
