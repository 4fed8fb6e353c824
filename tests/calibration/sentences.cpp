// SPDX-License-Identifier: BSD-3-Clause
// What a laboratory gets wrong costs one sentence with file, row and column, and nothing is written.
#include <gtest/gtest.h>

#include "laboratory.hpp"

namespace {

void expect_refused(const std::string& text, const std::string& sheet, const std::string& words) {
    const Workplace here;
    const Answer answer = calibrate(here, text, sheet);
    EXPECT_EQ(answer.status, 2) << answer.text;
    EXPECT_TRUE(answer.says(words)) << "expected " << words << "\ngot " << answer.text;
    EXPECT_EQ(here.files("out"), std::set<std::string>{});
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

// The sheet with one change.
void expect_cell_refused(const std::string& what, const std::string& by, const std::string& words) {
    expect_refused(oedometer_case(), replaced(oedometer_sheet(), what, by), words);
}

// The case with one change.
void expect_case_refused(const std::string& what, const std::string& by, const std::string& words) {
    expect_refused(replaced(oedometer_case(), what, by), oedometer_sheet(), words);
}

TEST(Cell, ThatIsEmpty) {
    expect_cell_refused("40,0.7440", "40,",
                        "lab.csv:3: column e is empty: fill it, or set may_be_empty of void_ratio");
    expect_cell_refused("60,0.7411", ",0.7411", "lab.csv:4: column sigma [kPa] is empty");
}

TEST(Cell, ThatIsNoNumber) {
    expect_cell_refused("40,0.7440", "40,ca. 0.744",
                        "lab.csv:3: column e has \"ca. 0.744\" where a number is needed");
}

TEST(Cell, ThatIsNoVoidRatio) {
    expect_cell_refused("40,0.7440", "40,74.40",
                        "lab.csv:3: column e: a void ratio must be in (0.05, 5), got 74.4");
}

TEST(Cell, WithAStressThatPulls) {
    expect_cell_refused("60,0.7411", "-60,0.7411",
                        "lab.csv:4: column sigma [kPa]: -60 would pull: compression = "
                        "\"negative\"?");
}

TEST(Cell, WithMoreThanSandBears) {
    expect_cell_refused("400,", "400000000,",
                        "lab.csv:10: column sigma [kPa]: 4e+08 kPa is more than sand bears: unit = "
                        "\"Pa\"?");
}

TEST(Cell, ThatIsMissing) { expect_cell_refused("40,0.7440,", "40,0.7440", "lab.csv:3: 2 cells"); }

TEST(Column, ThatIsNotThere) {
    expect_case_refused("column = \"e\"", "column = \"Porenzahl\"",
                        "x.toml:12: test[1].columns.void_ratio.column: the sheet has no column "
                        "\"Porenzahl\"; known here: sigma [kPa], e, remark");
    expect_case_refused("column = \"sigma [kPa]\"", "column = \"sigma [kpa]\"",
                        "nearest: sigma [kPa]");
}

TEST(Cell, WithAVoidRatioInPercent) {
    expect_cell_refused("40,0.7440", "40,74.40", "got 74.4: unit = \"percent\"?");
}

TEST(Cell, WithAPointWhereACommaIsDue) {
    const std::string text =
        oedometer_case(oedometer_columns, "separator = \";\"\ndecimal_comma = true\n");
    expect_refused(text, "sigma [kPa];e;remark\n20,5;0,748;\n1.040;0,7440;\n",
                   "lab.csv:3: \"1.040\" has a point, and decimal_comma = true");
}

TEST(Column, ThatStandsInAnotherLine) {
    expect_refused(oedometer_case(), "laboratory,of,soils\n" + oedometer_sheet(),
                   "the sheet has no column \"e\"; known here: laboratory, of, soils; "
                   "line 2 has it: "
                   "header_line = 2");
}

TEST(Column, OfEffectiveStressDoesNotDriveAnUndrainedTest) {
    expect_refused(
        "[sand]\nname = \"lausitz\"\n[fit]\nparameters = [\"alpha\"]\n[[test]]\nname = "
        "\"CU\"\ntest = "
        "\"triaxial_undrained\"\ndriven_by = \"axial_stress_kPa\"\nfile = \"lab.csv\"\nstart = { "
        "pressure_kPa "
        "= 200, void_ratio = 0.7 }\n[test.columns]\nstress_11 = { column = \"s [kPa]\", "
        "compression = "
        "\"positive\" }\npore_pressure = { column = \"u [kPa]\", error = 1 }\n",
        "s [kPa],u [kPa]\n200,0\n210,20\n",
        "an undrained test that is driven by axial stress needs the column of axial_deviator");
}

TEST(Column, ThatDrivesTheTestHasNoZero) {
    expect_refused(
        "[sand]\nname = \"lausitz\"\n[fit]\nparameters = [\"alpha\"]\n[[test]]\nname = "
        "\"CD\"\ntest = "
        "\"triaxial_drained\"\nfile = \"lab.csv\"\nstart = { pressure_kPa = 200, void_ratio = 0.7 "
        "}\n[test.columns]\naxial_strain = { column = \"e [%]\", compression = \"positive\", zero "
        "= 1 "
        "}\naxial_deviator = { column = \"q [kPa]\", error = 1 }\n",
        "e [%],q [kPa]\n0,0\n1,200\n",
        "axial_strain.zero: it drives the test, which counts from its first row");
}

TEST(Cell, ThatIsEmptyWhereChangesCountFrom) {
    expect_refused(
        "[sand]\nname = \"lausitz\"\n[fit]\nparameters = [\"alpha\"]\n[[test]]\nname = "
        "\"CD\"\ntest = "
        "\"triaxial_drained\"\nfile = \"lab.csv\"\nstart = { pressure_kPa = 200, void_ratio = 0.7 "
        "}\n"
        "[test.columns]\naxial_strain = { column = \"e [%]\", compression = \"positive\" }\n"
        "axial_deviator = { column = \"q [kPa]\", error = 1 }\nvolumetric_strain = { column = \"v "
        "[%]\", "
        "compression = \"positive\", error = 0.1, may_be_empty = true }\n",
        "e [%],q [kPa],v [%]\n0,0,\n1,200,0.1\n2,250,0.1\n",
        "lab.csv:2: column v [%] is empty, and its changes count from here: give zero of "
        "volumetric_strain");
}

TEST(Stages, LeaveTheStartToBeSaid) {
    expect_refused(oedometer_case() +
                       "[[test.stage]]\ntest = \"oedometer\"\naxial_stress_kPa = -20\n",
                   oedometer_sheet(), "test[1].start: stages come before the first row");
}

TEST(Resolution, HasBounds) {
    expect_refused(oedometer_case() + "[numerics]\nresolution = 1e12\n", oedometer_sheet(),
                   "numerics.resolution must be in [0.1, 100], got 1e+12");
}

TEST(Column, ThatIsThereTwice) {
    expect_refused(oedometer_case(), replaced(oedometer_sheet(), "remark", "e"),
                   "the sheet has 2 columns \"e\"");
}

TEST(Column, OfAQuantityThatNobodyKnows) {
    expect_case_refused("void_ratio =", "void_ration =",
                        "unknown key test[1].columns.void_ration; nearest: void_ratio");
}

TEST(Column, ThatDrivesTheTestIsNeeded) {
    expect_case_refused("stress_11 = { column", "stress_22 = { column",
                        "the test is driven by axial_stress_kPa: name the column of stress_11");
}

TEST(Unit, ThatNobodySays) {
    expect_refused(replaced(oedometer_case(), "sigma [kPa]", "sigma"),
                   replaced(oedometer_sheet(), "sigma [kPa]", "sigma"),
                   "the header \"sigma\" does not say its unit: give unit = one of \"kPa\"");
}

TEST(Unit, ThatIsNone) {
    expect_case_refused("compression = \"positive\" }",
                        "compression = \"positive\", unit = \"kPA\" }", "nearest: kPa");
}

// A strain in the place of the void ratio, unit = "-".
void expect_strain_refused(const std::string& last, const std::string& words) {
    expect_refused(replaced(oedometer_case(), "void_ratio = { column = \"e\",",
                            "axial_strain = { column = \"e\", unit = \"-\", compression = "
                            "\"positive\","),
                   replaced(oedometer_sheet(), "400,0.7198", "400," + last), words);
}

TEST(Unit, OfAStrainInPercentThatIsNotSaidToBe) {
    expect_strain_refused(
        "3.7198", "lab.csv:10: column e: a strain of 3.7198 is beyond 1: unit = \"percent\"?");
}

TEST(Unit, OfAStrainThatIsAllOfTheSample) {
    expect_strain_refused(
        "1", "lab.csv:10: column e: a strain of 1 is all of the sample: unit = \"percent\"?");
}

TEST(Unit, ThatTheHeaderContradicts) {
    expect_case_refused("compression = \"positive\" }",
                        "compression = \"positive\", unit = \"Pa\" }",
                        "x.toml:11: test[1].columns.stress_11.unit is \"Pa\", and the header says "
                        "\"kPa\": rename the column in the sheet if that is wrong");
}

TEST(Unit, OfALength) {
    expect_refused(replaced(oedometer_case(), "void_ratio = { column = \"e\",",
                            "axial_strain = { column = \"s [mm]\", compression = \"positive\","),
                   replaced(oedometer_sheet(), ",e,", ",s [mm],"),
                   "\"s [mm]\" is a length: give a column that is a strain");
}

TEST(Sign, ThatNobodySays) {
    expect_case_refused(", compression = \"positive\"", "",
                        "test[1].columns.stress_11.compression is missing");
}

TEST(Sign, OfASampleThatSwellsUnderLoad) {
    expect_refused(oedometer_case(), "sigma [kPa],e\n20,0.70\n40,0.71\n80,0.72\n400,0.73\n",
                   "lab.csv:5: column sigma [kPa] goes from 20 to 400, while e goes from 0.70 to "
                   "0.73: is the sign of one of them wrong?");
}

TEST(Error, OfNothingIsToldToBeMissing) {
    expect_case_refused(", error = 0.001", "", "none has an error");
}

TEST(Error, InPercentIsNoShare) {
    expect_case_refused("error = 0.001", "relative_error = 2", "percent?");
}

TEST(Test, OfANameThatTheSheetDoesNotHave) {
    expect_case_refused("file = \"lab.csv\"\n",
                        "file = \"lab.csv\"\nsplit_by = \"remark\"\nfit = \"unload\"\n",
                        "lab.csv:2: column remark is empty: whose row is this?");
}

TEST(Test, ThatStartsWhereNothingPresses) {
    expect_refused(oedometer_case(), replaced(oedometer_sheet(), "20,0.7480", "0,0.7480"),
                   "lab.csv:2: a test starts here at 0 kPa, where nothing presses: begin later "
                   "with from");
}

TEST(Test, WithoutARowThatIsUsed) {
    expect_case_refused("file = \"lab.csv\"\n", "file = \"lab.csv\"\nfrom = 400\n",
                        "of test oedometer, 1 row is left: two are needed");
}

TEST(Test, WithAStartThatNoSampleHas) {
    expect_case_refused(
        "file = \"lab.csv\"\n", "file = \"lab.csv\"\nstart.void_ratio = 75\n",
        "x.toml:10: test[1].start.void_ratio must be in (0.05, 5), got 75: percent?");
}

TEST(Test, OfAnotherNameThanItsStart) {
    expect_case_refused("file = \"lab.csv\"\n",
                        "file = \"lab.csv\"\nstarts.oedometre.void_ratio = 0.7\n",
                        "unknown key test[1].starts.oedometre; nearest: oedometer");
}

TEST(File, ThatIsNoCsv) {
    for (const auto& [begin, words] :
         {std::pair{std::string("PK\x03\x04"),
                    "lab.csv: is a workbook: let its name end with .xlsx"},
          {std::string("\xD0\xCF\x11\xE0"), "lab.csv: is a workbook of old: save it as .xlsx"},
          {std::string("\xFF\xFE"), "lab.csv: is UTF-16: save it as CSV in UTF-8"}})
        expect_refused(oedometer_case(), begin + oedometer_sheet(), words);
}

TEST(File, ThatIsNoWorkbook) {
    const Workplace here;
    here.write("lab.xlsx", oedometer_sheet());
    here.write("x.toml", replaced(oedometer_case(), "lab.csv", "lab.xlsx"));
    const Answer answer = here.grit("calibrate x.toml --out out");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("lab.xlsx: is no workbook: the name of a CSV ends with .csv"))
        << answer.text;
}

TEST(File, OfAnotherKindThanItsKeys) {
    expect_case_refused("file = \"lab.csv\"\n", "file = \"lab.csv\"\nsheet = \"OED 1\"\n",
                        "test[1].sheet is said of a workbook, .xlsx alone");
}

TEST(File, ThatIsNotThere) {
    expect_case_refused("lab.csv", "lob.csv", "x.toml:9: test[1].file: lob.csv: cannot read");
}

TEST(Parameter, ThatNobodyKnows) {
    expect_case_refused("\"h_s\"", "\"hs\"",
                        "x.toml:4: fit.parameters: no parameter is called \"hs\"; nearest: h_s");
}

TEST(Parameter, ThatIsNeitherSoughtNorGiven) {
    expect_case_refused("name = \"lausitz\"", "stiffness_exponent = 0.2",
                        "phi_c is neither sought nor given: name it in fit.parameters, or give "
                        "sand.critical_friction_angle_deg");
}

TEST(Bounds, InTheWrongOrder) {
    expect_case_refused("starts = 2\n", "starts = 2\nbounds.stiffness_exponent = [0.4, 0.2]\n",
                        "fit.bounds.stiffness_exponent must be two rising numbers");
}

TEST(Tie, OfAParameterThatIsSoughtItself) {
    expect_case_refused("starts = 2\n", "starts = 2\nties.n = { of = \"h_s\" }\n",
                        "fit.ties.n is sought itself");
}

}  // namespace
