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
