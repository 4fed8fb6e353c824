// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/particles.hpp"

#include <algorithm>
#include <stdexcept>

namespace grit::mpm {

void Particles::grow() {
    // An odd number of cache lines: columns do not fall on each other's place in the cache.
    const std::ptrdiff_t wider = (std::max<std::ptrdiff_t>(2 * count, 64) / 16) * 16 + 8;
    std::vector<double> moved(static_cast<std::size_t>(columns * wider));
    for (int c = 0; c < columns; ++c)
        std::copy_n(data.begin() + c * stride, count, moved.begin() + c * wider);
    data.swap(moved);
    stride = wider;
}

void Particles::add(const NewParticle& q, bool axisymmetric) {
    if (!(q.l_r > 0.0 && q.l_z > 0.0 && q.density > 0.0))
        throw std::invalid_argument("half sides and density of a particle must be positive");
    if (axisymmetric && !(q.r >= q.l_r * (1.0 - 1e-12)))
        throw std::invalid_argument("a particle must not reach across the axis");
    if (count == stride) grow();
    const ParticleView v = view();
    const std::ptrdiff_t p = count++;
    id.push_back(static_cast<int>(p));
    v[column::r][p] = q.r;
    v[column::z][p] = q.z;
    v[column::v_r][p] = q.v_r;
    v[column::v_z][p] = q.v_z;
    v[column::F_rr][p] = v[column::F_zz][p] = v[column::F_tt][p] = 1.0;
    v[column::l_r][p] = q.l_r;
    v[column::l_z][p] = q.l_z;
    v[column::V0][p] = 4.0 * q.l_r * q.l_z * (axisymmetric ? q.r : 1.0);
    v[column::mass][p] = q.density * v[column::V0][p];
}

void Particles::add(int of_id, const double* row) {
    if (count == stride) grow();
    for (int c = 0; c < columns; ++c) data[static_cast<std::size_t>(c * stride + count)] = row[c];
    id.push_back(of_id);
    ++count;
}

void Particles::remove(std::ptrdiff_t p) {
    --count;
    for (int c = 0; c < columns; ++c) {
        double* of_column = data.data() + c * stride;
        of_column[p] = of_column[count];
    }
    id[static_cast<std::size_t>(p)] = id.back();
    id.pop_back();
}

// Column by column: a second place for all of them would be half of what a particle takes.
void Particles::permute(const std::vector<int>& order) {
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
