// SPDX-License-Identifier: BSD-3-Clause
// The boundary of a body as the penalty contact works with it: vertices copied next to each other,
// length and outward normal of every segment, what each vertex has hit. All in the caller's workspace.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <grit/contact_penalty.h>

#include "support/vector.hpp"
#include "support/views.hpp"

namespace grit::penalty {

// The body lies on the left of the direction of travel t.
inline Vector2 outward(Vector2 t) { return {t[1], -t[0]}; }
inline Vector2 travel(Vector2 n) { return {-n[1], n[0]}; }

struct Segment {
    double length;
    Vector2 n;  // outward unit normal
};

struct Box {
    Vector2 low, high;
};

// Where a vertex is inside the other body; gap 0: nowhere.
struct Hit {
    std::ptrdiff_t segment;
    double xi;   // along the segment
    double gap;  // g < 0
    Vector2 n;   // outward normal of the other body there
};

struct Line {
    std::ptrdiff_t vertices = 0, segments = 0;
    bool closed = false;
    Vector2* x = nullptr;
    Segment* segment = nullptr;
    Hit* hit = nullptr;
    Box* box = nullptr;         // [2 leaves] a binary tree, root 1
    std::ptrdiff_t leaves = 0;  // power of two

    // Segment j joins vertices j and after(j); segment j lies between segments before(j), after(j).
    // -1 beyond an end.
    std::ptrdiff_t end_of(std::ptrdiff_t j) const { return j + 1 < vertices ? j + 1 : 0; }
    std::ptrdiff_t after(std::ptrdiff_t j) const {
        return j + 1 < segments ? j + 1 : (closed ? 0 : -1);
    }
    std::ptrdiff_t before(std::ptrdiff_t j) const {
        return j > 0 ? j - 1 : (closed ? segments - 1 : -1);
    }
    // The segment that starts, that ends at a vertex.
    std::ptrdiff_t leaving(std::ptrdiff_t v) const { return v < segments ? v : -1; }
    std::ptrdiff_t arriving(std::ptrdiff_t v) const { return before(v); }
};

constexpr std::ptrdiff_t segments_per_leaf = 4;
constexpr std::ptrdiff_t largest_count = std::ptrdiff_t(1) << 40;

// Bytes of workspace for one line.
std::size_t line_size(std::ptrdiff_t vertices);

// Lay a line out in memory and advance the pointer.
Line place_line(char*& memory, std::ptrdiff_t vertices, bool closed);

inline Vector2 vector_of(const grit_view& view, std::ptrdiff_t i) {
    return {component(view, i, 0), component(view, i, 1)};
}

struct Geometry {
    std::ptrdiff_t count;
    bool closed, axisymmetric;
    grit_view position;
};

constexpr double largest_length = 1e30;

// Coordinates finite, r >= 0, no segment without length. name: whose they are, for the message.
grit_status check_vertices(const Geometry& geometry, const char* name, grit_error* error);

// Check and copy the vertices, find lengths and normals.
grit_status read_line(const Geometry& geometry, const char* name, Line& line, grit_error* error);

}  // namespace grit::penalty
