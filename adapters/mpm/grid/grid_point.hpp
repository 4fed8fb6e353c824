// SPDX-License-Identifier: BSD-3-Clause
// A point on the grid: the nodes of its cell and their linear weights.
#pragma once

#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

struct GridPoint {
    std::ptrdiff_t node[4];
    double N[4];
};

inline GridPoint grid_point(const GridView& grid, double r, double z) {
    const int i = grid.r.cell_of(r), j = grid.z.cell_of(z);
    const double x = (r - grid.r.node[i]) * grid.r.inverse[i];
    const double y = (z - grid.z.node[j]) * grid.z.inverse[j];
    const std::ptrdiff_t n_r = grid.nodes_r(), first = j * n_r + i;
    return {{first, first + 1, first + n_r, first + n_r + 1},
            {(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y}};
}

}  // namespace grit::mpm
