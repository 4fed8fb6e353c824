// SPDX-License-Identifier: GPL-2.0-only
// What a process has of one direction of the grid: the cells that hold its particles, and those that their
// domains reach.
#pragma once

#include <vector>

#include "adapters/mpm/kernel/axis.hpp"

namespace grit::lammps {

struct Slice {
    int first_cell,
        last_cell;  // of particles: in the sub-domain, or as far outside as they may get
    int first_node, last_node;  // that they reach; complete after an exchange
    int axis_last;  // last node of the axis that kernels see: one more, which tells how far apart these are
};

// Slices of the sub-domains between ascending cuts, the first and last of which are the ends of the axis.
// slack: how far particles may leave their sub-domain before they migrate [m]. Throws
// std::invalid_argument where a node would belong to more than two of them.
std::vector<Slice> slices(const mpm::Axis& axis, const std::vector<double>& cuts, double slack);

}  // namespace grit::lammps
