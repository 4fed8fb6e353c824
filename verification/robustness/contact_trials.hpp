// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_contact_correct and grit_contact_correct_many: masses, velocities, laws and steps over many orders of
// magnitude, in any memory.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind contact_trials();

}  // namespace robustness
