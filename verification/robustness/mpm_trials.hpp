// SPDX-License-Identifier: BSD-3-Clause
// Trials of the material-point driver: small cases, read, run for some steps, in threads, and from a checkpoint.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind mpm_trials();

}  // namespace robustness
