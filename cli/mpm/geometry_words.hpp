// SPDX-License-Identifier: BSD-3-Clause
// How results of a case are worded: a pile in sand has r, a tip and a shaft; a metre of a plane has x and forces per
// metre, and nobody says that what is driven there is a pile.
#pragma once

#include <string>

#include <adapters/mpm/case/case.hpp>

namespace cli {

struct GeometryWords {
    const char* across;               // the horizontal coordinate; z is up everywhere
    const char* whole;                // what forces and energies are of
    const char* per;                  // after their units
    const char *under, *side, *load;  // columns of forces on the driven body, before "_force"
    const char* sideways;             // how surfaces face that bear the side's
};

const GeometryWords& words_of(const grit::mpm::Case& plan);

// "stress_rr" as it is called in plane strain, "stress_xx".
std::string name_in_plane_strain(const std::string& field);

}  // namespace cli
