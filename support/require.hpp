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
