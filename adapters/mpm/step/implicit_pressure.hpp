// SPDX-License-Identifier: BSD-3-Clause
// What the pore pressure of cells changes by in a step, as it is at the end of that step: its waves do not limit the step.
#pragma once

#include <vector>

#include "adapters/mpm/kernel/pore_water.hpp"

namespace grit::mpm {

// How the volume velocity (1 - n) v_s + n v_w of a node answers an impulse of the pressure [1/kg]: symmetric.
struct NodeAnswer {
    double rr, rz, zz;
    Vector2 operator()(const Vector2& f) const {
        return {rr * f[0] + rz * f[1], rz * f[0] + zz * f[1]};
    }
};

class ImplicitPressure {
  public:
    explicit ImplicitPressure(const GridView& grid);
    // Of cells, for the kernels.
    CellPatch* patches() { return of_cells.data(); }
    void clear();
    // Index of a node of the grid in the arrays of solve: these have a node more on each side.
    std::size_t node(std::size_t of_grid) const {
        return (of_grid / (row - 2) + 1) * row + of_grid % (row - 2) + 1;
    }
    std::size_t nodes() const { return at_nodes.size(); }

    // The change x of the mean pressures of cells [Pa] with
    //     p + x = mean over particles of max(p - K_w/n dt G^T (u + dt A G x)/V, -largest_tension),
    // u the volume velocity without it, A the answers of nodes; and its impulses dt G x [N s]. Throws
    // std::runtime_error without a solution.
    void solve(const PoreWater& water, const GridView& grid, Particles& particles, double dt,
               const std::vector<Vector2>& u, const std::vector<NodeAnswer>& answers,
               std::vector<Vector2>& impulses);

  private:
    friend class PressureOperator;
    struct Cell {
        std::size_t begin, end;  // of its particles
        double V, pressure;      // [m3], mean that bears [Pa]
        // p + x = reached - swelling/compliance, of the particles that bear; compliance 0: none does.
        double compliance, reached;
        double scale;  // 1/sqrt of the diagonal
    };
    struct InCell {
        double V, stiffness, p;  // K_w/n [Pa], p as it goes on below the largest tension
    };
    PatchCall all() const { return {of_cells.data(), patched.data(), cells.size(), row}; }
    // G x at nodes, and G^T v of all cells.
    void push(const double* x, std::vector<Vector2>& at) const;
    void swell(const std::vector<Vector2>& v, double* of) const;
    void find_cells(const PoreWater& water, const GridView& grid, Particles& particles);
    bool find_law(const PoreWater& water, Cell& cell, double swells) const;

    std::size_t row;  // nodes of one in the arrays of solve
    int cells_r;
    std::vector<CellPatch> of_cells;
    std::vector<Cell> cells;
    std::vector<PatchedCell> patched;  // ... of each
    std::vector<InCell> particles_of;
    std::vector<std::size_t> count_of;  // of each cell of the grid
    std::vector<Vector2> at_nodes, moved;
    std::vector<double> values, swelling;
};

}  // namespace grit::mpm
