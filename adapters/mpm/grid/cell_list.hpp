// SPDX-License-Identifier: BSD-3-Clause
// Undeformed particles by the cell of their centre, for set-up. Particles are filled cell by cell: the
// one that covers a place has its centre in the place's cell.
#pragma once

#include <cmath>
#include <vector>

#include "adapters/mpm/kernel/axis.hpp"
#include "adapters/mpm/kernel/particles.hpp"

namespace grit::mpm {

class CellList {
  public:
    // The axes outlive this.
    CellList(Particles& particles, const Axis& r, const Axis& z)
        : q(particles.view()), along_r(r.view()), along_z(z.view()),
          cells(static_cast<std::size_t>(r.cells()) * static_cast<std::size_t>(z.cells())) {
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
            cells[cell_of(q[column::r][p], q[column::z][p])].push_back(p);
    }

    // A particle that covers this place, but none that is left out; -1: none.
    std::ptrdiff_t covering(double r, double z, std::ptrdiff_t left_out = -1) const {
        for (const std::ptrdiff_t p : cells[cell_of(r, z)])
            if (p != left_out && std::abs(q[column::r][p] - r) <= q[column::l_r][p] &&
                std::abs(q[column::z][p] - z) <= q[column::l_z][p])
                return p;
        return -1;
    }

  private:
    std::size_t cell_of(double r, double z) const {
        return static_cast<std::size_t>(along_z.cell_of(z)) *
                   static_cast<std::size_t>(along_r.cells) +
               static_cast<std::size_t>(along_r.cell_of(r));
    }

    ParticleView q;
    AxisView along_r, along_z;
    std::vector<std::vector<std::ptrdiff_t>> cells;
};

}  // namespace grit::mpm
