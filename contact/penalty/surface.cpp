// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penalty/surface.hpp"

#include "support/require.hpp"

namespace grit::penalty {
namespace {

std::ptrdiff_t leaves_of(std::ptrdiff_t vertices) {
    std::ptrdiff_t leaves = 1;
    while (leaves * segments_per_leaf < vertices) leaves *= 2;
    return leaves;
}

template <class T> T* take(char*& memory, std::ptrdiff_t count) {
    T* taken = reinterpret_cast<T*>(memory);
    memory += static_cast<std::size_t>(count) * sizeof(T);
    return taken;
}

constexpr double roundoff = 1e-12;       // of the largest coordinate: no segment is shorter
constexpr double axis_tolerance = 1e-9;  // of the largest coordinate: r < 0 by roundoff

}  // namespace

std::size_t line_size(std::ptrdiff_t vertices) {
    const auto n = static_cast<std::size_t>(vertices);
    return n * (sizeof(Vector2) + sizeof(Segment) + sizeof(Hit)) +
           2 * static_cast<std::size_t>(leaves_of(vertices)) * sizeof(Box);
}

Line place_line(char*& memory, std::ptrdiff_t vertices, bool closed) {
    Line line;
    line.vertices = vertices;
    line.segments = closed ? vertices : vertices - 1;
    line.closed = closed;
    line.leaves = leaves_of(vertices);
    line.x = take<Vector2>(memory, vertices);
    line.segment = take<Segment>(memory, vertices);
    line.hit = take<Hit>(memory, vertices);
    line.box = take<Box>(memory, 2 * line.leaves);
    return line;
}

grit_status check_vertices(const Geometry& g, const char* name, grit_error* error) {
    const auto bad = [&](std::ptrdiff_t i, const char* format, auto... values) {
        return failure(error, GRIT_BAD_STATE, i, format, name, i, values...);
    };
    double largest = 0.0;
    for (std::ptrdiff_t i = 0; i < g.count; ++i)
        for (int c = 0; c < 2; ++c) {
            const double x = component(g.position, i, c);
            if (!(std::fabs(x) <= largest_length))
                return bad(i, "%s vertex %td: position %s must be within +-1e30 (length), got %g",
                           g.axisymmetric ? (c ? "z" : "r") : (c ? "y" : "x"), x);
            largest = std::max(largest, std::fabs(x));
        }
    for (std::ptrdiff_t i = 0; i < g.count; ++i) {
        const Vector2 x = vector_of(g.position, i);
        if (g.axisymmetric && !(x[0] >= -axis_tolerance * largest))
            return bad(i, "%s vertex %td: position r must be >= 0 (length), got %g", x[0]);
        const std::ptrdiff_t end = i + 1 < g.count ? i + 1 : 0;
        if (end == 0 && !g.closed) break;
        const double length = norm(vector_of(g.position, end) - x);
        if (!(length > roundoff * largest))
            return bad(i,
                       "%s vertex %td: the segment to vertex %td must be longer than %g (length), "
                       "got %g: merge them",
                       end, roundoff * largest, length);
    }
    return GRIT_OK;
}

grit_status read_line(const Geometry& g, const char* name, Line& line, grit_error* error) {
    if (const grit_status s = check_vertices(g, name, error)) return s;
    for (std::ptrdiff_t i = 0; i < g.count; ++i) line.x[i] = vector_of(g.position, i);
    for (std::ptrdiff_t j = 0; j < line.segments; ++j) {
        const Vector2 e = line.x[line.end_of(j)] - line.x[j];
        const double length = norm(e);
        line.segment[j] = {length, outward((1.0 / length) * e)};
    }
    return GRIT_OK;
}

}  // namespace grit::penalty
