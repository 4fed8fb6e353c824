// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "adapters/lammps/fix_case.hpp"
#include "adapters/lammps/words.hpp"

namespace grit::lammps {

// NAME type N|group G and rigid, elastic E NU, neo_hooke E NU or sand NAME|custom (PARAMETER VALUE)...
void read_body(Words& words, FixCase& out);
// NAME FUNCTION FUNCTION, velocities of a rigid body along r and z, and perhaps from STAGE.
void read_motion(Words& words, FixCase& out);
// NAME undrained|flow and words of the water.
void read_water(Words& words, FixCase& out);
// NAME FILE
void read_points(Words& words, FixCase& out);

}  // namespace grit::lammps
