// SPDX-License-Identifier: BSD-3-Clause
// Where a particle meets the grid: points with the weights S, G, T of the particle there. A point of CPDI
// is a corner, shared out to the four nodes of its cell; a point of the others is a node.
#pragma once

#include "adapters/mpm/kernel/domain.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Four corners of CPDI, k = 1/(3 r_p) or 0.
template <bool axisymmetric, bool weighted> struct CornerStencil {
    static constexpr bool is_corner = true;
    static constexpr int points = 4;
    Vec4 S, G_r, G_z;
    Vec4 A_r, A_z;  // area times the unweighted gradient [m]
    double T;       // (A3) [1/m], of every corner
    std::ptrdiff_t corner_node[4], n_r;
    double xi_r[4], xi_z[4];

    GRIT_INLINE CornerStencil(const GridView& grid, const Place& q) {
        const Domain& d = q.domain;
        const double k = axisymmetric && weighted ? 1.0 / (3.0 * q.r) : 0.0;
        const CornerWeights w = corner_weights(d, k);
        S = w.S;
        G_r = w.G_r;
        G_z = w.G_z;
        A_r = xi() * d.r2z - eta() * d.r1z;
        A_z = eta() * d.r1r - xi() * d.r2r;
        T = axisymmetric ? 0.25 / q.r : 0.0;
        const Vec4 r = q.r + xi() * d.r1r + eta() * d.r2r;
        const Vec4 z = q.z + xi() * d.r1z + eta() * d.r2z;
        n_r = grid.nodes_r();
        for (int c = 0; c < 4; ++c) {
            const int i = neighbour(grid.r, q.cell_r, r[c]), j = neighbour(grid.z, q.cell_z, z[c]);
            xi_r[c] = (r[c] - grid.r.node[i]) * grid.r.inverse[i];
            xi_z[c] = (z[c] - grid.z.node[j]) * grid.z.inverse[j];
            corner_node[c] = j * n_r + i;
        }
    }
    GRIT_INLINE double hoop(int) const { return T; }
    // The cell of x in the cell given or next to it.
    static GRIT_INLINE int neighbour(const AxisView& axis, int cell, double x) {
        cell += (x >= axis.node[cell + 1] && cell + 1 < axis.cells) ? 1 : 0;
        cell -= (x < axis.node[cell] && cell > 0) ? 1 : 0;
        return cell;
    }
    template <class Sums> GRIT_INLINE void add(int c, const Vec8& P, Sums& sums) const {
        const std::ptrdiff_t n = corner_node[c];
        const double x = xi_r[c], y = xi_z[c], xy = x * y;
        sums.add(n, (1.0 - x - y + xy) * P);
        sums.add(n + 1, (x - xy) * P);
        sums.add(n + n_r, (y - xy) * P);
        sums.add(n + n_r + 1, xy * P);
    }
    template <class Patch>
    GRIT_INLINE void add_to_patch(int c, const Vec2& force, Patch& patch) const {
        const auto at = patch.at(corner_node[c]);
        const double x = xi_r[c], y = xi_z[c], xy = x * y;
        patch.add(at, (1.0 - x - y + xy) * force);
        patch.add({at.row, at.column + 1}, (x - xy) * force);
        patch.add({at.row + 1, at.column}, (y - xy) * force);
        patch.add({at.row + 1, at.column + 1}, xy * force);
    }
    GRIT_INLINE Vec4 value(int c, const NodeMotion* nodes) const {
        const Vec4* n = reinterpret_cast<const Vec4*>(nodes + corner_node[c]);
        const double x = xi_r[c], y = xi_z[c], xy = x * y;
        return (1.0 - x - y + xy) * n[0] + (x - xy) * n[1] + (y - xy) * n[n_r] + xy * n[n_r + 1];
    }
};

GRIT_KERNEL_END
