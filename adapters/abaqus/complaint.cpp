// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/complaint.hpp"

#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace grit::abaqus {

grit_status failure(grit_error& error, grit_status status, const char* format, ...) {
    error.status = status;
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(error.message, sizeof error.message, format, arguments);
    va_end(arguments);
    return status;
}

void fail(const UmatArguments& call, const grit_error& why, double step_reduction) {
    if (call.pnewdt) *call.pnewdt = step_reduction < 1.0 ? step_reduction : default_reduction;
    if (call.pnewdt && why.status == GRIT_NOT_CONVERGED) return;
    // The library counts the points of its call, and a UMAT has one.
    constexpr char counted[] = "point 0: ";
    const char* message = why.message;
    if (std::strncmp(message, counted, sizeof counted - 1) == 0) message += sizeof counted - 1;
    std::fprintf(stderr, "Grit UMAT: element %d, point %d: %s\n", call.noel ? *call.noel : 0,
                 call.npt ? *call.npt : 0, message);
}

}  // namespace grit::abaqus
