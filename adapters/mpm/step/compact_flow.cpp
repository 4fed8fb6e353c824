// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/compact_flow.hpp"

#include <algorithm>
#include <cmath>

namespace grit::mpm {

CompactFlow::CompactFlow(const GridView& grid, Exchange& processes, bool in_fixed_point)
    : row(static_cast<std::size_t>(grid.nodes_r())), exchange(processes),
      fixed_point(in_fixed_point),
      at_cells((row + 1) + row * (static_cast<std::size_t>(grid.z.cells) + 1)),
      mixed(at_cells.size()), around(mixed.size() - (row + 1)) {
    for (std::vector<double>* of_grid : {&scale, &counted_scale, &rest, &right, &found, &change})
        of_grid->resize(around.size());
}

template <class SizeOf> Rounding CompactFlow::of_sums(const SizeOf& size_of) {
    if (!fixed_point) return {};
    double largest = 0.0;
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].counted) largest = std::max(largest, size_of(c));
    exchange.max(&largest, 1);
    return Rounding::of_sums(largest, 3);  // a node has four cells
}

void CompactFlow::begin(const std::vector<Cell>& now, const std::vector<CompactAnswer>& answers) {
    cells = now;
    to_change.resize(answers.size());
    to_pressure.resize(answers.size());
    const Rounding rounding = of_sums([this](std::size_t c) { return cells[c].skeleton; });
    std::fill(around.begin(), around.end(), Around{});
    for (const Cell& cell : cells)
        if (cell.counted)
            for (const std::size_t node : {std::size_t{0}, std::size_t{1}, row, row + 1}) {
                Around& at = around[cell.first + node];
                at.cells += 1.0;
                at.bearing += cell.bears ? 1.0 : 0.0;
                at.moduli += rounding(cell.skeleton);
            }
    exchange.sum_nodes(&around.data()->cells, static_cast<std::ptrdiff_t>(around.size()), 3);
    // Of a checkerboard of 1 Pa the mixed differences are 4 Pa, of which each of four nodes takes a share.
    constexpr double most = 100.0;
    for (std::size_t node = 0; node < answers.size(); ++node) {
        const Around& at = around[node];
        const CompactAnswer& of = answers[node];
        const double by_change = at.moduli > 0.0 ? std::clamp(4.0 * of.volume / at.moduli,
                                                              of.to_change, most * of.to_change)
                                                 : most * of.to_change;
        to_change[node] = at.cells == 4.0 ? by_change / 16.0 : 0.0;
        to_pressure[node] = at.bearing == 4.0 ? of.to_pressure / 16.0 : 0.0;
    }
}

// A cell's four nodes have it at the sides + - - + of their differences. Beside a row's last cell, and before its first
// one, is a node without a cell.
void CompactFlow::find_mixed(const std::vector<double>& answer) {
    const double* here = first_cell();
    const double *left = here - 1, *below = at_cells.data() + 1, *below_left = at_cells.data();
    double* of = mixed.data();
    const std::size_t nodes = answer.size();
    for (std::size_t node = 0; node < nodes; ++node)
        of[node] = ((below_left[node] - below[node]) - left[node]) + here[node];
    exchange.sum_nodes(of, static_cast<std::ptrdiff_t>(nodes), 1);
    for (std::size_t node = 0; node < nodes; ++node) of[node] *= answer[node];
}

void CompactFlow::add(const std::vector<double>& answer, const double* x, double* out) {
    const Rounding rounding = of_sums([x](std::size_t c) { return std::fabs(x[c]); });
    std::fill(at_cells.begin(), at_cells.end(), 0.0);
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].counted) first_cell()[cells[c].first] = rounding(x[c]);
    find_mixed(answer);
    for (std::size_t c = 0; c < cells.size(); ++c) out[c] += leaving(cells[c].first);
}

void CompactFlow::scale_by(const double* of_cells) {
    for (std::vector<double>* of_grid : {&scale, &counted_scale, &rest, &right})
        std::fill(of_grid->begin(), of_grid->end(), 0.0);
    largest_scale = 0.0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const std::size_t node = cells[c].first;
        scale[node] = of_cells[c];
        counted_scale[node] = cells[c].counted ? of_cells[c] : 0.0;
        rest[node] = 1.0 - own(c) * of_cells[c] * of_cells[c];
        largest_scale = std::max(largest_scale, counted_scale[node]);
    }
    if (fixed_point) exchange.max(&largest_scale, 1);
}

void CompactFlow::precondition(const double* r, double size, double* z) {
    constexpr int degree = 4;
    constexpr double least = 0.25, largest = 4.0;  // eigenvalues
    constexpr double middle = 0.5 * (largest + least), half = 0.5 * (largest - least);
    // What is found on the way are polynomials times r that are below 3 for every eigenvalue up to the largest.
    const Rounding rounding =
        fixed_point ? Rounding::of_sums(3.0 * size * largest_scale, 3) : Rounding{};
    for (std::size_t c = 0; c < cells.size(); ++c) right[cells[c].first] = r[c];
    const std::size_t nodes = right.size();
    for (std::size_t node = 0; node < nodes; ++node)
        found[node] = change[node] = right[node] / middle;
    double rate = half / middle;
    for (int k = 1; k < degree; ++k) {
        double* here = first_cell();
        for (std::size_t node = 0; node < nodes; ++node)
            here[node] = rounding(counted_scale[node] * found[node]);
        find_mixed(to_change);
        const double before = rate;
        rate = 1.0 / (2.0 * middle / half - before);
        for (std::size_t node = 0; node < nodes; ++node) {
            const double product = rest[node] * found[node] + scale[node] * leaving(node);
            change[node] =
                rate * before * change[node] + 2.0 * rate / half * (right[node] - product);
        }
        for (std::size_t node = 0; node < nodes; ++node) found[node] += change[node];
    }
    for (std::size_t c = 0; c < cells.size(); ++c) z[c] = found[cells[c].first];
}

}  // namespace grit::mpm
