// SPDX-License-Identifier: BSD-3-Clause
// What stages do, seen in the rows they leave.
#include <gtest/gtest.h>

#include <cmath>

#include "support/workplace.hpp"

namespace {

const std::string undrained_cycles = "[[stage]]\ntest = \"triaxial_undrained\"\n"
                                     "axial_strain_amplitude = -1e-3\ncycles = 20\n";

TEST(Until, EndsCyclesAndTheRowWhereItHeldIsTheLastOne) {
    const Workplace here;
    here.write_case("x", undrained_cycles +
                             "record_every = 50\nuntil = \"pore_pressure > 30\"\n"
                             "[reference]\norigin = \"x\"\n[[reference.value]]\n"
                             "quantity = \"pore_pressure\"\nvalue = 30\ntolerance = 0.02\n");
    const Answer answer = here.run("x");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("ended by stage 1, step ")) << answer.text;
    const auto rows = here.result("x");
    EXPECT_GT(rows.at("pore_pressure").back(), 30.0);
    EXPECT_LT(rows.at("pore_pressure").back(), 30.6);
    EXPECT_NE(std::fmod(rows.at("increment").back(), 50.0), 0.0);
}

TEST(Until, WorksOnAStageWithinAGroupAndOnTheGroup) {
    const std::string inner = "[[stage.stage]]\ntest = \"triaxial_undrained\"\n"
                              "axial_strain_amplitude = -1e-3\ncycles = 3\n";
    const Workplace here;
    here.write_case("inner", "[[stage]]\nrepeat = 2\n" + inner + "until = \"pore_pressure > 1\"\n");
    here.write_case("outer", "[[stage]]\nrepeat = 9\nuntil = \"pore_pressure > 20\"\n" + inner);
    const Answer answer = here.run("inner");
    EXPECT_TRUE(answer.says("stage 1, step 1, increment ")) << answer.text;
    EXPECT_TRUE(answer.says("stage 1, step 2, increment 1: pore_pressure > 1")) << answer.text;
    EXPECT_EQ(here.result("inner").at("step").back(), 2.0);
    here.run("outer");
    EXPECT_GT(here.result("outer").at("pore_pressure").back(), 20.0);
    EXPECT_LT(here.result("outer").at("pore_pressure").back(), 21.0);
}

TEST(Until, MeansTheColumnsOfTheResultInShearToo) {
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"simple_shear_constant_volume\"\nshear_strain = 0.05\n"
                         "until = \"q > 20\"\nuntil_exactly = true\n");
    here.run("x");
    EXPECT_NEAR(here.result("x").at("q").back(), 20.0, 1e-5);
}

TEST(Until, ThatNeverHeldIsSaid) {
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"oedometer\"\naxial_strain = -0.01\n"
                         "until = \"rho > 2\"\n");
    EXPECT_TRUE(here.run("x").says("until never held: stage 1, rho > 2"));
    EXPECT_NE(here.text("out/x.csv").find("# never held: stage 1, rho > 2"), std::string::npos);
}

TEST(Failure, IsTheLastRowHoweverRareRowsAre) {
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"triaxial_drained\"\naxial_stress_kPa = -800\n"
                         "record_every = 100\n");
    const Answer answer = here.run("x");
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says("the prescribed stress cannot be reached")) << answer.text;
    EXPECT_EQ(here.result("x").at("increment").back(), 253.0);
    EXPECT_NE(here.text("out/x.csv").find("# STOPPED EARLY"), std::string::npos);
}

TEST(Drain, LetsThePorePressureOut) {
    const Workplace here;
    here.write_case("x",
                    "[[stage]]\ntest = \"triaxial_undrained\"\naxial_strain = -0.002\n[[stage]]\n"
                    "test = \"drain\"\n[[stage]]\ntest = \"triaxial_drained\"\n"
                    "axial_strain = -0.001\n");
    EXPECT_EQ(here.run("x").status, 0);
    const auto rows = here.result("x");
    EXPECT_GT(rows.at("pore_pressure")[400], 1.0);
    EXPECT_EQ(rows.at("pore_pressure")[800], 0.0);
    EXPECT_NEAR(rows.at("stress_22").back(), -100.0, 1e-6);
}

TEST(Drain, IsAskedForWhereAnUndrainedStageWasBefore) {
    const Workplace here;
    const std::string undrained = "test = \"triaxial_undrained\"\naxial_strain = -0.001\n";
    const std::string drained = "test = \"triaxial_drained\"\naxial_strain = -0.001\n";
    here.write_case("x", "[[stage]]\n" + undrained + "[[stage]]\n" + drained);
    EXPECT_TRUE(here.run("x").says("x.toml:10: stage[2].test: \"triaxial_drained\" begins with"));
    here.write_case("x", "[[stage]]\nrepeat = 2\n[[stage.stage]]\n" + drained +
                             "[[stage.stage]]\n" + undrained);
    EXPECT_EQ(here.run("x").status, 2);
    here.write_case("x", "[[stage]]\nrepeat = 2\n[[stage.stage]]\n" + drained +
                             "[[stage.stage]]\n" + undrained +
                             "[[stage.stage]]\ntest = \"drain\"\n");
    EXPECT_EQ(here.run("x").status, 0);
}

TEST(Duration, IsThatOfTheStageInEveryWave) {
    const Workplace here;
    for (const std::string wave : {"triangle", "sine"}) {
        here.write_case("x", "[[stage]]\ntest = \"triaxial_drained\"\n"
                             "axial_strain_amplitude = -1e-4\ncycles = 3\nduration_s = 60\n"
                             "wave = \"" +
                                 wave + "\"\n");
        here.run("x");
        EXPECT_NEAR(here.result("x").at("time").back(), 60.0, 1e-9) << wave;
    }
}

TEST(WaterStiffness, MakesADrainedTestAnUndrainedOneByPenalty) {
    const Workplace here;
    here.write("x.toml", "[sand]\nname = \"lausitz\"\nwater_stiffness_kPa = 1e7\n[start]\n"
                         "pressure_kPa = 100\nvoid_ratio = 0.75\n[[stage]]\n"
                         "test = \"triaxial_drained\"\naxial_strain = -0.01\n");
    here.write("y.toml", "[sand]\nname = \"lausitz\"\n[start]\npressure_kPa = 100\n"
                         "void_ratio = 0.75\n[[stage]]\ntest = \"triaxial_undrained\"\n"
                         "axial_strain = -0.01\n");
    here.run("x");
    here.run("y");
    EXPECT_NEAR(here.result("x").at("pore_pressure").back(),
                here.result("y").at("pore_pressure").back(), 0.05);
}

TEST(WaterBulkModulus, IsThatOfWaterInPoresWhichCavitatesFromItsOwnPressure) {
    const Workplace here;
    here.write("x.toml", "[sand]\nname = \"lausitz\"\nwater_bulk_modulus_kPa = 2.2e6\n"
                         "cavitation_kPa = 100\n[start]\npressure_kPa = 100\n"
                         "pore_pressure_kPa = 20\nvoid_ratio = 0.55\n[[stage]]\n"
                         "test = \"triaxial_drained\"\naxial_strain = -0.2\n");
    here.run("x");
    const auto p_w = here.result("x").at("pore_pressure");
    EXPECT_EQ(p_w.front(), 20.0);
    EXPECT_EQ(p_w.back(), -100.0);
}

TEST(Residuals, ArePrintedWhenAskedFor) {
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"triaxial_drained\"\naxial_strain = -0.01\n");
    EXPECT_TRUE(here.run("x", "--residuals").says("stage 1, step 1, increment 400: residuals "));
}

}  // namespace
