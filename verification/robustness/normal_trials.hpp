// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_contact_normals_from_gradients and grit_contact_normals_by_regression: vectors of any size, clouds apart, mixed,
// coincident, on a line, of any weights.
#pragma once

#include "robustness/campaign.hpp"

namespace robustness {

Kind normal_trials();

}  // namespace robustness
