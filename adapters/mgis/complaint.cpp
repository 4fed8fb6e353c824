// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mgis/complaint.hpp"

#include <cstdio>

#include "adapters/host/failure.hpp"

namespace grit::mgis {

void report(const mfront_gb_BehaviourData& call, const char* hypothesis, const grit_error& why,
            double reduction) {
    if (call.rdt && !(*call.rdt <= reduction)) *call.rdt = reduction;
    if (!call.error_message) return;
    std::snprintf(call.error_message, error_message_size, "GritSand, %s: %s", hypothesis,
                  without_point(why.message));
}

}  // namespace grit::mgis
