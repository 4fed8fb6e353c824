// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/complaint.hpp"

#include <atomic>
#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace grit::abaqus {
namespace {

// Kept between calls: of increments that are too large, which many hosts cut back, and of all else.
std::atomic<bool> already_said[2]{false, false};

// The library counts the points of its call, a host its elements: "point 7: " goes.
const char* without_count(const char* message) {
    constexpr char counted[] = "point ";
    if (std::strncmp(message, counted, sizeof counted - 1) != 0) return message;
    const char* rest = message + sizeof counted - 1;
    while (std::isdigit(static_cast<unsigned char>(*rest))) ++rest;
    return rest[0] == ':' && rest[1] == ' ' ? rest + 2 : message;
}

}  // namespace

grit_status failure(grit_error& error, grit_status status, const char* format, ...) {
    error.status = status;
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(error.message, sizeof error.message, format, arguments);
    va_end(arguments);
    return status;
}

void complain(const grit_error& why, const char* where, ...) {
    std::atomic<bool>& said = already_said[why.status == GRIT_NOT_CONVERGED ? 0 : 1];
    if (said.exchange(true, std::memory_order_relaxed)) return;
    char place[128];
    std::va_list arguments;
    va_start(arguments, where);
    std::vsnprintf(place, sizeof place, where, arguments);
    va_end(arguments);
    std::fprintf(stderr, "%s: %s\n", place, without_count(why.message));
}

}  // namespace grit::abaqus
