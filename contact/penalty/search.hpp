// SPDX-License-Identifier: BSD-3-Clause
// Who is inside whom, (S1): the nearest point of the master's line for every vertex of the slave.
#pragma once

#include "contact/penalty/surface.hpp"

namespace grit::penalty {

// Boxes around runs of segments, from the leaves to the root.
void build_tree(Line& line);

// Fill slave.hit from master's tree. Returns the number of boxes and segments looked at.
std::ptrdiff_t search(Line& slave, const Line& master, double depth_max);

}  // namespace grit::penalty
