// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mgis/complaint.hpp"

#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace grit::mgis {

grit_status failure(grit_error& error, grit_status status, const char* format, ...) {
    error.status = status;
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(error.message, sizeof error.message, format, arguments);
    va_end(arguments);
    return status;
}

void report(const mfront_gb_BehaviourData& call, const char* hypothesis, const grit_error& why,
            double reduction) {
    if (call.rdt && !(*call.rdt <= reduction)) *call.rdt = reduction;
    if (!call.error_message) return;
    // The library counts the points of its call, and a behaviour has one.
    constexpr char counted[] = "point 0: ";
    const char* message = why.message;
    if (std::strncmp(message, counted, sizeof counted - 1) == 0) message += sizeof counted - 1;
    std::snprintf(call.error_message, error_message_size, "GritSand, %s: %s", hypothesis, message);
}

}  // namespace grit::mgis
