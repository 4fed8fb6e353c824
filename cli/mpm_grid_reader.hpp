// SPDX-License-Identifier: BSD-3-Clause
// [grid], [boundary] and [numerics] of a material-point case.
#pragma once

#include <adapters/mpm/case/case.hpp>
#include <adapters/mpm/case/case_words.hpp>

#include "cli/toml_table.hpp"

namespace cli {

void read_grid(TomlTable table, grit::mpm::Case& plan);
// After the grid.
void read_boundary(TomlTable table, grit::mpm::Case& plan);
void read_mpm_numerics(TomlTable table, grit::mpm::Case& plan);

// A number that must be in a range.
double number_within(TomlTable& table, const std::string& key, double otherwise,
                     grit::mpm::limits::Range range);
// ... in which integers have the same meaning as numbers.
int integer_within(TomlTable& table, const std::string& key, int otherwise,
                   grit::mpm::limits::Range range);

}  // namespace cli
