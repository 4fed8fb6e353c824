// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

struct Curve {
    std::filesystem::path csv;        // as written by element::write_csv
    std::filesystem::path reference;  // reference curve, empty: none
    std::string label;
    double axial_strain;  // at the end, to space the reference points [-]
};

// Draw q and void ratio over axial strain with gnuplot: stem.svg and stem.png, written aside and
// renamed. Returns what went wrong, empty if nothing.
std::string plot(const std::filesystem::path& stem, const std::string& title,
                 const std::vector<Curve>& curves);

}  // namespace cli
