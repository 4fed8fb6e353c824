// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_surface_correct: two bodies on grids of their own, whose facets cut any cells, masses over many orders of
// magnitude, in the plane, in axisymmetry and in space.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind surface_trials();

}  // namespace robustness
