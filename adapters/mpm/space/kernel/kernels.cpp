// SPDX-License-Identifier: BSD-3-Clause
#include <grit/version.h>

#include "adapters/mpm/space/kernel/call.hpp"

namespace grit::mpm::space {

#ifdef GRIT_HAS_X86_KERNELS
extern const Kernels avx2_kernels, avx512_kernels;

const Kernels& kernels() {
    static const Kernels& best = []() -> const Kernels& {
        switch (grit_instruction_set()) {
            case GRIT_ISA_AVX512: return avx512_kernels;
            case GRIT_ISA_AVX2: return avx2_kernels;
            default: return baseline_kernels;
        }
    }();
    return best;
}
#else
const Kernels& kernels() { return baseline_kernels; }
#endif

}  // namespace grit::mpm::space
