// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <grit/version.h>

#include "support/require.hpp"

namespace grit {

// The best GRIT_ISA_... of this machine that this build has a kernel for.
int best_instruction_set();

// An instruction set that a caller may ask for here.
inline grit_status check_instruction_set(int isa, grit_error* error) {
    const int best = best_instruction_set();
    GRIT_REQUIRE(isa >= GRIT_ISA_BEST && isa <= best,
                 "instruction_set %d is not available here: the best is %d", isa, best);
    return GRIT_OK;
}

// call() of the kernels for an instruction set that passed the check: baseline::call() and so on.
#ifdef GRIT_HAS_X86_KERNELS
#define GRIT_DISPATCH(isa, call)                                                                   \
    ([&](int asked) {                                                                              \
        const int chosen = asked == GRIT_ISA_BEST ? best_instruction_set() : asked;                \
        if (chosen == GRIT_ISA_AVX512) return avx512::call;                                        \
        if (chosen == GRIT_ISA_AVX2) return avx2::call;                                            \
        return baseline::call;                                                                     \
    }(isa))
#else
#define GRIT_DISPATCH(isa, call) ((void)(isa), baseline::call)
#endif

}  // namespace grit
