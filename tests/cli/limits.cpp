// SPDX-License-Identifier: BSD-3-Clause
// Files that ask for more than there is: refused by name, before memory or time is spent.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "support/workplace.hpp"

namespace {

TEST(Limits, EndFilesThatNeverEnd) {
    const Workplace here;
    here.write("endless.toml", "base = \"/dev/zero\"\n");
    Answer answer = here.grit("element endless.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("/dev/zero: is longer than 64 MiB, the most that is read"))
        << answer.text;
    answer = here.grit("element --sand /dev/zero endless.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("/dev/zero: is longer than 64 MiB")) << answer.text;
}

TEST(Limits, EndLinesThatNeverEnd) {
    const Workplace here;
    here.write("x.csv", "name,p\n" + std::string(1100000, '7') + ",1\n");
    here.write("x.toml", "[samples]\ntable = \"x.csv\"\nname = \"name\"\n");
    const Answer answer = here.grit("element x.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("x.csv:2: a line is longer than 1 MiB")) << answer.text;
}

// Tables within tables are as deep as the stack of what reads them.
TEST(Limits, EndKeysThatNeverEnd) {
    const Workplace here;
    const auto deep = [](const std::string& part, int parts) {
        std::string out = part;
        for (int i = 1; i < parts; ++i) out += '.' + part;
        return out;
    };
    const std::string nested = "x = { a = [{ b = '....................' }] }";
    here.write("sound.toml", "# ..................\n" + nested + '\n');
    EXPECT_FALSE(here.grit("element sound.toml").says("points"));
    here.write("key.toml",
               "title = \"\"\"\n......................\n\"\"\"\n" + deep("a", 100000) + " = 1\n");
    here.write("quoted.toml", "title = '\"'\n" + deep("'a b'", 100000) + " = 1\n");
    here.write("header.toml", "title = \"\\\"\"\n[" + deep("a", 200000) + "]\nb = 1\n");
    here.write("inline.toml", "x = 1\n\ny = {" + deep("\"a\"", 100000) + " = 1 }\n");
    for (const auto& [file, line] :
         {std::pair("key", 4), {"quoted", 2}, {"header", 2}, {"inline", 3}}) {
        const Answer answer = here.grit(std::string("element ") + file + ".toml");
        EXPECT_EQ(answer.status, 2) << file;
        EXPECT_TRUE(answer.says(file + (".toml:" + std::to_string(line)) +
                                ": a key has more than 16 points, the most that is read"))
            << answer.text.substr(0, 1000);
    }
}

TEST(Limits, EndTablesOfNothingButCells) {
    const Workplace here;
    const std::string row = std::string(1000000, ',') + '\n';
    std::string rows = "x" + row;
    for (int i = 0; i < 20; ++i) rows += row;
    here.write("x.csv", rows);
    const Answer answer = here.grit("plot x.csv");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("x.csv:20: more than 20000000 cells")) << answer.text.substr(0, 1000);
}

// What stands in a stranger's file neither commands the terminal nor fills it.
TEST(Limits, OfMessagesAreThoseOfAScreen) {
    const Workplace here;
    here.write("codes.toml", "\"\\u001b[2J\\u001b[31mevil\\u009b\\u00e9\" = 1\n");
    Answer answer = here.grit("element codes.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("\\x1B[2J\\x1B[31mevil\\xC2")) << answer.text;
    EXPECT_TRUE(answer.says("\xC3\xA9"));
    EXPECT_EQ(answer.text.find('\x1B'), std::string::npos);
    here.write("long.toml", "k" + std::string(1'000'000, 'k') + " = 1\n");
    answer = here.grit("element long.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_LT(answer.text.size(), 5000u);
    EXPECT_TRUE(answer.says("bytes) ... ")) << answer.text;
}

#ifdef GRIT_MPM_CASES
std::string box_of_elastic(int cells, int particles_per_cell) {
    const std::string n = std::to_string(cells), each = std::to_string(particles_per_cell);
    return "[grid]\ngeometry = \"plane_strain\"\n[[grid.r]]\nto_m = 1\ncells = " + n +
           "\n[[grid.z]]\nto_m = 1\ncells = " + n +
           "\n[[body]]\nname = \"box\"\ndensity_kg_per_m3 = 2000\nparticles_per_cell_r = " + each +
           "\nparticles_per_cell_z = " + each +
           "\n[[body.box]]\nr_m = [0, 1]\nz_m = [0, 1]\n[body.elastic]\nyoungs_modulus_kPa = 1e4\n"
           "poissons_ratio = 0.2\n[[stage]]\nname = \"rest\"\n[stage.until]\ntime_s = 1\n";
}

TEST(Limits, RefuseMoreNodesAndParticlesThanAMachineHolds) {
    const Workplace here;
    here.write("nodes.toml", box_of_elastic(100000, 1));
    Answer answer = here.grit("mpm nodes.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("nodes.toml:1: grid: a grid has at most 2e+07 nodes, got 1.00002e+10"))
        << answer.text;
    here.write("particles.toml", box_of_elastic(4000, 16));
    answer = here.grit("mpm particles.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("body box: its outlines would be filled with 4.096e+09 particles, at "
                            "most 1e+08 are possible"))
        << answer.text;
    EXPECT_EQ(here.files(), (std::set<std::string>{"nodes.toml", "particles.toml"}));
}

TEST(Limits, EndCheckpointsThatNeverEnd) {
    const Workplace here;
    here.write("box.toml", box_of_elastic(4, 1));
    std::filesystem::create_directory(here.path("out"));
    std::filesystem::create_symlink("/dev/zero", here.path("out/box.checkpoint"));
    const Answer answer = here.grit("mpm --out out --restart box.toml");
    EXPECT_NE(answer.status, 0);
    EXPECT_TRUE(answer.says("this is no checkpoint of grit mpm")) << answer.text;
}

TEST(Limits, EndSurfacesThatNeverEnd) {
    const Workplace here;
    const auto box_in = [](const std::string& file) {
        return "[grid]\ngeometry = \"space\"\n[[grid.x]]\nto_m = 1\ncells = 4\n[[grid.y]]\nto_m = "
               "1\ncells = 4\n[[grid.z]]\nto_m = 1\ncells = 4\n[[body]]\nname = \"box\"\n"
               "density_kg_per_m3 = 2000\n[[body.surface]]\nfile = \"" +
               file +
               "\"\n[body.elastic]\nyoungs_modulus_kPa = 1e4\npoissons_ratio = 0.2\n[[stage]]\n"
               "name = \"rest\"\n[stage.until]\ntime_s = 1\n";
    };
    here.write("endless.toml", box_in("/dev/zero"));
    Answer answer = here.grit("mpm endless.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("zero: is no file")) << answer.text;
    here.write("long.stl", "");
    std::filesystem::resize_file(here.path("long.stl"), (std::uintmax_t{1} << 30) + 1);  // a hole
    here.write("long.toml", box_in("long.stl"));
    answer = here.grit("mpm long.toml");
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(answer.says("long.stl: is longer than 1024 MiB, the most that is read"))
        << answer.text;
}
#endif

}  // namespace
