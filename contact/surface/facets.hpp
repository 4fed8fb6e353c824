// SPDX-License-Identifier: BSD-3-Clause
// A surface as facets: segments in the plane, triangles in space.
#pragma once

#include <grit/contact_surface.h>

#include "contact/surface/box_tree.hpp"
#include "support/views.hpp"

namespace grit::surface {

inline Vector2 cross(const Vector2& a) { return {a[1], -a[0]}; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <int C> struct Facet {
    Vector<double, C> x[C];          // its vertices
    Vector<double, C> n;             // outward unit normal
    double size;                     // length or area
    Vector<double, C> share[C - 1];  // gradients of the shares of all vertices but the first

    // Normal times size; twice that of a triangle.
    Vector<double, C> area_vector() const {
        if constexpr (C == 2) return cross(x[1] - x[0]);
        else return cross(x[1] - x[0], x[2] - x[0]);
    }
    double longest_edge() const {
        double longest = 0.0;
        for (int i = 0; i < C; ++i)
            for (int j = 0; j < i; ++j) longest = std::max(longest, norm(x[i] - x[j]));
        return longest;
    }
    Box<C> box() const {
        Box<C> box = Box<C>::empty();
        for (const auto& corner : x) box.include(corner);
        return box;
    }
};

// A surface of a call, ready to be met: what it is made of and how its vertices move.
template <int C> struct Skin {
    const grit_surface* given;
    Facet<C>* facet;
    Vector<double, C>* velocity;  // of the vertices, after the momentum update

    std::ptrdiff_t vertex(std::ptrdiff_t f, int corner) const {
        return given->facet[C * f + corner];
    }
    Vector<double, C> velocity_at(std::ptrdiff_t f, const double* place) const {
        Vector<double, C> v{};
        for (int i = 0; i < C; ++i) v = v + place[i] * velocity[vertex(f, i)];
        return v;
    }
};

template <int C> Vector<double, C> vector_of(const grit_view& view, std::ptrdiff_t i) {
    Vector<double, C> x;
    for (int c = 0; c < C; ++c) x[c] = component(view, i, c);
    return x;
}
inline grit_view read_only(const grit_mutable_view& v) {
    return {v.base, v.point_stride, v.component_stride};
}

// By the shape functions of a vertex, from velocities of the nodes.
template <int C>
Vector<double, C> at_vertex(const grit_surface& s, const grit_view& velocity, std::ptrdiff_t v) {
    if (s.rigid) return vector_of<C>(s.vertex_velocity, v);
    Vector<double, C> sum{};
    for (std::ptrdiff_t k = v * s.nodes_each; k < (v + 1) * s.nodes_each; ++k)
        if (s.weight[k] != 0.0) sum = sum + s.weight[k] * vector_of<C>(velocity, s.node[k]);
    return sum;
}

// What is thinner than this share of the spacing is nothing: its normal would be that of the last bits of its vertices,
// and it would press as any other facet does.
constexpr double least_height = 1e-6;

// spacing: of facets that are given none.
template <int C> Skin<C> read_skin(Arena& arena, const grit_surface& s, double spacing) {
    Skin<C> skin{&s, arena.take<Facet<C>>(s.facets), arena.take<Vector<double, C>>(s.vertices)};
    if (arena.is_overrun()) return skin;
    for (std::ptrdiff_t f = 0; f < s.facets; ++f) {
        Facet<C>& facet = skin.facet[f];
        for (int i = 0; i < C; ++i) facet.x[i] = vector_of<C>(s.position, s.facet[C * f + i]);
        const auto area = facet.area_vector();
        const double length = norm(area);
        facet.size = C == 2 ? length : 0.5 * length;
        const double thin = least_height * (s.spacing ? s.spacing[f] : spacing);
        if (!(length > (C == 2 ? thin : thin * facet.longest_edge()))) {  // nothing meets it
            facet.size = 0.0;
            facet.n = {};
            continue;
        }
        facet.n = area / length;
        const Vector<double, C> e = facet.x[1] - facet.x[0];
        if constexpr (C == 2) {
            facet.share[0] = e / (length * length);
        } else {
            facet.share[0] = cross(facet.x[2] - facet.x[0], area) / dot(area, area);
            facet.share[1] = cross(area, e) / dot(area, area);
        }
    }
    for (std::ptrdiff_t corner = 0; corner < C * s.facets; ++corner)
        skin.velocity[s.facet[corner]] = at_vertex<C>(s, read_only(s.velocity), s.facet[corner]);
    return skin;
}

}  // namespace grit::surface
