// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

constexpr std::size_t most_frames = 40;  // of one run that a page takes in, evenly chosen

struct Frames {
    std::string json;                    // for the player of a page; empty: no frame is whole
    std::vector<std::string> variables;  // that it shows, "p [kPa]"
};

// across: what the first axis of bodies in the plane is called, r or x.
// Frames of a list .pvd: places of all cells, in space of those that a plane across y cuts, and of every variable with one component its
// values, in 16 bits over its range.
Frames frames_of(const std::filesystem::path& list, const std::string& across);

}  // namespace cli
