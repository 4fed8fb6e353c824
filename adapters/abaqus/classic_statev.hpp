// SPDX-License-Identifier: BSD-3-Clause
// STATEV in the classic layout (docs/umat.md), for NTENS 6, 4 or 3: what the library wants of it, and
// back. Components that a host does not carry are zero.
#pragma once

#include <grit/classic_layout.h>

#include "adapters/abaqus/umat_arguments.hpp"

namespace grit::abaqus {

// A point as the library takes it.
struct Point {
    double strain_increment[6];
    double stress[6];  // effective
    double state[GRIT_SAND_STATE_SIZE];
    double substep;
    double pore_stress;  // minus the compression-positive excess pore pressure [stress]
};

// Effective stress T = STRESS + p_w I, and the rest.
Point read_point(const UmatArguments& call);

// Effective mean pressure [stress], compression positive.
double mean_pressure(const Point& point);

// Total stress and the state back to the host; start is the point as it was read.
void write_point(const UmatArguments& call, const Point& start, const Point& end);

// STATEV(9) ... STATEV(12): for output only.
void write_output(const UmatArguments& call, const grit_sand& sand, const Point& end,
                  int evaluations);

}  // namespace grit::abaqus
