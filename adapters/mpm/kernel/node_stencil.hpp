// SPDX-License-Identifier: BSD-3-Clause
// Shape functions that are products of one-dimensional ones: the generalised interpolation of Bardenhagen
// & Kober (2004) over the undeformed domain (uGIMP), and linear ones at the particle.
#pragma once

#include "adapters/mpm/kernel/stencil.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Mean of the hat functions and of their slope over [x - l, x + l], at nodes first ... first + 3.
struct LineWeights {
    int first;
    double S[4] = {}, G[4] = {};

    GRIT_INLINE LineWeights(const AxisView& axis, int cell, double x, double l) {
        first = cell > 0 ? cell - 1 : 0;
        const int last = cell + 1 < axis.cells ? cell + 1 : cell;
        for (int c = first; c <= last; ++c) {
            // The outermost cells go on beyond the grid.
            const double lower = x - l, upper = x + l;
            const double a = c > 0 && axis.node[c] > lower ? axis.node[c] : lower;
            const double b =
                c + 1 < axis.cells && axis.node[c + 1] < upper ? axis.node[c + 1] : upper;
            if (!(b > a)) continue;
            const double share = (b - a) / (2.0 * l);
            const double middle = (0.5 * (a + b) - axis.node[c]) * axis.inverse[c];
            S[c - first] += share * (1.0 - middle);
            S[c - first + 1] += share * middle;
            G[c - first] -= share * axis.inverse[c];
            G[c - first + 1] += share * axis.inverse[c];
        }
    }
    GRIT_INLINE LineWeights(const AxisView& axis, int cell, double x) : first(cell) {
        S[1] = (x - axis.node[cell]) * axis.inverse[cell];
        S[0] = 1.0 - S[1];
        G[1] = axis.inverse[cell];
        G[0] = -G[1];
    }
};

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

GRIT_KERNEL_END
