// SPDX-License-Identifier: BSD-3-Clause
// A small chart as inline SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cli {

using ChartPoints = std::vector<std::pair<double, double>>;

struct Chart {
    std::string title;
    std::string x_label, y_label;  // marked up as those of cli/plot/axis.hpp
    bool logarithmic = false;      // x, which is positive then
    ChartPoints points;            // measured
    ChartPoints line;              // computed
    ChartPoints lowest, highest;   // inner band, along one x
    ChartPoints lowest_outer, highest_outer;

    std::string svg() const;
};

}  // namespace cli
