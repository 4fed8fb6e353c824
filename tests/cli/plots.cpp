// SPDX-License-Identifier: BSD-3-Clause
// grit plot: what a file holds, in which units, under which names.
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/workplace.hpp"

namespace {

bool gnuplot_is_there() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

std::string stage(const std::string& test, const std::string& load) {
    return "[[stage]]\ntest = \"" + test + "\"\n" + load + "\n";
}

const std::string drained = stage("triaxial_drained", "axial_strain = -0.02");
const std::string oedometer = stage("oedometer", "axial_strain = -0.02");
const std::string undrained_cycles =
    stage("triaxial_undrained", "axial_strain_amplitude = -2e-3\ncycles = 4");

// Labels of the axes, each once, without what marks the text up.
std::string axes(const std::string& svg) {
    std::string out;
    for (const char* label :
         {"axial compression", "volumetric compression", "q = ", "effective mean pressure",
          "void ratio", "excess pore pressure [", "excess pore pressure u/p", "mobilised",
          "axial stress", "shear stress", "normal stress", "shear strain amplitude",
          "secant shear modulus", "damping", "cycle N", "depth", "velocity", "energy residual"})
        if (svg.find(label) != std::string::npos) out += std::string(label) + "; ";
    return out;
}

std::string name_of_run(int number) {
    return (number < 10 ? "run0" : "run") + std::to_string(number) + ".csv";
}

class Plot : public testing::Test {
  protected:
    void run(const std::string& name, const std::string& stages) const {
        here.write_case(name, stages);
        const Answer answer = here.run(name);
        EXPECT_EQ(answer.status, 0) << answer.text;
    }
    // Axes of what grit plot draws of these arguments.
    std::string axes_of(const std::string& arguments) const {
        const Answer answer = here.grit("plot " + arguments + " --out p");
        EXPECT_EQ(answer.status, 0) << answer.text;
        return axes(here.text("p.svg"));
    }
    void refused(const std::string& arguments, const std::string& words) const {
        const Answer answer = here.grit("plot " + arguments + " --out refused");
        EXPECT_EQ(answer.status, 2) << arguments << ": " << answer.text;
        EXPECT_TRUE(answer.says(words)) << "expected " << words << "\ngot " << answer.text;
        EXPECT_FALSE(here.files().contains("refused.svg"));
    }
    Workplace here;
};

// The picture of grit element, whatever the test.
TEST_F(Plot, OfAResultIsThatOfGritElement) {
    if (!gnuplot_is_there()) return;
    for (const auto& [name, stages] : std::map<std::string, std::string>{
             {"triaxial", drained},
             {"undrained", stage("triaxial_undrained", "axial_strain = -0.02")},
             {"oedometer", oedometer},
             {"isotropic", stage("isotropic", "pressure_kPa = 300")},
             {"shear", stage("simple_shear_constant_stress", "shear_strain = 0.05")},
             {"volume", stage("simple_shear_constant_volume", "shear_strain = 0.05")},
             {"cycles", undrained_cycles}}) {
        here.write_case(name, stages);
        ASSERT_EQ(here.grit("element --quiet --out out " + name + ".toml").status, 0);
        EXPECT_EQ(axes_of("out/" + name + ".csv"), axes(here.text("out/" + name + ".svg"))) << name;
        // And where the file does not say it, its columns do.
        std::string old = here.text("out/" + name + ".csv");
        const std::size_t line = old.find("# picture: ");
        old.erase(line, old.find('\n', line) + 1 - line);
        here.write("old.csv", old);
        EXPECT_EQ(axes_of("old.csv"), axes(here.text("out/" + name + ".svg"))) << name;
    }
}

TEST_F(Plot, OfCyclesIsOverTheirNumber) {
    if (!gnuplot_is_there()) return;
    run("x", undrained_cycles);
    const std::string undrained = axes_of("out/x_cycles.csv");
    EXPECT_EQ(undrained, "excess pore pressure u/p; shear strain amplitude; secant shear modulus; "
                         "damping; cycle N; ");
    EXPECT_EQ(axes_of("out/x.csv --kind cycles"), undrained);
    const auto result = here.result("x_cycles");
    EXPECT_NEAR(result.at("u/p0").back(), result.at("pore_pressure").back() / 100.0, 1e-12);
    here.write("w.toml", "picture = \"cycles\"\n" + here.text("x.toml"));
    ASSERT_EQ(here.grit("element --quiet --out out w.toml").status, 0);
    EXPECT_EQ(axes(here.text("out/w.svg")), undrained);
    EXPECT_EQ(axes_of("out/w.csv"), undrained);
    // A column less, a panel less.
    here.write("few.csv", "cycle,damping [-]\n1,0.1\n2,0.2\n");
    EXPECT_EQ(axes_of("few.csv"), "damping; cycle N; ");
    // Drained there is no pore pressure, and nothing is drawn of none.
    run("y", stage("triaxial_drained", "axial_strain_amplitude = -1e-3\ncycles = 2"));
    EXPECT_EQ(axes_of("out/y_cycles.csv").find("pore pressure"), std::string::npos);
    run("z", drained);
    refused("out/z.csv --kind cycles", "a picture of cycles needs cycles, as in RUN_cycles.csv");
}

TEST_F(Plot, HasNoPanelOfNoise) {
    if (!gnuplot_is_there()) return;
    run("x", stage("triaxial_undrained", "axial_strain = -0.02"));
    EXPECT_EQ(axes_of("out/x.csv --kind triaxial"),
              "axial compression; q = ; effective mean pressure; ");
}

TEST_F(Plot, OfTwoKindsOfTestIsRefused) {
    if (!gnuplot_is_there()) return;
    run("a", oedometer);
    run("b", drained);
    refused("out/a.csv out/b.csv",
            "out/a.csv is for a picture of oedometer, and out/b.csv for one of triaxial");
    EXPECT_NE(axes_of("out/a.csv out/b.csv --kind triaxial"), "");
    // Drained and undrained triaxial tests may be seen together, and loops.
    run("u", stage("triaxial_undrained", "axial_strain = -0.02"));
    EXPECT_EQ(axes_of("out/b.csv out/u.csv"), axes_of("out/b.csv"));
    EXPECT_EQ(axes_of("out/u.csv out/b.csv"), axes_of("out/u.csv"));
    run("c", stage("triaxial_drained", "axial_strain_amplitude = -1e-3\ncycles = 2"));
    EXPECT_EQ(axes_of("out/b.csv out/c.csv"), axes_of("out/b.csv"));
}

TEST_F(Plot, OfAFileOfNothingKnownTellsItsColumns) {
    if (!gnuplot_is_there()) return;
    here.write("x.csv", "wind [m/s],rain [mm]\n1,2\n2,3\n");
    refused("x.csv", "x.csv: no picture that is known here has two of its columns (wind, rain); "
                     "--x COLUMN --y COLUMN,... draws any");
}

TEST_F(Plot, OfAFolderNamesItsResults) {
    if (!gnuplot_is_there()) return;
    run("a", drained);
    refused("out", "out is a folder: name results in it, out/a.csv; grit report out shows all");
    refused("--data .", ". is a folder, without results");
}

#ifdef GRIT_MPM_CASES
TEST_F(Plot, OfHistoriesIsThatOfGritMpm) {
    if (!gnuplot_is_there()) return;
    const std::string mpm = "mpm " GRIT_MPM_CASES "/every_key.toml --quiet --out ";
    ASSERT_EQ(here.grit(mpm + "out").status, 0);
    ASSERT_EQ(here.grit(mpm + "other --no-plot --set numerics.cfl=0.3").status, 0);
    const std::string alone = axes_of("out/every_key.csv");
    EXPECT_EQ(alone, "depth; velocity; energy residual; ");
    EXPECT_EQ(alone, axes(here.text("out/every_key.svg")));
    EXPECT_EQ(axes_of("out/every_key.csv other/every_key.csv"), alone);
    EXPECT_NE(here.text("p.svg").find("other/every"), std::string::npos);
    run("b", drained);
    refused("other/every_key.csv out/b.csv", "other/every_key.csv is for a picture of history");
    here.write("n.csv", replaced(here.text("out/every_key.csv"), "depth [m]", "depth [mm]"));
    refused("out/every_key.csv n.csv", "n: depth is in depth [mm], and of what is drawn beside it "
                                       "depth [m]");
}
#endif

// What is drawn of points does not depend on the units they are written in.
TEST_F(Plot, ConvertsUnitsInTheHeader) {
    if (!gnuplot_is_there()) return;
    const auto picture = [&](const std::string& text, const std::string& options = "") {
        here.write("lab.csv", text);
        const Answer answer = here.grit("plot --data lab.csv --out p " + options);
        EXPECT_EQ(answer.status, 0) << answer.text;
        return here.text("p.svg");
    };
    const std::string plain = picture("eps_a_percent,q_kPa\n0,0\n1,120.5\n3,180\n");
    EXPECT_EQ(picture("axial_strain [%],axial_deviator [MPa]\n0,0\n-1,0.1205\n-3,0.18\n"), plain);
    EXPECT_EQ(picture("eps_a_percent [-],q_kPa [bar]\n0,0\n0.01,1.205\n0.03,1.8\n"), plain);
    const std::string names = "--column eps_a_percent=Axial ";
    EXPECT_EQ(picture("Axial [permille],Deviator [Pa]\n0,0\n10,120500\n30,180000\n",
                      names + "--column q_kPa=Deviator"),
              plain);
    EXPECT_EQ(picture("Axial,Deviator (MPa)\n0,0\n1,0.1205\n3,0.18\n",
                      names + "--column 'q_kPa=Deviator (MPa)'"),
              plain);
    EXPECT_EQ(picture("Axial,Deviator_MPa\n0,0\n1,0.1205\n3,0.18\n",
                      names + "--column q_kPa=Deviator_MPa"),
              plain);
    here.write("lab.csv", "eps_a_percent,q_kPa [ksi],p_kPa\n0,0,1\n1,2,3\n");
    refused("--data lab.csv",
            "lab.csv: column q_kPa: its unit [ksi] is not known here; known: kPa");
}

TEST_F(Plot, TakesAHeaderWithItsUnitAsItStands) {
    if (!gnuplot_is_there()) return;
    here.write("lab.csv", "Axial [%],Deviator [kPa]\n0,0\n1,120\n");
    const std::string strain = "--data lab.csv --column eps_a_percent=Axial --column ";
    EXPECT_EQ(axes_of(strain + "'q_kPa=Deviator [kPa]'"), "axial compression; q = ; ");
    EXPECT_EQ(axes_of(strain + "q_kPa=Deviator"), "axial compression; q = ; ");
    refused(strain + "'q_kPa=Deviatr [kPa]'", "nearest: Deviator [kPa]");
}

TEST_F(Plot, TakesNoNameThatNoPictureDraws) {
    if (!gnuplot_is_there()) return;
    here.write("lab.csv", "Axial,Deviator\n0,0\n1,120\n");
    refused("--data lab.csv --column q=Deviator",
            "--column q=Deviator: no picture of a kind draws \"q\"; nearest: q_kPa");
    refused("--data lab.csv --column foo=Deviator",
            "there is no column \"foo\"; known here: eps_a_");
    refused("x.csv --column q_kPa=Deviator", "--column requires --data");
    refused("x.csv --only A", "--only requires --data");
    EXPECT_EQ(here.grit("plot --data lab.csv --column q=Deviator --column axial_strain=Axial "
                        "--x axial_strain --y q --out p")
                  .status,
              0);
}

TEST_F(Plot, TellsItsKinds) {
    if (!gnuplot_is_there()) return;
    run("x", drained);
    refused("out/x.csv --kind oedometr",
            "--kind: there is no kind \"oedometr\"; nearest: oedometer");
    const std::string all = here.grit("plot out/x.csv --kind wind").text;
    EXPECT_EQ(all.find("oedometer"), all.rfind("oedometer")) << all;
    for (const char* command : {"plot --help", "man", "completion bash"}) {
        const Answer answer = here.grit(command);
        for (const char* kind : {"oedometer", "cycles", "shear_constant_volume", "history"})
            EXPECT_TRUE(answer.says(kind)) << command << ' ' << kind;
    }
}

// Where the grid of the first panel begins.
double left_of(const std::string& svg) {
    const std::string grid = "class=\"gridline\"  d='M";
    return std::atof(svg.c_str() + svg.find(grid) + grid.size());
}

// Numbers are short, and where they are not, they have room; neither leaves a label off the picture.
TEST_F(Plot, HasAPowerOfTenInTheUnitOrRoomForNumbers) {
    if (!gnuplot_is_there()) return;
    const auto drawn = [&](const std::string& values) {
        here.write("x.csv", "t [s],depth [m],count [-]\n" + values);
        EXPECT_EQ(here.grit("plot x.csv --x t --y depth,count --out p").status, 0);
        return here.text("p.svg");
    };
    const auto has = [](const std::string& svg, const std::string& word) {
        return svg.find(word) != std::string::npos;
    };
    const std::string plain = drawn("0,0,1\n1,4.5,2\n");
    EXPECT_FALSE(has(plain, ">10<")) << plain;
    const std::string small = drawn("0,0,0\n1,4.5e-5,2e6\n");
    EXPECT_TRUE(has(small, ">-6<") && has(small, ">6<") && has(small, " 45<")) << small;
    EXPECT_FALSE(has(small, "0.0000") || has(small, "\u00d7")) << small;
    EXPECT_NEAR(left_of(small), left_of(plain), 1.0);
    EXPECT_GT(left_of(drawn("0,0.61234,1\n1,0.61238,2\n")), left_of(plain) + 10.0);
}

// The number at the left end of a logarithmic axis, where a test begins.
TEST_F(Plot, HasANumberAtBothEndsOfALogarithmicAxis) {
    if (!gnuplot_is_there()) return;
    here.write("y.csv", "stress_11 [kPa],void_ratio [-]\n-100.00001,0.6\n-1000,0.5\n");
    EXPECT_NE(axes_of("y.csv --kind oedometer"), "");
    EXPECT_NE(here.text("p.svg").find(">100<"), std::string::npos) << here.text("p.svg");
}

// Values that differ in their last bits are one value, on every axis; and the pictures of tests at constant p, which
// Newton's method leaves within a tolerance, are drawn.
TEST_F(Plot, OfValuesThatDifferByRoundoffIsThatOfOneValue) {
    if (!gnuplot_is_there()) return;
    here.write("x.csv", "t [s],a [-],b [-],c [-]\n0,100,0.7,5e-324\n"
                        "1,100.00000000000001,0.7000000000000001,1e-320\n2,100,0.7,0\n");
    for (const char* axes : {"--x t --y a", "--x t --y b,c", "--x a --y t", "--x a --y b"})
        EXPECT_EQ(here.grit(std::string("plot x.csv --out p ") + axes).status, 0) << axes;
    here.write("y.csv", "stress_11 [kPa],void_ratio [-]\n-100,0.6\n-100.0000001,0.5\n");
    EXPECT_NE(axes_of("y.csv --kind oedometer"), "");
    here.write_case("z", stage("triaxial_constant_p", "axial_strain = -0.02"));
    const Answer answer = here.grit("element --out out z.toml");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(here.files("out").contains("z.svg"));
}

// Points of a laboratory are left out where one would cover the other, on the axis as it is drawn.
TEST_F(Plot, HasPointsAlongTheWholeOfALogarithmicAxis) {
    if (!gnuplot_is_there()) return;
    std::string sheet = "stress_11 [kPa],void_ratio [-]\n";
    for (int i = 0; i <= 10; ++i)
        sheet += std::to_string(-(1 << i)) + "," + std::to_string(0.7 - 0.002 * i) + "\n";
    here.write("lab.csv", sheet);
    EXPECT_NE(axes_of("--data lab.csv --kind oedometer"), "");
    const std::string svg = here.text("p.svg");
    std::size_t points = 0;
    for (std::size_t at = 0; (at = svg.find("xlink:href='#gpPt", at)) != std::string::npos; ++at)
        ++points;
    EXPECT_GE(points, 11U) << svg;
}

TEST_F(Plot, TellsRunsOfOneNameApart) {
    if (!gnuplot_is_there()) return;
    for (const char* path : {"p/r/x.csv", "q/r/x.csv"}) {
        std::filesystem::create_directories(here.path(path).parent_path());
        here.write(path, "t [s],a [-]\n0,1\n1,2\n");
    }
    EXPECT_EQ(here.grit("plot p/r/x.csv q/r/x.csv --x t --y a --out p").status, 0);
    for (const char* label : {"p/r/x.csv", "q/r/x.csv"})
        EXPECT_NE(here.text("p.svg").find(label), std::string::npos) << label;
    here.write_case("y", drained);
    here.write_case("z", drained);
    EXPECT_EQ(here.grit("element --out out y.toml z.toml --set title=One").status, 0);
    EXPECT_NE(here.text("out/comparison.svg").find("(z)"), std::string::npos);
}

// Fourteen runs in the order of their colours, with a key of several columns.
TEST_F(Plot, OfManyRunsHasAColourForEachAndALowKey) {
    if (!gnuplot_is_there()) return;
    std::string files;
    for (int i = 0; i < 14; ++i) {
        const std::string name = name_of_run(i);
        here.write(name, "t [s],depth [m]\n0,0\n1," + std::to_string(i + 1) + "\n");
        files += name + " ";
    }
    ASSERT_EQ(here.grit("plot " + files + "--x t --y depth --out many").status, 0);
    ASSERT_EQ(here.grit("plot run00.csv run01.csv --x t --y depth --out two").status, 0);
    const auto height = [&](const std::string& name) {
        const std::string svg = here.text(name);
        return std::atof(svg.c_str() + svg.find("height=\"") + 8);
    };
    EXPECT_LT(height("many.svg"), height("two.svg") + 120.0);
    const std::string svg = here.text("many.svg");
    std::set<std::string> colours;
    for (std::size_t at = 0; (at = svg.find("stroke='rgb(", at)) != std::string::npos; ++at)
        colours.insert(svg.substr(at, svg.find(')', at) - at));
    EXPECT_GE(colours.size(), 14u);
    EXPECT_TRUE(colours.contains("stroke='rgb( 68,   1,  84")) << *colours.begin();
}

TEST_F(Plot, TellsDataOfTheOtherSign) {
    if (!gnuplot_is_there()) return;
    run("x", drained);
    const auto said = [&](const std::string& header, const std::string& strain) {
        here.write("lab.csv", header + ",q_kPa\n0,0\n" + strain + ",100\n");
        return here.grit("plot out/x.csv --data lab.csv --out p").text;
    };
    EXPECT_NE(
        said("axial_strain [%]", "2")
            .find("axial_strain of lab.csv has the other sign than out/x.csv; compression positive "
                  "is eps_a_percent\n"),
        std::string::npos);
    EXPECT_NE(said("eps_a_percent", "-2")
                  .find("eps_a_percent of lab.csv has the other sign than "
                        "out/x.csv; tension positive is axial_strain\n"),
              std::string::npos);
    EXPECT_EQ(said("axial_strain [%]", "-2").find("other sign"), std::string::npos);
    EXPECT_EQ(said("eps_a_percent", "2").find("other sign"), std::string::npos);
}

TEST_F(Plot, TakesTabsEndingsAndUnitsInParentheses) {
    if (!gnuplot_is_there()) return;
    here.write("lab.csv", "Axial strain (%)\tDeviator (MPa)\n0\t0\n1,5\t0,12\n");
    const std::string names = "--data lab.csv --column eps_a_percent='Axial strain' --column "
                              "q_kPa=Deviator";
    EXPECT_EQ(axes_of(names), "axial compression; q = ; ");
    const std::string tabs = here.text("p.svg");
    here.write("lab.csv", "eps_a_percent,q_kPa\n0,0\n1.5,120\n");
    EXPECT_EQ(axes_of("--data lab.csv"), "axial compression; q = ; ");
    EXPECT_EQ(here.text("p.svg"), tabs);
    // What parts cells is a letter between quotation marks; a mark that is not closed, an inch, is one.
    here.write("lab.csv", "\"test, \"\"a\"\"\",rod,eps_a_percent,q_kPa\n\"1, first\",\"a,b\",0,0\n"
                          "2,2\",1.5,120\n");
    EXPECT_EQ(axes_of("--data lab.csv"), "axial compression; q = ; ");
    EXPECT_EQ(here.text("p.svg"), tabs);
    EXPECT_TRUE(here.grit("plot --data lab.csv --out r.svg --pdf").says("r.svg and .png, .pdf"));
    EXPECT_TRUE(here.grit("plot --data lab.csv --out s.pdf").says("s.svg and .png, .pdf"));
    EXPECT_TRUE(here.files().contains("r.svg") && here.files().contains("s.pdf"));
    EXPECT_FALSE(here.files().contains("r.svg.svg"));
    refused("r.png", "r.png: is no table");
    // Others' names for columns of any kind, and units that nobody has said.
    here.write("any.csv", "time,e,q\n0,0.6,1\n1,0.5,2\n");
    ASSERT_EQ(here.grit("plot any.csv --x time --y q,e --out any").status, 0);
    EXPECT_NE(here.text("any.svg").find("void ratio e"), std::string::npos);
    EXPECT_EQ(here.text("any.svg").find("time [s]"), std::string::npos);
    run("x", drained);
    EXPECT_EQ(here.grit("plot out/x.csv --x time --y q,e --out any").status, 0);
    EXPECT_NE(here.text("any.svg").find("time [s]"), std::string::npos);
}

// Data that the first panel has not are in the key all the same.
TEST_F(Plot, HasAllThatItDrawsInItsKey) {
    if (!gnuplot_is_there()) return;
    run("x", drained);
    here.write("measured.csv", "p_kPa,void_ratio\n100,0.6\n110,0.59\n");
    EXPECT_NE(axes_of("out/x.csv --data measured.csv"), "");
    EXPECT_NE(here.text("p.svg").find("measured"), std::string::npos);
    here.write("other.csv", "sigma_r_kPa\n1\n2\n");
    EXPECT_TRUE(here.grit("plot out/x.csv --data other.csv --out p")
                    .says("nothing of other.csv is in this picture of triaxial"));
}

}  // namespace
