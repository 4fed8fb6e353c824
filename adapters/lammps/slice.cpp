// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/slice.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "adapters/mpm/step/text.hpp"

namespace grit::lammps {

std::vector<Slice> slices(const mpm::Axis& axis, const std::vector<double>& cuts, double slack) {
    const mpm::AxisView view = axis.view();
    const int last_cell = axis.cells() - 1;
    std::vector<Slice> out;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        Slice s;
        s.first_cell = i == 0 ? 0 : view.cell_of(cuts[i] - slack);
        s.last_cell = i + 2 == cuts.size() ? last_cell : view.cell_of(cuts[i + 1] + slack);
        // A corner is no farther than in the neighbouring cell.
        s.first_node = std::max(s.first_cell - 1, 0);
        s.last_node = std::min(s.last_cell + 1, last_cell) + 1;
        s.axis_last = std::min(s.last_node + 1, axis.cells());
        out.push_back(s);
    }
    for (std::size_t i = 0; i + 2 < out.size(); ++i)
        if (out[i + 2].first_node <= out[i].last_node)
            throw std::invalid_argument(
                "a sub-domain from " + mpm::text(cuts[i + 1]) + " to " + mpm::text(cuts[i + 2]) +
                " m is too thin for the cells there: particles on both sides of it would meet at a "
                "node; use fewer processors along this direction");
    return out;
}

}  // namespace grit::lammps
