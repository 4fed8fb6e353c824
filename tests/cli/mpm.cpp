// SPDX-License-Identifier: BSD-3-Clause
// grit mpm as people call it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "support/workplace.hpp"

namespace {

using Names = std::set<std::string>;

const std::string cases = GRIT_MPM_CASES;

// A column in a tube for so many seconds.
std::string column(const std::string& seconds, const std::string& numerics = "") {
    return "[grid]\ngeometry = \"axisymmetric\"\n[[grid.r]]\nto_m = 0.2\ncells = 4\n"
           "[[grid.z]]\nto_m = 1.2\ncells = 24\n"
           "[boundary]\nright = \"roller\"\nbottom = \"roller\"\n[numerics]\n" +
           numerics +
           "[[body]]\nname = \"column\"\ndensity_kg_per_m3 = 1000\n[[body.box]]\n"
           "r_m = [0, 0.2]\nz_m = [0, 1]\n"
           "[body.elastic]\nyoungs_modulus_kPa = 1000\npoissons_ratio = 0.3\n"
           "[[stage]]\nname = \"stand\"\n[stage.until]\ntime_s = " +
           seconds + "\n[history]\ninterval_s = 0.01\n";
}

TEST(MaterialPointCommand, RunsTheFileThatExplainsEveryKey) {
    const Workplace here;
    const Answer answer = here.grit("mpm " + cases + "/every_key.toml --out out");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("stage rest ended by its time")) << answer.text;
    const std::map<std::string, Values> history = here.result("every_key");
    EXPECT_EQ(history.size(), 35U);
    EXPECT_EQ(history.at("blow").back(), 2.0);
    EXPECT_GT(history.at("depth").back(), 0.0);
    EXPECT_EQ(history.at("stage").back(), 2.0);
    for (const char* picture : {"every_key.svg", "every_key_void_ratio.png"})
        EXPECT_TRUE(here.files("out").contains(picture)) << picture;
    EXPECT_FALSE(here.files("out").contains("every_key_void_ratio.svg"));
    EXPECT_NE(here.text("out/every_key.csv").find("# stage drive ended by its blows"),
              std::string::npos);
}

TEST(MaterialPointCommand, RunsTheFileThatExplainsEveryKeyInSpace) {
    const Workplace here;
    const std::string run = "mpm " + cases + "/every_key_in_space.toml --no-plot --quiet --out ";
    ASSERT_EQ(here.grit(run + "out").status, 0);
    const std::map<std::string, Values> history = here.result("every_key_in_space");
    EXPECT_EQ(history.at("stage").back(), 1.0);
    EXPECT_LT(history.at("under_force").back(), 0.0);          // the stamp presses the soil down
    EXPECT_NEAR(history.at("load_force").back(), 0.48, 1e-3);  // 2 kPa on 0.4 m by 0.6 m
    EXPECT_LT(std::fabs(history.at("residual_share").back()), 0.05);
    // Eight corners a domain, as hexahedra.
    const std::string ball = here.text("out/every_key_in_space_000002_ball.vtu");
    const auto number = [&ball](const std::string& attribute) {
        return std::stoi(ball.substr(ball.find(attribute) + attribute.size()));
    };
    EXPECT_GT(number("NumberOfCells=\""), 5);
    EXPECT_EQ(number("NumberOfPoints=\""), 8 * number("NumberOfCells=\""));
}

TEST(MaterialPointCommand, WritesTheSurfaceOfTrianglesForLammps) {
    const Workplace here;
    const Answer answer =
        here.grit("mpm " + cases + "/../space/stub_quarter_surface.toml --to-lammps out");
    EXPECT_EQ(answer.status, 0) << answer.text;
    const std::string name = "stub_quarter_surface_stub_soil.stl";
    EXPECT_NE(here.text("out/stub_quarter_surface.fix").find("stiff_surface " + name),
              std::string::npos);
    EXPECT_EQ(here.text("out/" + name).rfind("solid", 0), 0U);
}

TEST(MaterialPointCommand, WritesNoColumnsByHeightForLammps) {
    const Workplace here;
    const Answer answer = here.grit("mpm " + cases + "/../space/monopile.toml --to-lammps out");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("fix grit/mpm of LAMMPS has no columns by height")) << answer.text;
}

// Columns of contact by height are there for each part, and add up to what contacts tell.
TEST(MaterialPointCommand, WritesContactsByHeightOfTheFileThatExplainsEveryKeyInSpace) {
    const Workplace here;
    ASSERT_EQ(
        here.grit("mpm " + cases +
                  "/every_key_in_space.toml --no-plot --quiet --set history.body=stamp --out out")
            .status,
        0);
    const std::map<std::string, Values> history = here.result("every_key_in_space");
    double sum = 0.0;
    for (int part = 1; part <= 4; ++part)
        sum += history.at("profile_z_" + std::to_string(part)).back();
    EXPECT_FALSE(history.contains("profile_z_5"));
    EXPECT_GT(sum, 0.0);
    EXPECT_NEAR(sum, history.at("contact_force_z").back(), 1e-6 * sum);
    EXPECT_NE(
        here.text("out/every_key_in_space.csv").find("in 4 parts of 0.1 m from z = -0.3 m up"),
        std::string::npos);
}

TEST(MaterialPointCommand, TellsTheSweepsOfContactsAtSurfaces) {
    const Workplace here;
    const Answer answer =
        here.grit("mpm " + cases + "/../space/stub_plane_surface.toml --no-plot --out out");
    EXPECT_EQ(answer.status, 0);
    EXPECT_TRUE(answer.says("surface contact of stub and soil:")) << answer.text;
    EXPECT_TRUE(answer.says("sweeps a step; 0 steps ended at 500")) << answer.text;
}

TEST(MaterialPointCommand, RunsACaseThatSaysInWhatItDiffersFromAnother) {
    const Workplace here;
    EXPECT_EQ(
        here.grit("mpm " + cases + "/every_key_override.toml --no-plot --out out --quiet").status,
        0);
    const Names files = here.files("out");
    EXPECT_TRUE(files.contains("every_key_override.csv"));
    EXPECT_TRUE(files.contains("every_key_override.pvd"));
    EXPECT_TRUE(files.contains("every_key_override_000000_soil.vtu"));
    for (const std::string& file : files)
        EXPECT_TRUE(file.starts_with("every_key_override")) << file;
    const std::map<std::string, Values> history = here.result("every_key_override");
    const Values& t = history.at("t");
    const Values& stage = history.at("stage");
    const auto second = std::find(stage.begin(), stage.end(), 2.0) - stage.begin();
    EXPECT_NEAR(t.at(static_cast<std::size_t>(second)), 0.002, 3e-4);
}

// A block on a roller, in plane strain, pressed by 2 kPa.
const std::string block =
    "[grid]\ngeometry = \"plane_strain\"\n[[grid.r]]\nto_m = 0.2\ncells = 2\n[[grid.z]]\nto_m = "
    "0.5\n"
    "cells = 5\n[boundary]\nright = \"roller\"\nbottom = \"roller\"\n[[body]]\nname = \"block\"\n"
    "density_kg_per_m3 = 1000\n[[body.box]]\nr_m = [0, 0.2]\nz_m = [0, 0.4]\n[body.elastic]\n"
    "youngs_modulus_kPa = 1000\npoissons_ratio = 0.3\n[[traction]]\nbody = \"block\"\nedge = "
    "\"top\"\n"
    "stress_kPa = [2]\n[[stage]]\nname = \"stand\"\n[stage.until]\ntime_s = 0.1\n"
    "[fields]\nvariables = [\"stress_xx\"]\n";

TEST(MaterialPointCommand, SaysInPlaneStrainWhatIsInAPlane) {
    const Workplace here;
    here.write("block.toml", block);
    const Answer answer = here.grit("mpm block.toml --out out --field-svg");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("pictures of fields: out/block_*.png and .svg")) << answer.text;
    const std::string history = here.text("out/block.csv");
    for (const char* word : {"under_force [kN/m],side_force [kN/m],load_force [kN/m]",
                             "kinetic_energy [J/m]", "80 kg/m", "forces and energies per metre"})
        EXPECT_NE(history.find(word), std::string::npos) << word;
    for (const char* word : {"tip", "shaft", "hammer"})
        EXPECT_EQ(history.find(word), std::string::npos) << word;
    EXPECT_NE(here.text("out/block.svg").find("force [kN/m]"), std::string::npos);
    EXPECT_NE(here.text("out/block_stress_xx.svg").find("x [m]"), std::string::npos);
    EXPECT_NE(here.text("out/block_000001_block.vtu").find("stress_xx [kPa]"), std::string::npos);
    for (const char* file : {"out/block_000001_block.vtu", "out/block.pvd"})
        EXPECT_NE(here.text(file).find("\n<!-- Grit "), std::string::npos) << file;
    EXPECT_TRUE(here.grit("mpm block.toml --set fields.variables=stress_rr --no-plot")
                    .says("no variable \"stress_rr\"; nearest: stress_xx"));
}

TEST(MaterialPointCommand, TakesXForRInPlaneStrain) {
    const Workplace here;
    const std::string with_x = replaced(replaced(block, "grid.r", "grid.x"), "\nr_m", "\nx_m");
    const std::string run = "mpm --no-plot --quiet --out out ";
    here.write("r.toml", block);
    here.write("x.toml", with_x);
    ASSERT_EQ(here.grit(run + "r.toml").status, 0);
    const Answer answer = here.grit(run + "x.toml");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_EQ(here.result("x").at("stored_energy"), here.result("r").at("stored_energy"));
    const auto refused = [&](const std::string& text, const std::string& words) {
        here.write("bad.toml", text);
        const Answer told = here.grit(run + "bad.toml");
        EXPECT_EQ(told.status, 2) << text;
        EXPECT_TRUE(told.says(words)) << told.text;
    };
    refused(replaced(with_x, "x_m = [0, 0.2]", "x_m = [0, 0.2]\nr_m = [0, 0.2]"),
            "give body[1].box[1].x_m or r_m, not both");
    refused(replaced(with_x, "x_m = [0, 0.2]", "x_m = [0, 0.3]"), "body[1].box[1].x_m");
    refused(replaced(with_x, "plane_strain", "axisymmetric"), "grid.r is missing");
}

TEST(MaterialPointCommand, TakesValuesFromTheCommandLine) {
    const Workplace here;
    here.write("x.toml", column("0.02"));
    here.write("y.toml", "base = \"x.toml\"\n[override]\n\"grid.z.1.cells\" = 12\n"
                         "\"body.column.elastic.poissons_ratio\" = 0.2\n");
    const std::string run = "mpm --no-plot --quiet ";
    ASSERT_EQ(here.grit(run + "y.toml --out out").status, 0);
    ASSERT_EQ(here.grit(run +
                        "x.toml --out out --set grid.z.1.cells=12 "
                        "--set body.column.elastic.poissons_ratio=0.2 --set history.body=column")
                  .status,
              0);
    EXPECT_EQ(here.result("x").at("stored_energy"), here.result("y").at("stored_energy"));
    EXPECT_NE(here.text("out/x.csv")
                  .find("\n# with grid.z.1.cells=12, "
                        "body.column.elastic.poissons_ratio=0.2, "
                        "history.body=column\n"),
              std::string::npos);
    const auto refused = [&](const std::string& setting, const std::string& words) {
        const Answer answer = here.grit(run + "x.toml --set " + setting);
        EXPECT_EQ(answer.status, 2) << setting;
        EXPECT_TRUE(answer.says(words)) << answer.text;
    };
    refused("body.colum.density_kg_per_m3=1",
            "--set body.colum.density_kg_per_m3=1: no [[body]] of the case has the name or number "
            "colum; nearest: column");
    refused("body.column.elastic.poisons_ratio=0.1",
            "unknown key body[1].elastic.poisons_ratio; nearest: poissons_ratio");
    refused("stages.1.until.time_s=1", "the case has no stages; nearest: stage");
    refused("grid.z.1.cells=many", "--set grid.z.1.cells=many: grid.z[1].cells must be");
    // A table that the case has not, and one that no case has.
    ASSERT_EQ(here.grit(run + "x.toml --set fields.variables=velocity").status, 0);
    refused("weather.wind=1", "unknown key weather");
}

TEST(MaterialPointCommand, OverridesElementsOfListsByNameAndByNumber) {
    const Workplace here;
    here.write("x.toml", column("0.1"));
    here.write("y.toml", "base = \"x.toml\"\n[override]\n\"stage.1.until.time_s\" = 0.02\n"
                         "\"grid.z.1.cells\" = 12\n\"body.column.box.1.z_m\" = [0, 0.5]\n");
    EXPECT_EQ(here.grit("mpm --no-plot --quiet --out out y.toml").text, "");
    EXPECT_NEAR(here.result("y").at("t").back(), 0.02, 2e-3);
    EXPECT_NE(here.text("out/y.csv").find("# 80 particles"), std::string::npos);
}

TEST(MaterialPointCommand, GivesTheSameHistoryForAnyNumberOfThreads) {
    const Workplace here;
    here.write("x.toml", column("0.05"));
    EXPECT_EQ(here.grit("mpm x.toml --no-plot --quiet --out one").text, "");
    EXPECT_EQ(here.grit("mpm x.toml --no-plot --quiet --out two --threads 2").text, "");
    EXPECT_NE(here.text("one/x.csv"), "");
    EXPECT_EQ(here.text("one/x.csv"), here.text("two/x.csv"));
}

TEST(MaterialPointCommand, EndsAfterTheStepWhenItIsInterrupted) {
    for (const char* signal : {"INT", "TERM", "HUP"}) {
        const Workplace here;
        here.write("x.toml", column("1000"));
        // A first checkpoint is written after many steps.
        const Answer answer = here.interrupted(
            "mpm --no-plot --checkpoint-minutes 1e-3 --out out x.toml", signal, "out/x.checkpoint");
        EXPECT_EQ(answer.status, 1) << answer.text;
        EXPECT_TRUE(answer.says("grit: x: interrupted (after step ")) << answer.text;
        EXPECT_EQ(here.files("out"), (Names{"x.checkpoint", "x.csv"}));
        EXPECT_NE(here.text("out/x.csv").find("# STOPPED EARLY: interrupted"), std::string::npos);
        EXPECT_GT(here.result("x").at("t").size(), 2U);
    }
}

TEST(MaterialPointCommand, GoesOnWithoutItsTerminalWhereItIsToldTo) {
    const Workplace here;
    here.write("x.toml", column("0.3"));
    EXPECT_EQ(here.grit("--version > /dev/null; nohup " GRIT_CLI " mpm --no-plot --quiet --out out "
                        "x.toml & sleep 0.1; kill -HUP $!; wait $!; exit $?")
                  .status,
              0);
}

TEST(MaterialPointCommand, LeavesNoHalfFilesWhereItIsToQuit) {
    const Workplace here;
    here.write("x.toml", column("1000"));
    const Answer answer = here.interrupted("mpm --no-plot --quiet --out out x.toml", "QUIT",
                                           "out/.grit-lock", "ulimit -c 0");
    EXPECT_EQ(answer.status, 128 + 3);
    EXPECT_EQ(here.files("out"), Names{});
}

// Ended by signals at any moment, it goes on to the same bits.
TEST(MaterialPointCommand, GoesOnFromACheckpointToTheHistoryOfARunThatNeverStopped) {
    const Workplace here;
    here.write("x.toml", column("30") + "[fields]\ninterval_s = 5\nvariables = \"q\"\n");
    ASSERT_EQ(here.grit("mpm --no-plot --quiet --out whole x.toml").status, 0);
    const std::string run = "mpm --no-plot --quiet --checkpoint-minutes 1e-3 --out parts x.toml";
    const auto killed = [&](const std::string& arguments, const std::string& signal) {
        here.interrupted(arguments, signal, "parts/x.checkpoint");
        EXPECT_TRUE(here.files("parts").contains("x.checkpoint"));
    };
    killed(run, "KILL");
    killed(run + " --restart", "TERM");
    EXPECT_NE(here.text("parts/x.csv").find("STOPPED EARLY: interrupted"), std::string::npos);
    const Answer answer = here.grit(run + " --restart");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_NE(here.text("whole/x.csv"), "");
    EXPECT_EQ(here.files("whole"), here.files("parts"));
    EXPECT_GE(here.files("whole").size(), 8U);
    for (const std::string& file : here.files("whole"))
        EXPECT_EQ(here.text("whole/" + file), here.text("parts/" + file)) << file;
    EXPECT_FALSE(here.files("parts").contains("x.checkpoint"));
}

// A free body is so from its stage on; how fast it turns may be told anew when it goes on.
TEST(MaterialPointCommand, GoesOnWithARigidBodyInSpaceThatBeginsLater) {
    const Workplace here;
    // It falls so slowly that a signal a second late still finds it on the grid.
    const std::string standing =
        "gravity_m_per_s2 = 1e-6\n[grid]\ngeometry = \"space\"\n"
        "[[grid.x]]\nto_m = 1\ncells = 5\n[[grid.y]]\nto_m = 1\ncells = 5\n[[grid.z]]\nto_m = "
        "1\ncells = 5\n[[body]]\nname = \"block\"\n"
        "density_kg_per_m3 = 2000\n[[body.box]]\nx_m = [0.3, 0.7]\ny_m = [0.3, 0.7]\n"
        "z_m = [0.3, 0.5]\n[body.rigid]\n";
    const std::string stages = "[[stage]]\nname = \"wait\"\nuntil = { time_s = 0.01 }\n"
                               "[[stage]]\nname = \"go\"\nuntil = { time_s = 1000 }\n";
    for (const std::string motion :
         {"free = [\"z\"]\nfrom_stage = \"go\"\n", "angular_velocity_z_rad_per_s = [0.5]\n"}) {
        here.write("x.toml", standing + motion + "[numerics]\nlargest_step_s = 1e-5\n" + stages);
        const std::string run = "mpm --no-plot --quiet --out out x.toml";
        here.interrupted(run, "TERM");
        const Answer answer =
            here.interrupted(run + " --restart" +
                                 (motion.starts_with("ang")
                                      ? " --set body.block.rigid.angular_velocity_z_rad_per_s=[0.7]"
                                      : ""),
                             "TERM");
        EXPECT_EQ(answer.status, 1);
        EXPECT_TRUE(answer.says("interrupted (after step")) << answer.text;
        std::filesystem::remove_all(here.path("out"));
    }
}

TEST(MaterialPointCommand, RefusesACheckpointThatIsMissingOrOfAnotherCase) {
    const Workplace here;
    here.write("x.toml", column("1000"));
    Answer answer = here.grit("mpm --no-plot --quiet --restart --out out x.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("x.checkpoint: cannot read this checkpoint")) << answer.text;
    here.interrupted("mpm --no-plot --quiet --out out x.toml", "TERM");
    here.write("x.toml", column("1000", "fixed_point = true\n"));
    answer = here.grit("mpm --no-plot --quiet --restart --out out x.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("fixed point")) << answer.text;
    EXPECT_TRUE(here.files("out").contains("x.checkpoint"));
}

TEST(MaterialPointCommand, RefusesACheckpointOfAnotherMaterialAndNamesTheDifference) {
    const Workplace here;
    here.write("x.toml", column("1000"));
    here.interrupted("mpm --no-plot --quiet --out out x.toml", "TERM");
    std::string stiffer = column("0.01");
    stiffer.replace(stiffer.find("_kPa = 1000"), 11, "_kPa = 4000");
    const std::pair<std::string, std::string> others[] = {
        {stiffer, "this has 'body 0: Lame's constants 23"},
        {column("0.01", "bulk_viscosity_linear = 0.1\n"), "this has 'bulk viscosity: linear 0.1"}};
    for (const auto& [other, difference] : others) {
        here.write("x.toml", other);
        const Answer answer = here.grit("mpm --no-plot --quiet --restart --out out x.toml");
        EXPECT_EQ(answer.status, 2);
        EXPECT_TRUE(answer.says("of another simulation: it has '")) << answer.text;
        EXPECT_TRUE(answer.says(difference)) << answer.text;
    }
}

// How steps are taken, stages and loads may be others when a run goes on; what it began with may not.
TEST(MaterialPointCommand, GoesOnWithTheStepsOfTheCaseAsItIsNowAndWithNoOtherStart) {
    const Workplace here;
    here.write("x.toml", column("1000"));
    const std::string run = "mpm --no-plot --quiet --out out x.toml";
    here.interrupted(run, "TERM");
    const std::string before = here.text("out/x.checkpoint");
    for (const auto& [setting, why] :
         {std::pair{"history.depth_of=centre_of_mass",
                    "of a case that says nothing for history.depth_of, this one 'centre_of_mass'"},
          std::pair{"body.column.velocity_m_per_s=[0,1]",
                    "nothing for body.column.velocity_m_per_s, this one [ 0, 1 ]"},
          std::pair{"stage.stand.name=lie", "of a case that says stand for stage, this one lie"}}) {
        const Answer other = here.grit(run + " --restart --set '" + setting + "'");
        EXPECT_EQ(other.status, 2);
        EXPECT_TRUE(other.says(why)) << other.text;
    }
    EXPECT_TRUE(here.text("out/x.checkpoint") == before);
    const std::string until =
        " --set stage.stand.until.time_s=" + std::to_string(here.result("x").at("t").back() + 0.03);
    std::filesystem::copy(here.path("out"), here.path("kept"));
    const auto step_of = [&](const std::string& setting) {
        std::filesystem::remove_all(here.path("out"));
        std::filesystem::copy(here.path("kept"), here.path("out"));
        const Answer answer = here.grit(run + " --restart" + until + setting);
        EXPECT_EQ(answer.status, 0) << answer.text;
        return here.result("x").at("dt").end()[-2];
    };
    const double step = step_of("");
    EXPECT_NEAR(step_of(" --set numerics.cfl=0.1"), 0.25 * step, 0.05 * step);
    EXPECT_NEAR(step_of(" --set numerics.largest_step_s=1e-5"), 1e-5, 1e-15);
}

TEST(MaterialPointCommand, PutsTheCheckpointOfAnInterruptedRunAsideWhereItBeginsAnew) {
    const Workplace here;
    here.write("x.toml", column("1000"));
    const std::string run = "mpm --no-plot --quiet --out out x.toml";
    here.interrupted(run, "TERM");
    const std::string before = here.text("out/x.checkpoint");
    EXPECT_GT(before.size(), 1000U);
    here.write("x.toml", column("0.01"));
    const Answer answer = here.grit(run);
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("left a checkpoint, now out/x.checkpoint.old")) << answer.text;
    EXPECT_EQ(here.files("out"), (Names{"x.checkpoint.old", "x.csv"}));
    EXPECT_TRUE(here.text("out/x.checkpoint.old") == before);
    EXPECT_EQ(here.grit(run + " --restart").status, 2);
}

TEST(MaterialPointCommand, LeavesNothingOfAnOlderRunBesideItsResults) {
    const Workplace here;
    here.write("x.toml", column("0.02") + "[fields]\ninterval_s = 0.01\nvariables = [\"q\"]\n");
    ASSERT_EQ(here.grit("mpm --quiet --field-svg --out out x.toml").status, 0);
    Names left = here.files("out");
    for (const char* name : {"x.svg", "x.pvd", "x_q.svg", "x_q.png", "x_000002_column.vtu"})
        EXPECT_TRUE(left.contains(name)) << name;
    for (const char* name : {"x_p.svg", "x_p.csv", "x_tension.svg", "xx.svg", "x_1_column.vtu"})
        here.write(std::string("out/") + name, "of another");
    here.write("x.toml", column("0.01"));
    ASSERT_EQ(here.grit("mpm --quiet --no-plot --out out x.toml").status, 0);
    EXPECT_EQ(here.files("out"),
              (Names{"x.csv", "x_1_column.vtu", "x_p.csv", "x_p.svg", "x_tension.svg", "xx.svg"}));
}

// A killed run removes nothing; the next one does, whether it begins anew or goes on.
TEST(MaterialPointCommand, LeavesNothingThatAKilledRunHasBegun) {
    const Workplace here;
    const std::string run = "mpm --quiet --no-plot --out out x.toml";
    const auto begin = [&](const std::string& name) {
        here.write("out/" + name + ".0123456789abcdef.part", "half");
    };
    here.write("x.toml", column("1000"));
    ASSERT_EQ(here.interrupted(run, "TERM").status, 1);
    here.write("out/x_p.csv", "of another");
    const Names others = {"x_p.png.0123456789abcdef.part",
                          "y_000001_column.vtu.0123456789abcdef.part"};
    begin("x_p.png");
    begin("y_000001_column.vtu");
    for (const char* how : {" --restart", ""}) {
        begin("x_000001_column.vtu");
        begin("x_q.png");
        here.interrupted(run + how, "TERM");
        Names left = here.files("out");
        for (const std::string& each : others) EXPECT_EQ(left.erase(each), 1u) << each << how;
        for (const std::string& each : left) EXPECT_FALSE(each.ends_with(".part")) << each << how;
    }
}

// A terminal that goes sends SIGHUP twice, timeout SIGTERM to the program and to its group.
TEST(MaterialPointCommand, IsInterruptedOnceByTwoSignalsInNoTime) {
    for (const std::string signal : {"HUP", "TERM"}) {
        const Workplace here;
        here.write("x.toml", column("1000"));
        const Answer answer =
            here.interrupted("mpm --no-plot --quiet --out out x.toml",
                             signal + " $grit; kill -" + signal + " $grit; kill -" + signal);
        EXPECT_EQ(answer.status, 1);
        EXPECT_TRUE(answer.says("interrupted (after step")) << answer.text;
        EXPECT_EQ(here.files("out"), (Names{"x.checkpoint", "x.csv"}));
    }
}

// Files of 20 KiB at most: the checkpoint is larger, the history is not.
constexpr const char* little_room = "ulimit -f 40";

TEST(MaterialPointCommand, KeepsHistoryAndOldCheckpointIfNoneCanBeWrittenWhenInterrupted) {
    const Workplace here;
    here.write("y.toml", column("1000"));
    here.write("x.toml", "base = \"y.toml\"\n[override]\n\"history.interval_s\" = 10\n");
    const std::string run = "mpm --no-plot --quiet --out out x.toml";
    here.interrupted(run, "INT");
    const std::string before = here.text("out/x.checkpoint");
    EXPECT_GT(before.size(), 40U * 1024);
    const Answer answer =
        here.interrupted(run + " --restart", "INT", "out/.grit-lock", little_room);
    EXPECT_EQ(answer.status, 1);
    const std::string problem = "; the checkpoint could not be written: out/x.checkpoint: cannot "
                                "write this file: File too large";
    EXPECT_TRUE(answer.says("grit: x: interrupted (after step ")) << answer.text;
    EXPECT_TRUE(answer.says(problem)) << answer.text;
    EXPECT_EQ(here.files("out"), (Names{"x.checkpoint", "x.csv"}));
    EXPECT_TRUE(here.text("out/x.checkpoint") == before);
    EXPECT_NE(here.text("out/x.csv").find(problem), std::string::npos);
}

TEST(MaterialPointCommand, GoesOnIfACheckpointBetweenCannotBeWritten) {
    const Workplace here;
    here.write("y.toml", column("12"));
    here.write("x.toml", "base = \"y.toml\"\n[override]\n\"history.interval_s\" = 1\n");
    const std::string run = "mpm --no-plot --quiet --out ";
    ASSERT_EQ(here.grit(run + "whole x.toml").status, 0);
    const Answer answer =
        here.grit(std::string("--version > /dev/null; ") + little_room + "; " GRIT_CLI " " + run +
                  "out x.toml --checkpoint-minutes 1e-3");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("grit: x: the checkpoint could not be written: out/x.checkpoint: "))
        << answer.text;
    EXPECT_EQ(here.files("out"), Names{"x.csv"});
    EXPECT_EQ(here.text("out/x.csv"), here.text("whole/x.csv"));
}

TEST(MaterialPointCommand, KeepsTheRowsOfAHistoryThatTheDiskDoesNotTake) {
    const Workplace here;
    here.write("y.toml", column("12"));
    here.write("x.toml", "base = \"y.toml\"\n[override]\n\"history.interval_s\" = 0\n");
    const Answer answer = here.grit(std::string("--version > /dev/null; ") + little_room +
                                    "; " GRIT_CLI " mpm --no-plot --quiet --out out x.toml");
    EXPECT_NE(answer.status, 0);
    EXPECT_TRUE(answer.says("; its rows so far are in out/x.csv.incomplete")) << answer.text;
    EXPECT_EQ(here.files("out"), Names{"x.csv.incomplete"});
    const std::string rows = here.text("out/x.csv.incomplete");
    EXPECT_GT(rows.size(), 10000U);
    EXPECT_EQ(rows.back(), '\n');
    const auto commas = [](const std::string& text) {
        return std::count(text.begin(), text.end(), ',');
    };
    const std::string last = rows.substr(rows.rfind('\n', rows.size() - 2) + 1);
    EXPECT_EQ(commas(last), 34) << last;
}

// A file is beside the one that names it.
TEST(MaterialPointCommand, FindsTheFilesOfABaseBesideTheBase) {
    const Workplace here;
    std::filesystem::create_directories(here.path("cases"));
    here.write("cases/own.toml",
               "[sand]\ncritical_friction_angle_deg = 33.0\ngranulate_hardness_kPa = 1.6e6\n"
               "stiffness_exponent = 0.19\ndensest_void_ratio = 0.44\ncritical_void_ratio = 0.85\n"
               "loosest_void_ratio = 1.00\npyknotropy_exponent = 0.25\n"
               "stiffness_void_exponent = 1.0\n");
    std::string base = column("0.01");
    base = replaced(base, "[body.elastic]\nyoungs_modulus_kPa = 1000\npoissons_ratio = 0.3\n",
                    "[body.sand]\nfile = \"own.toml\"\nvoid_ratio = 0.6\n"
                    "[body.stress_at_rest]\nsurface_m = 1\n");
    here.write("cases/y.toml", base);
    here.write("x.toml", "base = \"cases/y.toml\"\n");
    const Answer answer = here.grit("mpm --no-plot --quiet --out out x.toml");
    EXPECT_EQ(answer.status, 0) << answer.text;
}

TEST(MaterialPointCommand, WritesARowForEachThousandthOfTheFirstStageUnlessItIsToldOtherwise) {
    const Workplace here;
    std::string without = column("5");
    without.resize(without.find("[history]"));
    here.write("x.toml", without);
    EXPECT_EQ(here.grit("mpm --no-plot --quiet --out out x.toml").text, "");
    EXPECT_NEAR(static_cast<double>(here.result("x").at("t").size()), 1001.0, 3.0);
    here.write("y.toml", "base = \"x.toml\"\n[override]\n\"history.interval_s\" = 0\n");
    here.write("x.toml", column("0.05"));
    EXPECT_EQ(here.grit("mpm --no-plot --quiet --out out y.toml").text, "");
    const Values steps = here.result("y").at("step");
    EXPECT_EQ(steps.back(), static_cast<double>(steps.size()) - 1.0);
}

TEST(MaterialPointCommand, StopsAnUnstableRunWithOneClearLine) {
    const Workplace here;
    here.write("x.toml", column("1", "energy_residual_limit = 1e-6\n"));
    const Answer answer = here.grit("mpm --no-plot --quiet --out out x.toml");
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says("grit: x: the energy balance is broken at t = ")) << answer.text;
    EXPECT_TRUE(answer.says("the limit is 0.0001 %")) << answer.text;
    EXPECT_EQ(std::count(answer.text.begin(), answer.text.end(), '\n'), 1);
    EXPECT_EQ(here.files("out"), Names{"x.csv"});
}

TEST(MaterialPointCommand, NeverOverwritesItsCaseOrTheBaseOfIt) {
    const Workplace here;
    here.write("x.csv", column("0.01"));
    here.write("y.toml", "base = \"x.csv\"\nname = \"x\"\n");
    const Answer answer = here.grit("mpm --no-plot y.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("would overwrite this file")) << answer.text;
    EXPECT_EQ(here.text("x.csv"), column("0.01"));
}

TEST(MaterialPointCommand, SaysWhereParticlesLeftTheGrid) {
    const Workplace here;
    here.write("x.toml", column("1") + "[[body]]\nname = \"ball\"\ndensity_kg_per_m3 = 1000\n"
                                       "velocity_m_per_s = [0, 20]\n"
                                       "[[body.box]]\nr_m = [0, 0.1]\nz_m = [1.05, 1.15]\n"
                                       "[body.elastic]\nyoungs_modulus_kPa = 1000\n"
                                       "poissons_ratio = 0.3\n");
    const Answer answer = here.grit("mpm --no-plot --quiet --out out x.toml");
    EXPECT_EQ(answer.status, 1);
    EXPECT_TRUE(answer.says("particles left the grid at t = ")) << answer.text;
}

class LammpsFiles : public testing::Test {
  protected:
    LammpsFiles() {
        EXPECT_EQ(here.grit(convert).status, 0);
        for (const std::string& file : here.files("out")) before[file] = here.text("out/" + file);
        EXPECT_EQ(before.size(), 5U);  // data, fix, in, points of two bodies
    }
    void are_as_they_were() const {
        for (const auto& [file, text] : before) EXPECT_EQ(here.text("out/" + file), text) << file;
        EXPECT_EQ(here.files("out").size(), before.size());
    }
    Workplace here;
    const std::string convert = "mpm --quiet --to-lammps out " GRIT_MPM_CASES "/pile_push.toml";
    std::map<std::string, std::string> before;
};

TEST_F(LammpsFiles, AreAllThereOrAsTheyWereWhereTheDiskIsFull) {
    for (const int blocks : {0, 1, 100, 1000}) {
        const Answer answer = here.grit("sand list > /dev/null; trap '' XFSZ; ulimit -f " +
                                        std::to_string(blocks) + "; " GRIT_CLI " " + convert);
        EXPECT_EQ(answer.status, 1) << answer.text;
        EXPECT_TRUE(answer.says("File too large")) << answer.text;
        are_as_they_were();
    }
}

TEST_F(LammpsFiles, AreWrittenByOneAtATime) {
    Answer answer;
    for (int i = 0; i < 20 && !answer.says("0 + 1\n"); ++i) {  // the first may be done too soon
        answer = here.grit(convert +
                           " & while kill -0 $! && [ ! -e out/.grit-lock ]; do :; done; "
                           "kill -STOP $!; " GRIT_CLI " " +
                           convert + "; second=$?; kill -CONT $!; wait $!; echo $? + $second");
        are_as_they_were();
    }
    EXPECT_TRUE(answer.says("0 + 1\n")) << answer.text;
    EXPECT_TRUE(answer.says("another run of grit is writing this file")) << answer.text;
}

// What a law has, and nothing else: the fix refuses the rest.
TEST_F(LammpsFiles, HaveTheWordsOfTheLawOfAContact) {
    struct Law {
        std::string of_case, words;
    };
    const std::string layer = "\ncontact_stiffness_multiple = 10\nmodulus_kPa = "
                              "5e4\nrelaxation_time_s = 0.0009765625",
                      none = "\ncontact_stiffness_multiple = 0\nmodulus_kPa = 5e4";
    const std::string of_layer = " relaxation_time 0.0009765625 stiffness_multiple 10 ";
    for (const Law& law : {Law{"geo" + none, " power 6 normal stiff distance support gated yes"},
                           {"geo" + layer, " power 6 normal stiff distance support gated yes" +
                                               of_layer + "modulus 50000000"},
                           {"frictional", " normal stiff distance support gated yes"},
                           {"surface" + none, ""},
                           {"surface" + layer, of_layer + "modulus 50000000"},
                           {"surface" + layer + "\npressure_spacing_cells = 1",
                            of_layer + "pressure_spacing 1 modulus 50000000"}}) {
        std::string contact = law.of_case;
        contact.insert(contact.find('\n') == contact.npos ? contact.size() : contact.find('\n'),
                       "'");
        std::replace(contact.begin(), contact.end(), '\n', ',');
        here.write("law.toml", "base = '" GRIT_MPM_CASES
                               "/pile_push.toml'\n[override]\n'contact' = [{stiff = 'pile', "
                               "soft = 'soil', friction_coefficient = 0.5, law = '" +
                                   contact + "}]\n");
        const Answer answer = here.grit("mpm --quiet --to-lammps law law.toml");
        ASSERT_EQ(answer.status, 0) << answer.text;
        const std::string fix = here.text("law/law.fix");
        const std::string name = law.of_case.substr(0, law.of_case.find('\n'));
        EXPECT_NE(fix.find("contact pile soil " + name + " 0.5" + law.words + " &\n"),
                  std::string::npos)
            << law.words << " in\n"
            << fix;
    }
}

constexpr const char* saturated =
    "base = '" GRIT_SATURATED_CASES "/terzaghi.toml'\n[override]\n"
    "'stage.consolidate.until.time_s' = 1e-3\n'fields.interval_s' = 0\n";

TEST(SaturatedCase, ShowsPorePressuresAndTotalStresses) {
    const Workplace here;
    here.write("short.toml", saturated);
    const Answer answer = here.grit("mpm short.toml --out out --no-plot");
    ASSERT_EQ(answer.status, 0) << answer.text;
    const std::map<std::string, Values> history = here.result("short");
    EXPECT_GT(history.at("largest_pore_pressure").back(), 100.0);
    EXPECT_GT(history.at("drag_loss").back(), 0.0);
    EXPECT_GT(history.at("pore_water_work").back(), 0.0);
    const std::string fields = here.text("out/short_000001_sand.vtu");
    for (const char* name : {"pore_pressure", "total_zz", "stress_zz", "porosity", "seepage"})
        EXPECT_NE(fields.find("\"" + std::string(name) + " ["), std::string::npos) << name;
}

TEST(SaturatedCase, IsWrittenForLammps) {
    const Workplace here;
    here.write("short.toml", std::string(saturated) + "'body.sand.water.pressure' = 'implicit'\n");
    const Answer answer = here.grit("mpm --quiet --to-lammps out short.toml");
    ASSERT_EQ(answer.status, 0) << answer.text;
    const std::string fix = here.text("out/short.fix");
    for (const char* words : {"water sand flow pressure implicit porosity ", " cavitation 100000 ",
                              " conductivity 0.001", "# Of atoms: 25 pore_pressure, 26 total_rr, "})
        EXPECT_NE(fix.find(words), std::string::npos) << words << " in\n" << fix;
    EXPECT_NE(here.text("out/short_sand.points").find(" p_w w_r w_z m_w\n"), std::string::npos);
}

}  // namespace
