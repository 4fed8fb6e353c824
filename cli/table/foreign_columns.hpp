// SPDX-License-Identifier: BSD-3-Clause
// Columns of other people's tables under the names of Grit's results.
#pragma once

#include <string>
#include <vector>

#include "cli/table/table.hpp"

namespace cli {

// Understood: results of Grit as they are; references with eps11 ... gam23, s11 ... s23, e (tension
// positive); tables that incrementalDriver writes; laboratory sheets with eps_a_percent, eps_v_percent, q_kPa, p_kPa, void_ratio,
// sigma_a_kPa, sigma_r_kPa (compression positive). A unit in the header that is another one is converted, laboratory_unit.hpp;
// one that is not known is a problem of its column. Other columns stay as they are.
Table standardised(Table table);

// Names of laboratories and other programs that it understands.
std::vector<std::string> foreign_column_names();
// Those of laboratories' sheets among them.
std::vector<std::string> laboratory_column_names();
// What it calls a column of this name.
std::string standard_column_name(const std::string& name);
// Grit's unit of a column of this name; null: it is not understood.
const char* unit_of_column(const std::string& name);

}  // namespace cli
