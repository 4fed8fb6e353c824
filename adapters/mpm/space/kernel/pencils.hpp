// SPDX-License-Identifier: BSD-3-Clause
// Fixed pencils of grid rows along x, a few rows wide along y and along z, in four colours: particles of pencils of one
// colour never touch the same node, so that threads can scatter one colour after the other with a result that does not
// depend on them.
#pragma once

#include <vector>

#include "adapters/mpm/space/kernel/call.hpp"

namespace grit::mpm::space {

class Pencils {
  public:
    // A particle in row j touches nodes of rows j - 1 ... j + 2. Six rows leave room for particles that have moved on
    // by a row since they were sorted.
    static constexpr int rows = 6;
    static constexpr int colours = 4;

    explicit Pencils(const GridView& grid);
    int count() const { return along[0] * along[1]; }
    int colour(int pencil) const { return pencil % along[0] % 2 + 2 * (pencil / along[0] % 2); }
    // Sort by cell within pencils. Allocates on its first call for so many particles only.
    void sort(const GridView& grid, Particles& particles);
    // First particle of a pencil; that of pencil count() is the number of particles.
    std::ptrdiff_t begin(int pencil) const { return start[static_cast<std::size_t>(pencil)]; }
    template <class Self, class Archive> static void visit(Self& pencils, Archive& archive) {
        archive.starts(pencils.start);
    }

  private:
    int along[2];  // pencils along y and z
    std::vector<std::ptrdiff_t> start, place;
    std::vector<std::ptrdiff_t> cell;
    std::vector<int> order;
};

}  // namespace grit::mpm::space
