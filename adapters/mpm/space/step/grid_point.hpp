// SPDX-License-Identifier: BSD-3-Clause
// A point on the grid: the nodes of its cell and their linear weights.
#pragma once

#include "adapters/mpm/space/kernel/call.hpp"

namespace grit::mpm::space {

struct GridPoint {
    std::ptrdiff_t node[8];
    double N[8];
};

inline GridPoint grid_point(const GridView& grid, const Vector3& at) {
    std::ptrdiff_t first = 0;
    double upper[3];
    for (int k = 0; k < 3; ++k) {
        const AxisView& axis = grid.axis[k];
        const int cell = axis.cell_of(at[k]);
        upper[k] = (at[k] - axis.node[cell]) * axis.inverse[cell];
        first += cell * grid.step(k);
    }
    GridPoint out;
    for (int n = 0; n < 8; ++n) {
        out.node[n] = first;
        out.N[n] = 1.0;
        for (int k = 0; k < 3; ++k) {
            const bool behind = n >> k & 1;
            if (behind) out.node[n] += grid.step(k);
            out.N[n] *= behind ? upper[k] : 1.0 - upper[k];
        }
    }
    return out;
}

}  // namespace grit::mpm::space
