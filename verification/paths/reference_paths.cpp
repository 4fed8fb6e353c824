// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "paths/strain_path.hpp"

namespace paths {
namespace {

// Columns of verification/data/reference.
enum Column : std::size_t { strain = 1, stress = 7, void_ratio = 13, memory = 14, columns = 20 };
constexpr std::size_t principal_columns = 11;  // without 12, 13, 23
using Row = std::vector<double>;

std::vector<Row> rows_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    std::vector<Row> rows;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.find_first_of("0123456789") != 0) continue;
        std::istringstream cells(line);
        Row row;
        for (std::string cell; std::getline(cells, cell, ',');)
            row.push_back(std::strtod(cell.c_str(), nullptr));
        if (row.size() == principal_columns)
            row = {row[0], row[1], row[2], row[3], 0,      0,      0,       row[4], row[5], row[6],
                   0,      0,      0,      row[7], row[8], row[9], row[10], 0,      0,      0};
        if (row.size() != columns) throw std::runtime_error("columns of " + file.string());
        rows.push_back(row);
    }
    if (rows.size() < 2) throw std::runtime_error("no rows in " + file.string());
    return rows;
}

StrainPath path_of(const std::filesystem::path& file, int calls) {
    const std::string name = file.stem().string();
    StrainPath path{name, "lausitz", {}, name.find("noIGS") != std::string::npos, 0.0, {}, {}, {}};
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &p);
    grit_sand_prepare(&p, &path.sand, nullptr);
    path.opening_pressure = opening_pressure(path.sand);
    const std::vector<Row> rows = rows_of(file);
    for (std::size_t c = 0; c < 6; ++c) {
        path.stress[c] = rows[0][stress + c];
        path.state[c] = rows[0][memory + c];
    }
    path.state[GRIT_SAND_VOID_RATIO] = rows[0][void_ratio];
    const std::size_t last = rows.size() - 1;
    const std::size_t pieces = calls == 0 ? last : std::min(last, static_cast<std::size_t>(calls));
    for (std::size_t i = 1; i <= pieces; ++i) {
        const Row &from = rows[(i - 1) * last / pieces], &to = rows[i * last / pieces];
        Six d;
        for (std::size_t c = 0; c < 6; ++c) d[c] = to[strain + c] - from[strain + c];
        path.increments.push_back(d);
    }
    return path;
}

}  // namespace

std::vector<StrainPath> reference_paths(const std::string& folder, int calls) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".csv") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<StrainPath> r;
    for (const auto& file : files) r.push_back(path_of(file, calls));
    return r;
}

}  // namespace paths
