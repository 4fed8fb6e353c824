// SPDX-License-Identifier: BSD-3-Clause
// Sums that do not depend on the order of their terms: each term is cut into pieces of 32 bits that are
// added as integers at their place, after Kulisch & Miranker (1986), doi 10.1137/1028001.
#pragma once

#include <bit>
#include <cstdint>

#include "support/kernel.hpp"

GRIT_KERNEL_BEGIN

constexpr int exact_sum_words = 66;  // 2^-1074 to 2^1024 and the carries of 2^30 terms

// Add a finite x to the words of one sum.
inline void add_exactly(std::int64_t* word, double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto exponent = static_cast<int>(bits >> 52 & 0x7ff);
    std::uint64_t mantissa = bits & 0xfffffffffffffULL;
    if (exponent > 0) mantissa |= 1ULL << 52;
    const int place = exponent > 0 ? exponent - 1 : 0;  // x = mantissa 2^(place - 1074)
    const int shift = place % 32;
    const std::uint64_t low = mantissa << shift;  // its bits above 2^64 are in high
    const std::uint64_t high = shift > 11 ? mantissa >> (64 - shift) : 0;
    const std::int64_t sign = bits >> 63 ? -1 : 1;
    word += place / 32;
    word[0] += sign * static_cast<std::int64_t>(low & 0xffffffffULL);
    word[1] += sign * static_cast<std::int64_t>(low >> 32);
    if (high != 0) word[2] += sign * static_cast<std::int64_t>(high);
}

GRIT_KERNEL_END
