// SPDX-License-Identifier: BSD-3-Clause
// What makes one source into one kernel per instruction set.
//
// A translation unit defines GRIT_TARGET (baseline, avx2, avx512), is compiled with that instruction
// set and includes kernel headers; each of them lives in grit::GRIT_TARGET and an unnamed namespace,
// so that no template of one instruction set can be merged by the linker with that of another.
#pragma once

#ifndef GRIT_TARGET
#define GRIT_TARGET baseline
#endif

#define GRIT_KERNEL_BEGIN                                                                          \
    namespace grit::GRIT_TARGET {                                                                  \
    namespace {
// The same for the kernels of a room of its own: grit::room::GRIT_TARGET.
#define GRIT_KERNEL_BEGIN_OF(room)                                                                 \
    namespace grit::room::GRIT_TARGET {                                                            \
    namespace {
#define GRIT_KERNEL_END                                                                            \
    }                                                                                              \
    }

#define GRIT_INLINE inline __attribute__((always_inline))
