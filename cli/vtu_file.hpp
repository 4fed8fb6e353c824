// SPDX-License-Identifier: BSD-3-Clause
// Files of VTK: quadrilaterals in the x-y plane with values of cells, binary as base64; and the list of
// the files of a time series.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

struct VtuArray {
    std::string name;
    int components;  // 1, or 2: x and y of a vector, written with z = 0
    std::vector<double> values;
};

struct VtuSheet {
    double time;                  // [s]
    std::vector<double> corners;  // x, y of four corners of each cell, counterclockwise [m]
    std::vector<VtuArray> arrays;
};

// Both written aside and renamed; throw element::CannotWrite.
void write_vtu(const std::filesystem::path& place, const VtuSheet& sheet);

struct PvdEntry {
    double time;  // [s]
    int part;
    std::string file;  // beside the list
};
void write_pvd(const std::filesystem::path& place, const std::vector<PvdEntry>& entries);

}  // namespace cli
