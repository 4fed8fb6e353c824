// SPDX-License-Identifier: BSD-3-Clause
// Which vertices of a line stay, and how many parts each remaining segment becomes.
#pragma once

#include "contact/penalty/surface.hpp"

namespace grit::penalty {

struct Limits {
    double longest, shortest, tolerance;  // [length]
};

// Fill kept[0 ... n-1] with the old vertices that stay, in order; returns how many.
std::ptrdiff_t merge_short(const Geometry& line, const Limits& limits, std::ptrdiff_t* kept);

// Equal parts that a segment of this length is cut into.
double parts_of(double length, double longest);

}  // namespace grit::penalty
