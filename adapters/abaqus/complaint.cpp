// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/complaint.hpp"

#include <atomic>
#include <cstdarg>
#include <cstdio>

#include "adapters/host/failure.hpp"

namespace grit::abaqus {
namespace {

// Kept between calls: of increments that are too large, which many hosts cut back, and of all else.
std::atomic<bool> already_said[2]{false, false};

}  // namespace

void complain(const grit_error& why, const char* where, ...) {
    std::atomic<bool>& said = already_said[why.status == GRIT_NOT_CONVERGED ? 0 : 1];
    if (said.exchange(true, std::memory_order_relaxed)) return;
    char place[128];
    std::va_list arguments;
    va_start(arguments, where);
    std::vsnprintf(place, sizeof place, where, arguments);
    va_end(arguments);
    std::fprintf(stderr, "%s: %s\n", place, without_point(why.message));
}

}  // namespace grit::abaqus
