// SPDX-License-Identifier: BSD-3-Clause
// Pore water from nodes back to a particle, where its grains get theirs.
#pragma once

#include "adapters/mpm/kernel/cell_mean.hpp"
#include "adapters/mpm/kernel/node_stencil.hpp"
#include "adapters/mpm/kernel/pore_water.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Sums of v_r, v_z, other_r, other_z over the points of a particle.
struct Gathered {
    Vec4 S{}, U{}, G_r{}, G_z{}, T{};
};

template <class Stencil, bool axisymmetric>
GRIT_INLINE Gathered gather_point_values(const Stencil& w, const NodeMotion* nodes) {
    Gathered sum;
    for (int k = 0; k < Stencil::points; ++k) {
        const Vec4 v = w.value(k, nodes);
        sum.S += w.S[k] * v;
        sum.G_r += w.G_r[k] * v;
        sum.G_z += w.G_z[k] * v;
        if constexpr (Stencil::is_corner) sum.U += v;
    }
    // All corners have the same T and U; T of a node is S / r_p.
    if constexpr (Stencil::is_corner) {
        if constexpr (axisymmetric) sum.T = w.T * sum.U;
        sum.U *= 0.25;
    } else {
        if constexpr (axisymmetric) sum.T = w.per_r * sum.S;
        sum.U = sum.S;
    }
    return sum;
}

// Of the velocity in two lanes, times dt.
template <bool axisymmetric>
GRIT_INLINE Gradient gradient_of(const Gathered& g, int lane, double dt) {
    return {dt * g.G_r[lane], dt * g.G_z[lane], dt * g.G_r[lane + 1], dt * g.G_z[lane + 1],
            axisymmetric ? dt * g.T[lane] : 0.0};
}

template <class Stencil> GRIT_INLINE Vec4 velocities_at(const Stencil& w, const NodeMotion* nodes) {
    Vec4 sum{};
    for (int k = 0; k < Stencil::points; ++k) sum += w.S[k] * w.value(k, nodes);
    return sum;
}

// What a velocity against the grains keeps of what no node sees, as drag takes it there in a step; mass: of the water.
GRIT_INLINE double kept_by_drag(const GatherCall& call, const PoreWater& water, std::ptrdiff_t p,
                                const WaterPlace& at, double mass) {
    const double of_grains = call.particles[column::mass][p], both = of_grains * mass;
    return both / (both + call.dt * at.V * water.drag(at.e) * (of_grains + mass));
}

// grains: v and other, flowing: of the water.
GRIT_INLINE void move_water(const GatherCall& call, const PoreWater& water, const Vec4& grains,
                            const Vec4& flowing, std::ptrdiff_t p, const WaterPlace& at) {
    namespace c = column;
    const ParticleView& q = call.particles;
    const double mass = water.mass_of(at.e, at.V);
    const double kept_share = kept_by_drag(call, water, p, at, mass);
    const double unseen = (1.0 - call.pic) * kept_share;
    double kept = 0.0, dragged = 0.0, lost = 0.0;
    for (int k = 0; k < 2; ++k) {
        const double of_grains = q[c::v_r + k][p], against = q[water.velocity_column() + k][p];
        const double moved = of_grains + (grains[k] - grains[2 + k]);
        const double end = moved + call.pic * (grains[k] - moved);
        const double now = flowing[k] - grains[k];
        const double before = flowing[2 + k] - grains[2 + k];
        const double end_against = now + unseen * (against - before);
        const double change = flowing[k] - flowing[2 + k];
        const double all_kept = of_grains + against + change, end_water = end + end_against;
        q[water.velocity_column() + k][p] = end_against;
        kept += change * (change + 2.0 * of_grains);
        const double without_pic = moved + now + kept_share * (against - before);
        dragged += all_kept * all_kept - without_pic * without_pic;
        lost += without_pic * without_pic - end_water * end_water;
    }
    call.water->sums->kept.add(0.5 * mass * kept, call.fixed_point);
    call.water->sums->drag.add(0.5 * mass * dragged, call.fixed_point);
    call.water->sums->pic_loss.add(0.5 * mass * lost, call.fixed_point);
}

// Before the grains move. of_grains: what their nodes have given.
template <bool axisymmetric, class Stencil>
GRIT_INLINE void gather_water(const GatherCall& call, const PoreWater& water, const Place& place,
                              const Stencil& w, const Gathered& of_grains, std::ptrdiff_t p) {
    const ParticleView& q = call.particles;
    const WaterGather& of = *call.water;
    const double V = q[column::V0][p] * q.J(p);
    const WaterPlace at{V, water.void_ratio(q, p), place.cell_z * call.grid.r.cells + place.cell_r};
    of.places[p] = at;
    const Gathered g =
        water.flows ? gather_point_values<Stencil, axisymmetric>(w, of.volume) : of_grains;
    const double strain = midpoint_gradient(gradient_of<axisymmetric>(g, 0, call.dt)).trace();
    const double share = V * of.per_volume;
    add_share(of.cells[at.cell], share, strain);
    if (!water.flows) return;
    move_water(call, water, of_grains.S, velocities_at(w, of.flowing), p, at);
    // Linear in the nodes' velocities: the sum over all particles is what crosses surfaces and sides.
    const double left = gradient_of<axisymmetric>(g, motion::other_r, call.dt).trace();
    const double given = 0.125 * share * left;
    const std::int64_t taken = cell_share_rounded(given);
    of.cells[at.cell].left += taken;
    // What rounding does not take stays with the particle, so that no water is lost.
    if (!(given > -1.0 && given < 1.0)) return;
    q[water.content_column()][p] -=
        8.0 * water.density / of.per_volume *
        (given - static_cast<double>(taken) * (1.0 / CellIntegers::scale));
}

GRIT_KERNEL_END
