// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/axis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace grit::mpm {

Axis::Axis(std::vector<double> nodes) : node(std::move(nodes)) {
    if (node.size() < 2) throw std::invalid_argument("an axis needs two nodes at least");
    std::vector<double> length;
    for (std::size_t i = 0; i + 1 < node.size(); ++i) {
        length.push_back(node[i + 1] - node[i]);
        if (!(length.back() > 0.0)) throw std::invalid_argument("nodes of an axis must ascend");
        inverse.push_back(1.0 / length.back());
    }
    // A corner of a domain is never farther than in the neighbouring cell.
    for (std::size_t i = 0; i < length.size(); ++i) {
        const double before = length[i > 0 ? i - 1 : i];
        const double behind = length[std::min(i + 1, length.size() - 1)];
        limit.push_back(std::min({length[i], before, behind}));
    }
    shortest_cell = *std::min_element(length.begin(), length.end());
    const double total = node.back() - node.front();
    const double count = std::ceil(total / shortest_cell) + 1.0;
    if (!(count < 1e8)) throw std::invalid_argument("the cells of an axis differ too much");
    bin.resize(static_cast<std::size_t>(count));
    // Bins begin a little earlier: beside a node its coordinate decides, not the roundoff of a bin, which is another one
    // for a part of the axis.
    const double earlier = 0.25 * (shortest_cell - total / count);
    std::size_t cell = 0;
    for (std::size_t b = 0; b < bin.size(); ++b) {
        const double start = node.front() + total * static_cast<double>(b) / count - earlier;
        while (cell + 1 < length.size() && node[cell + 1] <= start) ++cell;
        bin[b] = static_cast<int>(cell);
    }
}

Axis Axis::uniform(double from, double to, int cells) {
    std::vector<double> nodes;
    for (int i = 0; i <= cells; ++i) nodes.push_back(from + (to - from) * i / cells);
    return Axis(std::move(nodes));
}

Axis Axis::part(int begin, int end) const {
    Axis out({node.begin() + begin, node.begin() + end + 1});
    out.limit.assign(limit.begin() + begin, limit.begin() + end);
    return out;
}

AxisView Axis::view() const {
    const auto bins = static_cast<int>(bin.size());
    return {node.data(),
            inverse.data(),
            limit.data(),
            bin.data(),
            bins / (node.back() - node.front()),
            cells(),
            bins};
}

}  // namespace grit::mpm
