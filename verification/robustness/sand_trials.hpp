// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_sand_update: parameters over their whole ranges, states and strains far beyond what a host asks for.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind sand_trials();

}  // namespace robustness
