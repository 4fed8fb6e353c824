// SPDX-License-Identifier: BSD-3-Clause
// How much of the contact a vertex answers for: A_v of (S2), shared between both views of a place.
#pragma once

#include "contact/penalty/surface.hpp"

namespace grit::penalty {

// Forget hits of vertices none of whose segments faces what they hit.
void keep_facing_hits(Line& slave);

// A_v. Both lines must have been searched.
double contact_area(const Line& slave, std::ptrdiff_t v, const Line& master, bool axisymmetric);

// The integral of r (axisymmetric) or 1 over the half of a segment of this length next to v.
double half_segment_area(double length, double r_v, double r_other, bool axisymmetric);

}  // namespace grit::penalty
