// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace cli {

constexpr std::size_t most_frames = 40;  // of one run that a page takes in, evenly chosen

// across: what the first axis of bodies in the plane is called, r or x.
// Frames of a list .pvd as JSON for the player of a page: places of all cells, in space of those that a plane across y cuts, and of every variable with one component its
// values, in 16 bits over its range. Empty where the list has no frame that is whole.
std::string frames_of(const std::filesystem::path& list, const std::string& across);

}  // namespace cli
