// SPDX-License-Identifier: BSD-3-Clause
// From particles to nodes: mass, momentum, forces (A4) and gradients, all in one pass.
#pragma once

#include "adapters/mpm/kernel/cell_mean.hpp"
#include "adapters/mpm/kernel/node_stencil.hpp"
#include "adapters/mpm/kernel/sums.hpp"
#include "adapters/mpm/kernel/water_scatter.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

template <Shape shape, bool axisymmetric, bool all, class Sums, class Water>
GRIT_INLINE void scatter_by(const ScatterCall& call, Sums& sums, Water water) {
    using Stencil = typename StencilOf<shape, axisymmetric>::type;
    namespace c = column;
    const ParticleView q = call.particles;
    const auto wanted = [&](unsigned part) { return all || (call.parts & part) ? 1.0 : 0.0; };
    const double with_mass = wanted(part::mass), with_momentum = wanted(part::momentum);
    const double with_force = wanted(part::force), with_gradient = wanted(part::gradient);
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        const Place place = place_of<axisymmetric>(call.grid, q, p);
        const Stencil w(call.grid, place);
        const double V = q[c::V0][p] * q.J(p);
        double mass = q[c::mass][p], V_f = V;
        double area = Stencil::is_corner ? 1.0 : axisymmetric ? V / place.r : V;
        const double m_v_r = with_momentum * (mass * q[c::v_r][p]);
        const double m_v_z = with_momentum * (mass * q[c::v_z][p]);
        double m_b_r = mass * q[c::b_r][p], m_b_z = mass * q[c::b_z][p];
        if (!all) {
            m_b_r *= with_force;
            m_b_z *= with_force;
            V_f *= with_force;
            mass *= with_mass;
            area *= with_gradient;
        }
        double pressure = q[c::q][p];  // besides that of the stresses
        if (call.mean.cells) pressure -= to_mean_stress<axisymmetric>(call, place, p);
        const double rr = V_f * (pressure - q[c::S_rr][p]), zz = V_f * (pressure - q[c::S_zz][p]);
        const double tt = V_f * (pressure - q[c::S_tt][p]), rz = -V_f * q[c::S_rz][p];
        for (int k = 0; k < Stencil::points; ++k) {
            const double S = w.S[k], G_r = w.G_r[k], G_z = w.G_z[k];
            double f_r = rr * G_r + rz * G_z + S * m_b_r;  // (A4)
            if constexpr (axisymmetric) f_r += tt * w.hoop(k);
            const double f_z = rz * G_r + zz * G_z + S * m_b_z;
            const double g_r = area * w.A_r[k], g_z = area * w.A_z[k];
            const Vec8 P = {S * mass, S * m_v_r, S * m_v_z, f_r,
                            f_z,      g_r,       g_z,       std::fabs(g_r) + std::fabs(g_z)};
            w.add(k, P, sums);
        }
        water.add(place, w, p, V);
    }
}

template <Shape shape, bool axisymmetric, bool all, class Sums>
GRIT_INLINE void scatter_both(const ScatterCall& call, Sums& sums) {
    if (!call.water) return scatter_by<shape, axisymmetric, all>(call, sums, NoWater{});
    with_water<axisymmetric>(
        call, [&](auto water) { scatter_by<shape, axisymmetric, all>(call, sums, water); });
}

template <Shape shape, bool axisymmetric> void scatter_parts(const ScatterCall& call) {
    if (call.fixed_point)
        return add_in_fixed_point(*call.fixed_point, [&](FixedSums& sums) {
            scatter_both<shape, axisymmetric, false>(call, sums);
        });
    DoubleSums sums{call.nodes};
    if (call.parts == part::all) scatter_both<shape, axisymmetric, true>(call, sums);
    else scatter_by<shape, axisymmetric, false>(call, sums, NoWater{});
}

void scatter(Shape shape, bool axisymmetric, const ScatterCall& call) {
    with_shape(shape, axisymmetric, [&]<Shape of, bool axi>() { scatter_parts<of, axi>(call); });
}

GRIT_KERNEL_END
