// SPDX-License-Identifier: BSD-3-Clause
// What the calls of UMAT and VUMAT have in common: sizes, and how points lie in memory.
#pragma once

#include "adapters/abaqus/point.hpp"

namespace grit::abaqus {

// Complaints in error.
grit_status refuse_null(const char* name, grit_error& error);
grit_status check_sizes(int nprops, const char* nprops_name, int nstatv, const char* nstatv_name,
                        grit_error& error);

// Views on points that lie side by side, without rotation and tangent.
grit_sand_points views_of(Point* points);

}  // namespace grit::abaqus
