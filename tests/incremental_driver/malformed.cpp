// SPDX-License-Identifier: BSD-3-Clause
// Files that cannot be used: one line on stderr that says file, line, what and value; exit status 2;
// nothing written.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdio>

#include "support/folder.hpp"

namespace {

struct Answer {
    int status = -1;
    std::string text;  // stdout and stderr
};

Answer run_grit(const std::string& arguments) {
    const std::string command = std::string(GRIT_CLI) + " " + arguments + " 2>&1";
    Answer out;
    std::FILE* pipe = popen(command.c_str(), "r");
    char buffer[4096];
    while (std::fgets(buffer, sizeof buffer, pipe)) out.text += buffer;
    out.status = WEXITSTATUS(pclose(pipe));
    return out;
}

struct Bad {
    const char* name;
    const char* file;
    std::string text;
    int line;
    const char* says;
};

std::string with_line(std::string text, int number, const std::string& line) {
    std::size_t begin = 0;
    for (int i = 1; i < number; ++i) begin = text.find('\n', begin) + 1;
    return text.replace(begin, text.find('\n', begin) - begin, line);
}

Bad parameter(const char* name, int line, const char* value, const char* says) {
    return {name, "parameters.inp", with_line(lausitz_parameters(), line, value), line, says};
}

Bad initial(const char* name, int line, const char* value, const char* says) {
    return {name, "initialconditions.inp", with_line(isotropic(100, 0.7), line, value), line, says};
}

// Line 1 is "result.out".
Bad test(const char* name, const std::string& steps, int line, const char* says) {
    return {name, "test.inp", "result.out\n" + steps, line, says};
}

const std::string six = "0 0\n0 0\n0 0\n0 0\n0 0\n0 0\n";
const std::string rows = "ed1 = -0.01\nsd2 = 0\nsd3 = 0\ned4 = 0\ned5 = 0\n";

const std::vector<Bad> bad_files{
    {"EmptyParameters", "parameters.inp", "", 0, "the name of the material"},
    {"NoNumberOfProps", "parameters.inp", "sand\nmany\n", 2, "nprops, a number, got \"many\""},
    {"FractionalNprops", "parameters.inp", "sand\n16.5\n", 2, "nprops must be a whole number"},
    {"FewerPropsThanSaid", "parameters.inp", "sand\n16\n33\n0\n1e6\n", 5, "PROPS(4) of 16"},
    {"TooFewProps", "parameters.inp", "sand\n2\n33\n0\n", -1, "nprops must be at least 16"},
    parameter("PropsNotANumber", 5, "1.6x6", "PROPS(3) of 16, a number, got \"1.6x6\""),
    parameter("PropsNan", 6, "nan", "PROPS(4)"),
    parameter("AngleInRadians", 3, "0.576", "PROPS(1): phi_c must be in [10, 60] degrees"),
    parameter("NegativeHardness", 5, "-1.6e6", "PROPS(3): granulate_hardness"),
    parameter("LooserThanLoosest", 8, "1.2", "critical_void_ratio"),
    {"ToleranceTooLarge", "parameters.inp",
     with_line(with_line(lausitz_parameters(), 2, "17"), 18, "10.6\n0.2"), 19,
     "PROPS(17): tolerance must be in [1e-12, 0.1], got 0.2"},
    parameter("NegativeWater", 17, "-1", "PROPS(15): K_w must be >= 0, got -1"),
    {"BinaryParameters", "parameters.inp", std::string("a\0b\n", 4), 1, "not a line of text"},

    {"EmptyInitialConditions", "initialconditions.inp", "", 0, "ntens"},
    initial("SevenComponents", 1, "7", "ntens must be a whole number in [1, 6], got 7"),
    initial("StressNotANumber", 3, "-1oo", "stress(2) of 6, a number, got \"-1oo\""),
    initial("NegativeNstatv", 8, "-3", "nstatv must be a whole number in [0, 10000], got -3"),
    initial("TooFewStateVariables", 8, "7", "nstatv must be at least 13"),
    initial("StateNotANumber", 9, "h", "statev(1) of 14, a number"),
    {"MissingNstatv", "initialconditions.inp", "3\n-1\n-1\n-1\n", 4, "nstatv"},
    {"NoTemperature", "initialconditions.inp", "1\n-1\ntemperature = warm\n1\n", 3, "temperature"},
    {"IntergranularStrainTooLarge", "initialconditions.inp",
     with_line(isotropic(100, 0.7), 9, "1.0"), 8, "the sand cannot start from this state"},

    {"EmptyTest", "test.inp", "", 0, "the name of the output file"},
    {"NoOutputName", "test.inp", "*TriaxialE1\n10 5 1\n-0.1\n", 1, "name of the output file"},
    {"OutputOverInput", "test.inp", "test.inp\n*PureCreep\n10 5 1\n", 1, "would overwrite"},
    test("NoStep", "*End\n", 1, "there is no step"),
    test("UnknownStep", "*TriaxalE1\n10 5 1\n-0.1\n", 2, "nearest: *TriaxialE1"),
    test("UnknownWord", "elephant\n", 2, "unknown step \"elephant\"; known here:"),
    test("ConditionWithoutMark", "*PureCreep s1 < -200\n10 5 1\n", 2,
         "a condition follows ?, got \"s1 < -200\" behind *PureCreep"),
    test("ConditionOnProbes", "*PerturbationsE ? s1 < 0\n8 5 1\n*Cartesian\n1e-5\n", 2,
         "no condition can end them"),
    {"OutputOverInputUnderAnotherName", "test.inp", "./parameters.inp\n*PureCreep\n10 5 1\n", 1,
     "would overwrite"},
    {"OutputOverImport", "test.inp",
     "./initialconditions.inp\n*ImportFile initialconditions.inp|1\n5 5 1\n*Cartesian\n" + six, 1,
     "would overwrite"},
    {"OutputElsewhere", "test.inp", "/tmp/grit_elsewhere\n*PureCreep\n10 5 1\n", 1,
     "not elsewhere, got \"/tmp/grit_elsewhere\""},
    {"OutputAbove", "test.inp", "sub/../../out\n*PureCreep\n10 5 1\n", 1, "not elsewhere"},
    test("NoIncrements", "*PureCreep\n0 5 1\n", 3, "ninc must be a whole number in [1,"),
    test("NoTime", "*PureCreep\n10 5\n", 3, "expected dtime, the line ends"),
    test("NegativeTime", "*PureCreep\n10 5 -1\n", 3, "dtime must be >= 0"),
    test("EveryNotANumber", "*PureCreep\n10 5 1 : x\n", 3, "every"),
    test("TemperatureNotANumber", "*PureCreep\n10 5 1 T hot\n", 3, "temperature behind T"),
    test("MissingChange", "*TriaxialE1\n10 5 1\n", 3, "the change of *TriaxialE1"),
    test("ChangeNotANumber", "*TriaxialE1\n10 5 1\ntwo\n", 4, "got \"two\""),
    test("DecimalComma", "*TriaxialE1\n10 5 1\n-0,2\n", 4, "got \"-0,2\": decimals follow a point"),
    test("UnknownVariables", "*LinearLoad\n10 5 1\n*Polar\n" + six, 4, "got \"*Polar\""),
    test("NeitherStressNorStrain", "*LinearLoad\n10 5 1\n*Cartesian\n2 -10\n" + six, 5,
         "ifstress (1 stress, 0 strain) must be a whole number in [0, 1], got 2"),
    test("FiveComponents", "*LinearLoad\n10 5 1\n*Cartesian\n0 0\n0 0\n0 0\n0 0\n0 0\n", 9,
         "component 6 of 6"),
    test("NoDrift", "*CirculatingLoad\n10 5 1\n*Cartesian\n0 1e-3 0\n" + six, 5, "change"),
    test("EmptyCondition", "*PureCreep ?\n10 5 1\n", 2, "expected a condition behind ?"),
    test("ConditionWithoutLimit", "*PureCreep ? s1\n10 5 1\n", 2, "exit condition \"s1\""),
    test("UnknownQuantity", "*PureCreep ? sigma < 1\n10 5 1\n", 2, "unknown quantity \"sigma\""),
    test("StateVariableThatIsNot", "*PureCreep ? v15 < 1\n10 5 1\n", 2, "there is no v15"),
    test("NumberCut", "*PureCreep ? 1.0*s1 - 0.5*s2-0.5*s3 < -4000\n10 5 1\n", 2,
         "column 40, which cuts \"-4000\""),
    test("ConditionCut", "*PureCreep ? 1.0*s1 - 0.5*s2 - 0.5*s3 < -4000\n10 5 1\n", 2, "column 40"),
    test("Inside", "*DeformationGradient\n10 5 1\n-1\n1\n1\n0\n0\n0\n0\n0\n0\n", 12,
         "det F must be > 0"),
    test("NoEquals", "*ObeyRestrictions\n10 5 1\n" + rows + "sd1 + sd2\n", 9, "expected = at"),
    test("UnknownTerm", "*ObeyRestrictions\n10 5 1\n" + rows + "sd7 = 0\n", 9, "got \"sd7\""),
    test("NoRightHandSide", "*ObeyRestrictions\n10 5 1\n" + rows + "sd1 =\n", 9,
         "expected a number at"),
    test("TwoRightHandSides", "*ObeyRestrictions\n10 5 1\n" + rows + "sd1 = 1 2\n", 9,
         "expected the end at"),
    test("NoRestriction", "*ObeyRestrictions\n10 5 1\n" + rows + "0*sd1 = 0\n", 9, "nothing"),
    test("SameRestrictionTwice", "*ObeyRestrictions\n10 5 1\n" + rows + "2*ed5 = 0\n", 2,
         "only 5 different things"),
    test("NoBar", "*ImportFile table.txt\n10 5 1\n" + six, 2, "*ImportFile name|columns"),
    test("NoSuchTable", "*ImportFile nowhere.txt|3\n10 5 1\n*Cartesian\n" + six, -1,
         "nowhere.txt: cannot read this file"),
    test("NoSuchColumn", "*ImportFile result.txt|3\n10 5 1\n*Cartesian\n0 4\n" + six, 5,
         "column must be a whole number in [0, 3], got 4"),
    test("NothingToRepeat", "*Repetition\n2 3\n*PureCreep\n10 5 1\n", 5, "a step of *Repetition"),
    test("RepetitionOfNothing", "*Repetition\n0 3\n", 3, "nSteps"),
    test("RepetitionInside", "*Repetition\n2 3\n*PureCreep\n10 5 1\n*Repetition\n2 2\n", 6,
         "step 2 of the 2 of *Repetition, got *Repetition"),
};

class MalformedFile : public testing::TestWithParam<Bad> {};

TEST_P(MalformedFile, IsAnsweredWithOneLineAndNothingIsWritten) {
    const Bad& bad = GetParam();
    const Folder folder;
    Folder::fill(folder);
    folder.write(bad.file, bad.text);
    const auto before = folder.files();
    const Answer answer = run_grit("element --incremental-driver " + folder.path().string());
    EXPECT_EQ(answer.status, 2) << answer.text;
    EXPECT_EQ(answer.text.find('\n') + 1, answer.text.size()) << answer.text;
    EXPECT_NE(answer.text.find(bad.says), std::string::npos) << answer.text;
    if (bad.line >= 0) {
        const std::string where =
            "grit: " + folder.path(bad.file).string() + ":" + std::to_string(bad.line) + ": ";
        EXPECT_EQ(answer.text.substr(0, where.size()), where) << answer.text;
    }
    EXPECT_EQ(folder.files(), before);
}

INSTANTIATE_TEST_SUITE_P(IncrementalDriver, MalformedFile, testing::ValuesIn(bad_files),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(IncrementalDriverFolder, ThatIsMissingIsSaid) {
    const Answer answer = run_grit("element --incremental-driver /nowhere/at/all");
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.text, "grit: /nowhere/at/all/parameters.inp: cannot read this file\n");
}

TEST(IncrementalDriverUmat, ThatIsMissingIsSaid) {
    const Folder folder;
    Folder::fill(folder);
    const Answer answer = run_grit("element --incremental-driver " + folder.path().string() +
                                   " --umat " + folder.path("libNONE.so").string());
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.text.find("libNONE.so"), std::string::npos) << answer.text;
    EXPECT_FALSE(folder.files().contains("result.out"));
}

}  // namespace
