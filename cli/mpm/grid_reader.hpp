// SPDX-License-Identifier: BSD-3-Clause
// [grid], [boundary] and [numerics] of a material-point case.
#pragma once

#include <adapters/mpm/case/case.hpp>

#include "cli/toml/toml_table.hpp"

namespace cli {

void read_grid(TomlTable table, grit::mpm::Case& plan);
// After the grid.
void read_boundary(TomlTable table, grit::mpm::Case& plan);
void read_mpm_numerics(TomlTable table, grit::mpm::Case& plan);

}  // namespace cli
