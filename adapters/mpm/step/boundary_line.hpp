// SPDX-License-Identifier: BSD-3-Clause
// A polyline along a body's boundary, with the body on the left of the direction of travel.
#pragma once

#include <vector>

#include "support/vector.hpp"

namespace grit::mpm {

struct BoundaryLine {
    std::vector<Vector2> points;  // (r, z) [m]
    bool closed = false;
};

}  // namespace grit::mpm
