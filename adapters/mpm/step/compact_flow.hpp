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
// and water start with it), and where it is what they were (water goes through the grains).
struct CompactAnswer {
    double to_change = 0.0, to_pressure = 0.0;
};

class CompactFlow {
  public:
    struct Cell {
        std::uint32_t first;             // of its nodes in the grid
        bool bears, counted, cavitates;  // cavitates: some of its particles
        double compliance;               // of its water, all of it bearing [m3/Pa]
    };
    CompactFlow(const GridView& grid, Exchange& exchange, bool fixed_point);

    // Nodes with four cells answer to changes, to pressures those where all four bear.
    void begin(const std::vector<Cell>& cells, const std::vector<CompactAnswer>& answers);
    // Adds to out what leaves each cell in a step [m3], and of all cells is nothing. Every process must call it.
    // By changes of pressures, or by pressures: symmetric.
    void add_by_changes(const double* x, double* out) { add(to_change, x, out); }
    void add_by_pressures(const double* x, double* out) { add(to_pressure, x, out); }
    // By what of pressures changes sign from cell to cell: positive, but for the last kind symmetric, and nothing of smooth ones.
    // - Checkerboards: M' sqrt(a) M M' sqrt(a) M p / 256, M the mixed differences at nodes, a their answers to changes: of a
    //   checkerboard as much as a change of it would start, and of no pressures more.
    // - Along r and along z: 0.9 B k B p, B the fourth differences 1, -4, 6, -4, 1 over 16 of five cells in a row, k the least
    //   compliance of their water, where one of the five cavitates. Elsewhere 0.9 B k b: b has in all five cells of a row along which
    //   B p changes sign from cell to cell the least of the five (of all such rows that a cell is in the most), with the sign of B p:
    //   nothing beside a jump between pressures that are even, or linear. B p of five cells needs nine in a row. The energy of what the
    //   cells' own water could bear does not grow by it: of a checkerboard, which has both directions, 0.8 is left, turned over.
    void add_of_alternating(const double* p, double* out);
    // ... of that of changes, by 1 Pa of the cell's own pressure [m3/Pa].
    double own(std::size_t cell) const {
        const double* at = to_change.data() + cells[cell].first;
        return at[0] + at[1] + at[row] + at[row + 1];
    }

  private:
    std::size_t row;  // nodes of one
    Exchange& exchange;
    bool fixed_point;
    std::vector<Cell> cells;
    // A sixteenth of what nodes answer, and of its root.
    std::vector<double> to_change, to_pressure, to_root;
    // At the first node of each cell, behind a row and a node more of nothing; mixed differences at nodes, with as much of
    // nothing behind them.
    std::vector<double> at_cells, mixed;
    // The cells at a node: how many, and those that bear.
    std::vector<Vector2> around;
    // At the first node of each cell, between rows of nothing, along r and z but for given: what neighbours must know of a cell.
    // second: second differences of the pressure; of these three cells the least compliance, and 1 where one cavitates.
    // compliance_of_five: the least; fourth: second differences of second ones; least_of_three, least_of_five: of these, that change sign;
    // most_of_three: of the latter. alternating: 0.9 k B p or 0.9 k b [m3]; leaves: second differences of it.
    struct Given {
        double pressure, compliance, cavitates;
    };
    struct Second {
        Vector2 difference, least_compliance, cavitates;
    };
    std::vector<Given> given;
    std::vector<Second> second;
    std::vector<Vector2> compliance_of_five, fourth, least_of_three, least_of_five, most_of_three,
        alternating, leaves;
    std::vector<double> part;  // of cells, on the way to what leaves of checkerboards
    double* first_cell() { return at_cells.data() + row + 1; }
    void add(const std::vector<double>& answer, const double* x, double* out);
    template <class Of> void share(std::vector<Of>& of_cells);
    template <class Find> void find_along(const Find& find);
};

// Of a node around which the body has this volume and cells these mean lengths: velocity answers impulses [1/kg] that act for
// a step along r and z.
GRIT_INLINE double compact_answer(double volume, double h_r, double h_z, const Vector2& answer,
                                  double dt) {
    return 4.0 * dt * dt * volume * volume * (answer[0] / (h_r * h_r) + answer[1] / (h_z * h_z));
}

}  // namespace grit::mpm
