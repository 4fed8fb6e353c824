// SPDX-License-Identifier: BSD-3-Clause
// Shape functions that are products of one-dimensional ones: the generalised interpolation of Bardenhagen
// & Kober (2004) over the undeformed domain (uGIMP), and linear ones at the particle.
#pragma once

#include "adapters/mpm/kernel/line_weights.hpp"
#include "adapters/mpm/kernel/stencil.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

template <bool axisymmetric, bool domain> struct NodeStencil {
    static constexpr bool is_corner = false;
    static constexpr int across = domain ? 4 : 2, points = across * across;
    double S[points], G_r[points], G_z[points];
    double A_r[points], A_z[points];  // divided by the area, see scatter.hpp
    double per_r;
    std::ptrdiff_t at[points];

    GRIT_INLINE NodeStencil(const GridView& grid, const Place& q) {
        const LineWeights r =
            domain ? LineWeights(grid.r, q.cell_r, q.r, q.l_r) : LineWeights(grid.r, q.cell_r, q.r);
        const LineWeights z =
            domain ? LineWeights(grid.z, q.cell_z, q.z, q.l_z) : LineWeights(grid.z, q.cell_z, q.z);
        per_r = axisymmetric ? 1.0 / q.r : 0.0;
        const std::ptrdiff_t n_r = grid.nodes_r();
        for (int j = 0, k = 0; j < across; ++j)
            for (int i = 0; i < across; ++i, ++k) {
                S[k] = r.S[i] * z.S[j];
                A_r[k] = G_r[k] = r.G[i] * z.S[j];
                A_z[k] = G_z[k] = r.S[i] * z.G[j];
                // Weights that are nothing may lie outside of the grid.
                const int node_i = r.first + i < grid.r.cells ? r.first + i : grid.r.cells;
                const int node_j = z.first + j < grid.z.cells ? z.first + j : grid.z.cells;
                at[k] = node_j * n_r + node_i;
            }
    }
    GRIT_INLINE double hoop(int k) const { return per_r * S[k]; }
    template <class Sums> GRIT_INLINE void add(int k, const Vec8& P, Sums& sums) const {
        sums.add(at[k], P);
    }
    template <class Patch>
    GRIT_INLINE void add_to_patch(int k, const Vec2& force, Patch& patch) const {
        if (force[0] == 0.0 && force[1] == 0.0)
            return;  // weights that are nothing may lie anywhere
        patch.add(patch.at(at[k]), force);
    }
    GRIT_INLINE Vec4 value(int k, const NodeMotion* nodes) const {
        return *reinterpret_cast<const Vec4*>(nodes + at[k]);
    }
};

template <Shape shape, bool axisymmetric> struct StencilOf;
template <bool a> struct StencilOf<Shape::cpdi, a> { using type = CornerStencil<a, true>; };
template <bool a> struct StencilOf<Shape::cpdi_published, a> {
    using type = CornerStencil<a, false>;
};
template <bool a> struct StencilOf<Shape::ugimp, a> { using type = NodeStencil<a, true>; };
template <bool a> struct StencilOf<Shape::point, a> { using type = NodeStencil<a, false>; };

// act.operator()<shape, axisymmetric>(), compiled for each of them.
template <bool axisymmetric, class Act> void with_shape(Shape shape, const Act& act) {
    switch (shape) {
        case Shape::cpdi: return act.template operator()<Shape::cpdi, axisymmetric>();
        case Shape::cpdi_published:
            return act.template operator()<Shape::cpdi_published, axisymmetric>();
        case Shape::ugimp: return act.template operator()<Shape::ugimp, axisymmetric>();
        case Shape::point: return act.template operator()<Shape::point, axisymmetric>();
    }
}
template <class Act> void with_shape(Shape shape, bool axisymmetric, const Act& act) {
    axisymmetric ? with_shape<true>(shape, act) : with_shape<false>(shape, act);
}

GRIT_KERNEL_END
