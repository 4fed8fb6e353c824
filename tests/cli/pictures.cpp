// SPDX-License-Identifier: BSD-3-Clause
// Pictures, where gnuplot is there to draw them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "support/workplace.hpp"

namespace {

using Names = std::set<std::string>;

const std::string shearing = "[[stage]]\ntest = \"triaxial_drained\"\naxial_strain = -0.02\n";

bool gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

// Lines that were drawn.
std::size_t lines(const std::string& svg) {
    std::size_t count = 0;
    for (std::size_t at = svg.find("<path stroke='rgb("); at != std::string::npos;
         at = svg.find("<path stroke='rgb(", at + 1))
        ++count;
    return count;
}

TEST(Picture, IsDrawnOfEveryCaseAndOfAllThatAreAlike) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write_case("a", shearing);
    here.write_case("b", shearing);
    const Answer answer = here.grit("element --out out a.toml b.toml");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_EQ(here.files("out"), (Names{"a.csv", "a.png", "a.svg", "b.csv", "b.png", "b.svg",
                                        "comparison.csv", "comparison.png", "comparison.svg"}));
    EXPECT_GE(lines(here.text("out/a.svg")), 4u);
    EXPECT_GT(lines(here.text("out/comparison.svg")), lines(here.text("out/a.svg")));
}

TEST(Picture, OfManyCyclesIsOfAFewThousandPoints) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"triaxial_undrained\"\n"
                         "axial_strain_amplitude = -1e-4\ncycles = 200\n");
    EXPECT_EQ(here.grit("element --quiet --out out x.toml").status, 0);
    EXPECT_LT(here.text("out/x.svg").size(), 1000000u);
    EXPECT_GE(lines(here.text("out/x.svg")), 4u);
}

TEST(Picture, IsOfTheLastStageThatDoesAnything) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"oedometer\"\naxial_strain = -0.02\n[[stage]]\n"
                         "test = \"rest\"\n");
    here.grit("element --out out x.toml");
    EXPECT_NE(here.text("out/x.svg").find("axial stress"), std::string::npos);
}

// A gnuplot that fails, that draws half, that draws nothing: data, no picture, and no status 0.
TEST(Picture, ThatIsNotWholeIsNoneAndSaid) {
    const Workplace here;
    here.write_case("x", shearing);
    for (const std::string does :
         {"echo no room >&2; exit 1", "echo half of a picture", "exit 0", "kill -9 $$"}) {
        here.write("gnuplot", "#!/bin/sh\n" + does + "\n");
        std::filesystem::permissions(here.path("gnuplot"), std::filesystem::perms::owner_all);
        const Answer answer =
            here.grit("sand list > /dev/null; PATH=.:$PATH " GRIT_CLI " element --out out x.toml");
        EXPECT_EQ(answer.status, 1) << does << ": " << answer.text;
        EXPECT_TRUE(answer.says("grit: no picture: out/x.svg: gnuplot ended")) << answer.text;
        EXPECT_EQ(here.files("out"), Names{"x.csv"}) << does;
    }
}

TEST(Picture, IsAlsoAPdfWhereThatIsWanted) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write_case("x", shearing);
    here.run("x");
    EXPECT_EQ(here.grit("plot out/x.csv --out without").status, 0);
    EXPECT_TRUE(here.grit("plot out/x.csv --out with --pdf").says("with.svg and .png, .pdf"));
    EXPECT_TRUE(here.text("with.pdf").starts_with("%PDF-"));
    EXPECT_FALSE(here.files().contains("without.pdf"));
}

TEST(Study, RunsACaseForEachValueAndDrawsThemTogether) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write_case("x", shearing + "[reference]\norigin = \"as it stands\"\n[[reference.value]]\n"
                                    "quantity = \"stress_11\"\nvalue = 1\ntolerance = 1e-6\n");
    const Answer answer =
        here.grit("element x.toml --vary start.void_ratio=0.55,0.65 --vary numerics.tolerance=1");
    EXPECT_TRUE(answer.says("--vary needs KEY=VALUE,VALUE,..., got \"numerics.")) << answer.text;
    const Answer misspelt = here.grit("element x.toml --vary start.void_ration=0.55,0.65");
    EXPECT_TRUE(misspelt.says("--vary start.void_ration=0.55: unknown key start.void_ration"))
        << misspelt.text;
    const Answer study =
        here.grit("element x.toml --out out --vary 'start.void_ratio=0.55, 0.65 ' --vary "
                  "sand.name=lausitz,hochstetten");
    EXPECT_EQ(study.status, 0) << study.text;
    for (const char* name :
         {"x_0.55_lausitz", "x_0.65_lausitz", "x_0.55_hochstetten", "x_0.65_hochstetten"}) {
        EXPECT_TRUE(here.files("out").contains(std::string(name) + ".csv")) << name;
        EXPECT_TRUE(here.files("out").contains(std::string(name) + ".png")) << name;
    }
    EXPECT_NE(here.text("out/comparison.svg").find("void_ratio = 0.65, name = hochstetten"),
              std::string::npos);
    EXPECT_NE(here.text("out/x_0.65_lausitz.csv")
                  .find("\n# with start.void_ratio=0.65, sand.name=lausitz\n"),
              std::string::npos);
    const std::string runs = here.text("out/comparison.csv");
    EXPECT_NE(runs.find("\nx_0.65_hochstetten,void_ratio = 0.65; name = hochstetten\n"),
              std::string::npos)
        << runs;
    ASSERT_EQ(here.run("x", "--set start.void_ratio=0.65 --set name=alone --no-plot").status, 1);
    EXPECT_EQ(here.result("alone").at("stress_11"), here.result("x_0.65_lausitz").at("stress_11"));
}

TEST(Study, VariesAKeyOnce) {
    const Workplace here;
    here.write_case("x", shearing);
    for (const std::string other :
         {"--vary start.void_ratio=0.55,0.65", "--set start.void_ratio=0.55"}) {
        const Answer answer = here.run("x", other + " --vary start.void_ratio=0.6,0.7");
        EXPECT_EQ(answer.status, 2);
        EXPECT_TRUE(answer.says(": " + other.substr(0, other.find(',')) + " says otherwise"))
            << answer.text;
    }
}

TEST(Study, OfTestsThatMayBeTogetherIsOnePictureAndOthersAreTold) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write_case("x", shearing);
    const std::string tests = "element x.toml --vary stage.1.test=triaxial_drained,";
    const Answer together = here.grit(tests + "triaxial_undrained --out out");
    EXPECT_EQ(together.status, 0) << together.text;
    EXPECT_NE(here.text("out/comparison.svg").find("test = triaxial_undrained"), std::string::npos);
    EXPECT_TRUE(here.files("out").contains("comparison.csv"));
    const Answer apart = here.grit(tests + "oedometer --out apart");
    EXPECT_TRUE(apart.says("no comparison: x_triaxial_drained is for a picture of triaxial, and "
                           "x_oedometer for one of oedometer\n"))
        << apart.text;
    EXPECT_FALSE(here.files("apart").contains("comparison.csv"));
    EXPECT_FALSE(here.grit(tests + "oedometer --out apart --quiet").says("no comparison"));
}

TEST(Study, TellsTheRunThatCannotBe) {
    const Workplace here;
    here.write_case("x", shearing);
    here.write("dense.toml",
               replaced(here.text("x.toml"), "void_ratio = 0.6", "void_ratio = 0.55"));
    const auto says = [&](const std::string& arguments, const std::string& words) {
        const Answer answer = here.grit("element --quiet --out out " + arguments);
        EXPECT_EQ(answer.status, 2) << answer.text;
        EXPECT_TRUE(answer.says(words)) << answer.text;
    };
    says("dense.toml --vary sand.name=lausitz,hostun", "got 0.55, with sand.name=hostun\n");
    says("x.toml --vary start.void_ratio=0.65,0.55 --vary sand.name=lausitz,hostun",
         "got 0.55, with start.void_ratio=0.55, sand.name=hostun\n");
    const Answer one = here.grit("element x.toml --vary start.void_ratio=0.6,5");
    EXPECT_TRUE(one.says("--vary start.void_ratio=5: ") && !one.says(", with ")) << one.text;
}

TEST(Study, MayBePlottedByAnyColumns) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write_case("x", shearing);
    ASSERT_EQ(here.grit("element x.toml --no-plot --out a").status, 0);
    ASSERT_EQ(here.grit("element x.toml --no-plot --out b --set start.void_ratio=0.7").status, 0);
    ASSERT_EQ(
        here.grit("plot a/x.csv b/x.csv --x axial_strain --y rho,void_ratio --out study").status,
        0);
    const std::string picture = here.text("study.svg");
    for (const char* word : {"a/x", "b/x", "rho [-]", "void ratio e", "axial compression"})
        EXPECT_NE(picture.find(word), std::string::npos) << word;
    EXPECT_GE(lines(picture), 4u);
    EXPECT_TRUE(here.grit("plot a/x.csv b/x.csv --x axial_strian --y rho")
                    .says("a/x has no column \"axial_strian\"; nearest: axial_strain"));
    EXPECT_EQ(here.grit("plot a/x.csv --x rho").status, 2);
    // Of laboratories also what is known, but not in such a picture.
    here.write("lab.csv", "eps_a_percent,q_kPa,void_ratio,s22\n0,0,0.6,-100\n1,100,0.6,-100\n");
    EXPECT_TRUE(here.grit("plot a/x.csv --data lab.csv --kind triaxial_undrained --out p")
                    .says("lab.csv: not in a picture of triaxial_undrained: void_ratio\n"));
    EXPECT_FALSE(here.grit("plot a/x.csv --data lab.csv --out p").says("not in a picture"));
}

TEST(PictureOfALaboratory, TakesSemicolonsAndNamesThatAreExplained) {
    if (!gnuplot()) return;
    const Workplace here;
    here.write("lab.csv", "Axial;Deviator;Cell\n0,0;0,0;100\n1,5;120,5;100\n3,0;180,0;100\n");
    const Answer bare = here.grit("plot --data lab.csv --out p");
    EXPECT_EQ(bare.status, 2);
    EXPECT_TRUE(bare.says(
        "lab.csv: not used: Axial, Deviator, Cell; --column OURS=THEIRS says what a column is"))
        << bare.text;
    const Answer told = here.grit(
        "plot --data lab.csv --column q_kPa=Deviator --column eps_a_percent=Axial --out p");
    EXPECT_EQ(told.status, 0) << told.text;
    EXPECT_TRUE(told.says("lab.csv: not used: Cell;")) << told.text;
    EXPECT_NE(here.text("p.svg").find("lab"), std::string::npos);
    const auto refused = [&](const std::string& column, const std::string& words) {
        const Answer answer = here.grit("plot --data lab.csv --column " + column);
        EXPECT_EQ(answer.status, 2) << column;
        EXPECT_TRUE(answer.says(words)) << answer.text;
    };
    refused("q_kPa", "--column needs OURS=THEIRS");
    refused("q_kP=Deviator", "there is no column \"q_kP\"; nearest: q_kPa");
    refused("q_kPa=Deviatr", "none of the data has a column Deviatr; nearest: Deviator");
}

TEST(Picture, OfDegradationNeedsCycles) {
    const Workplace here;
    here.write("x.toml", "picture = \"degradation\"\n[sand]\nname = \"lausitz\"\n[start]\n"
                         "pressure_kPa = 100\nvoid_ratio = 0.6\n" +
                             shearing);
    EXPECT_TRUE(here.run("x").says("x.toml:1: picture: \"degradation\" shows cycles"));
}

class PictureOfFiles : public testing::Test {
  protected:
    PictureOfFiles() {
        here.write("parameters.inp", "Lausitz\n16\n33\n0\n1.6e6\n0.19\n0.44\n0.85\n1.0\n0.25\n1.0\n"
                                     "5.0\n2.0\n1e-4\n0.5\n6.0\n0\n10.7\n");
        here.write("initialconditions.inp", "3\n-100\n-100\n-100\n14\n");
        here.write("test.inp", "result.out # dense\n*TriaxialE1\n50 5 1\n-0.02\n");
    }
    Workplace here;
};

TEST_F(PictureOfFiles, OfIncrementalDriverIsDrawnBesideTheResult) {
    if (!gnuplot()) return;
    EXPECT_TRUE(here.grit("element --incremental-driver .").says("result.svg and .png"));
    EXPECT_TRUE(here.files().contains("result.out") && here.files().contains("result.png"));
    EXPECT_GE(lines(here.text("result.svg")), 4u);
}

TEST_F(PictureOfFiles, IsLeftOutAndNothingIsSaidWhenAskedFor) {
    EXPECT_EQ(here.grit("element --incremental-driver . --no-plot --quiet").text, "");
    EXPECT_EQ(here.files().size(), 4u);
}

TEST_F(PictureOfFiles, MayBePlottedFromTheResultOfIncrementalDriver) {
    if (!gnuplot()) return;
    here.write_case("a", shearing);
    here.run("a");
    here.grit("element --incremental-driver . --no-plot");
    const Answer answer = here.grit("plot result.out out/a.csv --out both --title two");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_GE(lines(here.text("both.svg")), 6u);
    EXPECT_EQ(here.grit("plot out/a.csv --out a/b/c").status, 0);
    EXPECT_EQ(here.grit("plot result.out --kind degradation").status, 2);
}

}  // namespace
