// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/implicit_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/IterativeLinearSolvers>

namespace grit::mpm {

// The matrix of the system, scaled to a diagonal of 1, as Eigen's solver takes it: never assembled. Cells that do not
// bear have no row.
class PressureOperator;

}  // namespace grit::mpm

namespace Eigen::internal {
template <> struct traits<grit::mpm::PressureOperator> : traits<SparseMatrix<double>> {};
}  // namespace Eigen::internal

namespace grit::mpm {

class PressureOperator : public Eigen::EigenBase<PressureOperator> {
  public:
    using Scalar = double;
    using RealScalar = double;
    using StorageIndex = int;
    enum {
        ColsAtCompileTime = Eigen::Dynamic,
        MaxColsAtCompileTime = Eigen::Dynamic,
        IsRowMajor = false
    };

    PressureOperator(ImplicitPressure& of, double step, const std::vector<NodeAnswer>& of_nodes)
        : pressure(of), dt(step), answers(of_nodes), scaled(of.cells.size()) {}
    Eigen::Index rows() const { return static_cast<Eigen::Index>(pressure.cells.size()); }
    Eigen::Index cols() const { return rows(); }
    template <class Rhs>
    Eigen::Product<PressureOperator, Rhs, Eigen::AliasFreeProduct>
    operator*(const Eigen::MatrixBase<Rhs>& x) const {
        return {*this, x.derived()};
    }

    void apply(const double* x, double* y) const {
        const std::size_t count = pressure.cells.size();
        for (std::size_t c = 0; c < count; ++c)
            scaled[c] = pressure.cells[c].compliance > 0.0 ? pressure.cells[c].scale * x[c] : 0.0;
        pressure.push(scaled.data(), pressure.at_nodes);
        for (std::size_t i = 0; i < answers.size(); ++i)
            pressure.at_nodes[i] = answers[i](pressure.at_nodes[i]);
        pressure.swell(pressure.at_nodes, y);
        for (std::size_t c = 0; c < count; ++c) {
            const ImplicitPressure::Cell& cell = pressure.cells[c];
            y[c] = cell.compliance > 0.0
                       ? cell.scale * (cell.compliance * scaled[c] + dt * dt * y[c])
                       : x[c];
        }
    }

  private:
    ImplicitPressure& pressure;
    double dt;
    const std::vector<NodeAnswer>& answers;
    mutable std::vector<double> scaled;
};

}  // namespace grit::mpm

namespace Eigen::internal {
template <class Rhs>
struct generic_product_impl<grit::mpm::PressureOperator, Rhs, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<grit::mpm::PressureOperator, Rhs,
                                generic_product_impl<grit::mpm::PressureOperator, Rhs>> {
    template <class To>
    static void scaleAndAddTo(To& to, const grit::mpm::PressureOperator& of, const Rhs& x,
                              const double& factor) {
        const Ref<const VectorXd> in(x);
        VectorXd out(in.size());
        of.apply(in.data(), out.data());
        to += factor * out;
    }
};
}  // namespace Eigen::internal

namespace grit::mpm {

ImplicitPressure::ImplicitPressure(const GridView& grid)
    : row(static_cast<std::size_t>(grid.r.cells) + 3), cells_r(grid.r.cells),
      of_cells(static_cast<std::size_t>(grid.r.cells) * static_cast<std::size_t>(grid.z.cells)),
      count_of(of_cells.size()), at_nodes(row * (static_cast<std::size_t>(grid.z.cells) + 3)),
      moved(at_nodes.size()) {}

void ImplicitPressure::clear() { std::fill(of_cells.begin(), of_cells.end(), CellPatch{}); }

void ImplicitPressure::push(const double* x, std::vector<Vector2>& at) const {
    std::fill(at.begin(), at.end(), Vector2{});
    kernels().push_by_pressures(all(), x, at.data()->c);
}

void ImplicitPressure::swell(const std::vector<Vector2>& v, double* of) const {
    kernels().find_swelling(all(), v.data()->c, of);
}

void ImplicitPressure::find_cells(const PoreWater& water, const GridView& grid,
                                  Particles& particles) {
    const ParticleView q = particles.view();
    const auto cell_of = [&](std::ptrdiff_t p) {
        return static_cast<std::size_t>(grid.cell_of(q[column::r][p], q[column::z][p]));
    };
    std::fill(count_of.begin(), count_of.end(), 0);
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) ++count_of[cell_of(p)];
    cells.clear();
    patched.clear();
    std::size_t begin = 0;
    for (std::size_t at = 0; at < count_of.size(); ++at) {
        const std::size_t count = count_of[at], of_row = static_cast<std::size_t>(cells_r);
        count_of[at] = begin;
        if (count == 0) continue;
        patched.push_back({at, at / of_row * row + at % of_row});
        cells.push_back({.begin = begin,
                         .end = begin + count,
                         .V = 0.0,
                         .pressure = 0.0,
                         .compliance = 0.0,
                         .reached = 0.0,
                         .scale = 1.0});
        begin += count;
    }
    particles_of.resize(begin);
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
        particles_of[count_of[cell_of(p)]++] = {
            q[column::V0][p] * q.J(p),
            water.bulk_modulus / PoreWater::porosity_of(water.void_ratio(q, p)), q[water.first][p]};
    for (Cell& cell : cells) {
        for (std::size_t p = cell.begin; p < cell.end; ++p) {
            const InCell& in = particles_of[p];
            cell.V += in.V;
            cell.pressure += in.V * std::max(in.p, -water.largest_tension);
        }
        cell.pressure /= cell.V;
        find_law(water, cell, 0.0);
    }
}

// Of the particles that bear at the end of a step in which the cell swells by this [m3]. True: not those of before.
bool ImplicitPressure::find_law(const PoreWater& water, Cell& cell, double swells) const {
    double stiffness = 0.0, reached = 0.0;
    for (std::size_t p = cell.begin; p < cell.end; ++p) {
        const InCell& in = particles_of[p];
        const bool bears = in.p - in.stiffness * swells / cell.V > -water.largest_tension;
        reached += in.V * (bears ? in.p : -water.largest_tension);
        if (bears) stiffness += in.V * in.stiffness;
    }
    const double compliance = stiffness > 0.0 ? cell.V * cell.V / stiffness : 0.0;
    const bool changed = compliance != cell.compliance;
    cell.compliance = compliance;
    cell.reached = reached / cell.V;
    return changed;
}

void ImplicitPressure::solve(const PoreWater& water, const GridView& grid, Particles& particles,
                             double dt, const std::vector<Vector2>& u,
                             const std::vector<NodeAnswer>& answers,
                             std::vector<Vector2>& impulses) {
    constexpr int most_changes = 10, most_iterations = 2000;
    find_cells(water, grid, particles);
    values.resize(cells.size());
    swelling.resize(cells.size());
    const PressureOperator matrix(*this, dt, answers);
    Eigen::VectorXd b(static_cast<Eigen::Index>(cells.size()));
    // u + dt A G of the values.
    const auto move = [&] {
        push(values.data(), moved);
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const Vector2 v = answers[i](moved[i]);
            moved[i] = {u[i][0] + dt * v[0], u[i][1] + dt * v[1]};
        }
        swell(moved, swelling.data());
    };
    for (int change = 0; change < most_changes; ++change) {
        // Cells that do not bear go to the largest tension, which the others see as a load.
        for (std::size_t c = 0; c < cells.size(); ++c)
            values[c] = cells[c].compliance > 0.0 ? 0.0 : cells[c].reached - cells[c].pressure;
        move();
        for (std::size_t c = 0; c < cells.size(); ++c) {
            Cell& cell = cells[c];
            const double* force = of_cells[patched[c].patch].force;
            double diagonal = cell.compliance;
            for (std::size_t k = 0; k < 16; ++k) {
                const Vector2 f{force[2 * k], force[2 * k + 1]};
                const Vector2 v = answers[patched[c].first + k / 4 * row + k % 4](f);
                diagonal += dt * dt * (f[0] * v[0] + f[1] * v[1]);
            }
            cell.scale = diagonal > 0.0 ? 1.0 / std::sqrt(diagonal) : 1.0;
            b[static_cast<Eigen::Index>(c)] =
                cell.compliance > 0.0
                    ? cell.scale *
                          (cell.compliance * (cell.reached - cell.pressure) - dt * swelling[c])
                    : 0.0;
        }
        Eigen::ConjugateGradient<PressureOperator, Eigen::Lower | Eigen::Upper,
                                 Eigen::IdentityPreconditioner>
            solver;
        solver.setTolerance(1e-5);
        solver.setMaxIterations(most_iterations);
        solver.compute(matrix);
        const Eigen::VectorXd x = solver.solve(b);
        if (solver.info() != Eigen::Success)
            throw std::runtime_error(
                "pore pressure: not found after " + std::to_string(solver.iterations()) +
                " iterations, what is left is " + std::to_string(solver.error()) + " of the load");
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (cells[c].compliance > 0.0)
                values[c] = cells[c].scale * x[static_cast<Eigen::Index>(c)];
        move();
        bool changed = false;
        for (std::size_t c = 0; c < cells.size(); ++c)
            changed |= find_law(water, cells[c], dt * swelling[c]);
        if (!changed) break;
    }
    push(values.data(), impulses);
    for (Vector2& J : impulses) J = {dt * J[0], dt * J[1]};
}

}  // namespace grit::mpm
