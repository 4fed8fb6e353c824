// SPDX-License-Identifier: BSD-3-Clause
// A sand of one's own as a file, which every command reads by --sand FILE or [sand] file = "FILE".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <grit/grit.h>

namespace cli {

// Comments say where the parameters come from; those that are not given (NaN) are left out. Throws
// element::CannotWrite.
void write_sand_file(const std::filesystem::path& path, const grit_sand_parameters& parameters,
                     const std::vector<std::string>& comments);

}  // namespace cli
