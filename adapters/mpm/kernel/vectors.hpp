// SPDX-License-Identifier: BSD-3-Clause
// One source, one kernel per instruction set: a translation unit defines MPM_TARGET and what it includes
// lives in a namespace of its own, so that no template of one set is merged with that of another.
#pragma once

#ifndef MPM_TARGET
#define MPM_TARGET baseline
#endif

namespace grit::mpm {
typedef double Vec4 __attribute__((vector_size(32), may_alias));
typedef double Vec8 __attribute__((vector_size(64), may_alias));
}  // namespace grit::mpm

#define MPM_KERNEL_BEGIN                                                                           \
    namespace grit::mpm::MPM_TARGET {                                                              \
    namespace {
#define MPM_KERNEL_END                                                                             \
    }                                                                                              \
    }

#define MPM_INLINE __attribute__((always_inline, unused)) inline
