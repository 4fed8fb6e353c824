// SPDX-License-Identifier: BSD-3-Clause
// Where two bodies may touch: the nodes that both of them reach, and the cells around these.
#pragma once

#include <algorithm>
#include <vector>

#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

class NearCells {
  public:
    NearCells() = default;
    explicit NearCells(const GridView& grid)
        : is_near(static_cast<std::size_t>(grid.r.cells) * static_cast<std::size_t>(grid.z.cells)) {
    }

    void clear() { std::fill(is_near.begin(), is_near.end(), 0); }
    static bool is_shared(const NodeRecord& a, const NodeRecord& b) {
        return a[record::m] > 0.0 && b[record::m] > 0.0;
    }
    // The cells from which a domain may reach the node: it reaches into the neighbouring cells and to their nodes.
    void add(const GridView& grid, std::ptrdiff_t node) {
        const std::ptrdiff_t i = node % grid.nodes_r(), j = node / grid.nodes_r();
        const auto first_r = std::max<std::ptrdiff_t>(i - 2, 0);
        const auto last_r = std::min<std::ptrdiff_t>(i + 1, grid.r.cells - 1);
        for (auto z = std::max<std::ptrdiff_t>(j - 2, 0);
             z <= std::min<std::ptrdiff_t>(j + 1, grid.z.cells - 1); ++z)
            std::fill_n(is_near.begin() + z * grid.r.cells + first_r, last_r - first_r + 1, 1);
    }
    bool has(const GridView& grid, const ParticleView& particles, std::ptrdiff_t p) const {
        const std::ptrdiff_t cell =
            grid.z.cell_of(particles[column::z][p]) * std::ptrdiff_t{grid.r.cells} +
            grid.r.cell_of(particles[column::r][p]);
        return is_near[static_cast<std::size_t>(cell)];
    }

  private:
    std::vector<char> is_near;
};

}  // namespace grit::mpm
