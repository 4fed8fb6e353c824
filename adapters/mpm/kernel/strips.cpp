// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/strips.hpp"

#include <algorithm>

namespace grit::mpm {

Strips::Strips(const GridView& grid)
    : strips((grid.z.cells + rows - 1) / rows), start(static_cast<std::size_t>(strips) + 1),
      place(static_cast<std::size_t>(grid.r.cells) * static_cast<std::size_t>(grid.z.cells) + 1) {}

void Strips::sort(const GridView& grid, Particles& particles) {
    const auto n = static_cast<std::size_t>(particles.size());
    const ParticleView q = particles.view();
    cell.resize(n);
    order.resize(n);
    std::fill(place.begin(), place.end(), 0);
    for (std::size_t p = 0; p < n; ++p) {
        const auto i = static_cast<std::ptrdiff_t>(p);
        cell[p] = grid.z.cell_of(q[column::z][i]) * grid.r.cells + grid.r.cell_of(q[column::r][i]);
        ++place[static_cast<std::size_t>(cell[p]) + 1];
    }
    for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
    for (int s = 0; s <= strips; ++s) {
        const int row = std::min(s * rows, grid.z.cells);
        start[static_cast<std::size_t>(s)] =
            place[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.r.cells)];
    }
    for (std::size_t p = 0; p < n; ++p)
        order[static_cast<std::size_t>(place[static_cast<std::size_t>(cell[p])]++)] =
            static_cast<int>(p);
    if (!std::is_sorted(order.begin(), order.end())) particles.permute(order);
}

}  // namespace grit::mpm
