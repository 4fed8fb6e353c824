/* SPDX-License-Identifier: BSD-3-Clause
 * The classic layout of a hypoplastic UMAT's PROPS and STATEV (docs/umat.md), for programs that speak it:
 *   PROPS  1 phi_c [deg], 2 p_t, 3 h_s, 4 n, 5 e_d0, 6 e_c0, 7 e_i0, 8 alpha, 9 beta, 10 m_R, 11 m_T,
 *          12 R, 13 beta_r, 14 chi, 15 K_w of the mixture [stress], 0: drained, 16 e_0, and, if they are there,
 *          17 tolerance, 18 largest tension of the water [stress], 19 is K_w that of the water itself?
 *   STATEV 1-6 h (11 22 33 12 13 23), 7 e, 8 minus the excess pore pressure [stress], 9 p' [stress],
 *          10 evaluations, 11 mobilised friction angle [deg], 12 rho, 13 substep, 14 separation
 * Not part of grit.h: nothing of the library depends on it. Places count from 0. */
#pragma once

#include <grit/sand_operators.h>
#include <grit/sand_water.h>

#define GRIT_DEGREE 0.017453292519943295 /* [rad] */

enum {
    GRIT_CLASSIC_NPROPS = 16,
    GRIT_CLASSIC_REVERSAL_STIFFNESS = 9, /* the five of the intergranular strain begin here */
    GRIT_CLASSIC_WATER_STIFFNESS = 14,
    GRIT_CLASSIC_VOID_RATIO_AT_ZERO_PRESSURE = 15,
    /* optional, 0 where they are missing */
    GRIT_CLASSIC_TOLERANCE = 16,
    GRIT_CLASSIC_LARGEST_TENSION = 17, /* of the water [stress]; 0: it never cavitates */
    GRIT_CLASSIC_WATER_ITSELF = 18,    /* 1: K_w is that of the water, 0: of the mixture */
    GRIT_CLASSIC_PROPS_READ = 19,

    GRIT_CLASSIC_NSTATV = 13, /* the least; with 14 the separation is kept */
    GRIT_CLASSIC_VOID_RATIO = 6,
    GRIT_CLASSIC_PORE_STRESS = 7,
    GRIT_CLASSIC_PRESSURE = 8,
    GRIT_CLASSIC_EVALUATIONS = 9,
    GRIT_CLASSIC_MOBILISED_ANGLE = 10,
    GRIT_CLASSIC_RHO = 11,
    GRIT_CLASSIC_SUBSTEP = 12,
    GRIT_CLASSIC_SEPARATION = 13
};

#define GRIT_CLASSIC_FAILED (-1.0)        /* STATEV(10) of a point that a VUMAT could not update */
#define GRIT_CLASSIC_NO_MEMORY 0.5        /* m_R at or below it: no intergranular strain */
#define GRIT_CLASSIC_NO_VOID_RATIO 1e-3   /* STATEV(7) below it: not initialised */
#define GRIT_CLASSIC_TRUE_VOID_RATIO 10.0 /* e_0 above it: e_0 - 10 is e itself */
#define GRIT_CLASSIC_LEAST_PRESSURE                                                                \
    1e-3 /* in any unit of stress: part of the layout, not of the sand */

/* PROPS(1) ... PROPS(14) as parameters; the five of the intergranular strain stay NaN if m_R says so
 * (a NaN is passed on for the library to refuse). */
static inline void grit_classic_parameters(const double* props, grit_sand_parameters* p) {
    grit_sand_parameters_init(p, sizeof *p);
    p->critical_friction_angle = props[0] * GRIT_DEGREE;
    p->pressure_shift = props[1];
    p->granulate_hardness = props[2];
    p->stiffness_exponent = props[3];
    p->densest_void_ratio = props[4];
    p->critical_void_ratio = props[5];
    p->loosest_void_ratio = props[6];
    p->pyknotropy_exponent = props[7];
    p->stiffness_void_exponent = props[8];
    if (props[GRIT_CLASSIC_REVERSAL_STIFFNESS] <= GRIT_CLASSIC_NO_MEMORY) return;
    p->reversal_stiffness = props[9];
    p->transverse_stiffness = props[10];
    p->elastic_strain_radius = props[11];
    p->evolution_exponent = props[12];
    p->stiffness_interpolation_exponent = props[13];
}

/* And back. */
static inline void grit_classic_props(const grit_sand_parameters* p, int intergranular_strain,
                                      double props[GRIT_CLASSIC_NPROPS]) {
    int i;
    props[0] = p->critical_friction_angle / GRIT_DEGREE;
    props[1] = p->pressure_shift;
    props[2] = p->granulate_hardness;
    props[3] = p->stiffness_exponent;
    props[4] = p->densest_void_ratio;
    props[5] = p->critical_void_ratio;
    props[6] = p->loosest_void_ratio;
    props[7] = p->pyknotropy_exponent;
    props[8] = p->stiffness_void_exponent;
    for (i = GRIT_CLASSIC_REVERSAL_STIFFNESS; i < GRIT_CLASSIC_NPROPS; ++i) props[i] = 0.0;
    if (!intergranular_strain) return;
    props[9] = p->reversal_stiffness;
    props[10] = p->transverse_stiffness;
    props[11] = p->elastic_strain_radius;
    props[12] = p->evolution_exponent;
    props[13] = p->stiffness_interpolation_exponent;
}

/* The water of K_w and of PROPS(18), PROPS(19). GRIT_BAD_PARAMETER with the place in PROPS, from 0, in *bad. */
static inline grit_status grit_classic_water(double K_w, double largest_tension, double itself,
                                             grit_sand_water* water, int* bad) {
    grit_sand_water_init(water, sizeof *water);
    *bad = GRIT_CLASSIC_WATER_STIFFNESS;
    if (!(K_w >= 0.0 && K_w < 1e300)) return GRIT_BAD_PARAMETER;
    *bad = GRIT_CLASSIC_LARGEST_TENSION;
    if (!(largest_tension >= 0.0 && largest_tension < 1e300)) return GRIT_BAD_PARAMETER;
    *bad = GRIT_CLASSIC_WATER_ITSELF;
    if (itself != 0.0 && itself != 1.0) return GRIT_BAD_PARAMETER;
    water->bulk_modulus = K_w;
    water->porosity = itself == 1.0 ? 0.0 : 1.0;
    if (largest_tension > 0.0) water->largest_tension = largest_tension;
    return GRIT_OK;
}

/* The void ratio of a point that has none yet, at the effective pressure p [stress]:
 *   e_0 > 10: e_0 - 10;  e_0 <= 10: e_0 at zero pressure, compressed by (H6) where p > 1e-3.
 * GRIT_BAD_STATE unless e_0 is positive. */
static inline grit_status grit_classic_void_ratio(const grit_sand* sand, double e_0, double p,
                                                  double* void_ratio) {
    if (!(e_0 > 0.0 && e_0 < 1e300)) return GRIT_BAD_STATE;
    *void_ratio = e_0;
    if (e_0 > GRIT_CLASSIC_TRUE_VOID_RATIO) {
        *void_ratio = e_0 - GRIT_CLASSIC_TRUE_VOID_RATIO;
        return GRIT_OK;
    }
    if (p > GRIT_CLASSIC_LEAST_PRESSURE && p < 1e300)
        return grit_sand_void_ratio_at_pressure(sand, e_0, p, void_ratio);
    return GRIT_OK;
}
