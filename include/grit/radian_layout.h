/* SPDX-License-Identifier: BSD-3-Clause
 * The second layout of a hypoplastic UMAT's PROPS and STATEV (docs/umat.md), for programs that speak it:
 *   PROPS  1 phi_c [rad], 2 nu (not used), 3 h_s, 4 n, 5 e_d0, 6 e_c0, 7 e_i0, 8 alpha, 9 beta, 10 m_T,
 *          11 m_R, 12 R, 13 beta_r, 14 chi, 15 K_w of the mixture [stress], 0: drained, 16 e_0
 *   STATEV 1 e, 2-7 h (11 22 33 12 13 23), from 8 on as in the classic layout, 11 in radians
 * Not part of grit.h: nothing of the library depends on it. Places count from 0. */
#pragma once

#include <grit/classic_layout.h>

enum {
    GRIT_RADIAN_POISSON_RATIO = 1,
    GRIT_RADIAN_VOID_RATIO = 0,
    GRIT_RADIAN_INTERGRANULAR_STRAIN = 1
};

/* PROPS of the classic layout from PROPS of this one; p_t is 0, for this layout has none. */
static inline void grit_radian_to_classic(const double* props,
                                          double classic[GRIT_CLASSIC_NPROPS]) {
    int i;
    for (i = 0; i < GRIT_CLASSIC_NPROPS; ++i) classic[i] = props[i];
    classic[0] = props[0] / GRIT_DEGREE;
    classic[1] = 0.0;
    classic[9] = props[10];
    classic[10] = props[9];
}

/* And back; nu is 0. GRIT_BAD_PARAMETER, and nothing written, if p_t is not 0. */
static inline grit_status grit_radian_of_classic(const double* classic,
                                                 double props[GRIT_CLASSIC_NPROPS]) {
    int i;
    if (classic[1] != 0.0) return GRIT_BAD_PARAMETER;
    for (i = 0; i < GRIT_CLASSIC_NPROPS; ++i) props[i] = classic[i];
    props[0] = classic[0] * GRIT_DEGREE;
    props[9] = classic[10];
    props[10] = classic[9];
    return GRIT_OK;
}
