// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace grit::mpm {

// FNV-1a over words of eight bytes, the last one filled up with zeros. Every step is one to one, so that
// a change within one word always shows.
inline std::uint64_t checksum(const void* data, std::size_t bytes) {
    std::uint64_t sum = 0xcbf29ce484222325u;
    const auto* at = static_cast<const unsigned char*>(data);
    while (bytes > 0) {
        std::uint64_t word = 0;
        const std::size_t taken = bytes < sizeof word ? bytes : sizeof word;
        std::memcpy(&word, at, taken);
        sum = (sum ^ word) * 0x100000001b3u;
        at += taken;
        bytes -= taken;
    }
    return sum;
}

}  // namespace grit::mpm
