// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/kernel/pencils.hpp"

#include <algorithm>

namespace grit::mpm::space {

Pencils::Pencils(const GridView& grid)
    : along{(grid.axis[1].cells + rows - 1) / rows, (grid.axis[2].cells + rows - 1) / rows},
      start(static_cast<std::size_t>(count()) + 1) {}

// Cells are numbered pencil by pencil, as if each were complete.
void Pencils::sort(const GridView& grid, Particles& particles) {
    const auto n = static_cast<std::size_t>(particles.size());
    const ParticleView q = particles.view();
    const std::ptrdiff_t cells_x = grid.axis[0].cells, each = cells_x * rows * rows;
    cell.resize(n);
    order.resize(n);
    place.assign(static_cast<std::size_t>(each * count()) + 1, 0);
    for (std::size_t p = 0; p < n; ++p) {
        const Vector3 at = q.position(static_cast<std::ptrdiff_t>(p));
        const int j = grid.axis[1].cell_of(at[1]), k = grid.axis[2].cell_of(at[2]);
        const std::ptrdiff_t pencil = k / rows * along[0] + j / rows;
        const std::ptrdiff_t row = k % rows * rows + j % rows;
        cell[p] = pencil * each + row * cells_x + grid.axis[0].cell_of(at[0]);
        ++place[static_cast<std::size_t>(cell[p]) + 1];
    }
    for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
    for (std::size_t s = 0; s < start.size(); ++s)
        start[s] = place[s * static_cast<std::size_t>(each)];
    for (std::size_t p = 0; p < n; ++p)
        order[static_cast<std::size_t>(place[static_cast<std::size_t>(cell[p])]++)] =
            static_cast<int>(p);
    if (!std::is_sorted(order.begin(), order.end())) particles.permute(order);
}

}  // namespace grit::mpm::space
