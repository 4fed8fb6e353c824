// SPDX-License-Identifier: BSD-3-Clause
// [[traction]] and [[contact]] of a material-point case.
#pragma once

#include <adapters/mpm/case/case.hpp>

#include "cli/toml/toml_table.hpp"

namespace cli {

// After the bodies.
grit::mpm::TractionPlan read_traction(TomlTable table, grit::mpm::Case& plan);
grit::mpm::InflowPlan read_inflow(TomlTable table, const grit::mpm::Case& plan);
grit::mpm::ContactPlan read_contact(TomlTable table, const grit::mpm::Case& plan);

// A key that must name a body, or a stage.
std::string body_name(TomlTable& table, const std::string& key, const grit::mpm::Case& plan);
std::string stage_name(TomlTable& table, const std::string& key, const grit::mpm::Case& plan);

}  // namespace cli
