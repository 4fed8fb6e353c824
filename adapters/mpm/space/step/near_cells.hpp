// SPDX-License-Identifier: BSD-3-Clause
// Where two bodies may touch in space: the nodes that both of them reach, and the cells around these.
#pragma once

#include <algorithm>
#include <vector>

#include "adapters/mpm/space/step/model.hpp"

namespace grit::mpm::space {

// Nodes that both bodies reach, ascending.
inline void find_shared_nodes(const Part& a, const Part& b, std::vector<std::ptrdiff_t>& nodes) {
    nodes.clear();
    for (std::size_t node = 0; node < a.records.size(); ++node)
        if (a.records[node][record::m] > 0.0 && b.records[node][record::m] > 0.0)
            nodes.push_back(static_cast<std::ptrdiff_t>(node));
}

class NearCells {
  public:
    explicit NearCells(std::size_t count) : is_near(count) {}

    // A domain reaches into the neighbouring cells and to their nodes.
    void find(const GridView& grid, const std::vector<std::ptrdiff_t>& nodes) {
        for (const std::ptrdiff_t cell : cells) is_near[static_cast<std::size_t>(cell)] = 0;
        cells.clear();
        for (const std::ptrdiff_t node : nodes) {
            int first[3], last[3];
            std::ptrdiff_t rest = node;
            for (int d = 0; d < 3; ++d) {
                const auto i = static_cast<int>(rest % grid.nodes(d));
                rest /= grid.nodes(d);
                first[d] = std::max(i - 2, 0);
                last[d] = std::min(i + 1, grid.axis[d].cells - 1);
            }
            for (int k = first[2]; k <= last[2]; ++k)
                for (int j = first[1]; j <= last[1]; ++j)
                    for (int i = first[0]; i <= last[0]; ++i) add(grid.cell(i, j, k));
        }
    }
    bool has(std::ptrdiff_t cell) const { return is_near[static_cast<std::size_t>(cell)] != 0; }
    // Nodes that a domain in one of these cells may reach: of these cells and their neighbours, in no order.
    template <class Take> void each_reached(const GridView& grid, const Take& take) {
        reached.clear();
        is_reached.resize(static_cast<std::size_t>(grid.nodes(0) * grid.nodes(1) * grid.nodes(2)));
        for (const std::ptrdiff_t cell : cells) {
            std::ptrdiff_t rest = cell, first[3], last[3];
            for (int d = 0; d < 3; ++d) {
                const std::ptrdiff_t i = rest % grid.axis[d].cells;
                rest /= grid.axis[d].cells;
                first[d] = std::max<std::ptrdiff_t>(i - 1, 0);
                last[d] = std::min<std::ptrdiff_t>(i + 2, grid.axis[d].cells);
            }
            for (std::ptrdiff_t k = first[2]; k <= last[2]; ++k)
                for (std::ptrdiff_t j = first[1]; j <= last[1]; ++j)
                    for (std::ptrdiff_t i = first[0]; i <= last[0]; ++i) {
                        const std::ptrdiff_t node = i + j * grid.step(1) + k * grid.step(2);
                        char& is = is_reached[static_cast<std::size_t>(node)];
                        if (!is) reached.push_back(node);
                        is = 1;
                    }
        }
        for (const std::ptrdiff_t node : reached) {
            is_reached[static_cast<std::size_t>(node)] = 0;
            take(node);
        }
    }

  private:
    void add(std::ptrdiff_t cell) {
        char& is = is_near[static_cast<std::size_t>(cell)];
        if (is) return;
        is = 1;
        cells.push_back(cell);
    }

    std::vector<char> is_near;     // [cells of the grid]
    std::vector<char> is_reached;  // [nodes] 0 between calls
    std::vector<std::ptrdiff_t> cells, reached;
};

}  // namespace grit::mpm::space
