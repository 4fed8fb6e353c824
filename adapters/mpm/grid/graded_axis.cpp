// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/grid/graded_axis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grit::mpm {

int cells_for(double length, double smallest, double growth) {
    const double ratio = std::max(growth, 1.0 / growth), cells = length / smallest;
    // h (1 + q + ... + q^(n-1)) = length
    const double n =
        ratio - 1.0 < 1e-9 ? cells : std::log1p(cells * (ratio - 1.0)) / std::log(ratio);
    return static_cast<int>(std::clamp(std::round(n), 1.0, 1e6));
}

Axis make_axis(const AxisPlan& plan) {
    std::vector<double> nodes{plan.from};
    for (const AxisSegment& segment : plan.segments) {
        const double begin = nodes.back(), length = segment.to - begin;
        double sum = 0.0;
        for (int i = 0; i < segment.cells; ++i) sum += std::pow(segment.growth, i);
        double done = 0.0;
        for (int i = 0; i + 1 < segment.cells; ++i) {
            done += std::pow(segment.growth, i);
            nodes.push_back(begin + length * (done / sum));
        }
        nodes.push_back(segment.to);
    }
    return Axis(std::move(nodes));
}

}  // namespace grit::mpm
