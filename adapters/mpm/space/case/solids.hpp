// SPDX-License-Identifier: BSD-3-Clause
// Shapes in space filled with particles.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "adapters/mpm/case/space_plan.hpp"
#include "adapters/mpm/space/kernel/particles.hpp"

namespace grit::mpm::space {

using Axes = std::array<Axis, 3>;

// Bricks in cells that are cut where a shape begins or ends along x, y and z, so that a box is filled exactly. Where
// shapes overlap, the first one has it. In the part of a cell that a shape fills along a direction, there are as many
// particles as its share of the cell asks for, one at least. A brick that the surface of a shape goes through becomes the
// one of the part within: of its volume, about its centre of mass, its sides in the ratio of that part's radii of gyration.
// body: of the plan's. Throws std::invalid_argument if nothing is inside, or a shape reaches out of the grid.
Particles fill(const SpacePlan& plan, std::size_t body, const std::string& name, double density,
               const Axes& axes, int own_columns);

// A face of a particle that has nothing of the body beyond, or not everywhere.
struct OuterFace {
    int particle;  // id
    double
        share;  // of its area; where the shape goes through, of what the shape shows along the direction
};
// Of particles of a body of the plan, as fill has made them, with their centre in the range. The areas are those that the shapes
// show along the direction, whatever cells they are cut by. Throws std::invalid_argument if there is none.
std::vector<OuterFace> outermost(const SpacePlan& plan, std::size_t body, const Axes& axes,
                                 const FacePlan& face, const std::string& name);

// Whether a shape of a body comes as near to a place along x, y or z, from above or from below.
bool comes_to(const SolidPlan& body, int along, double place, bool from_above, double distance);

// Throw std::invalid_argument where boxes of two bodies overlap by more than roundoff, or the centre of a particle of one
// lies in a particle of the other. names: of both.
void check_boxes_apart(const SolidPlan& one, const SolidPlan& other, const std::string& names);
void check_apart(Particles& one, Particles& other, const Axes& axes, const std::string& names);

}  // namespace grit::mpm::space
