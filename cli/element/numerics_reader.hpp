// SPDX-License-Identifier: BSD-3-Clause
// [numerics] of a case file.
#pragma once

#include "cli/toml/toml_table.hpp"
#include "element/grit_law.hpp"
#include "element/simulate.hpp"

namespace cli {

// Of a table that may have other keys. Throws BadInput.
void read_numerics(TomlTable& table, element::GritLawOptions& options, element::Settings& settings);

}  // namespace cli
