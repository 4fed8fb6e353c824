// SPDX-License-Identifier: BSD-3-Clause
// From which value to which one colours go.
#pragma once

#include <string>
#include <vector>

namespace cli {

struct ColourRange {
    double low, high;
    std::string beyond = {};  // "-3 ... 2e+04" where values lie outside; empty: none do
};

// Of finite values, a little apart at least. A few that are far off do not take the colours from all
// others: where 1 % of the values are more than half of the range, they are left outside.
ColourRange colour_range(std::vector<double> values);

}  // namespace cli
