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
    {"[[contact]]", "relaxation_time_s = {}", "contact plate block geo 0 relaxation_time {}"},
    {"[[contact]]", "contact_stiffness_multiple = {}\nmodulus_kPa = 5",
     "contact plate block geo 0 stiffness_multiple {} modulus 5000"},
    {"[[contact]]", "contact_stiffness_multiple = 1\nmodulus_kPa = {}",
     "contact plate block geo 0 stiffness_multiple 1 modulus {}", false, 1e3},
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
    const grit::lammps::Box box{{{0.0, 30.0}, {0.0, 30.0}}};
    const std::string given = fmt::format(fmt::runtime(pair.words), number);
    std::string words = "plane_strain grid r 30 3 1";
    if (given.find("grid z") != 0) words += " grid z 30 1 1";
    words += " body plate type 1 rigid body block type 2 elastic 1000 0.3";
    words += " traction block pressed top 0 -1 pulses triangle 1 3 1 4 0 2";
    if (!pair.of_stage) words += ' ' + given;
    try {
        const grit::lammps::FixCase plan = grit::lammps::read_fix(split(words), box);
        if (pair.of_stage) grit::lammps::read_stage(split(given), plan.plan.stages[0], plan.plan);
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
    const grit::lammps::Box box{{{0.0, 30.0}, {0.0, 30.0}}};
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
    EXPECT_EQ(plane(smooth + " power 4"), "power belongs to the law geo, not to frictional");
    EXPECT_EQ(plane(smooth + " distance edge gated no"),
              "distance: the frictional law measures none unless it is gated");
    EXPECT_EQ(plane(geo + " contact block plate geo 0.1"),
              "contact block plate: \"block\" and \"plate\" have a contact already");
    EXPECT_EQ(plane("stages 3 a b a"), "the name of a stage: there is a stage \"a\" already");
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
    grit::mpm::Case plan;
    const std::vector<std::string> rest = split("until_unbalanced 0.1 until_kinetic 0.01");
    EXPECT_EQ(read_stage(rest, {}, plan).end.kinetic_share, 0.01);
    const auto refusal = [&plan](const std::vector<std::string>& words, Scheme scheme) {
        plan.settings.scheme = scheme;
        try {
            read_stage(words, {}, plan);
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

// A case file and the words of the fix for the same case.
const char* const sound_file = R"([numerics]
scheme = "usl"
[grid]
geometry = "axisymmetric"
r = [{to_m = 30, cells = 3}]
z = [{to_m = 30, cells = 3}]
[boundary]
left = "roller"
[[body]]
name = "plate"
box = [{r_m = [0, 9], z_m = [20, 21]}]
rigid = {time_s = [0, 1], velocity_z_m_per_s = [0, 1]}
[[body]]
name = "other"
box = [{r_m = [0, 9], z_m = [23, 24]}]
rigid = {}
[[body]]
name = "block"
box = [{r_m = [0, 9], z_m = [1, 9]}]
density_kg_per_m3 = 1000
elastic = {youngs_modulus_kPa = 1, poissons_ratio = 0.3}
[[traction]]
body = "block"
edge = "top"
pulses = {peak_kPa = 1, form = "half_sine", duration_s = 3, peak_time_s = 1.5, interval_s = 4}
[[contact]]
stiff = "plate"
soft = "block"
law = "geo"
[[stage]]
name = "one"
until = {time_s = 1, blows = 1, unbalanced_share = 0.1, kinetic_share = 0.01}
)";
const char* const sound_fix =
    "axisymmetric grid r 30 3 1 grid z 30 3 1 scheme usl boundary left roller "
    "body plate type 1 rigid motion plate 0 table 2 0 0 1 1 body other type 2 rigid "
    "body block type 3 elastic 1000 0.3 "
    "traction block loaded top 0 -1 pulses half_sine 1000 3 1.5 4 0 1 "
    "contact plate block geo 0 stages 1 one";
const char* const sound_stage =
    "until_time 1 until_blows 1 until_unbalanced 0.1 until_kinetic 0.01";

// Other words in the place of those of the sound case, in the file and in the fix or its stage.
struct Change {
    const char *in_file, *file, *in_fix, *fix;
    const char* refusal;  // what both say behind the place; "": both take it
};

const Change changes[] = {
    {"", "", "", "", ""},
    {"left = \"roller\"", "", " boundary left roller", "", ""},
    {"\"roller\"", "\"fixed\"", "left roller", "left fixed", " is the axis r = 0: roller"},
    {"\"roller\"", "\"free\"", "left roller", "left free", " is the axis r = 0: roller"},
    {"body = \"block\"", "body = \"plate\"", "traction block", "traction plate",
     ": \"plate\" is rigid, no load moves it"},
    {"soft = \"block\"", "soft = \"plate\"", "contact plate block", "contact plate plate",
     " must be another body than "},
    {"soft = \"block\"", "soft = \"other\"", "contact plate block", "contact plate other",
     ": both bodies are rigid"},
    {"[[stage]]", "[[contact]]\nstiff = \"block\"\nsoft = \"plate\"\nlaw = \"geo\"\n[[stage]]",
     "stages", "contact block plate geo 0 stages",
     ": \"block\" and \"plate\" have a contact already"},
    {"[[stage]]", "[[contact]]\nstiff = \"block\"\nsoft = \"other\"\nlaw = \"geo\"\n[[stage]]",
     "stages", "contact block other geo 0 stages", ""},
    {"\"geo\"", "\"geo\"\npenalty_power = 6", "geo 0", "geo 0 power 6", ""},
    {"\"geo\"", "\"frictional\"\npenalty_power = 6", "geo 0", "frictional 0 power 6",
     " belongs to the law geo, not to frictional"},
    {"\"geo\"", "\"frictional\"\nrelaxation_time_s = 1", "geo 0", "frictional 0 relaxation_time 1",
     " belongs to the laws geo and surface, not to frictional"},
    {"\"geo\"", "\"surface\"\nrelaxation_time_s = 1", "geo 0", "surface 0 relaxation_time 1",
     " of surfaces belongs to a stiffness of the contact, and there is none"},
    {"\"geo\"",
     "\"surface\"\nrelaxation_time_s = 1\ncontact_stiffness_multiple = 1\nmodulus_kPa = 1", "geo 0",
     "surface 0 relaxation_time 1 stiffness_multiple 1 modulus 1000", ""},
    {"\"geo\"",
     "\"surface\"\nafter_damping = true\ncontact_stiffness_multiple = 1\nmodulus_kPa = 1", "geo 0",
     "surface 0 after_damping yes stiffness_multiple 1 modulus 1000",
     ": a stiffness would act twice in a step"},
    {"\"geo\"", "\"geo\"\npressure_spacing_cells = 1", "geo 0", "geo 0 pressure_spacing 1",
     " belongs to the law surface, not to geo"},
    {"\"geo\"", "\"surface\"\npressure_spacing_cells = 1", "geo 0", "surface 0 pressure_spacing 1",
     ""},
    {"\"geo\"", "\"geo\"\nsweep_tolerance = 1e-9", "geo 0", "geo 0 sweep_tolerance 1e-9",
     " belongs to the law surface, not to geo"},
    {"\"geo\"", "\"surface\"\nsweep_tolerance = 1e-9", "geo 0", "surface 0 sweep_tolerance 1e-9",
     ""},
    {"\"geo\"", "\"geo\"\nafter_damping = true", "geo 0", "geo 0 after_damping yes",
     " belongs to the law surface, not to geo"},
    {"\"geo\"", "\"surface\"\nafter_damping = true", "geo 0", "surface 0 after_damping yes", ""},
    {"\"geo\"", "\"geo\"\ncontact_stiffness_multiple = 1", "geo 0", "geo 0 stiffness_multiple 1",
     " needs the P-wave modulus of the softer body"},
    {"\"geo\"", "\"geo\"\nmodulus_kPa = 1", "geo 0", "geo 0 modulus 1000",
     " belongs to a stiffness of the contact, and there is none"},
    {"\"geo\"", "\"geo\"\ngated = false\ncontact_stiffness_multiple = 1\nmodulus_kPa = 1", "geo 0",
     "geo 0 gated no stiffness_multiple 1 modulus 1000", " needs a gap: the contact is not gated"},
    {"\"geo\"", "\"frictional\"\ndistance = \"edge\"", "geo 0", "frictional 0 distance edge", ""},
    {"\"geo\"", "\"frictional\"\ndistance = \"support\"\ngated = false", "geo 0",
     "frictional 0 distance support gated no",
     ": the frictional law measures none unless it is gated"},
    {"unbalanced_share = 0.1, ", "", " until_unbalanced 0.1", "",
     ": a body that turns back has no kinetic energy either"},
    {"unbalanced_share = 0.1", "unbalanced_share = 0", "unbalanced 0.1", "unbalanced 0",
     ": a body that turns back has no kinetic energy either"},
    {", kinetic_share = 0.01", "", " until_kinetic 0.01", "", ""},
    {"unbalanced_share = 0.1, kinetic_share = 0.01", "kinetic_share = 0",
     "until_unbalanced 0.1 until_kinetic 0.01", "until_kinetic 0", ""},
    {"\"usl\"", "\"musl\"", "usl", "musl", " is not measured with the scheme musl"},
    {"time_s = [0, 1]", "time_s = [1, 2]", "table 2 0 0 1 1", "table 2 1 0 2 1", ""},
    {"half_sine", "triangle", "half_sine", "triangle", ""},
    {"peak_time_s = 1.5", "peak_time_s = 1", "3 1.5", "3 1",
     ": a half sine has its peak at 1.5 s, got 1"},
    {"\"half_sine\", duration_s = 3, peak_time_s = 1.5",
     "\"triangle\", duration_s = 3, peak_time_s = 3", "half_sine 1000 3 1.5", "triangle 1000 3 3",
     "3, got 3"},
    {"interval_s = 4", "interval_s = 3", "1.5 4", "1.5 3", ""},
    {"interval_s = 4", "interval_s = 2.5", "1.5 4", "1.5 2.5", "3, got 2.5"},
    {"time_s = [0, 1]", "time_s = [1, 0.5]", "table 2 0 0 1 1", "table 2 1 0 0.5 1",
     " must ascend: 0.5 after 1"},
    {"pulses = {peak_kPa = 1, form = \"half_sine\", duration_s = 3, peak_time_s = 1.5, interval_s "
     "= 4}",
     "time_s = [0, 0]\nstress_kPa = [1, 2]", "pulses half_sine 1000 3 1.5 4 0 1",
     "table 2 0 1000 0 2000", " must ascend: 0 after 0"},
    {"pulses = {peak_kPa = 1, form = \"half_sine\", duration_s = 3, peak_time_s = 1.5, interval_s "
     "= 4}",
     "time_s = [0, 1]\nstress_kPa = [1, 2]", "pulses half_sine 1000 3 1.5 4 0 1",
     "table 2 0 1000 1 2000", " needs a traction with pulses"},
    {"name = \"other\"", "name = \"block\"", "other", "block",
     ": there is a body \"block\" already"},
    {"name = \"other\"", "name = \"other.one\"", "other", "other.one",
     " may have letters, digits, _ and - only, got \"other.one\""},
    {"name = \"other\"", "name = \"Other_1-b\"", "other", "Other_1-b", ""},
    {"[[stage]]", "[[stage]]\nname = \"one\"\nuntil = {time_s = 1}\n[[stage]]", "stages 1",
     "stages 2 one", ": there is a stage \"one\" already"},
    {"name = \"one\"", "name = \"o/ne\"", "stages 1 one", "stages 1 o/ne",
     " may have letters, digits, _ and - only, got \"o/ne\""},
};

std::string refusal_of_fix_and_stage(const std::string& fix, const std::string& stage) {
    const grit::lammps::Box box{{{0.0, 30.0}, {0.0, 30.0}}};
    try {
        const grit::mpm::Case plan = grit::lammps::read_fix(split(fix), box).plan;
        grit::lammps::read_stage(split(stage), plan.stages[0], plan);
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return {};
}

TEST(LammpsRanges, OfWholeCasesAreBrokenInTheSameWordsForBothReaders) {
    const Folder folder;
    // False: it is not there.
    const auto put = [](std::string& text, const std::string& words, const char* others) {
        const std::size_t at = text.find(words);
        if (at != std::string::npos) text.replace(at, words.size(), others);
        return at != std::string::npos;
    };
    for (const Change& change : changes) {
        std::string text = sound_file, fix = sound_fix, stage = sound_stage;
        ASSERT_TRUE(put(text, change.in_file, change.file)) << change.in_file;
        ASSERT_TRUE(put(fix, change.in_fix, change.fix) || put(stage, change.in_fix, change.fix))
            << change.in_fix;
        const std::string refusals[] = {refusal_of_file(folder, text),
                                        refusal_of_fix_and_stage(fix, stage)};
        const std::string all = fmt::format("{}, {}\nfile: {}\nfix: {}", change.file, change.fix,
                                            refusals[0], refusals[1]);
        for (const std::string& refusal : refusals) {
            EXPECT_EQ(refusal.empty(), !*change.refusal) << all;
            EXPECT_TRUE(refusal.find(change.refusal) != std::string::npos) << all;
        }
    }
}

}  // namespace
