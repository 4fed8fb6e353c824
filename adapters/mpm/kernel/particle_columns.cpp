// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/particle_columns.hpp"

#include <algorithm>

namespace grit::mpm {

void ParticleColumns::grow() {
    // An odd number of cache lines: columns do not fall on each other's place in the cache.
    const std::ptrdiff_t wider = (std::max<std::ptrdiff_t>(2 * count, 64) / 16) * 16 + 8;
    std::vector<double> moved(static_cast<std::size_t>(columns * wider));
    for (int c = 0; c < columns; ++c)
        std::copy_n(data.begin() + c * stride, count, moved.begin() + c * wider);
    data.swap(moved);
    stride = wider;
}

std::ptrdiff_t ParticleColumns::append() {
    if (count == stride) grow();
    id.push_back(static_cast<int>(count));
    return count++;
}

void ParticleColumns::add(int of_id, const double* row) {
    if (count == stride) grow();
    for (int c = 0; c < columns; ++c) data[static_cast<std::size_t>(c * stride + count)] = row[c];
    id.push_back(of_id);
    ++count;
}

void ParticleColumns::remove(std::ptrdiff_t p) {
    --count;
    for (int c = 0; c < columns; ++c) {
        double* of_column = data.data() + c * stride;
        of_column[p] = of_column[count];
    }
    id[static_cast<std::size_t>(p)] = id.back();
    id.pop_back();
}

// Column by column: a second place for all of them would be half of what a particle takes.
void ParticleColumns::permute(const std::vector<int>& order) {
    spare.resize(static_cast<std::size_t>(count));
    spare_id.resize(id.size());
    for (int c = 0; c < columns; ++c) {
        double* of_column = data.data() + c * stride;
        for (std::size_t p = 0; p < spare.size(); ++p) spare[p] = of_column[order[p]];
        std::copy(spare.begin(), spare.end(), of_column);
    }
    for (std::size_t p = 0; p < id.size(); ++p)
        spare_id[p] = id[static_cast<std::size_t>(order[p])];
    id.swap(spare_id);
}

}  // namespace grit::mpm
