// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#ifndef __has_feature  // clang's
#define __has_feature(feature) 0
#endif

// How many of n random samples a test draws: all, or a twentieth under sanitizers, which look at the ways
// through the code and take ten times as long on each.
constexpr std::size_t samples(std::size_t n) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) ||                               \
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    return n / 20;
#else
    return n;
#endif
}
