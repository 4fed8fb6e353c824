// SPDX-License-Identifier: BSD-3-Clause
// What is said where a call fails.
#pragma once

#include <grit/status.h>

#include "adapters/mgis/generic_behaviour.hpp"

namespace grit::mgis {

// The message goes to the host's buffer if it has one. *rdt falls to reduction, and never rises.
void report(const mfront_gb_BehaviourData& call, const char* hypothesis, const grit_error& why,
            double reduction);

}  // namespace grit::mgis
