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

  private:
    void add(std::ptrdiff_t cell) {
        char& is = is_near[static_cast<std::size_t>(cell)];
        if (is) return;
        is = 1;
        cells.push_back(cell);
    }

    std::vector<char> is_near;
    std::vector<std::ptrdiff_t> cells;
};

}  // namespace grit::mpm::space
