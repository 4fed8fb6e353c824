// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

#ifdef GRIT_MPM_HAS_X86_KERNELS
extern const Kernels avx2_kernels, avx512_kernels;

const Kernels& kernels() {
    static const Kernels& best = []() -> const Kernels& {
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
            __builtin_cpu_supports("avx512dq"))
            return avx512_kernels;
        return __builtin_cpu_supports("avx2") ? avx2_kernels : baseline_kernels;
    }();
    return best;
}
#else
const Kernels& kernels() { return baseline_kernels; }
#endif

}  // namespace grit::mpm
