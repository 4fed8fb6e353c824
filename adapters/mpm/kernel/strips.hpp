// SPDX-License-Identifier: BSD-3-Clause
// Fixed strips of grid rows: particles of even strips never touch the same node, nor those of odd strips,
// so that threads can scatter one kind after the other with a result that does not depend on them.
#pragma once

#include <vector>

#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

class Strips {
  public:
    // A particle in row j touches nodes of rows j - 1 ... j + 2. Eight rows leave room for
    // particles that have moved on by a row, or two, since they were sorted.
    static constexpr int rows = 8;

    explicit Strips(const GridView& grid);
    int count() const { return strips; }
    // Sort by cell. Allocates on its first call for so many particles only.
    void sort(const GridView& grid, Particles& particles);
    // First particle of a strip; that of strip count() is the number of particles.
    std::ptrdiff_t begin(int strip) const { return start[static_cast<std::size_t>(strip)]; }
    template <class Self, class Archive> static void visit(Self& strips, Archive& archive) {
        archive.starts(strips.start);
    }

  private:
    int strips;
    std::vector<std::ptrdiff_t> start;
    std::vector<int> cell, order, place;
};

}  // namespace grit::mpm
