// SPDX-License-Identifier: BSD-3-Clause
// grit calibrate from sheets to a sand that other commands read.
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "book.hpp"
#include "laboratory.hpp"

namespace {

TEST(Calibrate, WritesASandThatOtherCommandsRead) {
    const Workplace here;
    const Answer answer = calibrate(here, oedometer_case(), oedometer_sheet());
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_EQ(here.files("out"), (std::set<std::string>{"x_report.html", "x_sand.toml"}));
    const std::string sand = here.text("out/x_sand.toml");
    for (const char* words : {"found by grit calibrate", "from lab.csv", "tests fitted: oedometer",
                              "granulate_hardness_kPa = ", "95 % intervals"})
        EXPECT_NE(sand.find(words), std::string::npos) << words;
    const Answer shown = here.grit("sand show out/x_sand.toml");
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_TRUE(shown.says("granulate_hardness")) << shown.text;

    here.write_case("y",
                    "[[stage]]\ntest = \"oedometer\"\naxial_stress_kPa = -300\nincrements = 50\n");
    const Answer own = here.run("y"), other = here.run("y", "--sand ../out/x_sand.toml");
    const Answer given = here.grit("element y.toml --no-plot --out with --sand out/x_sand.toml");
    ASSERT_EQ(own.status, 0) << own.text;
    ASSERT_EQ(given.status, 0) << given.text;
    EXPECT_NE(here.text("out/y.csv"), here.text("with/y.csv"));
    here.write("z.toml", "[sand]\nfile = \"out/x_sand.toml\"\n[start]\npressure_kPa = 100\n"
                         "void_ratio = 0.6\n[[stage]]\ntest = \"oedometer\"\n"
                         "axial_stress_kPa = -300\nincrements = 50\n");
    const Answer by_key = here.grit("element z.toml --no-plot --out with");
    ASSERT_EQ(by_key.status, 0) << by_key.text;
    EXPECT_NE(here.text("with/z.csv").find("sand x_sand"), std::string::npos);
}

TEST(Calibrate, GivesTheSameBytesWithAnyNumberOfThreads) {
    std::string sand[2], page[2];
    for (const int threads : {1, 2}) {
        const Workplace here;
        const Answer answer = calibrate(here, oedometer_case(), oedometer_sheet(),
                                        "--samples 1000 --threads " + std::to_string(threads));
        ASSERT_EQ(answer.status, 0) << answer.text;
        EXPECT_TRUE(answer.says("R-hat")) << answer.text;
        sand[threads - 1] = here.text("out/x_sand.toml");
        page[threads - 1] = here.text("out/x_report.html");
    }
    EXPECT_EQ(sand[0], sand[1]);
    EXPECT_EQ(page[0], page[1]);
}

// A number of a sand file.
double value_of(const std::string& sand, const std::string& key) {
    const std::size_t at = sand.find('\n' + key + " = ");
    return at == std::string::npos ? NAN : std::stod(sand.substr(at + key.size() + 4));
}

// Undrained, sheared and cycled: from element tests of a sand to this sand.
TEST(Calibrate, FindsTheSandOfUndrainedShearAndCyclicTests) {
    const Workplace here;
    const auto element = [&here](const std::string& name, int pressure, double e,
                                 const std::string& stage) {
        std::ostringstream text;
        text << "[sand]\nname = \"lausitz\"\n[start]\npressure_kPa = " << pressure
             << "\nvoid_ratio = " << e << "\n[[stage]]\n"
             << stage;
        here.write(name + ".toml", text.str());
        const Answer answer = here.grit("element --no-plot --out made " + name + ".toml");
        ASSERT_EQ(answer.status, 0) << answer.text;
    };
    element("undrained", 100, 0.65, "test = \"triaxial_undrained\"\naxial_strain = -0.08\n");
    element("shear", 100, 0.70, "test = \"simple_shear_constant_stress\"\nshear_strain = 0.15\n");
    element("cycles", 200, 0.60,
            "test = \"triaxial_drained\"\naxial_strain_amplitude = -1e-3\ncycles = 3\n");
    const std::string axial =
        "axial_strain = { column = \"axial_strain [-]\", compression = \"negative\", strain = "
        "\"logarithmic\" }\naxial_deviator = { column = \"axial_deviator [kPa]\", error = 2 }\n";
    const auto test = [](const std::string& name, const std::string& word, const std::string& start,
                         const std::string& columns) {
        return "[[test]]\nname = \"" + name + "\"\ntest = \"" + word + "\"\nfile = \"made/" + name +
               ".csv\"\nstart = { " + start + " }\n[test.columns]\n" + columns;
    };
    here.write(
        "x.toml",
        "[sand]\nname = \"lausitz\"\ngranulate_hardness_kPa = 1.2e6\npyknotropy_exponent = 0.2\n"
        "reversal_stiffness = 4\nelastic_strain_radius = 0.8e-4\n"
        "[fit]\nparameters = [\"h_s\", \"alpha\", \"e_c0\", \"m_R\", \"R\"]\nstarts = 1\n" +
            test("undrained", "triaxial_undrained", "pressure_kPa = 100, void_ratio = 0.65",
                 axial + "pore_pressure = { column = \"pore_pressure [kPa]\", error = 2 }\n") +
            test("shear", "simple_shear_constant_stress", "pressure_kPa = 100, void_ratio = 0.70",
                 "shear_strain = { column = \"shear_strain [-]\" }\n"
                 "shear_stress = { column = \"shear_stress [kPa]\", error = 2 }\n"
                 "void_ratio = { column = \"void_ratio [-]\", error = 0.002 }\n") +
            test("cycles", "triaxial_drained", "pressure_kPa = 200, void_ratio = 0.60",
                 axial + "void_ratio = { column = \"void_ratio [-]\", error = 0.0005 }\n"));
    const Answer answer = here.grit("calibrate x.toml --samples 0 --out out --quiet");
    ASSERT_EQ(answer.status, 0) << answer.text;
    const std::string sand = here.text("out/x_sand.toml");
    EXPECT_NEAR(value_of(sand, "granulate_hardness_kPa"), 1.6e6, 2e-3 * 1.6e6);
    EXPECT_NEAR(value_of(sand, "pyknotropy_exponent"), 0.25, 5e-3 * 0.25);
    EXPECT_NEAR(value_of(sand, "critical_void_ratio"), 0.85, 1e-3 * 0.85);
    EXPECT_NEAR(value_of(sand, "reversal_stiffness"), 5.0, 1e-3 * 5.0);
    EXPECT_NEAR(value_of(sand, "elastic_strain_radius"), 1e-4, 2e-3 * 1e-4);
}

// From an element test of lausitz to its h_s: stages, and columns of the sheet that drive and that are compared.
double hardness_from(const std::string& start_of_element, const std::string& stages,
                     const std::string& test, const std::string& last, const std::string& start,
                     const std::string& columns) {
    const Workplace here;
    here.write("made.toml", "[sand]\nname = \"lausitz\"\n[start]\n" + start_of_element + "\n" +
                                stages + "[[stage]]\ntest = \"" + test + "\"\n" + last);
    EXPECT_EQ(here.grit("element made.toml --no-plot --out made").status, 0);
    std::string of_test = stages;
    for (std::size_t at = 0; (at = of_test.find("[[stage]]", at)) != std::string::npos; at += 14)
        of_test.replace(at, 9, "[[test.stage]]");
    // The rows of the last stage alone.
    std::string sheet, line, before;
    std::istringstream lines(here.text("made/made.csv"));
    const std::string own =
        std::to_string(1 + std::count(stages.begin(), stages.end(), '\n') / 4) + ",";
    bool begun = false;
    while (std::getline(lines, line)) {
        if (line.starts_with("#")) continue;
        if (sheet.empty()) sheet = line + "\n";
        else if (line.starts_with(own)) {
            if (!begun) sheet += before;
            begun = true;
            sheet += line + "\n";
        }
        before = line + "\n";
    }
    here.write("lab.csv", sheet);
    here.write("x.toml",
               "[sand]\nname = \"lausitz\"\ngranulate_hardness_kPa = 1.2e6\n[fit]\nparameters = "
               "[\"h_s\"]\n"
               "starts = 1\n[[test]]\nname = \"T\"\ntest = \"" +
                   test + "\"\ndriven_by = \"axial_stress_kPa\"\nfile = \"lab.csv\"\nstart = { " +
                   start + " }\n[test.columns]\n" + columns + of_test);
    const Answer answer = here.grit("calibrate x.toml --samples 0 --out out --quiet");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_FALSE(answer.says("look:")) << answer.text;
    return value_of(here.text("out/x_sand.toml"), "granulate_hardness_kPa");
}

// A deviator drives as it is, whatever lateral stress the stages before, the water or the oedometer lead to.
TEST(Calibrate, IsDrivenByADeviatorInEveryTest) {
    const std::string consolidated =
        "[[stage]]\ntest = \"isotropic\"\npressure_kPa = 100\nincrements = 20\n";
    const std::string deviator = "axial_deviator = { column = \"axial_deviator [kPa]\" }\n";
    const std::string strain =
        "axial_strain = { column = \"axial_strain [-]\", compression = \"negative\", strain = "
        "\"logarithmic\", error = 0.0005 }\n";
    const std::string void_ratio = "void_ratio = { column = \"void_ratio [-]\", error = 0.0005 }\n";
    const std::string at_50 = "pressure_kPa = 50\nvoid_ratio = 0.7",
                      start = "pressure_kPa = 50, void_ratio = 0.7";
    const double lausitz = 1.6e6;
    EXPECT_NEAR(hardness_from(at_50, consolidated, "triaxial_drained",
                              "axial_strain = -0.02\nincrements = 40\n", start,
                              deviator + strain + void_ratio),
                lausitz, 0.01 * lausitz);
    EXPECT_NEAR(hardness_from(at_50, consolidated, "triaxial_undrained",
                              "axial_strain = -0.01\nincrements = 40\n", start, deviator + strain),
                lausitz, 0.01 * lausitz);
    EXPECT_NEAR(hardness_from(at_50, consolidated, "biaxial_drained",
                              "axial_strain = -0.01\nincrements = 40\n", start,
                              deviator + strain + void_ratio),
                lausitz, 0.01 * lausitz);
    // K_0 = 1 - sin phi_c
    EXPECT_NEAR(hardness_from("stress_kPa = [-100, -45.536096498497256, -45.536096498497256, 0, 0, "
                              "0]\nvoid_ratio = 0.7\nintergranular_direction = [-1, 0, 0, 0, 0, 0]",
                              "", "k0_consolidation", "axial_strain = -0.01\nincrements = 40\n",
                              "axial_stress_at_rest_kPa = 100, void_ratio = 0.7",
                              deviator + void_ratio),
                lausitz, 0.01 * lausitz);
}

TEST(Calibrate, TellsWhatTheTestsDoNotDetermine) {
    const Workplace here;
    std::string text = oedometer_case();
    text.replace(text.find("[\"h_s\", \"n\"]"), 12, "[\"h_s\", \"n\", \"alpha\"]");
    const Answer answer = calibrate(here, text, oedometer_sheet());
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("these tests do not determine")) << answer.text;
}

TEST(Calibrate, ReadsTheSheetsOfOtherCountriesAndUnits) {
    std::string sand[2];
    for (const bool foreign : {false, true}) {
        const Workplace here;
        std::string sheet = oedometer_sheet(), columns = oedometer_columns, more;
        if (foreign) {
            sheet = "Versuch 1;;\nSpannung;Porenzahl;Bem.\n"
                    "-0,020;0,7480;\n-0,040;0,7440;\n-0,060;0,7411;\n-0,080;0,7388;\n"
                    "-0,100;0,7368;\n-0,150;0,7327;\n-0,200;0,7294;\n-0,300;0,7241;\n"
                    "-0,400;0,7198;\n";
            columns = "stress_11 = { column = \"Spannung\", unit = \"MPa\", compression = "
                      "\"negative\" }\nvoid_ratio = { column = \"Porenzahl\", error = 0.001 }\n";
            more = "separator = \";\"\ndecimal_comma = true\nheader_line = 2\n";
        }
        const Answer answer = calibrate(here, oedometer_case(columns, more), sheet);
        ASSERT_EQ(answer.status, 0) << answer.text;
        sand[foreign] = here.text("out/x_sand.toml");
    }
    EXPECT_EQ(sand[0], sand[1]);
}

TEST(Calibrate, ReadsLatin1) {
    const Workplace here;
    std::string text = oedometer_case(
        "stress_11 = { column = \"Spannung \u03c3 [kPa]\", compression = \"positive\" }\n"
        "void_ratio = { column = \"Pr\u00fcfwert\", unit = \"-\", error = 0.001 }\n");
    text.replace(text.find("Spannung \u03c3"), 11, "Spannung");
    std::string sheet = oedometer_sheet();
    sheet.replace(0, 13,
                  "Spannung [kPa],Pr\xFC"
                  "fwert");
    const Answer answer = calibrate(here, text, sheet);
    EXPECT_EQ(answer.status, 0) << answer.text;
}

// A date in a column that nobody uses, a header of two lines, a test whose name has a line break.
TEST(Calibrate, MindsWhatIsUsedAlone) {
    const Workplace here;
    const std::string columns =
        "stress_11 = { column = \"sigma [kPa]\", compression = \"positive\" }\n"
        "void_ratio = { column = \"e\", error = 0.001 }\n";
    const Answer answer =
        calibrate(here,
                  oedometer_case(
                      columns, "separator = \";\"\ndecimal_comma = true\nsplit_by = \"Versuch\"\n"),
                  "Datum;Versuch;\"sigma\n[kPa]\";e\n12.03.2020;\"OE\n1\";20,0;,7480\n12.03.2020;"
                  "\"OE\n1\";100;0,7368\n"
                  "13.03.2020;\"OE\n1\";400;0,7198\n");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_EQ(here.grit("sand show out/x_sand.toml").status, 0) << here.text("out/x_sand.toml");
}

// More parameters than readings: what they do not tell is said, and nothing is made up.
TEST(Calibrate, DoesNotJudgeErrorsByFewerReadingsThanParameters) {
    const Workplace here;
    std::string text = oedometer_case();
    text.replace(text.find("[\"h_s\", \"n\"]"), 12, "[\"h_s\", \"n\", \"alpha\", \"phi_c\"]");
    const Answer answer =
        calibrate(here, text, "sigma [kPa],e\n20,0.748\n100,0.7368\n400,0.7198\n");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("misfit: 2 independent readings do not tell 4 parameters"))
        << answer.text;
    EXPECT_TRUE(answer.says("these tests do not determine")) << answer.text;
    EXPECT_FALSE(answer.says("determine :")) << answer.text;
    EXPECT_FALSE(answer.says("look: residuals")) << answer.text;
}

// In the sheet's numbers, whatever strain Grit makes of them; also where a reading is missing.
TEST(Calibrate, UsesTheRowsThatAreAskedFor) {
    const Workplace here;
    const std::string text = "[sand]\nname = \"lausitz\"\n[fit]\nparameters = [\"alpha\"]\nstarts "
                             "= 1\n[[test]]\nname = \"CD\"\ntest = "
                             "\"triaxial_drained\"\nfile = \"lab.csv\"\nto = 20\nfirst_loading = "
                             "true\nstart = { pressure_kPa = 100, void_ratio = "
                             "0.7 }\n[test.columns]\naxial_strain = { column = \"e [%]\", "
                             "compression = \"positive\", may_be_empty = true }\n"
                             "axial_deviator = { column = \"q [kPa]\", error = 5 }\n";
    const Answer answer =
        calibrate(here, text, "e [%],q [kPa]\n0,0\n5,180\n,190\n15,210\n20,205\n10,100\n25,200\n");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_NE(here.text("out/x_report.html").find("4 of 7 rows"), std::string::npos);
}

// Loaded from the start that is said to where the sheet begins, not from there by as much again.
TEST(Calibrate, LoadsToTheFirstRowFromAnotherStart) {
    double hardness[2];
    for (const bool elsewhere : {false, true}) {
        const Workplace here;
        std::string text = oedometer_case(
            oedometer_columns,
            elsewhere
                ? "from = 100\nstart = { axial_stress_at_rest_kPa = 20, void_ratio = 0.748 }\n"
                : "");
        const Answer answer = calibrate(here, text, oedometer_sheet());
        ASSERT_EQ(answer.status, 0) << answer.text;
        hardness[elsewhere] = value_of(here.text("out/x_sand.toml"), "granulate_hardness_kPa");
    }
    EXPECT_NEAR(hardness[1], hardness[0], 0.1 * hardness[0]);
}

TEST(Calibrate, SamplesFromACornerOfTheBounds) {
    const Workplace here;
    std::string text = oedometer_case();
    text.replace(text.find("starts = 2\n"), 11,
                 "starts = 2\nbounds = { granulate_hardness_kPa = [1e4, 1e5], stiffness_exponent = "
                 "[0.6, 0.9] }\n");
    const Answer answer = calibrate(here, text, oedometer_sheet(), "--samples 1000");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("posterior: ")) << answer.text;
}

// Where the reading at the start is another than the first row's, the fit knows it.
TEST(Calibrate, CountsPorePressureFromItsZero) {
    std::string sand[2];
    for (const bool back_pressure : {false, true}) {
        const Workplace here;
        std::string sheet =
            "eps [%],q [kPa],u [kPa]\n0,0," + std::string(back_pressure ? "312" : "0") + "\n";
        for (const auto& [eps, q, u] :
             {std::array{1, 80, 45}, {2, 110, 60}, {4, 130, 64}, {6, 140, 62}, {8, 148, 58}})
            sheet += std::to_string(eps) + ',' + std::to_string(q) + ',' +
                     std::to_string(u + (back_pressure ? 300 : 0)) + '\n';
        const std::string text =
            "[sand]\nname = \"lausitz\"\n[fit]\nparameters = [\"alpha\"]\nstarts = 1\n[[test]]\n"
            "name = \"CU\"\ntest = \"triaxial_undrained\"\nfile = \"lab.csv\"\n"
            "start = { pressure_kPa = 100, void_ratio = 0.75 }\n[test.columns]\n"
            "axial_strain = { column = \"eps [%]\", compression = \"positive\" }\n"
            "pore_pressure = { column = \"u [kPa]\", error = 3" +
            std::string(back_pressure ? ", zero = 300" : "") + " }\n";
        const Answer answer = calibrate(here, text, sheet);
        ASSERT_EQ(answer.status, 0) << answer.text;
        sand[back_pressure] = here.text("out/x_sand.toml");
    }
    EXPECT_EQ(sand[0], sand[1]);
}

// Two tests of a sheet, each with a start of its own.
TEST(Calibrate, StartsEachTestOfASheetWhereItIsSaidTo) {
    const Workplace here;
    std::string sheet = "test,sigma [kPa],e\n";
    std::istringstream rows(oedometer_sheet());
    std::string row;
    std::getline(rows, row);
    while (std::getline(rows, row)) {
        row = row.substr(0, row.rfind(','));
        sheet += "A," + row + "\nB," + row + '\n';
    }
    const Answer answer = calibrate(
        here,
        oedometer_case(oedometer_columns, "split_by = \"test\"\nstarts.A = { void_ratio = 0.748 }\n"
                                          "starts.B = { void_ratio = 0.760 }\n"),
        sheet);
    ASSERT_EQ(answer.status, 0) << answer.text;
    const std::string page = here.text("out/x_report.html");
    EXPECT_NE(page.find("<td>0.748</td>"), std::string::npos);
    EXPECT_NE(page.find("<td>0.76</td>"), std::string::npos);
}

// What is wrong without being impossible is told, on the screen and in the report.
std::string doubts_of(const std::string& text, const std::string& sheet) {
    const Workplace here;
    const Answer answer = calibrate(here, text, sheet);
    EXPECT_EQ(answer.status, 0) << answer.text;
    std::string out;
    std::istringstream lines(answer.text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("look: ")) out += line + '\n';
    EXPECT_EQ(here.text("out/x_report.html").find("Look at this first") != std::string::npos,
              !out.empty());
    return out;
}

// With the error that its digits have.
std::string exact_columns() {
    std::string out = oedometer_columns;
    return out.replace(out.find("0.001"), 5, "1.5e-5");
}

TEST(Doubt, ThereIsNoneAboutAGoodSheet) {
    EXPECT_EQ(doubts_of(oedometer_case(exact_columns()), oedometer_sheet()), "");
}

TEST(Doubt, RowsOutOfOrder) {
    std::string exact = exact_columns();
    std::string sheet = oedometer_sheet();
    sheet.replace(sheet.find("80,0.7388,\n100,0.7368,\n"), 23, "100,0.7368,\n80,0.7388,\n");
    EXPECT_NE(doubts_of(oedometer_case(oedometer_columns, "first_loading = true\n"), sheet)
                  .find("test oedometer: first_loading ends where sigma [kPa] turns back after "
                        "100, and it is 150 "
                        "later: are rows out of order?"),
              std::string::npos);
    EXPECT_EQ(
        doubts_of(oedometer_case(exact, "first_loading = true\nto = 100\n"), oedometer_sheet()),
        "");
}

TEST(Doubt, TestsBelowEachOther) {
    const std::string twice = oedometer_sheet() + oedometer_sheet().substr(21);
    EXPECT_NE(doubts_of(oedometer_case(), twice)
                  .find("sigma [kPa] goes back from 400 to 20 in one row: are these several "
                        "tests (split_by)?"),
              std::string::npos);
}

TEST(Doubt, IndexTestsWithoutErrors) {
    EXPECT_NE(
        doubts_of("[index_tests]\nleast_void_ratio = 0.45\n" + oedometer_case(), oedometer_sheet())
            .find("with least_void_ratio_error they are measurements"),
        std::string::npos);
}

TEST(Doubt, ErrorsThatAreFarTooLargeOrTooSmall) {
    std::string columns = oedometer_columns;
    columns.replace(columns.find("0.001"), 5, "0.1");
    EXPECT_NE(doubts_of(oedometer_case(columns), oedometer_sheet())
                  .find("of the stated errors: these are too large"),
              std::string::npos);
    columns.replace(columns.find("0.1"), 3, "1e-6");
    EXPECT_NE(doubts_of(oedometer_case(columns), oedometer_sheet())
                  .find("a unit, a sign or a start is wrong"),
              std::string::npos);
}

// A drained test with its volume the other way round, and with a deviator in another unit.
TEST(Doubt, SignsAndUnitsThatSandDoesNotHave) {
    const auto sheet = [](double q_times, double v_times) {
        std::ostringstream out;
        out << "eps,q,epsv\n";
        for (const auto& [eps, q, v] : {std::array{0.0, 0.0, 0.0},
                                        {1.0, 130.0, 0.25},
                                        {2.0, 170.0, 0.1},
                                        {4.0, 190.0, -0.7},
                                        {8.0, 190.0, -2.4},
                                        {12.0, 180.0, -3.9}})
            out << eps << ',' << q_times * q << ',' << v_times * v << '\n';
        return out.str();
    };
    const std::string text =
        "[sand]\nname = \"lausitz\"\npyknotropy_exponent = 0.5\nstiffness_void_exponent = "
        "2.5\n[fit]\nparameters = [\"alpha\", \"beta\"]\nstarts = "
        "1\n[[test]]\nname = \"CD\"\n"
        "test = \"triaxial_drained\"\nfile = \"lab.csv\"\nstart = { pressure_kPa = 50, void_ratio "
        "= 0.62 }\n[test.columns]\n"
        "axial_strain = { column = \"eps\", unit = \"%\", compression = \"positive\" }\n"
        "axial_deviator = { column = \"q\", unit = \"kPa\", error = 10 }\n"
        "volumetric_strain = { column = \"epsv\", unit = \"%\", compression = \"positive\", error "
        "= 0.5 }\n";
    EXPECT_EQ(doubts_of(text, sheet(1.0, 1.0)).find("look at its unit and sign"),
              std::string::npos);
    EXPECT_NE(doubts_of(text, sheet(1.0, -1.0))
                  .find("look: test CD: sand as it is estimated from the tests has the other sign "
                        "of volumetric_strain: look at its unit and sign"),
              std::string::npos);
    EXPECT_NE(doubts_of(text, sheet(1e-3, 1.0))
                  .find("look: test CD: sand as it is estimated from the tests has a thousand "
                        "times as much of axial_deviator: look at its unit and sign"),
              std::string::npos);
}

// The rows of a sheet as cells of a workbook.
std::string worksheet(const std::string& sheet) {
    std::string out = "<worksheet><sheetData><row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>"
                      "Oedometer 1</t></is></c></row>";
    std::istringstream lines(sheet);
    int row = 3;
    for (std::string line; std::getline(lines, line); ++row) {
        out += "<row r=\"" + std::to_string(row) + "\">";
        std::istringstream cells(line);
        char column = 'B';
        for (std::string cell; std::getline(cells, cell, ','); ++column) {
            const bool number = !cell.empty() && std::isdigit(cell[0]) != 0;
            out += std::string("<c r=\"") + column + std::to_string(row) + "\"" +
                   (number ? "><v>" + cell + "</v></c>"
                           : " t=\"inlineStr\"><is><t>" + cell + "</t></is></c>");
        }
        out += "</row>";
    }
    return out + "</sheetData></worksheet>";
}

TEST(Calibrate, ReadsASheetOfAWorkbookAsItReadsTheSameCsv) {
    const Workplace here;
    const Answer from_csv = calibrate(here, oedometer_case(), oedometer_sheet());
    ASSERT_EQ(from_csv.status, 0) << from_csv.text;
    const Book book(
        {{"xl/workbook.xml", "<workbook xmlns:r=\"x\"><sheets><sheet name=\"Deckblatt\" "
                             "r:id=\"a\"/><sheet name=\"OED 1\" r:id=\"b\"/></sheets>"
                             "</workbook>"},
         {"xl/_rels/workbook.xml.rels",
          "<Relationships><Relationship Id=\"a\" Target=\"worksheets/a.xml\"/>"
          "<Relationship Id=\"b\" Target=\"worksheets/b.xml\"/></Relationships>"},
         {"xl/worksheets/a.xml", "<worksheet><sheetData/></worksheet>"},
         {"xl/worksheets/b.xml", worksheet(oedometer_sheet())}},
        here.path("lab.xlsx"));
    std::string text = oedometer_case(oedometer_columns, "sheet = \"OED 1\"\nheader_line = 3\n");
    text.replace(text.find("lab.csv"), 7, "lab.xlsx");
    here.write("x.toml", text);
    const Answer from_book = here.grit("calibrate x.toml --out book");
    ASSERT_EQ(from_book.status, 0) << from_book.text;
    std::string expected = here.text("out/x_sand.toml");
    expected.replace(expected.find("lab.csv"), 7, "lab.xlsx");
    EXPECT_EQ(here.text("book/x_sand.toml"), expected);
}

// Made by make_laboratory.py: a workbook of openpyxl, and a CSV with semicolons and decimal commas. Every parameter of the
// sand that they were made of lies in its interval.
TEST(Calibrate, FindsTheSandThatTheSheetsOfALaboratoryWereMadeOf) {
    const Workplace here;
    const Answer answer =
        here.grit("calibrate " GRIT_CALIBRATIONS "/laboratory.toml --samples 0 --out out");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_FALSE(answer.says("look: ")) << answer.text;
    std::istringstream sand(here.text("out/laboratory_sand.toml"));
    const std::map<std::string, double> truth = {{"phi_c", 33.0}, {"h_s", 0.82e6}, {"n", 0.29},
                                                 {"e_d0", 0.55},  {"e_c0", 0.92},  {"e_i0", 1.05},
                                                 {"alpha", 0.16}, {"beta", 1.5}};
    std::size_t found = 0;
    for (std::string line; std::getline(sand, line);) {
        std::istringstream words(line);
        std::string hash, symbol, dots;
        double low = NAN, high = NAN;
        if (!(words >> hash >> symbol >> low >> dots >> high) || dots != "...") continue;
        ++found;
        EXPECT_TRUE(low < truth.at(symbol) && truth.at(symbol) < high) << line;
        EXPECT_LT(high - low, (symbol == "h_s"     ? 1.0
                               : symbol == "alpha" ? 0.6
                                                   : 0.35) *
                                  truth.at(symbol))
            << line;
    }
    EXPECT_EQ(found, truth.size());
}

TEST(Calibrate, KeepsTheBestFitWhenSamplingIsInterrupted) {
    const Workplace here;
    here.write("lab.csv", oedometer_sheet());
    here.write("x.toml", oedometer_case());
    const Answer answer =
        here.grit("calibrate x.toml --out out --samples 10000000 > log 2>&1 & of=$!; "
                  "for i in $(seq 600); do grep -q 'best fit' log && break; sleep 0.1; done; "
                  "kill -INT $of; wait $of; status=$?; cat log; exit $status");
    EXPECT_EQ(answer.status, 1) << answer.text;
    EXPECT_TRUE(answer.says("sampling was stopped on request: intervals are those of a normal"))
        << answer.text;
    EXPECT_EQ(here.files("out"), (std::set<std::string>{"x_report.html", "x_sand.toml"}));
}

// The rows of tests that are held out: the last number is the error over that of the published set.
TEST(Calibrate, ComesNearerToKarlsruheSandThatItHasNotSeenThanThePublishedSet) {
    const Workplace here;
    const Answer answer =
        here.grit("calibrate " GRIT_CALIBRATIONS "/karlsruhe.toml --samples 0 --out out");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("5 of 5 starts end there")) << answer.text;
    std::istringstream lines(answer.text);
    int held = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.find(" held    ") == std::string::npos) continue;
        ++held;
        EXPECT_LT(std::stod(line.substr(line.rfind(' '))), 1.0) << line;
    }
    EXPECT_EQ(held, 5) << answer.text;
}

TEST(Calibrate, LeavesItsInputsAlone) {
    const Workplace here;
    here.write("lab.csv", oedometer_sheet());
    here.write("x.toml", oedometer_case());
    here.write("x_sand.toml", here.text("x.toml"));
    std::string text = oedometer_case();
    text.replace(text.find("name = \"lausitz\""), 16, "file = \"x_sand.toml\"");
    here.write("x.toml", text);
    const Answer answer = here.grit("calibrate x.toml");
    EXPECT_EQ(answer.status, 2) << answer.text;
}

}  // namespace
