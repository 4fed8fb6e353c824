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

// Written beside and renamed; throws element::CannotWrite.
void write_vtu(const std::filesystem::path& place, const VtuSheet& sheet);

struct PvdEntry {
    double time;  // [s]
    int part;
    std::string file;  // beside the list
};

// The list grows in place: entries go where the closing tags stand, together with new ones and in one
// call of the system, so that what a killed program leaves is a list of all frames it finished.
class PvdFile {
  public:
    // Written beside and renamed. All throw element::CannotWrite.
    PvdFile(const std::filesystem::path& place, const std::vector<PvdEntry>& entries);
    PvdFile(const PvdFile&) = delete;
    PvdFile& operator=(const PvdFile&) = delete;
    ~PvdFile();

    // What does not fit on the disk leaves the list as it is.
    void add(const std::vector<PvdEntry>& entries);

  private:
    void put(const std::string& text, std::size_t at);

    std::filesystem::path name;
    int file = -1;
    std::size_t end = 0;  // of the entries: the place of the closing tags
};

}  // namespace cli
