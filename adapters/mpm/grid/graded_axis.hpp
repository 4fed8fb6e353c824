// SPDX-License-Identifier: BSD-3-Clause
// An axis of segments, in each of which the cells grow by a constant ratio.
#pragma once

#include <vector>

#include "adapters/mpm/kernel/axis.hpp"

namespace grit::mpm {

struct AxisSegment {
    double to;            // where it ends [m]
    int cells;            // >= 1
    double growth = 1.0;  // length of a cell / length of the one before [-]
};

struct AxisPlan {
    double from = 0.0;  // [m]
    std::vector<AxisSegment> segments;
    double to() const { return segments.back().to; }
};

// How many cells fill a length so that the smallest has about this size.
int cells_for(double length, double smallest, double growth);

// Throws std::invalid_argument for what does not ascend.
Axis make_axis(const AxisPlan& plan);

}  // namespace grit::mpm
