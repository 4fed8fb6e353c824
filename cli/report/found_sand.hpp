// SPDX-License-Identifier: BSD-3-Clause
// What grit calibrate has left: a sand, and a page about it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

// Whether grit calibrate wrote it.
bool is_found_sand(const std::filesystem::path& path);
bool is_calibration_page(const std::filesystem::path& path);

struct FoundSand {
    std::string title, version, file;            // of the case
    std::vector<std::string> comments;           // about tests and misfit
    std::vector<std::vector<std::string>> rows;  // of parameters with their intervals, below a head
};

// Throws BadInput.
FoundSand found_sand_of(const std::filesystem::path& path);

}  // namespace cli
