// SPDX-License-Identifier: BSD-3-Clause
// From particles to nodes in space: mass, momentum, forces (A4) and gradients, all in one pass.
#pragma once

#include "adapters/mpm/kernel/sums.hpp"
#include "adapters/mpm/space/kernel/cell_mean.hpp"
#include "adapters/mpm/space/kernel/stencil.hpp"

GRIT_KERNEL_BEGIN_OF(mpm::space)

using mpm::GRIT_TARGET::add_in_fixed_point;

template <class Vec> struct DoubleSums {
    Vec* nodes;
    GRIT_INLINE void add(std::ptrdiff_t node, const Vec& x) { nodes[node] += x; }
};

// What else than records is wanted.
enum class Besides { nothing, slopes, pore_forces_too };

template <Shape shape, Besides besides, class Records, class Slopes, class Pores>
GRIT_INLINE void scatter_by(const ScatterCall& call, Records& records, Slopes& slopes,
                            Pores& pores) {
    using Stencil = typename StencilOf<shape>::type;
    namespace c = column;
    const ParticleView q = call.particles;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        const Place place = place_of(call.grid, q, p);
        const Stencil w(call.grid, place);
        const double V = q.volume(p), m = q[c::mass][p];
        double pressure = q[c::q][p];  // besides that of the stresses
        if (call.mean.cells) pressure -= to_mean_stress(call, place, p);
        double p_w = 0.0;
        if (call.pore_pressures.cells) p_w = call.pore_pressures.of(cell_of(call.grid, place));
        pressure += p_w;
        const double xx = V * (pressure - q[c::S_xx][p]), xy = -V * q[c::S_xy][p];
        const double yy = V * (pressure - q[c::S_yy][p]), xz = -V * q[c::S_xz][p];
        const double zz = V * (pressure - q[c::S_zz][p]), yz = -V * q[c::S_yz][p];
        const Vec8 by_S{m,
                        m * q[c::v_x][p],
                        m * q[c::v_y][p],
                        m * q[c::v_z][p],
                        m * q[c::b_x][p],
                        m * q[c::b_y][p],
                        m * q[c::b_z][p],
                        0.0};
        const Vec8 by_x{0.0, 0.0, 0.0, 0.0, xx, xy, xz, 0.0};
        const Vec8 by_y{0.0, 0.0, 0.0, 0.0, xy, yy, yz, 0.0};
        const Vec8 by_z{0.0, 0.0, 0.0, 0.0, xz, yz, zz, 0.0};
        for (int k = 0; k < Stencil::points; ++k) {
            const double G_x = w.G[0][k], G_y = w.G[1][k], G_z = w.G[2][k];
            w.add(k, w.S(k) * by_S + G_x * by_x + G_y * by_y + G_z * by_z, records);  // (A4)
            if constexpr (besides != Besides::nothing) {
                const double size = std::fabs(G_x) + std::fabs(G_y) + std::fabs(G_z);
                w.add(k, V * Vec4{G_x, G_y, G_z, size}, slopes);
            }
            if constexpr (besides == Besides::pore_forces_too)
                w.add(k, (V * p_w) * Vec4{G_x, G_y, G_z, 0.0}, pores);
        }
    }
}

template <Shape shape> void scatter_in_doubles(const ScatterCall& call) {
    DoubleSums<Vec8> records{reinterpret_cast<Vec8*>(call.nodes)};
    DoubleSums<Vec4> slopes{reinterpret_cast<Vec4*>(call.slopes)};
    DoubleSums<Vec4> pores{reinterpret_cast<Vec4*>(call.pore_forces)};
    if (!call.slopes) scatter_by<shape, Besides::nothing>(call, records, slopes, pores);
    else if (!call.pore_forces) scatter_by<shape, Besides::slopes>(call, records, slopes, pores);
    else scatter_by<shape, Besides::pore_forces_too>(call, records, slopes, pores);
}

template <Shape shape> void scatter_in_fixed_point(const ScatterCall& call) {
    add_in_fixed_point(*call.fixed_records, [&](auto& records) {
        if (!call.fixed_slopes)
            return scatter_by<shape, Besides::nothing>(call, records, records, records);
        add_in_fixed_point(*call.fixed_slopes, [&](auto& slopes) {
            if (!call.fixed_pore_forces)
                return scatter_by<shape, Besides::slopes>(call, records, slopes, slopes);
            add_in_fixed_point(*call.fixed_pore_forces, [&](auto& pores) {
                scatter_by<shape, Besides::pore_forces_too>(call, records, slopes, pores);
            });
        });
    });
}

template <Shape shape> void scatter_parts(const ScatterCall& call) {
    call.fixed_records ? scatter_in_fixed_point<shape>(call) : scatter_in_doubles<shape>(call);
}

void scatter(Shape shape, const ScatterCall& call) {
    switch (shape) {
        case Shape::ugimp: return scatter_parts<Shape::ugimp>(call);
        case Shape::point: return scatter_parts<Shape::point>(call);
        default: return scatter_parts<Shape::cpdi>(call);
    }
}

GRIT_KERNEL_END
