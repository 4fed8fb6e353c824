// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_sand_update_differentiated: the calls of sand_calls.hpp along any directions.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind derivative_trials();

}  // namespace robustness
