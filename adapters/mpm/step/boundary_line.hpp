// SPDX-License-Identifier: BSD-3-Clause
// A polyline along a body's boundary, with the body on the left of the direction of travel.
#pragma once

#include <utility>
#include <vector>

#include "support/vector.hpp"

namespace grit::mpm {

struct BoundaryLine {
    std::vector<Vector2> points;  // (r, z) [m]
    bool closed = false;
};

// Closed if its last point is its first.
inline BoundaryLine line_through(std::vector<Vector2> points) {
    const auto is_same = [](const Vector2& x, const Vector2& y) {
        return x[0] == y[0] && x[1] == y[1];
    };
    const bool closed = points.size() > 2 && is_same(points.front(), points.back());
    if (closed) points.pop_back();
    return {std::move(points), closed};
}

}  // namespace grit::mpm
