// SPDX-License-Identifier: BSD-3-Clause
// What a result is held against, and when that says nothing.
#include <gtest/gtest.h>

#include "support/workplace.hpp"

namespace {

const std::string shearing = "[[stage]]\ntest = \"triaxial_drained\"\naxial_strain = -0.02\n";

// Exit status and words of a run with this table as its reference.
Answer against(const std::string& table, const std::string& more = "curve_tolerance = 1e-2\n") {
    const Workplace here;
    here.write("lab.csv", table);
    here.write_case("x", shearing + "[reference]\norigin = \"lab\"\ncurve = \"lab.csv\"\n" + more);
    Answer answer = here.run("x");
    if (answer.status == 2) {
        EXPECT_EQ(here.files("out"), std::set<std::string>{}) << answer.text;
    }
    return answer;
}

TEST(Curve, OfDeviatorAndPressureAloneIsComparedToo) {
    const Answer answer = against("eps11,q_kPa\n0,99999\n-0.01,99999\n");
    EXPECT_EQ(answer.status, 1) << answer.text;
    EXPECT_TRUE(answer.says("EXCEEDED")) << answer.text;
}

TEST(Curve, WithNothingToCompareIsRefused) {
    EXPECT_TRUE(against("eps11,rain\n0,1\n-0.01,2\n").says("has neither stress nor void ratio"));
    EXPECT_TRUE(against("s11,e\n-100,0.6\n-200,0.6\n").says("has no strain that changes"));
}

TEST(Curve, BeyondTheRunIsNotExtrapolated) {
    const Answer answer = against("eps11,s11\n0,-100\n-0.01,-300\n-0.05,-300\n");
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says("the reference has strain_11 = -0.05, the run goes from 0 to -0.02"))
        << answer.text;
}

TEST(Curve, IsReadToItsEndBeforeTheRun) {
    EXPECT_TRUE(against("eps11,s11\n0,-100\n-0.01\n").says("lab.csv:3: 1 cells where"));
    EXPECT_TRUE(against("eps11,s11\n0,-100\n-0.01,80 kPa\n", "")
                    .says("lab.csv:3: column s11 has \"80 kPa\" where a number is needed"));
}

// As spreadsheets of many countries write it.
TEST(Curve, WithSemicolonsAndDecimalCommasIsTheSame) {
    const Answer commas = against("eps11,s11\n0,-100\n-0.01,-200.5\n");
    const Answer semicolons = against("eps11;s11\n0;-100\n-0,01;-200,5\n");
    const auto verdict = [](const Answer& answer) {
        const std::size_t end = answer.text.find("EXCEEDED");
        return end == std::string::npos ? answer.text
                                        : answer.text.substr(answer.text.rfind('\n', end) + 1,
                                                             end - answer.text.rfind('\n', end));
    };
    EXPECT_TRUE(commas.says("EXCEEDED")) << commas.text;
    EXPECT_EQ(verdict(semicolons), verdict(commas));
}

// In the names and signs of results, so that whoever draws one can draw the other.
TEST(Curve, IsLeftBesideTheResult) {
    const Workplace here;
    here.write("lab.csv", "eps_a_percent,q_kPa,weather\n0,0,fair\n1,250,rain\n");
    here.write_case("x", shearing + "[reference]\norigin = \"lab\"\ncurve = \"lab.csv\"\n");
    ASSERT_EQ(here.run("x").status, 0);
    const std::map<std::string, Values> left = here.result("x_reference");
    EXPECT_EQ(left.at("axial_deviator"), (Values{0, 250}));
    EXPECT_EQ(left.at("axial_strain"), (Values{0, -0.01}));
    EXPECT_FALSE(left.contains("weather"));
    EXPECT_NE(here.text("out/x_reference.csv").find(", reference beside case x: lab\n"),
              std::string::npos);
}

TEST(Curve, MayHaveAByteOrderMarkEmptyCellsAndColumnsOfWords) {
    const Answer answer =
        against("\xEF\xBB\xBF"
                "eps11,s22,weather\n0,-100,fair\n-0.005,,rain\n-0.01,-100,snow\n");
    EXPECT_EQ(answer.status, 0) << answer.text;
}

TEST(Difference, BeyondItsLimitIsExitStatusOne) {
    const Workplace here;
    const Answer answer = here.grit("element --no-plot --out out " GRIT_CASES "/exceeded.toml");
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says("EXCEEDED")) << answer.text;
}

TEST(Samples, MayGiveAnyNumberAndAreNamedInErrors) {
    const Workplace here;
    here.write("s.csv", "id,p,n\na,-100,20\nb,-200,3.5\n");
    const std::string text = "[samples]\ntable = \"s.csv\"\nname = \"id\"\n[sand]\n"
                             "name = \"lausitz\"\n[start]\nvoid_ratio = 0.6\n"
                             "stress_kPa = [\"column p\", -50, -50, 0, 0, 0]\n" +
                             shearing + "increments = \"column n\"\n";
    here.write("x.toml", text);
    Answer answer = here.run("x");
    EXPECT_TRUE(answer.says("sample b: stage[1].increments must be an integer")) << answer.text;
    here.write("s.csv", "id,p,n\na,-100,20\nb,-200,30\n");
    answer = here.run("x");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_EQ(here.result("x_b").at("increment").back(), 30.0);
    EXPECT_EQ(here.result("x_b").at("stress_11").front(), -200.0);
}

}  // namespace
