// SPDX-License-Identifier: BSD-3-Clause
// The history of a material-point run as columns of a CSV.
#pragma once

#include <string>
#include <vector>

#include <adapters/mpm/run/run.hpp>

#include "cli/table/table.hpp"

namespace cli {

// In words of the case: geometry_words.hpp.
std::vector<Column> history_columns(const grit::mpm::Case& plan);
std::vector<double> history_values(const grit::mpm::Case& plan, const grit::mpm::HistoryRow& row);
// Table of the documentation, Markdown: as fix grit/mpm has them, in SI units.
std::string history_table();
// What stands above them.
std::vector<std::string> history_comments(const grit::mpm::Runner& runner,
                                          const std::string& changes);

}  // namespace cli
