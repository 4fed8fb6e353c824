// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_sand_update_undrained: the calls of sand_calls.hpp, and water of any stiffness, porosity and tension.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind undrained_trials();

}  // namespace robustness
