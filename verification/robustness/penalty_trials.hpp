// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_penalty_forces: closed and open lines of any lengths that overlap by any depth, in the plane and in axisymmetry.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind penalty_trials();

}  // namespace robustness
