// SPDX-License-Identifier: BSD-3-Clause
// Where the particle with an id is: a search, for a process may have few of very many ids; where it has all from 0 on,
// they are places in a table.
#pragma once

#include <algorithm>
#include <numeric>

#include "adapters/mpm/kernel/particle_columns.hpp"

namespace grit::mpm {

class IdIndex {
  public:
    // Allocates where there are more particles than before.
    void find_all(const ParticleColumns& particles) {
        const int* ids = particles.ids();
        const auto count = static_cast<std::size_t>(particles.size());
        places.assign(count, -1);
        is_table = true;
        for (std::size_t p = 0; p < count && is_table; ++p) {
            is_table = ids[p] >= 0 && static_cast<std::size_t>(ids[p]) < count;
            if (is_table) places[static_cast<std::size_t>(ids[p])] = static_cast<std::ptrdiff_t>(p);
        }
        if (is_table) return;
        std::iota(places.begin(), places.end(), 0);
        std::sort(places.begin(), places.end(),
                  [ids](std::ptrdiff_t a, std::ptrdiff_t b) { return ids[a] < ids[b]; });
    }
    // -1: another process has it.
    std::ptrdiff_t find(const ParticleColumns& particles, int id) const {
        const int* ids = particles.ids();
        if (is_table) {
            const bool is_here = id >= 0 && static_cast<std::size_t>(id) < places.size();
            return is_here ? places[static_cast<std::size_t>(id)] : -1;
        }
        const auto at =
            std::lower_bound(places.begin(), places.end(), id,
                             [ids](std::ptrdiff_t p, int wanted) { return ids[p] < wanted; });
        return at != places.end() && ids[*at] == id ? *at : -1;
    }

  private:
    std::vector<std::ptrdiff_t> places;
    bool is_table = true;
};

}  // namespace grit::mpm
