// SPDX-License-Identifier: BSD-3-Clause
// How a C entry point says what is wrong: no exception, no allocation, no global.
#pragma once

#include <cstdarg>
#include <cstddef>
#include <cstdio>

#include <grit/status.h>

namespace grit {

// Fill error (may be null) and return status.
__attribute__((format(printf, 4, 5))) inline grit_status
failure(grit_error* error, grit_status status, std::ptrdiff_t point, const char* format, ...) {
    if (error) {
        error->status = status;
        error->reserved = 0;
        error->point = point;
        std::va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
    }
    return status;
}

}  // namespace grit

// Leave a function that has a grit_error* error, unless the condition holds.
#define GRIT_REQUIRE(condition, ...)                                                               \
    if (!(condition)) return grit::failure(error, GRIT_BAD_CALL, -1, __VA_ARGS__)
