/* SPDX-License-Identifier: BSD-3-Clause */
#pragma once

#include <grit/export.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GRIT_VERSION_MAJOR 0
#define GRIT_VERSION_MINOR 1
#define GRIT_VERSION_PATCH 0

/* Version of the library linked, as 10000 major + 100 minor + patch. */
GRIT_API int grit_version(void);

enum {
    GRIT_ISA_BEST = 0,     /* in options: the best this machine has        */
    GRIT_ISA_BASELINE = 1, /* what every CPU of this architecture has      */
    GRIT_ISA_AVX2 = 2,     /* AVX2 and FMA                                 */
    GRIT_ISA_AVX512 = 3    /* AVX-512 F, VL and DQ                         */
};

/* The best instruction set this machine and this build have: GRIT_ISA_BASELINE or higher. */
GRIT_API int grit_instruction_set(void);

#ifdef __cplusplus
}
#endif
