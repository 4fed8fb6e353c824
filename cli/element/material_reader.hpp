// SPDX-License-Identifier: BSD-3-Clause
// [sand], [umat] and [start] of a case file.
#pragma once

#include "cli/element/case_file.hpp"
#include "cli/toml/toml_table.hpp"

namespace cli {

// Parameters in kPa; a name says where they come from.
struct NamedSand {
    std::string name = "given in the case file";
    grit_sand_parameters parameters{};
    std::filesystem::path file;  // that they were read from, if any
};
// name or file, and parameters, of a table that may have other keys.
NamedSand read_sand_parameters(TomlTable& table);
// Water of [sand].
void read_water(TomlTable& table, element::GritLawOptions& options);

// given: a file whose parameters count instead, empty: none.
// Of a case without [sand]: a file, or a name of the catalogue. Throws BadInput.
void take_sand(CaseFile& file, const std::filesystem::path& given);
void read_sand(TomlTable table, CaseFile& file, const std::filesystem::path& given);
void read_umat(TomlTable table, CaseFile& file);
// Parts of a start that may have other keys: pressure_kPa or stress_kPa; what is said of h.
element::Vector6 read_start_stress(TomlTable& table);
void read_intergranular_start(TomlTable& table, const grit_sand_parameters& parameters,
                              element::Start& start);
// After the sand.
void read_start(TomlTable table, CaseFile& file);

// A UMAT of the classic layout (PROPS 16, STATEV 14), or of the second one, with the sand and the start
// of the case. Throws element::BadCase.
void fill_umat(CaseFile& file, bool radian);

// law, own_law and point of the case. Throws element::BadCase.
void make_material(CaseFile& file);

}  // namespace cli
