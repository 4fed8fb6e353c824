// SPDX-License-Identifier: BSD-3-Clause
// One direction of a graded tensor-product grid.
#pragma once

#include <vector>

#include "support/kernel.hpp"

namespace grit::mpm {

// What kernels see of an axis. Cell c lies between node[c] and node[c + 1].
struct AxisView {
    const double* node;     // [cells + 1] coordinates, ascending [m]
    const double* inverse;  // [cells] 1 / length [1/m]
    const double* limit;    // [cells] largest half extent of a domain centred there [m]
    const int* bin;         // [bins] cell of the start of equal bins, none longer than a cell
    double bins_per_length;
    int cells, bins;

    // The cell of x; the first or the last one outside.
    GRIT_INLINE int cell_of(double x) const {
        const double b = (x - node[0]) * bins_per_length;
        const int cell = bin[b > 0.0 ? (b < bins - 1 ? static_cast<int>(b) : bins - 1) : 0];
        return cell + (cell + 1 < cells && x >= node[cell + 1] ? 1 : 0);
    }
};

class Axis {
  public:
    explicit Axis(std::vector<double> nodes);
    static Axis uniform(double from, double to, int cells);

    // Cells [begin, end) as a process sees them that shares the grid: with the limits of the whole.
    Axis part(int begin, int end) const;

    AxisView view() const;
    int cells() const { return static_cast<int>(inverse.size()); }
    int nodes() const { return static_cast<int>(node.size()); }
    double operator[](int i) const { return node[static_cast<std::size_t>(i)]; }
    double shortest() const { return shortest_cell; }

  private:
    std::vector<double> node, inverse, limit;
    std::vector<int> bin;
    double shortest_cell = 0.0;
};

}  // namespace grit::mpm
