// SPDX-License-Identifier: BSD-3-Clause
// What a file holds, which says how it is drawn.
#pragma once

#include <string>
#include <vector>

#include "cli/table/table.hpp"

namespace cli {

// Of pictures of tests and of histories of grit mpm.
const std::vector<std::string>& plot_kinds();
// Columns that such a picture shows.
std::vector<std::string> columns_drawn(const std::string& kind);

// Line above a result that says which picture grit element draws of it.
std::string picture_comment(const std::string& picture);

// A row of it is a cycle.
bool is_of_cycles(const Table& table);

// Kind of picture of a result with standard column names: as the comments above it say, or of what its columns are; empty:
// it is none that is known here.
std::string picture_of_result(const std::vector<std::string>& comments, const Table& table);

}  // namespace cli
