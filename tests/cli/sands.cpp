// SPDX-License-Identifier: BSD-3-Clause
// Sands by name, by file and changed on the command line; as PROPS of hosts.
#include <gtest/gtest.h>

#include "support/workplace.hpp"

namespace {

const std::string shearing = "[[stage]]\ntest = \"triaxial_drained\"\naxial_strain = -0.02\n";

double last_stress(const Workplace& here, const std::string& name) {
    return here.result(name).at("stress_11").back();
}

// Lausitz sand at 100 kPa, e 0.6, without its [sand].
void write_bare(const Workplace& here) {
    here.write("bare.toml", "[start]\npressure_kPa = 100\nvoid_ratio = 0.6\n" + shearing);
}

TEST(SandOfACase, MayComeByNameOrFileFromTheCommandLineAlone) {
    const Workplace here;
    here.write_case("whole", shearing);
    write_bare(here);
    ASSERT_EQ(here.run("whole").status, 0);
    const double wanted = last_stress(here, "whole");
    EXPECT_TRUE(here.run("bare").says("bare.toml:1: sand is missing")) << here.run("bare").text;
    ASSERT_EQ(here.run("bare", "--sand lausitz").status, 0);
    EXPECT_EQ(last_stress(here, "bare"), wanted);
    EXPECT_NE(here.text("out/bare.csv").find("\n# with --sand lausitz\n"), std::string::npos);
    // Another name in the case gives way.
    ASSERT_EQ(here.run("whole", "--sand hochstetten").status, 0);
    EXPECT_NE(last_stress(here, "whole"), wanted);
    EXPECT_TRUE(
        here.run("bare", "--sand lausits")
            .says("there is no file lausits, and no sand is called \"lausits\"; nearest: lausitz"));
}

TEST(SettingOnTheCommandLine, ChangesACaseAsAnOverrideDoes) {
    const Workplace here;
    here.write_case("x", shearing);
    here.write("y.toml", "base = \"x.toml\"\n[override]\n\"sand.critical_void_ratio\" = "
                         "0.9\n\"stage.1.axial_strain\" = -0.01\n");
    ASSERT_EQ(here.run("y").status, 0);
    ASSERT_EQ(
        here.run("x", "--set sand.critical_void_ratio=0.9 --set stage.1.axial_strain=-0.01").status,
        0);
    EXPECT_EQ(here.result("x").at("stress_11"), here.result("y").at("stress_11"));
    EXPECT_NE(here.text("out/x.csv")
                  .find("\n# with sand.critical_void_ratio=0.9, stage.1.axial_strain=-0.01\n"),
              std::string::npos);
    ASSERT_EQ(here.run("x", "--set sand.name=hochstetten").status, 0);
}

TEST(SettingOnTheCommandLine, IsRefusedWhereItMeansNothing) {
    const Workplace here;
    here.write_case("x", shearing);
    const auto refused = [&](const std::string& setting, const std::string& words) {
        const Answer answer = here.run("x", "--set " + setting);
        EXPECT_EQ(answer.status, 2) << setting;
        EXPECT_TRUE(answer.says(words)) << answer.text;
    };
    refused("sand.critical_void_ratio", "--set needs KEY=VALUE, got \"sand.critical_void_ratio\"");
    refused("sand.critical_void_rato=0.9", "nearest: critical_void_ratio");
    refused("sad.critical_void_ratio=0.9",
            "--set sad.critical_void_ratio=0.9: the case has no sad; nearest: sand");
    refused("sand.critical_void_ratio=9",
            "--set sand.critical_void_ratio=9: sand.critical_void_ratio (e_c0) must be in");
    refused("stage.axial_strain=-0.01",
            "which [[stage]], by name or number, as in stage.1.axial_strain?");
    refused("numeric.stress_tolerance=1e-9",
            "--set numeric.stress_tolerance=1e-9: unknown key numeric; nearest: numerics");
    refused("stage.2.axial_strain=-0.01",
            "no [[stage]] of the case has the name or number 2; known here: 1");
}

TEST(PropsOfASand, AreThoseOfItsHosts) {
    const Workplace here;
    const auto props = [&](const std::string& form) {
        return here.grit("sand show lausitz --void-ratio 0.6 --props " + form).text;
    };
    EXPECT_EQ(props("classic"),
              "33, 0, 1600000, 0.19, 0.44, 0.85, 1, 0.25\n1, 5, 2, 0.0001, 0.5, 6, 0, 10.6\n");
    EXPECT_EQ(props("radian"), "0.575958653158129, 0, 1600000, 0.19, 0.44, 0.85, 1, 0.25\n1, 2, 5, "
                               "0.0001, 0.5, 6, 0, 10.6\n");
    EXPECT_EQ(props("calculix"), "*USER MATERIAL, CONSTANTS=16\n" + props("classic") + "293.\n");
    EXPECT_EQ(props("incremental-driver").substr(0, 25), "lausitz\n16\n33\n0\n1600000\n0");
    const Answer without = here.grit("sand show lausitz --props classic");
    EXPECT_TRUE(without.says("6, 0, 0\n")) << without.text;
    EXPECT_TRUE(without.says("PROPS(16), the void ratio of the sample, is 0")) << without.text;
    EXPECT_TRUE(here.grit("sand show lausitz --props moose").says("moose"));
    EXPECT_EQ(here.grit("sand show lausitz --props moose").status, 2);
}

}  // namespace
