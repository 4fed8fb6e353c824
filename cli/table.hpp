// SPDX-License-Identifier: BSD-3-Clause
// Named columns of numbers: results, references and laboratory data alike.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace cli {

struct Column {
    std::string name, unit;
    std::vector<double> values;
};

struct Table {
    std::vector<Column> columns;
    std::vector<std::string> comments;  // before the header, without #

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
    const std::vector<double>* find(const std::string& name) const;  // null: there is none
    const std::vector<double>& at(const std::string& name) const;    // throws std::out_of_range
};

// A CSV with # comments and a header "name [unit],..."; cells that are no numbers become NaN. If only
// is not empty, the rows whose first cell it is. Throws BadInput naming file and line.
Table read_table(const std::filesystem::path& path, const std::string& only = {});

// Cells as they are written, a row after another, the header first. Throws BadInput.
std::vector<std::vector<std::string>> read_cells(const std::filesystem::path& path);

// Written aside and renamed when complete. Throws BadInput.
void write_table(const std::filesystem::path& path, const Table& table);

// Write a file aside and rename it when complete, so that a reader never sees half of it.
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace cli
