// SPDX-License-Identifier: BSD-3-Clause
// From nodes to particles: velocity (FLIP with a PIC share), position, deformation (A5), and the
// increments that a material wants, all in one pass.
#pragma once

#include "adapters/mpm/kernel/cell_mean.hpp"
#include "adapters/mpm/kernel/increment.hpp"
#include "adapters/mpm/kernel/node_stencil.hpp"
#include "adapters/mpm/kernel/water_gather.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

GRIT_INLINE void move_velocity(const GatherCall& call, const Gathered& g, std::ptrdiff_t p,
                               GatherSums& sums) {
    namespace c = column;
    const ParticleView q = call.particles;
    const double m = q[c::mass][p];
    const double dv_r = g.S[0] - g.S[2], dv_z = g.S[1] - g.S[3];
    const double flip_r = q[c::v_r][p] + dv_r, flip_z = q[c::v_z][p] + dv_z;
    const double v_r = flip_r + call.pic * (g.S[0] - flip_r);
    const double v_z = flip_z + call.pic * (g.S[1] - flip_z);
    const double v2 = v_r * v_r + v_z * v_z;
    q[c::v_r][p] = v_r;
    q[c::v_z][p] = v_z;
    const double body_work =
        0.5 * call.dt * m * (q[c::b_r][p] * (g.S[0] + g.S[2]) + q[c::b_z][p] * (g.S[1] + g.S[3]));
    sums.kept.add(0.5 * m * (dv_r * dv_r + dv_z * dv_z), call.fixed_point);
    sums.pic_loss.add(0.5 * m * (flip_r * flip_r + flip_z * flip_z - v2), call.fixed_point);
    sums.body_work.add(body_work, call.fixed_point);
    sums.most_v2 = v2 > sums.most_v2 ? v2 : sums.most_v2;
}

GRIT_INLINE void move_position(const GatherCall& call, const Gathered& g, std::ptrdiff_t p,
                               bool axisymmetric, GatherSums& sums) {
    namespace c = column;
    const ParticleView q = call.particles;
    const AxisView &a_r = call.grid.r, &a_z = call.grid.z;
    const double dz = call.dt * g.U[1];
    const double r = q[c::r][p] + call.dt * g.U[0], z = q[c::z][p] + dz;
    q[c::r][p] = r;
    q[c::z][p] = z;
    const double way = std::fabs(dz);
    sums.most_dz = way > sums.most_dz ? way : sums.most_dz;
    const bool reflected = axisymmetric && r < 0.0;
    const double beyond = reflected ? -r : r;
    sums.reflected += reflected;
    // Positive conditions, so that NaN fails them.
    sums.outside += !(beyond >= a_r.node[0] && beyond <= a_r.node[a_r.cells] && z >= a_z.node[0] &&
                      z <= a_z.node[a_z.cells]);
}

template <Shape shape, bool axisymmetric, bool all, bool mean, bool water>
void gather_by(const GatherCall& call, Increments& increments, GatherSums& sums) {
    using Stencil = typename StencilOf<shape, axisymmetric>::type;
    const unsigned tasks = all ? static_cast<unsigned>(task::all) : call.tasks;
    // Numbers of its own: no store to a column can change them.
    const PoreWater pores = water ? *call.water->water : PoreWater{};
    const std::ptrdiff_t lane = tasks & task::deform_by_other ? 2 : 0;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        const Place place = place_of<axisymmetric>(call.grid, call.particles, p);
        const Stencil w(call.grid, place);
        const Gathered g = gather_point_values<Stencil, axisymmetric>(w, call.nodes);
        if constexpr (water) gather_water<axisymmetric>(call, pores, place, w, g, p);
        if (tasks & task::velocity) move_velocity(call, g, p, sums);
        if (tasks & task::position) move_position(call, g, p, axisymmetric, sums);
        if (tasks & (task::deformation | task::deform_by_other)) {
            const Gradient L = gradient_of<axisymmetric>(g, lane, call.dt);
            if constexpr (mean) defer(call, place, p, L);
            else
                deform(call.particles, p, L, call.separation, call.reduces_domains, increments,
                       p - call.begin);
        }
    }
}

template <Shape shape, bool axisymmetric, bool water>
void gather_tasks(const GatherCall& call, Increments& increments, GatherSums& sums) {
    if (call.mean.cells) gather_by<shape, axisymmetric, false, true, water>(call, increments, sums);
    else if (call.tasks == task::all)
        gather_by<shape, axisymmetric, true, false, water>(call, increments, sums);
    else gather_by<shape, axisymmetric, false, false, water>(call, increments, sums);
}

void gather(Shape shape, bool axisymmetric, const GatherCall& call, Increments& increments,
            GatherSums& sums) {
    with_shape(shape, axisymmetric, [&]<Shape of, bool axi>() {
        call.water ? gather_tasks<of, axi, true>(call, increments, sums)
                   : gather_tasks<of, axi, false>(call, increments, sums);
    });
}

GRIT_KERNEL_END
