// SPDX-License-Identifier: BSD-3-Clause
// Columns of other people's tables under the names of Grit's results.
#pragma once

#include <string>
#include <vector>

#include "cli/table/table.hpp"

namespace cli {

// Understood: results of Grit as they are; references with eps11 ... gam23, s11 ... s23, e (tension
// positive); tables that incrementalDriver writes; laboratory sheets with eps_a_percent, eps_v_percent, q_kPa, p_kPa, void_ratio,
// sigma_a_kPa, sigma_r_kPa (compression positive). Other columns stay as they are.
Table standardised(Table table);

// Names of laboratories and other programs that it understands.
std::vector<std::string> foreign_column_names();

}  // namespace cli
