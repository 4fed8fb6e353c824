// SPDX-License-Identifier: BSD-3-Clause
// A sand of one's own as a file, which every command reads by --sand FILE (or the name of a sand) or [sand] file = "FILE".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <grit/grit.h>

#include "cli/toml/toml_table.hpp"
#include "element/atomic_file.hpp"

namespace cli {

// A parameter by its key (parameter_key), if the table has it. Throws BadInput beyond its limits.
void read_sand_parameter(TomlTable& table, int index, grit_sand_parameters& parameters);

// A sand of the catalogue by its name, or a file of one's own. Throws BadInput.
grit_sand_parameters sand_of(const std::filesystem::path& name_or_file);

// [sand] with all parameters, stresses in kPa. Throws BadInput.
grit_sand_parameters read_sand_file(const std::filesystem::path& path);

// Comments say where the parameters come from; those that are not given (NaN) are left out. The file is
// complete but for its name. Throws element::CannotWrite.
void write_sand_file(element::AtomicFile& file, const grit_sand_parameters& parameters,
                     const std::vector<std::string>& comments);

}  // namespace cli
