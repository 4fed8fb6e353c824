// SPDX-License-Identifier: BSD-3-Clause
// What flows between the four cells around a node and the node's velocity does not show: of pressures in a checkerboard the
// gradient at nodes is nothing, though from cell to cell it is the largest there is. Rhie & Chow (1983), doi 10.2514/3.8284.
#pragma once

#include <cstdint>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/pore_water.hpp"

namespace grit::mpm {

// Of a node: the volume that flows in a step for a checkerboard of 1 Pa [m3/Pa], where that is what pressures change by (grains
// and water start with it, in stiff grains), and where it is what they were (water goes through the grains); that of the body around it [m3].
struct CompactAnswer {
    double to_change = 0.0, to_pressure = 0.0, volume = 0.0;
};

class CompactFlow {
  public:
    struct Cell {
        std::uint32_t first;  // of its nodes in the grid
        bool bears, counted;
        double skeleton;  // P-wave modulus of its grains [Pa]
    };
    CompactFlow(const GridView& grid, Exchange& exchange, bool fixed_point);

    // Nodes with four cells answer to changes: what starts in a step, but no less than soft grains give way by, 1 Pa over their
    // modulus (as White & Borja 2008, doi 10.1016/j.cma.2008.05.015, have it), up to a hundred times the former. To pressures
    // those where all four bear.
    void begin(const std::vector<Cell>& cells, const std::vector<CompactAnswer>& answers);
    // Adds to out what leaves each cell in a step [m3] by changes of pressures, or by pressures: symmetric, and of all cells
    // nothing. Every process must call it.
    void add_by_changes(const double* x, double* out) { add(to_change, x, out); }
    void add_by_pressures(const double* x, double* out) { add(to_pressure, x, out); }
    // ... of it, by a change of 1 Pa of the cell's own pressure [m3/Pa].
    double own(std::size_t cell) const {
        const double* at = to_change.data() + cells[cell].first;
        return at[0] + at[1] + at[row] + at[row + 1];
    }

    // A preconditioner: z about the solution of (1 + D (F - own) D) z = r of cells, F what add_by_changes has, D their scale, of which
    // own D^2 < 1. So that it is symmetric and positive it is a polynomial of that matrix, Chebyshev's for eigenvalues from 1/4 to
    // 4: none is above, for x F x <= 4 x own x. Every process must call it.
    void scale_by(const double* scale);
    // size: of r of all processes, the root of its squares.
    void precondition(const double* r, double size, double* z);

  private:
    std::size_t row;  // nodes of one
    Exchange& exchange;
    bool fixed_point;
    std::vector<Cell> cells;
    std::vector<double> to_change, to_pressure;  // a sixteenth of what nodes answer
    // At the first node of each cell, behind a row and a node more of nothing; mixed differences at nodes, with as much of
    // nothing behind them.
    std::vector<double> at_cells, mixed;
    // The cells at a node: how many, those that bear, the sum of their moduli.
    struct Around {
        double cells, bearing, moduli;
    };
    std::vector<Around> around;
    // At the first node of each cell: D, of those that are counted; 1 - own D^2; r, z, and what z changed by at last.
    std::vector<double> scale, counted_scale, rest, right, found, change;
    double largest_scale = 0.0;
    double* first_cell() { return at_cells.data() + row + 1; }
    void find_mixed(const std::vector<double>& answer);
    void add(const std::vector<double>& answer, const double* x, double* out);
    // What leaves the cell whose first node this is.
    double leaving(std::size_t node) const {
        const double* at = mixed.data() + node;
        return (at[0] - at[1]) - (at[row] - at[row + 1]);
    }
    // For sums at nodes of what cells have, of this size.
    template <class SizeOf> Rounding of_sums(const SizeOf& size_of);
};

// Of a node around which the body has this volume and cells these mean lengths: velocity answers impulses [1/kg] that act for
// a step along r and z.
GRIT_INLINE double compact_answer(double volume, double h_r, double h_z, const Vector2& answer,
                                  double dt) {
    return 4.0 * dt * dt * volume * volume * (answer[0] / (h_r * h_r) + answer[1] / (h_z * h_z));
}

}  // namespace grit::mpm
