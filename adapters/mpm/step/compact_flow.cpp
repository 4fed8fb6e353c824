// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/compact_flow.hpp"

#include <algorithm>
#include <cmath>

namespace grit::mpm {

CompactFlow::CompactFlow(const GridView& grid, Exchange& processes, bool in_fixed_point)
    : row(static_cast<std::size_t>(grid.nodes_r())), exchange(processes),
      fixed_point(in_fixed_point),
      at_cells((row + 1) + row * (static_cast<std::size_t>(grid.z.cells) + 1)),
      mixed(at_cells.size() - (row + 1)), around(mixed.size()) {}

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
    nodes = answers;
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
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const Around& at = around[node];
        CompactAnswer& of = nodes[node];
        const double change = at.moduli > 0.0 ? std::clamp(4.0 * of.volume / at.moduli,
                                                           of.to_change, most * of.to_change)
                                              : most * of.to_change;
        of.to_change = at.cells == 4.0 ? change / 16.0 : 0.0;
        of.to_pressure = at.bearing == 4.0 ? of.to_pressure / 16.0 : 0.0;
    }
}

// A cell's four nodes have it at the sides + - - + of their differences. Beside a row's last cell, and before its first
// one, is a node without a cell.
void CompactFlow::find_mixed() {
    const double* here = at_cells.data() + row + 1;
    const double *left = here - 1, *below = at_cells.data() + 1, *below_left = at_cells.data();
    for (std::size_t node = 0; node < mixed.size(); ++node)
        mixed[node] = ((below_left[node] - below[node]) - left[node]) + here[node];
}

void CompactFlow::add(double CompactAnswer::*answer, const double* x, double* out) {
    const Rounding rounding = of_sums([x](std::size_t c) { return std::fabs(x[c]); });
    std::fill(at_cells.begin(), at_cells.end(), 0.0);
    double* here = at_cells.data() + row + 1;
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].counted) here[cells[c].first] = rounding(x[c]);
    find_mixed();
    exchange.sum_nodes(mixed.data(), static_cast<std::ptrdiff_t>(mixed.size()), 1);
    for (std::size_t node = 0; node < mixed.size(); ++node) mixed[node] *= nodes[node].*answer;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const double* at = mixed.data() + cells[c].first;
        out[c] += (at[0] - at[1]) - (at[row] - at[row + 1]);
    }
}

}  // namespace grit::mpm
