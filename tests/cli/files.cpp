// SPDX-License-Identifier: BSD-3-Clause
// Which files are written, and which never.
#include <gtest/gtest.h>

#include "support/workplace.hpp"

namespace {

using Names = std::set<std::string>;

const std::string compression = "[[stage]]\ntest = \"oedometer\"\naxial_strain = -0.01\n";
const std::string cycles = "[[stage]]\ntest = \"triaxial_drained\"\n"
                           "axial_strain_amplitude = -1e-4\ncycles = 2\n";

TEST(Outputs, OfTwoCasesThatWouldCollideAreRefused) {
    const Workplace here;
    here.write_case("x", cycles);
    here.write_case("x_cycles", compression);
    here.write_case("comparison", compression);
    const Answer answer = here.grit("element --no-plot --out out x.toml x_cycles.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(
        answer.says("x_cycles.csv would be written by case x (x.toml) and by case x_cycles"))
        << answer.text;
    EXPECT_EQ(here.grit("element --out out comparison.toml x_cycles.toml").status, 2);
    EXPECT_EQ(here.files("out"), Names{});
    const Answer table = here.grit("element --no-plot --out out comparison.toml x_cycles.toml");
    EXPECT_EQ(table.status, 2);
    EXPECT_TRUE(table.says("comparison.csv would be written by")) << table.text;
    EXPECT_EQ(here.run("comparison").status, 0);
}

TEST(Outputs, NeverOverwriteAnInput) {
    const Workplace here;
    here.write_case("x", compression + "[reference]\norigin = \"x\"\ncurve = \"x.csv\"\n");
    const std::string data = "eps11,s11\n0,-100\n-0.01,-300\n";
    here.write("x.csv", data);
    const Answer answer = here.grit("element --no-plot x.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("x.csv: case x (x.toml) would overwrite this file")) << answer.text;
    EXPECT_EQ(here.text("x.csv"), data);
}

// The table of verdicts is an output like others, though runs at one time may all write it.
TEST(Outputs, OfVerdictsOverwriteNeitherInputsNorResults) {
    const Workplace here;
    const std::string judged = compression + "[reference]\norigin = \"x\"\ncurve = \"lab.csv\"\n"
                                             "curve_tolerance = 0.1\n";
    here.write("lab.csv", "eps11,s11\n0,-100\n-0.01,-300\n");
    here.write_case("references", judged);
    Answer answer = here.run("references");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("references.csv would be written by")) << answer.text;
    EXPECT_EQ(here.files("out"), Names{});
    here.write_case("x", replaced(judged, "lab.csv", "references.csv"));
    const std::string data = here.text("lab.csv");
    here.write("references.csv", data);
    answer = here.grit("element --no-plot x.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("would overwrite this file")) << answer.text;
    EXPECT_EQ(here.text("references.csv"), data);
}

TEST(Outputs, LeaveNoCyclesAndNoReferenceOfAnOlderRun) {
    const Workplace here;
    here.write("lab.csv", "eps11,s11\n0,-100\n-0.01,-300\n");
    here.write_case("x", cycles + "[reference]\norigin = \"x\"\ncurve = \"lab.csv\"\n");
    EXPECT_EQ(here.run("x").status, 0);
    EXPECT_EQ(here.files("out"), (Names{"x.csv", "x_cycles.csv", "x_reference.csv"}));
    here.write_case("x", compression);
    EXPECT_EQ(here.run("x").status, 0);
    EXPECT_EQ(here.files("out"), Names{"x.csv"});
    here.write("out/x_cycles.csv", "a,b\n1,2\n");  // nobody knows whose
    EXPECT_EQ(here.run("x").status, 0);
    EXPECT_EQ(here.files("out"), (Names{"x.csv", "x_cycles.csv"}));
}

TEST(Outputs, ThatCannotBeWrittenAreSaidBeforeTheRun) {
    const Workplace here;
    here.write_case("x", compression);
    here.write("out", "a file where a folder is wanted");
    Answer answer = here.run("x");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("out: cannot make this folder")) << answer.text;
    std::filesystem::remove(here.path("out"));
    std::filesystem::create_directories(here.path("out/x.csv"));
    answer = here.run("x");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("x.csv: cannot write this file: it is a folder")) << answer.text;
    EXPECT_EQ(here.files("out"), Names{"x.csv"});
}

TEST(Outputs, OfOneCaseAreKeptWhereAnotherFails) {
    const Workplace here;
    here.write_case("good", compression);
    here.write_case("weak", "[[stage]]\ntest = \"triaxial_drained\"\naxial_stress_kPa = -900\n");
    EXPECT_EQ(here.grit("element --no-plot --out out good.toml weak.toml").status, 1);
    EXPECT_EQ(here.files("out"), (Names{"good.csv", "weak.csv"}));
}

TEST(Outputs, AreCompleteOrNotThereWhenTheRunIsInterrupted) {
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"triaxial_undrained\"\n"
                         "axial_strain_amplitude = -1e-4\ncycles = 100000\nrecord_every = 1000\n");
    const Answer answer =
        here.grit("element --no-plot --out out x.toml & sleep 1; kill -INT $!; wait $!; exit $?");
    EXPECT_EQ(answer.status, 1) << answer.text;
    EXPECT_TRUE(answer.says("interrupted")) << answer.text;
    EXPECT_EQ(here.files("out"), (Names{"x.csv", "x_cycles.csv"}));
    EXPECT_NE(here.text("out/x.csv").find("STOPPED EARLY: stage 1, interrupted"),
              std::string::npos);
}

TEST(Cases, MaySayInWhatTheyDifferFromAnother) {
    const Workplace here;
    here.write_case("x", compression);
    here.write("y.toml", "base = \"x.toml\"\n[override]\n\"start.pressure_kPa\" = 200\n");
    EXPECT_EQ(here.grit("element --no-plot --out out x.toml y.toml").status, 0);
    EXPECT_EQ(here.result("x").at("p").front(), 100.0);
    EXPECT_EQ(here.result("y").at("p").front(), 200.0);
    here.write("y.toml", "base = \"x.toml\"\n[override]\n\"start.pressure_kPa\" = -1\n");
    const Answer answer = here.grit("element --no-plot --out out y.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("y.toml:3: start.pressure_kPa must be > 0, got -1")) << answer.text;
}

}  // namespace
