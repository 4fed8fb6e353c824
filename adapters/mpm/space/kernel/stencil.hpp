// SPDX-License-Identifier: BSD-3-Clause
// Where a particle meets the grid in space: points with the weights S, G of the particle there. A point of CPDI is a
// corner, shared out to the eight nodes of its cell; a point of the others is a node.
#pragma once

#include "adapters/mpm/kernel/line_weights.hpp"
#include "adapters/mpm/kernel/record_lanes.hpp"
#include "adapters/mpm/space/kernel/place.hpp"

GRIT_KERNEL_BEGIN_OF(mpm::space)

using Vec4 = mpm::GRIT_TARGET::Vec4;
using Vec8 = mpm::GRIT_TARGET::Vec8;
using Bits = grit::GRIT_TARGET::VectorTypes<4>::Bits;

// Of the lower four corners and of the upper ones, whose zeta is -1 and 1.
GRIT_INLINE Vec4 xi() { return Vec4{-1, 1, -1, 1}; }
GRIT_INLINE Vec4 eta() { return Vec4{-1, -1, 1, 1}; }

// Eight corners, (A7): a lane each, in two vectors of four, which compilers choose lanes of without taking them apart.
struct CornerStencil {
    static constexpr int points = 8;
    static constexpr double S(int) { return 0.125; }
    alignas(64) double G[3][8];          // [1/m]
    alignas(64) double N[8][8];          // of node n of the corner's cell, at the corner
    alignas(64) std::int64_t corner[8];  // first node of its cell
    std::ptrdiff_t to[8];                // from there to the others

    GRIT_INLINE CornerStencil(const GridView& grid, const Place& q) {
        const Domain a = reciprocal(q.domain);
        for (int half = 0; half < 2; ++half) {
            const double zeta = half == 0 ? -1.0 : 1.0;
            Bits node{};
            Vec4 upper[3];  // local coordinates
            for (int k = 0; k < 3; ++k) {
                const Domain& r = q.domain;
                const Vec4 slope = xi() * a.r[0][k] + eta() * a.r[1][k] + zeta * a.r[2][k];
                store(&G[k][4 * half], 0.125 * slope);
                const Vec4 x = q.at[k] + (xi() * r.r[0][k] + eta() * r.r[1][k] + zeta * r.r[2][k]);
                upper[k] = local(grid.axis[k], q.cell[k], x, grid.step(k), node);
            }
            __builtin_memcpy(corner + 4 * half, &node, sizeof node);
            const Vec4 x0 = 1.0 - upper[0], y0 = 1.0 - upper[1], z0 = 1.0 - upper[2];
            const Vec4 xy[4] = {x0 * y0, upper[0] * y0, x0 * upper[1], upper[0] * upper[1]};
            for (int n = 0; n < 4; ++n) {
                store(&N[n][4 * half], xy[n] * z0);
                store(&N[n + 4][4 * half], xy[n] * upper[2]);
            }
        }
        for (int n = 0; n < 8; ++n)
            to[n] = (n & 1) + (n & 2 ? grid.step(1) : 0) + (n & 4 ? grid.step(2) : 0);
    }
    // Adds P to sums at nodes.
    template <class Vec, class Sums> GRIT_INLINE void add(int c, const Vec& P, Sums& sums) const {
        for (int n = 0; n < 8; ++n) sums.add(corner[c] + to[n], N[n][c] * P);
    }
    GRIT_INLINE Vec8 value(int c, const Vec8* nodes) const {
        const Vec8* first = nodes + corner[c];
        Vec8 sum = N[0][c] * first[0];
        for (int n = 1; n < 8; ++n) sum += N[n][c] * first[to[n]];
        return sum;
    }

  private:
    static GRIT_INLINE void store(double* to, const Vec4& x) { *reinterpret_cast<Vec4*>(to) = x; }
    // In the cell given or next to it; node grows by the steps to its first node.
    static GRIT_INLINE Vec4 local(const AxisView& axis, int cell, const Vec4& x,
                                  std::ptrdiff_t step, Bits& node) {
        const int before = cell > 0 ? cell - 1 : 0,
                  behind = cell + 1 < axis.cells ? cell + 1 : cell;
        const Vec4 none{}, end = none + axis.node[cell + 1], begin = none + axis.node[cell];
        const Bits is_behind = x >= end, is_before = x < begin;
        node += step * cell + (is_behind & (step * (behind - cell))) -
                (is_before & (step * (cell - before)));
        Vec4 first = is_before ? none + axis.node[before] : begin;
        Vec4 per = is_before ? none + axis.inverse[before] : none + axis.inverse[cell];
        first = is_behind ? none + axis.node[behind] : first;
        per = is_behind ? none + axis.inverse[behind] : per;
        return (x - first) * per;
    }
};

template <bool domain> struct NodeStencil {
    static constexpr int across = domain ? 4 : 2, points = across * across * across;
    double weight[points], G[3][points];
    std::ptrdiff_t at[points];
    GRIT_INLINE double S(int k) const { return weight[k]; }

    GRIT_INLINE NodeStencil(const GridView& grid, const Place& q) {
        using mpm::GRIT_TARGET::LineWeights;
        const auto line = [&](int d) {
            return domain ? LineWeights(grid.axis[d], q.cell[d], q.at[d], q.l[d])
                          : LineWeights(grid.axis[d], q.cell[d], q.at[d]);
        };
        const LineWeights x = line(0), y = line(1), z = line(2);
        // Weights that are nothing may lie outside of the grid.
        const auto node = [&](int d, int i) {
            return (i < grid.axis[d].cells ? i : grid.axis[d].cells) * grid.step(d);
        };
        for (int k = 0, n = 0; k < across; ++k)
            for (int j = 0; j < across; ++j)
                for (int i = 0; i < across; ++i, ++n) {
                    weight[n] = x.S[i] * y.S[j] * z.S[k];
                    G[0][n] = x.G[i] * y.S[j] * z.S[k];
                    G[1][n] = x.S[i] * y.G[j] * z.S[k];
                    G[2][n] = x.S[i] * y.S[j] * z.G[k];
                    at[n] = node(0, x.first + i) + node(1, y.first + j) + node(2, z.first + k);
                }
    }
    template <class Vec, class Sums> GRIT_INLINE void add(int k, const Vec& P, Sums& sums) const {
        sums.add(at[k], P);
    }
    GRIT_INLINE Vec8 value(int k, const Vec8* nodes) const { return nodes[at[k]]; }
};

template <Shape shape> struct StencilOf;
template <> struct StencilOf<Shape::cpdi> { using type = CornerStencil; };
template <> struct StencilOf<Shape::ugimp> { using type = NodeStencil<true>; };
template <> struct StencilOf<Shape::point> { using type = NodeStencil<false>; };

GRIT_KERNEL_END
