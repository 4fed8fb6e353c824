// SPDX-License-Identifier: BSD-3-Clause
// The volumetric strain of a step as the mean of a cell, and the mean stress that is conjugate to it: with
// both, the nodal forces do the work that the stresses take.
#pragma once

#include "adapters/mpm/kernel/cell_share.hpp"
#include "adapters/mpm/kernel/increment.hpp"
#include "adapters/mpm/kernel/place.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

GRIT_INLINE void defer(const GatherCall& call, const Place& place, std::ptrdiff_t p,
                       const Gradient& L) {
    const ParticleView& q = call.particles;
    const bool alone = is_separated(q, p, call.separation);
    const int cell = place.cell_z * call.grid.r.cells + place.cell_r;
    call.mean.deferred[p] = {L, alone ? -1 : cell};
    if (alone) return;
    const double V = q[column::V0][p] * q.J(p) * call.mean.per_volume;
    call.mean.cells[cell].volume += cell_share(0.125 * V);
    call.mean.cells[cell].weighted += cell_share(0.125 * V * L.trace());
}

// Of the directions that may strain, bulk viscosity included; tension positive [Pa].
template <bool axisymmetric>
GRIT_INLINE double mean_stress(const ParticleView& q, std::ptrdiff_t p) {
    namespace c = column;
    const double sum = q[c::S_rr][p] + q[c::S_zz][p];
    return (axisymmetric ? (sum + q[c::S_tt][p]) * (1.0 / 3.0) : 0.5 * sum) - q[c::q][p];
}

template <bool axisymmetric> double add_mean_stresses_in(const MeanStressCall& call) {
    const ParticleView& q = call.particles;
    double largest = 0.0;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        if (is_separated(q, p, call.separation)) continue;
        const double stress = mean_stress<axisymmetric>(q, p), size = std::fabs(stress);
        largest = size > largest ? size : largest;
        if (!call.mean.cells) continue;
        CellIntegers& cell = call.mean.cells[call.grid.cell_of(q[column::r][p], q[column::z][p])];
        const double V = q[column::V0][p] * q.J(p) * call.mean.per_volume;
        cell.volume += cell_share(0.125 * V);
        cell.weighted += cell_share(0.125 * V * (stress * call.mean.per_stress));
    }
    return largest;
}

double add_mean_stresses(bool axisymmetric, const MeanStressCall& call) {
    return axisymmetric ? add_mean_stresses_in<true>(call) : add_mean_stresses_in<false>(call);
}

// What the mean stress of a particle lacks to that of its cell [Pa].
template <bool axisymmetric>
GRIT_INLINE double to_mean_stress(const ScatterCall& call, const Place& place, std::ptrdiff_t p) {
    const CellIntegers& cell = call.mean.cells[place.cell_z * call.grid.r.cells + place.cell_r];
    if (cell.volume <= 0 || is_separated(call.particles, p, call.separation)) return 0.0;
    return cell.mean() / call.mean.per_stress - mean_stress<axisymmetric>(call.particles, p);
}

// Each particle with the mean of its cell: its volumetric strain is replaced, along all directions that
// may strain.
void deform_by_mean(bool axisymmetric, const DeformCall& call, Increments& increments) {
    const double share = axisymmetric ? 1.0 / 3.0 : 0.5;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        Gradient L = call.deferred[p].L;
        const int cell = call.deferred[p].cell;
        if (cell >= 0 && call.cells[cell].volume > 0) {
            const double change = share * (call.cells[cell].mean() - L.trace());
            L.rr += change;
            L.zz += change;
            if (axisymmetric) L.tt += change;
        }
        deform(call.particles, p, L, call.separation, call.reduces_domains, increments,
               p - call.begin);
    }
}

GRIT_KERNEL_END
