// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_contact_surfaces_reset, _add, _merge and _finish: domains of any shape around nodes in any lists, added in any order, in
// parts, by one or many calls.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind distance_trials();

}  // namespace robustness
