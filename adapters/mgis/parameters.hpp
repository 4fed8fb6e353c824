// SPDX-License-Identifier: BSD-3-Clause
// What a user of MGIS may set for all points at once, at any time and from any thread.
#pragma once

#include <grit/sand.h>

namespace grit::mgis {

constexpr double default_tolerance = GRIT_SAND_DEFAULT_TOLERANCE;
constexpr int default_evaluation_limit = GRIT_SAND_DEFAULT_EVALUATION_LIMIT;
constexpr double default_smallest_reduction = 0.1;
constexpr double highest_water_tension = 1e30;

struct Parameters {
    double tolerance;              // grit_sand_options.tolerance
    int evaluation_limit;          // grit_sand_options.evaluation_limit
    double smallest_reduction;     // (0, 1) of the time step, also where nothing better is known
    double largest_water_tension;  // [stress], 0: the water never cavitates
    int water_itself;  // 1: WaterStiffness is that of the water itself, 0: of the mixture
};

Parameters current_parameters();

}  // namespace grit::mgis
