// SPDX-License-Identifier: BSD-3-Clause
// Pictures of material points: fields as they lie in space.
#pragma once

#include <filesystem>
#include <string>

#include "cli/mpm/fields.hpp"
#include "cli/plot/gnuplot.hpp"

namespace cli {

// A part of the plane [m].
struct Window {
    double r0, r1, z0, z1;
};

struct FieldPicture {
    MpmField field;
    std::string title;
    Window window;  // of nothing (r1 <= r0): all particles
    bool mirrored = false;
    const char* across = "r";      // the horizontal coordinate
    double low = 0.0, high = 0.0;  // of the colours; low >= high: see colour_range.hpp
    int height = 700;              // [px]
    // As SVG every domain is a polygon: megabytes.
    PictureFiles files{.svg = false, .png = true, .pdf = false};
};

// stem.png and what else files say, written beside and renamed: domains of particles, coloured by the field;
// bodies without it are grey. Of a vector its length. Returns what went wrong, empty if nothing.
std::string draw_field(const std::filesystem::path& stem, const FieldPicture& picture,
                       const MpmFields& fields);

}  // namespace cli
