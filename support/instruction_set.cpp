// SPDX-License-Identifier: BSD-3-Clause
#include "support/instruction_set.hpp"

#include <grit/version.h>

namespace grit {

int best_instruction_set() {
#ifdef GRIT_HAS_X86_KERNELS
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma"))
        return GRIT_ISA_AVX512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return GRIT_ISA_AVX2;
#endif
    return GRIT_ISA_BASELINE;
}

}  // namespace grit

extern "C" int grit_instruction_set(void) { return grit::best_instruction_set(); }
