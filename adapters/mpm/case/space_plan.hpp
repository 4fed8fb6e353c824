// SPDX-License-Identifier: BSD-3-Clause
// What a case in space has in the place of what lies in the plane.
#pragma once

#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "adapters/mpm/case/closed_surface.hpp"
#include "adapters/mpm/grid/graded_axis.hpp"
#include "support/vector.hpp"

namespace grit::mpm {

enum class Boundary {
    free,       // nothing: particles that reach it are lost
    roller,     // no velocity across
    fixed,      // none at all
    absorbing,  // dashpots, besides what holds the bodies at the start
    platen      // bodies move as one across
};

struct BoxShape {
    Vector3 from, to;  // [m]
};
// Around an upright axis; of equal radii it is a cylinder.
struct ConeShape {
    Vector2 centre;          // x, y [m]
    double z[2], radius[2];  // from, to [m]
};
struct SphereShape {
    Vector3 centre;
    double radius;  // [m]
};
// Within any closed surface, which need not be convex.
struct SurfaceShape {
    std::shared_ptr<const ClosedSurface> surface;
};
using Shape3 = std::variant<BoxShape, ConeShape, SphereShape, SurfaceShape>;

struct SolidShape {
    Shape3 of;
    int particles[3] = {2, 2, 2};  // per cell along x, y and z
};

// Of a body: it has what lies in any of its shapes, and in none of those of the bodies that it is outside of.
struct SolidPlan {
    std::vector<SolidShape> shapes = {};
    std::vector<std::size_t> outside_of = {};  // bodies
    Vector3 velocity{0.0, 0.0, 0.0};           // at the start [m/s]
};

// Of a traction: the outermost faces of particles, across a direction on its upper or its lower side, whose centres are
// in this range.
struct FacePlan {
    int across = 2;
    bool upper = true;
    double range[3][2] = {
        {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
        {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
        {-std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::infinity()}};  // [m]
    Vector3 direction{0.0, 0.0, -1.0};               // unit
};

struct SpacePlan {
    AxisPlan axis[3];
    Boundary boundary[6] = {};      // left, right, front, back, bottom, top
    std::vector<SolidPlan> bodies;  // beside those of the case
    std::vector<FacePlan> faces;    // ... and its tractions
};

}  // namespace grit::mpm
