// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/compact_flow.hpp"

#include <algorithm>
#include <cmath>

namespace grit::mpm {

CompactFlow::CompactFlow(const GridView& grid, Exchange& processes, bool in_fixed_point)
    : row(static_cast<std::size_t>(grid.nodes_r())), exchange(processes),
      fixed_point(in_fixed_point), mixed(row * (static_cast<std::size_t>(grid.z.cells) + 1)) {}

// A cell's four nodes have it at the sides + - - + of their differences.
void CompactFlow::begin(const std::vector<Cell>& now, const std::vector<CompactAnswer>& answers) {
    cells = now;
    nodes = answers;
    std::fill(mixed.begin(), mixed.end(), Vector2{});
    for (const Cell& cell : cells)
        if (cell.bears && cell.counted)
            for (const std::size_t node : {std::size_t{0}, std::size_t{1}, row, row + 1})
                mixed[cell.first + node][0] += 1.0;
    exchange.sum_nodes(mixed.data(), static_cast<std::ptrdiff_t>(mixed.size()));
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (mixed[node][0] != 4.0) nodes[node] = {};
}

void CompactFlow::add(double CompactAnswer::*answer, const double* x, double* out) {
    Rounding rounding;
    if (fixed_point) {
        double largest = 0.0;
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (cells[c].counted) largest = std::max(largest, std::fabs(x[c]));
        exchange.max(&largest, 1);
        rounding = Rounding::of_sums(largest, 3);  // a node has four cells
    }
    std::fill(mixed.begin(), mixed.end(), Vector2{});
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (!cells[c].counted) continue;
        const double share = rounding(x[c]);
        Vector2* at = mixed.data() + cells[c].first;
        at[0][0] += share;
        at[1][0] -= share;
        at[row][0] -= share;
        at[row + 1][0] += share;
    }
    exchange.sum_nodes(mixed.data(), static_cast<std::ptrdiff_t>(mixed.size()));
    // Of a checkerboard of 1 Pa the mixed differences are 4 Pa, of which each of four nodes takes a share.
    for (std::size_t node = 0; node < mixed.size(); ++node)
        mixed[node][0] *= nodes[node].*answer / 16.0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Vector2* at = mixed.data() + cells[c].first;
        out[c] += (at[0][0] - at[1][0]) - (at[row][0] - at[row + 1][0]);
    }
}

}  // namespace grit::mpm
