// SPDX-License-Identifier: BSD-3-Clause
// Files of VTK: quadrilaterals in the x-y plane, or hexahedra, with values of cells, binary as base64; and the list
// of the files of a time series.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

struct VtuArray {
    std::string name;
    int components;  // 1, 3, or 2: x and y of a vector, written with z = 0
    std::vector<double> values;
};

struct VtuSheet {
    double time;  // [s]
    // x, y of four corners of each cell, counterclockwise, or x, y, z of eight, the lower four before the upper ones [m]
    std::vector<double> corners;
    std::vector<VtuArray> arrays;
    int corners_each = 4;
};

// Written beside and renamed; throws element::CannotWrite.
void write_vtu(const std::filesystem::path& place, const VtuSheet& sheet);

struct PvdEntry {
    double time;  // [s]
    int part;
    std::string file;  // beside the list
};

// The list grows in place, in room that is kept before the closing tags: each entry within a page of memory, which a system
// that kills a program writes whole or not at all, so that what is left is a list of all frames that were finished. Where the
// room ends the list is written anew, with twice as much.
class PvdFile {
  public:
    // With the bytes of a list to which the frames were added one by one; written beside and renamed. All throw
    // element::CannotWrite.
    PvdFile(const std::filesystem::path& place, const std::vector<std::vector<PvdEntry>>& frames);
    PvdFile(const PvdFile&) = delete;
    PvdFile& operator=(const PvdFile&) = delete;
    ~PvdFile();

    // What does not fit on the disk leaves the list as it is.
    void add(const std::vector<PvdEntry>& frame);

  private:
    void write_whole(const std::string& text);
    void put(const std::string& text, std::size_t at);

    std::filesystem::path name;
    int file = -1;
    std::size_t end = 0;   // of the entries
    std::size_t room = 0;  // where the closing tags stand
};

}  // namespace cli
