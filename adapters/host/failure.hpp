// SPDX-License-Identifier: BSD-3-Clause
// How adapters for hosts fill an error of their own, and pass on one of the library's.
#pragma once

#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include <grit/status.h>

namespace grit {

// Of no point.
inline grit_status vfailure(grit_error& error, grit_status status, const char* format,
                            std::va_list arguments) {
    error.status = status;
    error.point = -1;
    std::vsnprintf(error.message, sizeof error.message, format, arguments);
    return status;
}

__attribute__((format(printf, 3, 4))) inline grit_status
failure(grit_error& error, grit_status status, const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    vfailure(error, status, format, arguments);
    va_end(arguments);
    return status;
}

// The library counts the points of its call, a host its elements: "point 7: " goes.
inline const char* without_point(const char* message) {
    constexpr char counted[] = "point ";
    if (std::strncmp(message, counted, sizeof counted - 1) != 0) return message;
    const char* rest = message + sizeof counted - 1;
    while (std::isdigit(static_cast<unsigned char>(*rest))) ++rest;
    return rest[0] == ':' && rest[1] == ' ' ? rest + 2 : message;
}

}  // namespace grit
