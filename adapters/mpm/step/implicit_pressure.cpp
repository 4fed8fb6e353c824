// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/implicit_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace grit::mpm {

void Answers::operator()(std::vector<Vector2>& at) const {
    if (held) held->read(at);
    std::vector<double> tied(ties.size());
    for (std::size_t t = 0; t < ties.size(); ++t)
        for (const std::size_t node : ties[t].nodes.nodes)
            tied[t] += at[node][ties[t].nodes.direction];
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = nodes[i](at[i]);
    for (std::size_t t = 0; t < ties.size(); ++t)
        for (const std::size_t node : ties[t].nodes.nodes)
            at[node][ties[t].nodes.direction] = ties[t].per_mass * tied[t];
    if (held) held->hold(at);
}

ImplicitPressure::ImplicitPressure(const GridView& grid, Exchange& processes, bool in_fixed_point,
                                   int strips)
    : row(static_cast<std::size_t>(grid.r.cells) + 3), cells_r(grid.r.cells), exchange(processes),
      fixed_point(in_fixed_point),
      of_cells(static_cast<std::size_t>(grid.r.cells) * static_cast<std::size_t>(grid.z.cells)),
      end_of(of_cells.size()), sums(7 * of_cells.size()),
      at_nodes(row * (static_cast<std::size_t>(grid.z.cells) + 3)), moved(at_nodes.size()),
      compact(grid, processes, in_fixed_point), after_of_grid(of_cells.size()),
      rates((row - 2) * (static_cast<std::size_t>(grid.z.cells) + 1)) {
    if (fixed_point) rows_of_patches.resize(4 * of_cells.size(), strips);
    if (exchange.whole()) shared.resize(rates.size());
}

void ImplicitPressure::begin() {
    std::fill(of_cells.begin(), of_cells.end(), CellPatch{});
    rows_of_patches.begin();
}

void ImplicitPressure::finish() {
    static_assert(sizeof(CellPatch) == 4 * sizeof(NodeRecord));
    if (fixed_point)
        return rows_of_patches.add_to(reinterpret_cast<NodeRecord*>(of_cells.data()), 4, exchange);
    exchange.sum_cells(of_cells.data()->force, static_cast<std::ptrdiff_t>(of_cells.size()), 32);
}

// Sums at nodes that processes share; what lies outside of the grid moves nothing.
void ImplicitPressure::share(std::vector<Vector2>& at) {
    if (shared.empty()) return;
    for (std::size_t i = 0; i < shared.size(); ++i) shared[i] = at[node(i)];
    exchange.sum_nodes(shared.data(), static_cast<std::ptrdiff_t>(shared.size()));
    for (std::size_t i = 0; i < shared.size(); ++i) at[node(i)] = shared[i];
}

void ImplicitPressure::push(const double* x, std::vector<Vector2>& at) {
    PatchCall call = patch_call();
    if (exchange.counted_cells()) {
        for (std::size_t c = 0; c < cells.size(); ++c) pushing[c] = cells[c].counted ? x[c] : 0.0;
        x = pushing.data();
    }
    if (fixed_point) {
        double largest = 0.0;
        for (std::size_t c = 0; c < cells.size(); ++c)
            largest = std::max(largest, std::fabs(x[c]) * cells[c].reach);
        exchange.max(&largest, 1);
        call.rounding = Rounding::of_sums(largest, 5);  // a node has 16 cells
    }
    std::fill(at.begin(), at.end(), Vector2{});
    kernels().push_by_pressures(call, x, at.data()->c);
    share(at);
}

void ImplicitPressure::swell(const std::vector<Vector2>& v, double* of) const {
    kernels().find_swelling(patch_call(), v.data()->c, of);
}

// Those that are here, by cells.
void ImplicitPressure::find_particles(const PoreWater& water, const GridView& grid,
                                      Particles& particles) {
    const ParticleView q = particles.view();
    std::fill(end_of.begin(), end_of.end(), 0);
    cell_of.resize(static_cast<std::size_t>(particles.size()));
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const std::ptrdiff_t cell = grid.cell_of(q[column::r][p], q[column::z][p]);
        cell_of[static_cast<std::size_t>(p)] = static_cast<std::uint32_t>(cell);
        ++end_of[static_cast<std::size_t>(cell)];
    }
    std::size_t begin = 0;
    for (std::size_t& of_cell : end_of) {
        const std::size_t count = of_cell;
        of_cell = begin;
        begin += count;
    }
    particles_of.resize(begin);
    double largest[3] = {};  // of V, V K_w/n and V p
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const double e = water.void_ratio(q, p);
        const InCell in{q[column::V0][p] * q.J(p), water.stiffness(e), q[water.first][p],
                        water.keeps_cavity(e, q[water.first][p])};
        particles_of[end_of[cell_of[static_cast<std::size_t>(p)]]++] = in;
        largest[0] = std::max(largest[0], in.V);
        largest[1] = std::max(largest[1], in.V * in.stiffness);
        largest[2] = std::max(largest[2], in.V * std::max(std::fabs(in.p), water.largest_tension));
    }
    if (!fixed_point) return;
    exchange.max(largest, 3);
    constexpr int room = 12;  // bits for the particles of a cell
    of_volume = Rounding::of_sums(largest[0], room);
    of_stiffness = Rounding::of_sums(largest[1], room);
    of_pressure = Rounding::of_sums(largest[2], room);
}

// Those with particles, of any process.
void ImplicitPressure::find_cells(const PoreWater& water) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t at = 0, p = 0; at < end_of.size(); ++at)
        for (; p < end_of[at]; ++p) {
            const InCell& in = particles_of[p];
            const double V = of_volume(in.V),
                         pressed = of_pressure(in.V * std::max(in.p, -water.largest_tension));
            double* sum = sums.data() + 7 * at;
            sum[0] += V;
            sum[1] += pressed;
            sum[2] += of_stiffness(in.V * in.stiffness);
            const double cavity = in.p <= -water.largest_tension ? 1.0 : 0.0;
            sum[3] += cavity;
            if (in.keeps_cavity) continue;
            sum[4] += V;
            sum[5] += pressed;
            sum[6] += cavity;
        }
    exchange.sum_cells(sums.data(), static_cast<std::ptrdiff_t>(end_of.size()), 7);
    const std::uint8_t* mine = exchange.counted_cells();
    cells.clear();
    patched.clear();
    for (std::size_t at = 0; at < end_of.size(); ++at) {
        const double* sum = sums.data() + 7 * at;
        const double V = sum[0];
        if (V == 0.0) continue;
        const std::size_t of_row = static_cast<std::size_t>(cells_r);
        const double* force = of_cells[at].force;
        double reach = 0.0;
        for (int k = 0; k < 32 && fixed_point; ++k) reach = std::max(reach, std::fabs(force[k]));
        patched.push_back({at, at / of_row * row + at % of_row});
        cells.push_back({.begin = at == 0 ? 0 : end_of[at - 1],
                         .end = end_of[at],
                         .counted = !mine || mine[at],
                         .cavitates = sum[3] > 0.0,
                         .closes = sum[6] > 0.0,
                         .reach = reach,
                         .V = V,
                         .pressure = sum[1] / V,
                         .common = sum[4] > 0.0 ? sum[5] / sum[4] : 0.0,
                         .stiffness = sum[2] / V,
                         .compliance = 0.0,
                         .reached = 0.0,
                         .scale = 1.0});
    }
    for (std::vector<double>* of_all : {&values, &swelling, &own_swelling, &scaled, &pushing})
        of_all->resize(cells.size());
}

// Of the particles that bear at the end of a step in which cells swell as they do. True: not those of before.
bool ImplicitPressure::find_laws(const PoreWater& water, double dt) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Cell& cell = cells[c];
        const double strain = dt * swelling[c] / cell.V;
        double &stiffness = sums[2 * patched[c].patch], &reached = sums[2 * patched[c].patch + 1];
        for (std::size_t p = cell.begin; p < cell.end; ++p) {
            const InCell& in = particles_of[p];
            const bool bears = in.p - in.stiffness * strain > -water.largest_tension;
            reached += of_pressure(in.V * (bears ? in.p : -water.largest_tension));
            if (bears) stiffness += of_stiffness(in.V * in.stiffness);
        }
    }
    exchange.sum_cells(sums.data(), static_cast<std::ptrdiff_t>(end_of.size()), 2);
    double changed = 0.0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        Cell& cell = cells[c];
        const double stiffness = sums[2 * patched[c].patch];
        const double compliance = stiffness > 0.0 ? cell.V * cell.V / stiffness : 0.0;
        if (compliance != cell.compliance) changed = 1.0;
        cell.compliance = compliance;
        cell.reached = sums[2 * patched[c].patch + 1] / cell.V;
    }
    exchange.max(&changed, 1);
    return changed > 0.0;
}

void ImplicitPressure::apply(const System& system, const double* x, double* y) {
    for (std::size_t c = 0; c < cells.size(); ++c) scaled[c] = system.scale[c] * x[c];
    push(scaled.data(), at_nodes);
    system.answers(at_nodes);
    swell(at_nodes, y);
    for (std::size_t c = 0; c < cells.size(); ++c) y[c] *= system.dt * system.dt;
    compact.add_by_changes(scaled.data(), y);
    for (std::size_t c = 0; c < cells.size(); ++c)
        y[c] = system.scale[c] * (system.compliance[c] * scaled[c] + y[c]) + system.alone[c] * x[c];
}

// Of cells, each once.
double ImplicitPressure::dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    if (!fixed_point && shared.empty()) return a.dot(b);
    std::array<Total, 1> sum;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const auto i = static_cast<Eigen::Index>(c);
        if (cells[c].counted) sum[0].add(a[i] * b[i], fixed_point);
    }
    exchange.sum(sum, fixed_point);
    return sum[0].value();
}

// Of those that are counted: at the margin of a process's grid, where it has no particles, its numbers of a cell are not those
// of all.
double ImplicitPressure::largest_size(const Eigen::VectorXd& a) const {
    double largest = 0.0;
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].counted)
            largest = std::max(largest, std::fabs(a[static_cast<Eigen::Index>(c)]));
    exchange.max(&largest, 1);
    return largest;
}

// What may be left in any case, in a square: a share of what water is compressed by, so that pressures are at most that share
// of themselves off (all of them together).
double ImplicitPressure::least_error2(const System& system) const {
    constexpr double share = 1e-6;
    Eigen::VectorXd compressed(static_cast<Eigen::Index>(cells.size()));
    for (std::size_t c = 0; c < cells.size(); ++c)
        compressed[static_cast<Eigen::Index>(c)] =
            system.scale[c] * system.compliance[c] * cells[c].pressure;
    const double largest = largest_size(compressed);
    if (!(largest > 0.0)) return 0.0;
    const double unit = std::ldexp(1.0, std::ilogb(largest));
    compressed /= unit;
    return share * share * unit * unit * dot(compressed, compressed);
}

// What the last two steps lead to, or what is known of this one, as solve has it.
Eigen::VectorXd ImplicitPressure::guess(double dt, bool again) const {
    Eigen::VectorXd out(static_cast<Eigen::Index>(cells.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Vector2& rate = rates[first_node(patched[c])];
        const double now = again ? found[c] : dt * (2.0 * rate[0] - rate[1]);
        out[static_cast<Eigen::Index>(c)] = cells[c].compliance > 0.0 ? now / cells[c].scale : 0.0;
    }
    return out;
}

// So that every process has those of all its nodes, wherever the grid will be cut.
void ImplicitPressure::remember(double dt) {
    std::vector<Vector2> now(rates.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].counted) {
            const std::size_t node = first_node(patched[c]);
            now[node] = {values[c] / dt, rates[node][0]};
        }
    if (!shared.empty()) exchange.sum_nodes(now.data(), static_cast<std::ptrdiff_t>(now.size()));
    rates.swap(now);
}

// Conjugate gradients. Processes that share a cell have the same numbers of it; products are those of all.
Eigen::VectorXd ImplicitPressure::solve(const System& system, Eigen::VectorXd b,
                                        const Eigen::VectorXd& guess) {
    constexpr double tolerance = 1e-5;
    constexpr int most_iterations = 2000;
    // So that products are neither too large nor too small for integers.
    const double largest = largest_size(b);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    if (!(largest > 0.0)) return x;
    const double unit = std::ldexp(1.0, std::ilogb(largest));
    b /= unit;
    Eigen::VectorXd product(b.size());
    const double load2 = dot(b, b);
    const double enough2 =
        std::max(tolerance * tolerance * load2, least_error2(system) / (unit * unit));
    double left2 = load2;
    // From the guess, if that is nearer than nothing.
    const Eigen::VectorXd x_0 = guess / unit;
    apply(system, x_0.data(), product.data());
    const Eigen::VectorXd left = b - product;
    if (const double of_guess = dot(left, left); of_guess < load2) {
        x = x_0;
        b = left;
        left2 = of_guess;
    }
    Eigen::VectorXd direction = b;
    int i = 0;
    for (; i < most_iterations && std::isfinite(left2); ++i) {
        if (left2 < enough2) return unit * x;
        ++iterated;
        apply(system, direction.data(), product.data());
        const double along = left2 / dot(direction, product), before = left2;
        x += along * direction;
        b -= along * product;
        left2 = dot(b, b);
        direction = b + left2 / before * direction;
    }
    char text[160];
    std::snprintf(text, sizeof text,
                  "its implicit pressure was not found in %d iterations: what is left is %g of the "
                  "load, the limit %g",
                  i, std::sqrt(left2 / load2), tolerance);
    throw std::runtime_error(text);
}

// By the pressures there were. again: with other cells that bear, which those that alternate do not ask for.
void ImplicitPressure::find_compact_flow(const Answers& answers, bool again) {
    std::vector<CompactFlow::Cell> of_compact;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        of_compact.push_back({static_cast<std::uint32_t>(first_node(patched[c])),
                              cells[c].compliance > 0.0, cells[c].counted, cells[c].cavitates,
                              cells[c].V / cells[c].stiffness});
        scaled[c] = cells[c].pressure;
    }
    compact.begin(of_compact, answers.compact);
    if (!again) {
        flow_of_alternating.assign(cells.size(), 0.0);
        compact.add_of_alternating(scaled.data(), flow_of_alternating.data());
    }
    flow_before = flow_of_alternating;
    compact.add_by_pressures(scaled.data(), flow_before.data());
}

void ImplicitPressure::solve(const PoreWater& water, const GridView& grid, Particles& particles,
                             double dt, const std::vector<Vector2>& u, const Answers& answers,
                             bool again, std::vector<Vector2>& impulses) {
    constexpr int most_changes = 10;
    if (again) {
        found = values;
    } else {
        find_particles(water, grid, particles);
        find_cells(water);
    }
    kernels().find_own_swelling(patch_call(), answers.nodes.data(), own_swelling.data());
    std::fill(swelling.begin(), swelling.end(), 0.0);
    find_laws(water, dt);
    System system{dt, answers};
    for (std::vector<double>* of : {&system.scale, &system.compliance, &system.alone})
        of->resize(cells.size());
    Eigen::VectorXd b(static_cast<Eigen::Index>(cells.size()));
    // u + dt A G of the values, of which G is left in impulses, and the flow beside it.
    const auto move = [&] {
        double any = std::any_of(values.begin(), values.end(), [](double x) { return x != 0.0; });
        exchange.max(&any, 1);
        flow = flow_before;
        if (any > 0.0) {
            push(values.data(), impulses);
            moved = impulses;
            answers(moved);
            for (std::size_t i = 0; i < moved.size(); ++i)
                moved[i] = {u[i][0] + dt * moved[i][0], u[i][1] + dt * moved[i][1]};
            compact.add_by_changes(values.data(), flow.data());
        } else {
            std::fill(impulses.begin(), impulses.end(), Vector2{});
        }
        swell(any > 0.0 ? moved : u, swelling.data());
        for (std::size_t c = 0; c < cells.size(); ++c) swelling[c] += flow[c] / dt;
    };
    bool settled = false;
    for (int change = 0; change < most_changes && !settled; ++change) {
        // Cells that do not bear go to the largest tension, which the others see as a load.
        for (std::size_t c = 0; c < cells.size(); ++c)
            values[c] = cells[c].compliance > 0.0 ? 0.0 : cells[c].reached - cells[c].pressure;
        find_compact_flow(answers, again || change > 0);
        move();
        for (std::size_t c = 0; c < cells.size(); ++c) {
            Cell& cell = cells[c];
            const double diagonal = cell.compliance + compact.own(c) + dt * dt * own_swelling[c];
            cell.scale = diagonal > 0.0 ? 1.0 / std::sqrt(diagonal) : 1.0;
            const bool bears = cell.compliance > 0.0;
            system.scale[c] = bears ? cell.scale : 0.0;
            system.compliance[c] = cell.compliance;
            system.alone[c] = bears ? 0.0 : 1.0;
            b[static_cast<Eigen::Index>(c)] =
                bears ? cell.scale *
                            (cell.compliance * (cell.reached - cell.pressure) - dt * swelling[c])
                      : 0.0;
        }
        const Eigen::VectorXd x = solve(system, b, guess(dt, again));
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (cells[c].compliance > 0.0)
                values[c] = cells[c].scale * x[static_cast<Eigen::Index>(c)];
        move();
        settled = !find_laws(water, dt);
    }
    if (!settled) ++not_settled;
    for (Vector2& J : impulses) J = {dt * J[0], dt * J[1]};
}

void ImplicitPressure::find_after(double pic) {
    // Without pic no particle goes beyond the mean by it, unless its K_w/n is twice that of the cell.
    constexpr double where_some_cavitate = 0.5;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Cell& cell = cells[c];
        after_of_grid[patched[c].patch] = {flow[c], cell.common, cell.stiffness,
                                           cell.closes ? pic + (1.0 - pic) * where_some_cavitate
                                                       : pic};
    }
}

}  // namespace grit::mpm
