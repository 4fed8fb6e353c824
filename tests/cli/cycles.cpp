// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/workplace.hpp"

namespace {

std::string cycles(const std::string& more) {
    return "[[stage]]\ntest = \"triaxial_drained\"\naxial_strain_amplitude = -1e-3\ncycles = 3\n" +
           more;
}

TEST(CyclesTable, DoesNotDependOnWhatIsRecorded) {
    const Workplace here;
    here.write_case("all", cycles(""));
    here.write_case("few", cycles("record_every = 50\n"));
    here.run("all");
    here.run("few");
    const auto all = here.result("all_cycles"), few = here.result("few_cycles");
    ASSERT_EQ(all.at("damping").size(), 3u);
    EXPECT_EQ(all, few);
    EXPECT_NEAR(all.at("damping")[0], 0.2467, 1e-3);
    EXPECT_NEAR(all.at("secant_G")[0], 8267.6, 10.0);
    // secant_G of a row counts from the last reversal, which need not be recorded
    const auto rows = here.result("few");
    EXPECT_NEAR(rows.at("secant_G").back(), here.result("all").at("secant_G").back(), 1e-6);
}

TEST(CyclesTable, IsNotMadeWithoutShear) {
    const Workplace here;
    here.write_case("x",
                    "[[stage]]\ntest = \"isotropic\"\npressure_amplitude_kPa = 10\ncycles = 3\n");
    EXPECT_EQ(here.run("x").status, 0);
    EXPECT_EQ(here.files("out"), std::set<std::string>{"x.csv"});
}

TEST(CyclesTable, OfASineHasItsWholeCycles) {
    const Workplace here;
    here.write_case("x", cycles("wave = \"sine\"\n"));
    here.run("x");
    EXPECT_EQ(here.result("x_cycles").at("cycle").size(), 2u);
}

TEST(CyclesTable, CountsFromTheBeginningOfAStageWhoseStrainsCountAnew) {
    const std::string before = "[[stage]]\ntest = \"triaxial_drained\"\naxial_strain = -0.01\n";
    const Workplace here;
    here.write_case("anew", before + cycles("zero_strain = true\n"));
    here.write_case("on", before + cycles(""));
    here.run("anew");
    here.run("on");
    const auto anew = here.result("anew_cycles"), on = here.result("on_cycles");
    ASSERT_EQ(anew.at("cycle").size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(anew.at("secant_G")[i], on.at("secant_G")[i], 1e-3 * on.at("secant_G")[i]);
        EXPECT_NEAR(anew.at("damping")[i], on.at("damping")[i], 1e-3);
    }
}

TEST(SlopeOfAStage, CountsFromItsBeginningWhereItsStrainsCountAnew) {
    const Workplace here;
    here.write_case("x", "[[stage]]\ntest = \"triaxial_drained\"\naxial_strain = -0.01\n[[stage]]\n"
                         "test = \"triaxial_drained\"\naxial_strain = -0.001\nzero_strain = true\n"
                         "[reference]\norigin = \"x\"\n[[reference.value]]\n"
                         "quantity = \"stress_11\"\nover = \"axial_strain\"\nstage = 2\n"
                         "value = 8837\ntolerance = 0.01\n");
    const Answer answer = here.run("x");
    EXPECT_EQ(answer.status, 0) << answer.text;
}

TEST(SmallStrainStiffness, OfTheBasicModelHasNoReversalStiffness) {
    const Workplace here;
    here.write("x.toml", "[sand]\nname = \"lausitz\"\n[start]\npressure_kPa = 100\n"
                         "void_ratio = 0.6\nintergranular_strain = \"off\"\n[[stage]]\n"
                         "test = \"simple_shear_constant_stress\"\n"
                         "shear_strain_amplitude = 1e-5\n");
    here.run("x");
    EXPECT_NEAR(here.result("x_cycles").at("G/G_0").at(0), 1.0, 1e-3);
}

}  // namespace
