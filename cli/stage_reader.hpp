// SPDX-License-Identifier: BSD-3-Clause
// [[stage]] of a case file: the words of the laboratory as programs of steps.
#pragma once

#include <vector>

#include "cli/case_file.hpp"
#include "cli/toml_table.hpp"

namespace cli {

// state_names: of the law, for exit conditions.
CaseStage read_stage(TomlTable table, const std::vector<std::string>& state_names);

}  // namespace cli
