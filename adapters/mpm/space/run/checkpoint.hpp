// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation in space between two steps, for one that is built from the same case; see io/checkpoint.hpp.
#pragma once

#include <iosfwd>

#include "adapters/mpm/io/checkpoint.hpp"
#include "adapters/mpm/space/step/simulation.hpp"

namespace grit::mpm::space {

void save(const Simulation& simulation, std::ostream& out);
void restore(Simulation& simulation, std::istream& in, OtherBits bits = OtherBits::refused);

}  // namespace grit::mpm::space
