// SPDX-License-Identifier: BSD-3-Clause
// Outlines filled with particles.
#pragma once

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// Rectangular particles in cells that are cut where an outline begins or ends along r and along z, so
// that a box is filled exactly; they are in a polygon if their centre is. Where outlines overlap, the
// first one has it. Along a direction that a body fills for a part of a cell only, there are in that
// part as many particles as its share of the cell asks for, one at least. own_columns: of the material.
// Throws std::invalid_argument if nothing is inside.
Particles fill(const BodyPlan& body, const Axis& r, const Axis& z, bool axisymmetric,
               int own_columns);

// Particles, by id, one edge of which has no particle beyond, with their centre in the traction's range.
// Throws std::invalid_argument if there is none.
std::vector<int> outermost(Particles& particles, const Axis& r, const Axis& z,
                           const TractionPlan& traction);

// Throws std::invalid_argument where the centre of a particle of one lies in a particle of the other.
// names: of both.
void check_apart(Particles& one, Particles& other, const Axis& r, const Axis& z,
                 const std::string& names);
// Throws std::invalid_argument where boxes of two bodies share more than roundoff. Boxes alone are filled
// exactly; particles along an oblique side stand out of their polygon by up to a half, beside others.
void check_boxes_apart(const BodyPlan& one, const BodyPlan& other);

}  // namespace grit::mpm
