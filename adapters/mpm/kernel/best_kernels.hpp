// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <grit/version.h>

namespace grit::mpm {

// The kernels of the best instruction set that this processor has.
template <class Kernels>
const Kernels& best_kernels(const Kernels& baseline, const Kernels& avx2, const Kernels& avx512) {
    switch (grit_instruction_set()) {
        case GRIT_ISA_AVX512: return avx512;
        case GRIT_ISA_AVX2: return avx2;
        default: return baseline;
    }
}

}  // namespace grit::mpm
