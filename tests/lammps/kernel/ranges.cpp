// SPDX-License-Identifier: BSD-3-Clause
// A number that a case file may say is one that the fix takes, and the other way round.
#include <gtest/gtest.h>

#include <stdexcept>

#include <adapters/lammps/fix_case.hpp>
#include <cli/mpm/case_file.hpp>
#include <cli/process/exit_code.hpp>
#include <fmt/format.h>

#include "support/folder.hpp"

namespace {

// A line of a case file and words of the fix that mean the same, {} in the place of the number.
struct Pair {
    const char *table, *line;  // "": the file's first lines
    const char* words;
    bool of_stage = false;
    double unit = 1.0;  // of the file in SI
};

const Pair pairs[] = {
    {"", "gravity_m_per_s2 = {}", "gravity {}"},
    {"[[grid.z]]", "growth = {}", "grid z 30 1 {}"},
    {"[[grid.z]]", "cells = {}", "grid z 30 {} 1"},
    {"[numerics]", "cfl = {}", "cfl {}"},
    {"[numerics]", "largest_step_s = {}", "largest_step {}"},
    {"[numerics]", "pic_rate_per_s = {}", "pic_rate {}"},
    {"[numerics]", "local_damping = {}", "local_damping {}"},
    {"[numerics]", "bulk_viscosity_linear = {}", "bulk_viscosity {} 0"},
    {"[numerics]", "bulk_viscosity_quadratic = {}", "bulk_viscosity 0 {}"},
    {"[numerics]", "energy_residual_limit = {}", "energy_residual_limit {}"},
    {"[numerics]", "threads = {}", "threads {}"},
    {"[[contact]]", "friction_coefficient = {}", "contact plate block geo {}"},
    {"[[contact]]", "penalty_power = {}", "contact plate block geo 0 power {}"},
    {"[stage.until]", "depth_m = {}", "until_depth {}", true},
    {"[stage.until]", "blows = {}", "until_blows {}", true},
    {"[stage.until]", "unbalanced_share = {}", "until_unbalanced {}", true},
    {"[[stage]]", "cfl = {}", "cfl {}", true},
    {"[[stage]]", "pic_rate_per_s = {}", "pic_rate {}", true},
    {"[[stage]]", "local_damping = {}", "local_damping {}", true},
    {"[traction.pulses]", "start_s = {}",
     "traction block loaded top 0 -1 pulses triangle 1 3 1 4 {} 2"},
    {"[traction.pulses]", "count = {}",
     "traction block loaded top 0 -1 pulses triangle 1 3 1 4 0 {}"},
    {"[traction.pulses]", "peak_time_s = {}",
     "traction block loaded top 0 -1 pulses triangle 1 3 {} 4 0 2"},
    {"[traction.pulses]", "interval_s = {}",
     "traction block loaded top 0 -1 pulses triangle 1 3 1 {} 0 2"},
    {"[body.elastic]", "youngs_modulus_kPa = {}", "body other type 3 elastic {} 0.3", false, 1e3},
    {"[body.elastic]", "poissons_ratio = {}", "body other type 3 elastic 1000 {}"},
};

// Numbers at which something might begin or end.
const double numbers[] = {-1e6, -10,   -1,   -0.99, -1e-9, 0,    1e-300, 1e-12, 1e-7, 1e-6,
                          1e-5, 1e-4,  1e-3, 0.01,  0.1,   0.4,  0.49,   0.5,   0.94, 0.95,
                          0.96, 1,     1.01, 1.5,   2,     2.01, 3,      4,     9.9,  10,
                          11,   99,    100,  101,   999,   1000, 1001,   1024,  1025, 99999,
                          1e5,  1.1e5, 1e6,  1.1e6, 1e9,   2e9,  1e30};

std::string case_with(const Pair& pair, double number) {
    const char* tables[] = {
        "",
        "[grid]\ngeometry = \"plane_strain\"\n[[grid.r]]\nto_m = 30\ncells = 3\n",
        "[[grid.z]]\nto_m = 30\n",
        "[numerics]\n",
        "[[body]]\nname = \"plate\"\n[[body.box]]\nr_m = [1, 9]\nz_m = [20, 21]\n"
        "[body.rigid]\n[[body]]\nname = \"block\"\ndensity_kg_per_m3 = 1000\n"
        "[[body.box]]\nr_m = [1, 9]\nz_m = [1, 9]\n",
        "[body.elastic]\n",
        "[[traction]]\nbody = \"block\"\nedge = \"top\"\n",
        "[traction.pulses]\npeak_kPa = 1\nform = \"triangle\"\nduration_s = 3\n",
        "[[contact]]\nstiff = \"plate\"\nsoft = \"block\"\nlaw = \"geo\"\n",
        "[[stage]]\nname = \"one\"\n",
        "[stage.until]\ntime_s = 1\n"};
    const std::string given = fmt::format(fmt::runtime(pair.line), number / pair.unit);
    const auto says = [&](const char* key) { return std::string(pair.line).find(key) == 0; };
    std::string out;
    for (const std::string table : tables) {
        out += table;
        if (table.find(pair.table) == 0 && (*pair.table || table.empty())) out += given + '\n';
        if (table.find("[[grid.z]]") == 0 && !says("cells")) out += "cells = 1\n";
        if (table.find("[body.elastic]") == 0 && !says("youngs")) out += "youngs_modulus_kPa = 1\n";
        if (table.find("[body.elastic]") == 0 && !says("poissons")) out += "poissons_ratio = 0.3\n";
        if (table.find("[traction.pulses]") == 0 && !says("interval_s")) out += "interval_s = 4\n";
    }
    return out;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream words(text);
    for (std::string word; words >> word;) out.push_back(word);
    return out;
}

std::string refusal_of_file(const Folder& folder, const std::string& text) {
    folder.write("case.toml", text);
    try {
        cli::read_mpm_case(folder.path() / "case.toml");
    } catch (const cli::BadInput& refused) {
        return refused.what();
    }
    return {};
}

std::string refusal_of_fix(const Pair& pair, double number) {
    const double box[2][2] = {{0.0, 30.0}, {0.0, 30.0}};
    const std::string given = fmt::format(fmt::runtime(pair.words), number);
    std::string words = "plane_strain grid r 30 3 1";
    if (given.find("grid z") != 0) words += " grid z 30 1 1";
    words += " body plate type 1 rigid body block type 2 elastic 1000 0.3";
    words += " traction block pressed top 0 -1 pulses triangle 1 3 1 4 0 2";
    if (!pair.of_stage) words += ' ' + given;
    try {
        const grit::lammps::FixCase plan = grit::lammps::read_fix(split(words), box);
        if (pair.of_stage)
            grit::lammps::read_stage(split(given), plan.plan.stages[0], plan.plan.settings.scheme);
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return {};
}

TEST(LammpsRanges, AreThoseOfCaseFilesForEveryNumber) {
    const Folder folder;
    for (const Pair& pair : pairs) {
        int taken = 0;
        for (const double number : numbers) {
            const std::string file = refusal_of_file(folder, case_with(pair, number));
            const std::string fix = refusal_of_fix(pair, number);
            EXPECT_EQ(file.empty(), fix.empty())
                << pair.line << ", " << number << "\nfile: " << file << "\nfix: " << fix;
            taken += file.empty();
        }
        EXPECT_GT(taken, 0) << pair.line << ": " << case_with(pair, 0.4);
    }
}

// What belongs together, or apart, in a case file.
TEST(LammpsRanges, OfWordsThatMustFitTogetherAreThoseOfCaseFiles) {
    const double box[2][2] = {{0.0, 30.0}, {0.0, 30.0}};
    const std::string grid = "grid r 30 3 1 grid z 30 3 1 ";
    const std::string bodies = "body plate type 1 rigid body block type 2 elastic 1000 0.3 ";
    const auto refusal = [&](const std::string& words, const std::string& geometry) {
        try {
            grit::lammps::read_fix(split(geometry + ' ' + grid + bodies + words), box);
        } catch (const std::invalid_argument& refused) {
            return std::string(refused.what());
        }
        return std::string();
    };
    const auto plane = [&](const std::string& words) { return refusal(words, "plane_strain"); };
    const std::string geo = "contact plate block geo 0.3",
                      smooth = "contact plate block frictional 0";
    EXPECT_EQ(plane(geo + " power 4 distance edge gated no"), "");
    EXPECT_EQ(plane(smooth + " distance edge"), "");
    EXPECT_EQ(plane(smooth + " power 4"),
              "power belongs to the geo law, not to the frictional one");
    EXPECT_EQ(plane(smooth + " distance edge gated no"),
              "distance: the frictional law measures none unless it is gated");
    EXPECT_EQ(plane(geo + " contact block plate geo 0.1"),
              "contact block plate: \"block\" and \"plate\" have a contact already");
    EXPECT_EQ(plane("stages 3 a b a"), "two stages are called \"a\"");
    EXPECT_EQ(plane("traction block all top 0 0 5"), "the direction of a traction must not be 0");
    EXPECT_EQ(plane("traction block all top 0 -1 pulses half_sine 1 3 1 4 0 2"),
              "the time of its peak: a half sine has its peak at 1.5 s, got 1");
    EXPECT_EQ(plane("boundary left fixed"), "");
    EXPECT_EQ(refusal("boundary left roller", "axisymmetric"), "");
    for (const char* other : {"fixed", "free"})
        EXPECT_EQ(refusal(std::string("boundary left ") + other, "axisymmetric"),
                  "boundary left is the axis r = 0: roller");
}

TEST(LammpsRanges, OfStagesThatEndAtRestAreThoseOfCaseFiles) {
    using grit::lammps::read_stage;
    using grit::mpm::Scheme;
    const std::vector<std::string> rest = split("until_unbalanced 0.1 until_kinetic 0.01");
    EXPECT_EQ(read_stage(rest, {}, Scheme::usl).end.kinetic_share, 0.01);
    const auto refusal = [](const std::vector<std::string>& words, Scheme scheme) {
        try {
            read_stage(words, {}, scheme);
        } catch (const std::invalid_argument& refused) {
            return std::string(refused.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal(rest, Scheme::musl), "until_unbalanced is not measured with the scheme musl");
    EXPECT_EQ(refusal(split("until_kinetic 0.01"), Scheme::usl),
              "until_kinetic needs until_unbalanced: a body that turns back has no kinetic energy "
              "either");
}

}  // namespace
