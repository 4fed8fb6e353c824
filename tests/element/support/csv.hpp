// SPDX-License-Identifier: BSD-3-Clause
// Tables of verification/data: comma separated, lines of text and a header before the numbers.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tests {

using Row = std::vector<double>;

inline std::vector<Row> read_rows(const std::string& name) {
    const std::string path = std::string(GRIT_DATA) + "/" + name;
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    std::vector<Row> rows;
    std::string line;
    while (std::getline(file, line)) {
        if (line.empty() || line.find_first_of("0123456789") != 0) continue;
        std::istringstream cells(line);
        std::string cell;
        Row row;
        while (std::getline(cells, cell, ',')) row.push_back(std::strtod(cell.c_str(), nullptr));
        rows.push_back(row);
    }
    return rows;
}

}  // namespace tests
