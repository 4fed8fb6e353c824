// SPDX-License-Identifier: BSD-3-Clause
// What the pore pressure of cells changes by in a step, as it is at the end of that step: its waves do not limit the step.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/pore_water.hpp"
#include "adapters/mpm/step/compact_flow.hpp"
#include "adapters/mpm/step/held_rows.hpp"
#include "adapters/mpm/step/integer_records.hpp"

namespace grit::mpm {

// Nodes that move as one along a direction (0 r, 1 z).
struct TiedNodes {
    int direction;
    std::vector<std::size_t> nodes;
};

// The answers of all nodes, and of those that are tied: these take their sum along the direction, for one over the mass
// of all; and what surfaces in contact take of it. Beside them, the flow between cells that nodes do not show.
struct Answers {
    struct Tie {
        TiedNodes nodes;
        double per_mass = 0.0;  // [1/kg]
    };
    std::vector<NodeAnswer> nodes = {};
    std::vector<Tie> ties = {};
    const HeldRows* held = nullptr;           // null: none
    std::vector<CompactAnswer> compact = {};  // of the nodes of the grid
    // Impulses become velocities.
    void operator()(std::vector<Vector2>& at) const;
};

class ImplicitPressure {
  public:
    ImplicitPressure(const GridView& grid, Exchange& processes, bool in_fixed_point, int strips);
    // Of cells, for the kernels, in doubles or in fixed point: before particles are scattered; whether that must be done
    // again; once it is done.
    CellPatch* patches() { return of_cells.data(); }
    IntegerRecords& integers() { return rows_of_patches; }
    void begin();
    void finish();
    // Index of a node of the grid in the arrays of solve: these have a node more on each side.
    std::size_t node(std::size_t of_grid) const {
        return (of_grid / (row - 2) + 1) * row + of_grid % (row - 2) + 1;
    }
    std::size_t nodes() const { return at_nodes.size(); }

    // The change x of the mean pressures of cells [Pa] with
    //     p + x = mean over particles of max(p - K_w/n (dt G^T (u + dt A G x) + flow)/V, -largest_tension),
    // u the volume velocity without it, A the answers of nodes, flow that of CompactFlow; and its impulses dt G x [N s].
    // again: in the same step, with other answers. Every process must call it. Throws std::runtime_error without a solution.
    void solve(const PoreWater& water, const GridView& grid, Particles& particles, double dt,
               const std::vector<Vector2>& u, const Answers& answers, bool again,
               std::vector<Vector2>& impulses);
    // Of the cells of the grid, once it is solved for good. Particles come together by the share pic, and by half of the way where
    // some have a cavity that they do not keep.
    void find_after(double pic);
    const ImplicitCell* after() const { return after_of_grid.data(); }
    // ... for the next step's guess.
    void remember(double dt);
    // Of all solutions since it was built.
    long iterations() const { return iterated; }
    // Of these, those whose cells at the largest tension were not the same twice.
    long unsettled() const { return not_settled; }

    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        IntegerRecords::visit(of.rows_of_patches, archive);
        archive.nodes(of.rates);
    }

  private:
    struct Cell {
        std::size_t begin, end;  // of its particles here
        bool counted;            // by this process
        bool cavitates;          // some of its particles, before the step ...
        bool closes;             // ... and do not keep their cavity
        double reach;            // largest force of its patch [m2]
        double V, pressure;      // [m3], mean that bears [Pa]
        double common;           // ... of the particles that do not keep a cavity [Pa]
        double stiffness;        // of its water, K_w/n, mean [Pa]
        // p + x = reached - swelling/compliance, of the particles that bear; compliance 0: none does.
        double compliance, reached;
        double scale;  // 1/sqrt of the diagonal
    };
    struct InCell {
        double V, stiffness, p;  // K_w/n [Pa], p as it goes on below the largest tension
        bool keeps_cavity;
    };
    // The matrix of the system, scaled to a diagonal of 1: never assembled. Of cells one after the other: the scale, nothing
    // where a cell does not bear, and 1 there.
    struct System {
        double dt;
        const Answers& answers;
        std::vector<double> scale = {}, compliance = {}, alone = {};
    };
    void apply(const System& system, const double* x, double* y);
    Eigen::VectorXd solve(const System& system, Eigen::VectorXd b, const Eigen::VectorXd& guess);
    double least_error2(const System& system) const;
    Eigen::VectorXd guess(double dt, bool again) const;
    // Of the grid, the first of the cell itself.
    std::size_t first_node(const PatchedCell& cell) const {
        const auto n = static_cast<std::size_t>(cells_r);
        return cell.patch / n * (n + 1) + cell.patch % n;
    }
    double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
    double largest_size(const Eigen::VectorXd& a) const;
    PatchCall patch_call() const { return {of_cells.data(), patched.data(), cells.size(), row}; }
    // G x at nodes, and G^T v of all cells.
    void push(const double* x, std::vector<Vector2>& at);
    void share(std::vector<Vector2>& at);
    void swell(const std::vector<Vector2>& v, double* of) const;
    void find_particles(const PoreWater& water, const GridView& grid, Particles& particles);
    void find_cells(const PoreWater& water);
    bool find_laws(const PoreWater& water, double dt);
    void find_compact_flow(const Answers& answers, bool again);

    std::size_t row;  // nodes of one in the arrays of solve
    int cells_r;
    Exchange& exchange;
    bool fixed_point;
    IntegerRecords rows_of_patches;
    std::vector<CellPatch> of_cells;
    std::vector<Cell> cells;
    std::vector<PatchedCell> patched;  // ... of each
    std::vector<InCell> particles_of;
    std::vector<std::uint32_t> cell_of;  // of each particle here ...
    std::vector<std::size_t>
        end_of;                // particles of each cell of the grid, one cell after the other
    std::vector<double> sums;  // seven or two of each cell of the grid
    Rounding of_volume, of_stiffness, of_pressure;  // of addends of these
    std::vector<Vector2> at_nodes, moved, shared;   // shared: of the grid
    CompactFlow compact;
    std::vector<double> values, found, swelling, own_swelling, scaled, pushing;
    // What leaves cells beside what nodes show, of it what does by the pressures before, and of that by those that alternate [m3].
    std::vector<double> flow, flow_before, flow_of_alternating;
    std::vector<ImplicitCell> after_of_grid;
    // Of cells, at the first of their nodes: how fast values changed in the last two steps [Pa/s].
    std::vector<Vector2> rates;
    long iterated = 0, not_settled = 0;
};

}  // namespace grit::mpm
