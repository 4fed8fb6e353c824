// SPDX-License-Identifier: BSD-3-Clause
// Where two bodies may touch: the nodes that both of them reach, and the cells around these.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

class NearCells {
  public:
    explicit NearCells(const GridView& grid)
        : is_near(static_cast<std::size_t>(grid.r.cells) * static_cast<std::size_t>(grid.z.cells)) {
    }

    void clear() {
        std::fill(is_near.begin(), is_near.end(), 0);
        r = z = {};
    }
    static bool is_shared(const NodeRecord& a, const NodeRecord& b) {
        return a[record::m] > 0.0 && b[record::m] > 0.0;
    }
    // The cells from which a domain may reach the node: it reaches into the neighbouring cells and to their nodes.
    void add(const GridView& grid, std::ptrdiff_t node) {
        const std::ptrdiff_t i = node % grid.nodes_r(), j = node / grid.nodes_r();
        const auto first_r = std::max<std::ptrdiff_t>(i - 2, 0);
        const auto last_r = std::min<std::ptrdiff_t>(i + 1, grid.r.cells - 1);
        const auto first_z = std::max<std::ptrdiff_t>(j - 2, 0);
        const auto last_z = std::min<std::ptrdiff_t>(j + 1, grid.z.cells - 1);
        for (auto row = first_z; row <= last_z; ++row)
            std::fill_n(is_near.begin() + row * grid.r.cells + first_r, last_r - first_r + 1, 1);
        r.include(first_r, last_r);
        z.include(first_z, last_z);
    }
    bool has(const GridView& grid, const ParticleView& particles, std::ptrdiff_t p) const {
        const std::ptrdiff_t cell =
            grid.z.cell_of(particles[column::z][p]) * std::ptrdiff_t{grid.r.cells} +
            grid.r.cell_of(particles[column::r][p]);
        return is_near[static_cast<std::size_t>(cell)];
    }

    // Nodes that a domain in one of these cells may reach, ascending.
    template <class Take> void each_reached(const GridView& grid, const Take& take) const {
        for (std::ptrdiff_t j = z.first - 1; j <= z.last + 2; ++j)
            for (std::ptrdiff_t i = r.first - 1; i <= r.last + 2; ++i)
                if (is_reached(grid, i, j)) take(j * grid.nodes_r() + i);
    }

  private:
    // Of near cells along a direction.
    struct Range {
        static constexpr std::ptrdiff_t far = std::numeric_limits<int>::max();
        std::ptrdiff_t first = far, last = -far;
        void include(std::ptrdiff_t from, std::ptrdiff_t to) {
            first = std::min(first, from);
            last = std::max(last, to);
        }
    };
    // One of its cells is near, or a neighbour of one. Not beyond the grid.
    bool is_reached(const GridView& grid, std::ptrdiff_t i, std::ptrdiff_t j) const {
        if (i < 0 || j < 0 || i > grid.r.cells || j > grid.z.cells) return false;
        for (auto row = std::max<std::ptrdiff_t>(j - 2, 0);
             row <= std::min<std::ptrdiff_t>(j + 1, grid.z.cells - 1); ++row) {
            const auto* cells = is_near.data() + row * grid.r.cells;
            const auto* first = cells + std::max<std::ptrdiff_t>(i - 2, 0);
            const auto* last = cells + std::min<std::ptrdiff_t>(i + 2, grid.r.cells);
            if (std::find(first, last, 1) != last) return true;
        }
        return false;
    }

    std::vector<char> is_near;
    Range r, z;
};

}  // namespace grit::mpm
