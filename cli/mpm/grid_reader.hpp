// SPDX-License-Identifier: BSD-3-Clause
// [grid], [boundary] and [numerics] of a material-point case.
#pragma once

#include <adapters/mpm/case/case_words.hpp>

#include "cli/toml/toml_table.hpp"

namespace cli {

// [[name]] of a grid that begins at the number of this word.
grit::mpm::AxisPlan read_axis(TomlTable& grid, const std::string& name,
                              const grit::mpm::CaseWord& begin);
// Refuses a grid of too many nodes.
void check_nodes(const TomlTable& grid, double nodes);
double nodes_of(const grit::mpm::AxisPlan& plan);
// In plane strain r may be called x.
void name_axes(TomlTable& root);
void read_grid(TomlTable table, grit::mpm::Case& plan);
// After the grid.
void read_boundary(TomlTable table, grit::mpm::Case& plan);
void read_mpm_numerics(TomlTable table, grit::mpm::Case& plan);

}  // namespace cli
