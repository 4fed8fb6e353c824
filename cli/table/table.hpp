// SPDX-License-Identifier: BSD-3-Clause
// Named columns of numbers: results, references and laboratory data alike.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/tables/csv.hpp"

namespace cli {

struct Column {
    std::string name, unit;
    std::vector<double> values;  // NaN where a cell was empty
    std::string problem;         // where a cell is no number; nobody minds until the column is used
};

struct Table {
    std::vector<Column> columns;
    std::string file{};  // where they stand, empty: in none

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
    // Null if there is none. Throws BadInput if it has a problem.
    const std::vector<double>* find(const std::string& name) const;
    const std::vector<double>& at(const std::string& name) const;  // throws std::out_of_range too
};

// A CSV with # comments and a header "name [unit],...", or a table that incrementalDriver has written.
// If only is not empty, the rows whose first cell it is. Throws BadInput naming file and line.
Table read_table(const std::filesystem::path& path, const std::string& only = {});

// Lines "# TEXT" above the header.
std::vector<std::string> comments_above(const std::filesystem::path& path);

// Throws BadInput.
using grit::csv::Cells;
Cells read_cells(const std::filesystem::path& path);

}  // namespace cli
