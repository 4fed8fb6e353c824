// SPDX-License-Identifier: BSD-3-Clause
// The library's version and instruction sets as users are told them.
#pragma once

#include <string>

#include <grit/version.h>

namespace grit {

// Of grit_version().
inline std::string version_text(int version) {
    return std::to_string(version / 10000) + '.' + std::to_string(version / 100 % 100) + '.' +
           std::to_string(version % 100);
}

// Of a GRIT_ISA_...
inline std::string instruction_set_text(int set) {
    switch (set) {
        case GRIT_ISA_BASELINE: return "baseline";
        case GRIT_ISA_AVX2: return "AVX2";
        case GRIT_ISA_AVX512: return "AVX-512";
        default: return "number " + std::to_string(set);
    }
}

}  // namespace grit
