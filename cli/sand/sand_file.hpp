// SPDX-License-Identifier: BSD-3-Clause
// A sand of one's own as a file, which every command reads by --sand FILE or [sand] file = "FILE".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <grit/grit.h>

#include "cli/toml/toml_table.hpp"

namespace cli {

// A parameter by its key (parameter_key), if the table has it. Throws BadInput beyond its limits.
void read_sand_parameter(TomlTable& table, int index, grit_sand_parameters& parameters);

// [sand] with all parameters, stresses in kPa. Throws BadInput.
grit_sand_parameters read_sand_file(const std::filesystem::path& path);

// Comments say where the parameters come from; those that are not given (NaN) are left out. Throws
// element::CannotWrite.
void write_sand_file(const std::filesystem::path& path, const grit_sand_parameters& parameters,
                     const std::vector<std::string>& comments);

}  // namespace cli
