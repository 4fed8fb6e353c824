// SPDX-License-Identifier: BSD-3-Clause
// [[body]] of a material-point case.
#pragma once

#include <filesystem>

#include <adapters/mpm/case/case.hpp>

#include "cli/toml/toml_table.hpp"

namespace cli {

// After the grid. Names of stages are checked by check_stage_names.
// sand: a file whose parameters take the place of the body's, empty: none.
// In space its shapes are added to those of the plan.
grit::mpm::BodyPlan read_body(TomlTable table, grit::mpm::Case& plan,
                              const std::filesystem::path& sand);

// time_s and a list of values under key, in units of unit. Both ascending in time; one value: constant.
grit::mpm::TimeTable read_time_table(TomlTable& table, const std::string& key, double unit);

}  // namespace cli
