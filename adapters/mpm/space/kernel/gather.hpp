// SPDX-License-Identifier: BSD-3-Clause
// From nodes to particles in space: velocity (FLIP with a PIC share), position, deformation (A5), and the increments
// that a material wants, all in one pass.
#pragma once

#include "adapters/mpm/space/kernel/cell_mean.hpp"
#include "adapters/mpm/space/kernel/stencil.hpp"

GRIT_KERNEL_BEGIN_OF(mpm::space)

// Sums over the points of a particle: of velocities with S, and of v with G.
struct Gathered {
    Vec8 S{};
    Vec4 G[3]{};
};

template <class Stencil>
GRIT_INLINE Gathered gather_point_values(const Stencil& w, const NodeMotion* nodes) {
    const auto* motions = reinterpret_cast<const Vec8*>(nodes);
    Gathered sum;
    for (int k = 0; k < Stencil::points; ++k) {
        const Vec8 both = w.value(k, motions);
        const Vec4 v = __builtin_shufflevector(both, both, 0, 1, 2, 3);
        sum.S += w.S(k) * both;
        for (int d = 0; d < 3; ++d) sum.G[d] += w.G[d][k] * v;
    }
    return sum;
}

GRIT_INLINE void move_velocity(const GatherCall& call, const Gathered& g, std::ptrdiff_t p,
                               GatherSums& sums) {
    namespace c = column;
    const ParticleView q = call.particles;
    const double m = q[c::mass][p];
    double change2 = 0.0, flip2 = 0.0, v2 = 0.0, work = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double now = g.S[motion::v_x + k], before = g.S[motion::other_x + k];
        const double dv = now - before, flip = q[c::v_x + k][p] + dv;
        const double v = flip + call.pic * (now - flip);
        q[c::v_x + k][p] = v;
        change2 += dv * dv;
        flip2 += flip * flip;
        v2 += v * v;
        work += q[c::b_x + k][p] * (now + before);
    }
    sums.kept.add(0.5 * m * change2, call.fixed_point);
    sums.pic_loss.add(0.5 * m * (flip2 - v2), call.fixed_point);
    sums.body_work.add(0.5 * call.dt * m * work, call.fixed_point);
    sums.most_v2 = v2 > sums.most_v2 ? v2 : sums.most_v2;
}

GRIT_INLINE void move_position(const GatherCall& call, const Gathered& g, std::ptrdiff_t p,
                               GatherSums& sums) {
    const ParticleView q = call.particles;
    for (int k = 0; k < 3; ++k) {
        const double way = call.dt * g.S[motion::v_x + k];
        q[column::x + k][p] += way;
        if (k == 0) continue;
        const double length = std::fabs(way);
        double& farthest = sums.farthest[k - 1];
        farthest = length > farthest ? length : farthest;
    }
    sums.outside += !call.grid.has(q.position(p));
}

GRIT_INLINE Gradient gradient_of(const Gathered& g, double dt) {
    Gradient L;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) L.of[i][j] = dt * g.G[j][i];
    return L;
}

// (W1) takes the strain of the cell.
GRIT_INLINE void strain_pores(const GatherCall& call, const Place& place, std::ptrdiff_t p,
                              const Gradient& L) {
    const ParticleView& q = call.particles;
    call.pores.places[p] = {q.volume(p), call.pores.water->void_ratio(q, p),
                            midpoint_gradient(L).trace(), cell_of(call.grid, place)};
}

template <Shape shape, bool mean>
void gather_by(const GatherCall& call, Increments& increments, GatherSums& sums) {
    using Stencil = typename StencilOf<shape>::type;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        const Place place = place_of(call.grid, call.particles, p);
        const Stencil w(call.grid, place);
        const Gathered g = gather_point_values(w, call.nodes);
        move_position(call, g, p, sums);
        move_velocity(call, g, p, sums);
        const Gradient L = gradient_of(g, call.dt);
        if (call.pores.water) strain_pores(call, place, p, L);
        if constexpr (mean) defer(call, place, p, L);
        else deform(call.particles, p, L, call.separation, increments, p - call.begin);
    }
}

template <Shape shape>
void gather_with(const GatherCall& call, Increments& increments, GatherSums& sums) {
    call.mean.cells ? gather_by<shape, true>(call, increments, sums)
                    : gather_by<shape, false>(call, increments, sums);
}

void gather(Shape shape, const GatherCall& call, Increments& increments, GatherSums& sums) {
    switch (shape) {
        case Shape::ugimp: return gather_with<Shape::ugimp>(call, increments, sums);
        case Shape::point: return gather_with<Shape::point>(call, increments, sums);
        default: return gather_with<Shape::cpdi>(call, increments, sums);
    }
}

GRIT_KERNEL_END
