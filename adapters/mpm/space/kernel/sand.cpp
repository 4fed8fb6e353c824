// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/kernel/sand.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <grit/sand_operators.h>

#include "adapters/mpm/kernel/material_failure.hpp"

namespace grit::mpm::space {
namespace c = column;
namespace {

// Stress and state of a range as the library sees them.
grit_sand_points points_of(const Range& range) {
    const ParticleView& q = range.particles;
    grit_sand_points points{};
    points.struct_size = sizeof points;
    points.components = 6;
    points.stress = grit_mutable_view_of(q[c::S_xx] + range.begin, 1, q.stride);
    points.state = grit_mutable_view_of(q[Sand::state] + range.begin, 1, q.stride);
    return points;
}

// The point that failed is as it was.
SandUpdate asked_of(const Range& range, const Increments& d, std::ptrdiff_t i) {
    const ParticleView& q = range.particles;
    const std::ptrdiff_t p = range.begin + i;
    SandUpdate out{};
    for (int k = 0; k < 6; ++k) {
        out.stress[k] = q[c::S_xx + k][p];
        out.strain[k] = d.strain[k][i];
    }
    for (int k = 0; k < GRIT_SAND_STATE_SIZE; ++k) out.state[k] = q[Sand::state + k][p];
    for (int k = 0; k < 9; ++k) out.rotation[k] = d.rotation[k][i];
    return out;
}

}  // namespace

void Sand::update(const Range& range, const Increments& d) {
    const ParticleView& q = range.particles;
    const std::ptrdiff_t n = range.end - range.begin;
    double before[6][Increments::capacity];
    for (int k = 0; k < 6; ++k) std::copy_n(q[c::S_xx + k] + range.begin, n, before[k]);

    grit_sand_points points = points_of(range);
    points.strain_increment = grit_view_of(d.strain[0], 1, Increments::capacity);
    points.rotation_increment = grit_view_of(d.rotation[0], 1, Increments::capacity);
    grit_error error;
    if (grit_sand_update(&sand, &options, n, &points, nullptr, &error) != GRIT_OK)
        throw_failure(error, range.begin, [&](std::ptrdiff_t i) { return asked_of(range, d, i); });

    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const std::ptrdiff_t p = range.begin + i;
        double density = 0.0;
        for (int k = 0; k < 6; ++k)
            density += 0.5 * (before[k][i] + q[c::S_xx + k][p]) * d.strain[k][i];
        q[work][p] += density * q.volume(p);
    }
}

void Sand::wave_moduli(const Range& range, double* moduli) const {
    grit_error error;
    const grit_sand_points points = points_of(range);
    if (grit_sand_wave_moduli(&sand, &options, range.end - range.begin, &points, moduli, &error) !=
        GRIT_OK)
        throw std::runtime_error(std::string("sand: ") + error.message);
}

}  // namespace grit::mpm::space
