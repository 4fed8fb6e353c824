// SPDX-License-Identifier: BSD-3-Clause
// The volumetric strain of a step as the mean of a cell, and the mean stress that is conjugate to it: with
// both, the nodal forces do the work that the stresses take.
#pragma once

#include "adapters/mpm/kernel/cell_share.hpp"
#include "adapters/mpm/space/kernel/increment.hpp"
#include "adapters/mpm/space/kernel/place.hpp"

GRIT_KERNEL_BEGIN_OF(mpm::space)

using mpm::GRIT_TARGET::cell_share;

GRIT_INLINE std::ptrdiff_t cell_of(const GridView& grid, const Place& place) {
    return grid.cell(place.cell[0], place.cell[1], place.cell[2]);
}

GRIT_INLINE void defer(const GatherCall& call, const Place& place, std::ptrdiff_t p,
                       const Gradient& L) {
    const ParticleView& q = call.particles;
    const bool alone = is_separated(q, p, call.separation);
    const std::ptrdiff_t cell = cell_of(call.grid, place);
    call.mean.deferred[p] = {L, alone ? -1 : cell};
    if (alone) return;
    const double V = q.volume(p) * call.mean.per_volume;
    call.mean.cells[cell].volume += cell_share(0.125 * V);
    call.mean.cells[cell].weighted += cell_share(0.125 * V * L.trace());
}

// Bulk viscosity included; tension positive [Pa].
GRIT_INLINE double mean_stress(const ParticleView& q, std::ptrdiff_t p) {
    return (q[column::S_xx][p] + q[column::S_yy][p] + q[column::S_zz][p]) * (1.0 / 3.0) -
           q[column::q][p];
}

double add_mean_stresses(const MeanStressCall& call) {
    const ParticleView& q = call.particles;
    double largest = 0.0;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        if (is_separated(q, p, call.separation)) continue;
        const double stress = mean_stress(q, p), size = std::fabs(stress);
        largest = size > largest ? size : largest;
        if (!call.mean.cells) continue;
        CellIntegers& cell = call.mean.cells[call.grid.cell_of(q.position(p))];
        const double V = q.volume(p) * call.mean.per_volume;
        cell.volume += cell_share(0.125 * V);
        cell.weighted += cell_share(0.125 * V * (stress * call.mean.per_stress));
    }
    return largest;
}

// What the mean stress of a particle lacks to that of its cell [Pa].
GRIT_INLINE double to_mean_stress(const ScatterCall& call, const Place& place, std::ptrdiff_t p) {
    const CellIntegers& cell = call.mean.cells[cell_of(call.grid, place)];
    if (cell.volume <= 0 || is_separated(call.particles, p, call.separation)) return 0.0;
    return cell.mean() / call.mean.per_stress - mean_stress(call.particles, p);
}

// Each particle with the mean of its cell: its volumetric strain is replaced.
void deform_by_mean(const DeformCall& call, Increments& increments) {
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        Gradient L = call.deferred[p].L;
        const std::ptrdiff_t cell = call.deferred[p].cell;
        if (cell >= 0 && call.cells[cell].volume > 0) {
            const double change = (1.0 / 3.0) * (call.cells[cell].mean() - L.trace());
            for (int k = 0; k < 3; ++k) L.of[k][k] += change;
        }
        deform(call.particles, p, L, call.separation, increments, p - call.begin);
    }
}

GRIT_KERNEL_END
