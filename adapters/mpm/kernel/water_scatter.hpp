// SPDX-License-Identifier: BSD-3-Clause
// Pore water from particles to nodes, at the places where the grains of a particle go. The force of its pressure and the
// strain that changes it are conjugate: the force is that of the mean pressure of cells, the strain the mean of cells.
#pragma once

#include <type_traits>

#include "adapters/mpm/kernel/node_stencil.hpp"
#include "adapters/mpm/kernel/pore_water.hpp"
#include "adapters/mpm/kernel/sums.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Into the patch of a cell. Rows: sums of its rows, four a cell.
template <class Rows> struct PatchSums {
    Rows& rows;
    std::ptrdiff_t first, row, column, n_r;  // of its first node, even outside of the grid

    GRIT_INLINE PatchSums(Rows& of_cells, const GridView& grid, const Place& place)
        : rows(of_cells), first(4 * (std::ptrdiff_t{place.cell_z} * grid.r.cells + place.cell_r)),
          row(place.cell_z - 1), column(place.cell_r - 1), n_r(grid.nodes_r()) {}
    struct At {
        std::ptrdiff_t row, column;
    };
    GRIT_INLINE At at(std::ptrdiff_t node) const {
        const std::ptrdiff_t begin = row * n_r;
        const int j = (node >= begin + n_r) + (node >= begin + 2 * n_r) + (node >= begin + 3 * n_r);
        return {j, node - begin - j * n_r - column};
    }
    GRIT_INLINE void add(const At& to, const Vec2& force) {
        rows.add(first + to.row, to.column, force);
    }
};

struct RowsInDouble {
    CellPatch* patches;
    GRIT_INLINE void add(std::ptrdiff_t row, std::ptrdiff_t node, const Vec2& force) const {
        *reinterpret_cast<Vec2*>(patches->force + 8 * row + 2 * node) += force;
    }
};

struct RowsInFixedPoint {
    FixedSums& sums;
    GRIT_INLINE void add(std::ptrdiff_t row, std::ptrdiff_t node, const Vec2& force) const {
        Vec8 x{};
        x[2 * node] = force[0];
        x[2 * node + 1] = force[1];
        sums.add(row, x);
    }
};

struct NoRows {};

// Of a particle of this volume, to nodes and to the patch of its cell.
template <bool axisymmetric, class Sums, class Rows> struct WaterShares {
    const ScatterCall& call;
    const WaterCell* cells;
    Sums& sums;
    Rows rows;
    PoreWater water;  // numbers of its own: no store to a column can change them

    template <class Stencil>
    GRIT_INLINE void add(const Place& place, const Stencil& w, std::ptrdiff_t p, double V) {
        const ParticleView& q = call.particles;
        const WaterCell& cell = cells[place.cell_z * call.grid.r.cells + place.cell_r];
        const double force =
            cell.volume > 0 ? V * (water.bulk_modulus * cell.mean()) : V * water.pressure(q, p);
        double mass = 0.0, drag = 0.0, m_v_r = 0.0, m_v_z = 0.0;
        if (water.flows) {
            mass = water.mass(q, p);
            drag = V * water.drag(water.void_ratio(q, p));
            m_v_r = mass * q[water.velocity_column()][p];
            m_v_z = mass * q[water.velocity_column() + 1][p];
        }
        if constexpr (!std::is_same_v<Rows, NoRows>) add_to_patch(place, w, V);
        for (int k = 0; k < Stencil::points; ++k) {
            const double S = w.S[k];
            double f_r = force * w.G_r[k];
            if constexpr (axisymmetric) f_r += force * w.hoop(k);
            w.add(k,
                  Vec8{S * mass, S * m_v_r, S * m_v_z, f_r, force * w.G_z[k], S * V, S * drag, 0.0},
                  sums);
        }
    }

  private:
    template <class Stencil>
    GRIT_INLINE void add_to_patch(const Place& place, const Stencil& w, double V) {
        PatchSums<Rows> patch(rows, call.grid, place);
        for (int k = 0; k < Stencil::points; ++k) {
            const double hoop = axisymmetric ? w.hoop(k) : 0.0;
            w.add_to_patch(k, Vec2{V * (w.G_r[k] + hoop), V * w.G_z[k]}, patch);
        }
    }
};

struct NoWater {
    template <class Stencil>
    GRIT_INLINE void add(const Place&, const Stencil&, std::ptrdiff_t, double) {}
};

// act(shares of water)
template <bool axisymmetric, class Act>
GRIT_INLINE void with_water(const ScatterCall& call, const Act& act) {
    const WaterScatter& of = *call.water;
    if (of.fixed_point)
        return add_in_fixed_point(*of.fixed_point, [&](FixedSums& sums) {
            if (!of.fixed_patches)
                return act(WaterShares<axisymmetric, FixedSums, NoRows>{
                    call, of.cells, sums, {}, *of.water});
            add_in_fixed_point(*of.fixed_patches, [&](FixedSums& rows) {
                act(WaterShares<axisymmetric, FixedSums, RowsInFixedPoint>{
                    call, of.cells, sums, {rows}, *of.water});
            });
        });
    DoubleSums sums{of.nodes};
    if (of.patches)
        return act(WaterShares<axisymmetric, DoubleSums, RowsInDouble>{
            call, of.cells, sums, {of.patches}, *of.water});
    act(WaterShares<axisymmetric, DoubleSums, NoRows>{call, of.cells, sums, {}, *of.water});
}

GRIT_KERNEL_END
