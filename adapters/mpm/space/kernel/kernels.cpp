// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/best_kernels.hpp"
#include "adapters/mpm/space/kernel/call.hpp"

namespace grit::mpm::space {

#ifdef GRIT_HAS_X86_KERNELS
extern const Kernels avx2_kernels, avx512_kernels;

const Kernels& kernels() {
    static const Kernels& best = best_kernels(baseline_kernels, avx2_kernels, avx512_kernels);
    return best;
}
#else
const Kernels& kernels() { return baseline_kernels; }
#endif

}  // namespace grit::mpm::space
