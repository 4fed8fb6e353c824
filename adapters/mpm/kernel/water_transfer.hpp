// SPDX-License-Identifier: BSD-3-Clause
// Pore water from particles to nodes and back. The force of its pressure and the strain that changes it are
// conjugate: the force is that of the mean pressure of cells, the strain the mean of cells.
#pragma once

#include <type_traits>

#include "adapters/mpm/kernel/gather.hpp"
#include "adapters/mpm/kernel/pore_water.hpp"
#include "adapters/mpm/kernel/sums.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// As sums of nodes, into the patch of a cell. Rows: sums of its rows, four a cell.
template <class Rows> struct PatchSums {
    Rows& rows;
    std::ptrdiff_t first, row, column, n_r;  // of its first node, even outside of the grid

    GRIT_INLINE PatchSums(Rows& of_cells, const GridView& grid, const Place& place)
        : rows(of_cells), first(4 * (std::ptrdiff_t{place.cell_z} * grid.r.cells + place.cell_r)),
          row(place.cell_z - 1), column(place.cell_r - 1), n_r(grid.nodes_r()) {}
    GRIT_INLINE void add(std::ptrdiff_t node, const Vec8& P) {
        if (P[0] == 0.0 && P[1] == 0.0) return;  // weights that are nothing may lie anywhere
        const std::ptrdiff_t j = node / n_r, i = node - j * n_r;
        rows.add(first + (j - row), i - column, P[0], P[1]);
    }
};

struct RowsInDouble {
    CellPatch* patches;
    GRIT_INLINE void add(std::ptrdiff_t row, std::ptrdiff_t node, double f_r, double f_z) const {
        double* force = patches->force + 8 * row + 2 * node;
        force[0] += f_r;
        force[1] += f_z;
    }
};

struct RowsInFixedPoint {
    FixedSums& sums;
    GRIT_INLINE void add(std::ptrdiff_t row, std::ptrdiff_t node, double f_r, double f_z) const {
        Vec8 x{};
        x[2 * node] = f_r;
        x[2 * node + 1] = f_z;
        sums.add(row, x);
    }
};

struct NoRows {};

template <bool axisymmetric, class Stencil, class Rows>
GRIT_INLINE void add_to_patch(const WaterScatterCall& call, const Place& place, const Stencil& w,
                              std::ptrdiff_t p, Rows& rows) {
    const ParticleView& q = call.particles;
    PatchSums<Rows> sums(rows, call.grid, place);
    const double V = q[column::V0][p] * q.J(p);
    for (int k = 0; k < Stencil::points; ++k) {
        const double hoop = axisymmetric ? w.hoop(k) : 0.0;
        w.add(k, Vec8{V * (w.G_r[k] + hoop), V * w.G_z[k], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, sums);
    }
}

template <Shape shape, bool axisymmetric, class Sums, class Rows>
GRIT_INLINE void scatter_water_to(const WaterScatterCall& call, Sums& sums, Rows rows) {
    using Stencil = typename StencilOf<shape, axisymmetric>::type;
    namespace c = column;
    const ParticleView& q = call.particles;
    const PoreWater& water = *call.water;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        const Place place = place_of<axisymmetric>(call.grid, q, p);
        const Stencil w(call.grid, place);
        const CellIntegers& cell = call.cells[place.cell_z * call.grid.r.cells + place.cell_r];
        const double V = q[c::V0][p] * q.J(p);
        const double force =
            cell.volume > 0 ? V * (water.bulk_modulus * cell.mean()) : V * water.pressure(q, p);
        double mass = 0.0, drag = 0.0, m_v_r = 0.0, m_v_z = 0.0;
        if (water.flows) {
            const double e = water.void_ratio(q, p);
            mass = water.mass(q, p);
            drag = V * water.drag(e);
            m_v_r = mass * q[water.velocity_column()][p];
            m_v_z = mass * q[water.velocity_column() + 1][p];
        }
        if constexpr (!std::is_same_v<Rows, NoRows>)
            add_to_patch<axisymmetric>(call, place, w, p, rows);
        for (int k = 0; k < Stencil::points; ++k) {
            const double S = w.S[k];
            double f_r = force * w.G_r[k];
            if constexpr (axisymmetric) f_r += force * w.hoop(k);
            w.add(k,
                  Vec8{S * mass, S * m_v_r, S * m_v_z, f_r, force * w.G_z[k], S * V, S * drag, 0.0},
                  sums);
        }
    }
}

template <Shape shape, bool axisymmetric> void scatter_water_by(const WaterScatterCall& call) {
    if (call.fixed_point)
        return add_in_fixed_point(*call.fixed_point, [&](FixedSums& sums) {
            if (!call.fixed_patches)
                return scatter_water_to<shape, axisymmetric>(call, sums, NoRows{});
            add_in_fixed_point(*call.fixed_patches, [&](FixedSums& rows) {
                scatter_water_to<shape, axisymmetric>(call, sums, RowsInFixedPoint{rows});
            });
        });
    DoubleSums sums{call.nodes};
    if (call.patches)
        return scatter_water_to<shape, axisymmetric>(call, sums, RowsInDouble{call.patches});
    scatter_water_to<shape, axisymmetric>(call, sums, NoRows{});
}

// Velocities at a particle: v of the lanes v_r, v_z and of the other ones.
struct TwoVelocities {
    double now[2], before[2];
};

template <class Stencil>
GRIT_INLINE TwoVelocities velocities_at(const Stencil& w, const NodeMotion* nodes) {
    Vec4 sum{};
    for (int k = 0; k < Stencil::points; ++k) sum += w.S[k] * w.value(k, nodes);
    return {{sum[0], sum[1]}, {sum[2], sum[3]}};
}

// What a velocity against the grains keeps of what no node sees, as drag takes it there in a step; mass: of the water.
GRIT_INLINE double kept_by_drag(const WaterGatherCall& call, std::ptrdiff_t p, double mass) {
    const ParticleView& q = call.particles;
    const PoreWater& water = *call.water;
    const double e = water.void_ratio(q, p), V = q[column::V0][p] * q.J(p);
    return 1.0 / (1.0 + call.dt * V * water.drag(e) * (1.0 / q[column::mass][p] + 1.0 / mass));
}

template <class Stencil>
GRIT_INLINE void move_water(const WaterGatherCall& call, const Stencil& w, std::ptrdiff_t p,
                            WaterSums& sums) {
    namespace c = column;
    const ParticleView& q = call.particles;
    const PoreWater& water = *call.water;
    const TwoVelocities grains = velocities_at(w, call.grains);
    const TwoVelocities flowing = velocities_at(w, call.flowing);
    const double mass = water.mass(q, p);
    const double unseen = (1.0 - call.pic) * kept_by_drag(call, p, mass);
    double kept = 0.0, lost = 0.0;
    for (int k = 0; k < 2; ++k) {
        const double of_grains = q[c::v_r + k][p], against = q[water.velocity_column() + k][p];
        const double moved = of_grains + (grains.now[k] - grains.before[k]);
        const double end = moved + call.pic * (grains.now[k] - moved);
        const double now = flowing.now[k] - grains.now[k];
        const double before = flowing.before[k] - grains.before[k];
        const double end_against = now + unseen * (against - before);
        const double change = flowing.now[k] - flowing.before[k];
        const double all_kept = of_grains + against + change, end_water = end + end_against;
        q[water.velocity_column() + k][p] = end_against;
        kept += change * (change + 2.0 * of_grains);
        lost += all_kept * all_kept - end_water * end_water;
    }
    sums.kept.add(0.5 * mass * kept, call.fixed_point);
    sums.drag.add(0.5 * mass * lost, call.fixed_point);
}

template <Shape shape, bool axisymmetric>
void gather_water_by(const WaterGatherCall& call, WaterSums& sums) {
    using Stencil = typename StencilOf<shape, axisymmetric>::type;
    const ParticleView& q = call.particles;
    for (std::ptrdiff_t p = call.begin; p < call.end; ++p) {
        const Place place = place_of<axisymmetric>(call.grid, q, p);
        const Stencil w(call.grid, place);
        const Gathered g = gather_point_values<Stencil, axisymmetric>(w, call.volume);
        const double strain = midpoint_gradient(gradient_of<axisymmetric>(g, 0, call.dt)).trace();
        const int cell = place.cell_z * call.grid.r.cells + place.cell_r;
        const double V = q[column::V0][p] * q.J(p) * call.per_volume;
        call.cell[p] = cell;
        call.cells[cell].volume += cell_share_rounded(0.125 * V);
        call.cells[cell].weighted += cell_share_rounded(0.125 * V * strain);
        if (!call.water->flows) continue;
        move_water(call, w, p, sums);
        // Linear in the nodes' velocities: the sum over all particles is what crosses surfaces and sides.
        const double left = gradient_of<axisymmetric>(g, motion::other_r, call.dt).trace();
        q[call.water->content_column()][p] -=
            call.water->density * q[column::V0][p] * q.J(p) * left;
    }
}

void scatter_water(Shape shape, bool axisymmetric, const WaterScatterCall& call) {
    with_shape(shape, axisymmetric, [&]<Shape of, bool axi>() { scatter_water_by<of, axi>(call); });
}

void gather_water(Shape shape, bool axisymmetric, const WaterGatherCall& call, WaterSums& sums) {
    with_shape(shape, axisymmetric,
               [&]<Shape of, bool axi>() { gather_water_by<of, axi>(call, sums); });
}

GRIT_KERNEL_END
