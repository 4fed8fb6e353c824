/* SPDX-License-Identifier: BSD-3-Clause
 * The elementary operators of the sand, one point at a time: what grit_sand_update integrates, laid
 * open for users, tests and start-up code. They are meant for insight and set-up, not for speed.
 *
 * stress [6], strain rate D [6] (engineering shear), state [GRIT_SAND_STATE_SIZE] as in sand.h;
 * 6 x 6 matrices row-major, d stress / d strain in Voigt components.
 * Errors: GRIT_BAD_CALL for a null pointer, an unprepared sand, a value that is not finite or out of
 * the range stated; results are untouched then. Outside the domain (p at or
 * below the floor, tan psi >= sqrt 2, e outside [e_d, e_i]) the values are those of its border. */
#pragma once

#include <grit/sand.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Limiting void ratios (H6) at mean pressure p >= 0 [stress], p_t already added: [0] e_i, [1] e_c,
 * [2] e_d. */
GRIT_API grit_status grit_sand_void_ratios(const grit_sand* sand, double p, double void_ratios[3]);

typedef struct grit_sand_scalar_factors {
    size_t struct_size; /* set by the caller */
    double a;           /* (H4) */
    double F;           /* (H5) */
    double f_d;         /* density factor (H7) */
    double f_e;         /* (H7) */
    double f_b;         /* barotropy factor [stress] (H8) */
    double f_s;         /* f_b f_e [stress] */
} grit_sand_scalar_factors;

GRIT_API grit_status grit_sand_factors(const grit_sand* sand, const double stress[6],
                                       double void_ratio, grit_sand_scalar_factors* factors);

/* L of (H2) [36], N of (H3) [6]; either may be null. */
GRIT_API grit_status grit_sand_stiffness(const grit_sand* sand, const double stress[6],
                                         double void_ratio, double* L, double* N);

/* M of (G1) [36]; D chooses the branch of the intergranular strain, which the sand must have. */
GRIT_API grit_status grit_sand_intergranular_stiffness(const grit_sand* sand,
                                                       const double stress[6], const double* state,
                                                       const double D[6], double M[36]);

/* Rates of stress (H1)/(G2) and of the state (G3), (H9) for the strain rate D.
 * intergranular_off 1: (H1), h at rest. Degree 1 in D; no time enters. */
GRIT_API grit_status grit_sand_rate(const grit_sand* sand, int intergranular_off,
                                    const double stress[6], const double* state, const double D[6],
                                    double stress_rate[6], double* state_rate);

/* Upper bound of the P-wave modulus [stress] for an explicit time step dt = CFL dx / sqrt(M/rho).
 * Without intergranular strain k A + N, k = f_s/(T_hat:T_hat), A = F^2 + a^2 t^2, t the largest |principal value| of
 * T_hat, N the largest of that of N; with it the larger of k (m_R A + (m_R - m_T) C) where strain turns back and
 * k (m_T A + (m_T - 1) C) + N, C = (sqrt(A^2 + B^2) - A)/2, B = a^2 s sqrt(T_hat:T_hat - s^2), s at most t and
 * |T_hat|/sqrt(2). */
GRIT_API grit_status grit_sand_wave_modulus(const grit_sand* sand, int intergranular_off,
                                            const double stress[6], double void_ratio,
                                            double* modulus);

/* The same of n points, for hosts that ask at every step: points as in grit_sand_update, of which stress,
 * state (void ratio), components and index are read; moduli [n]. options (null: defaults):
 * intergranular_off and instruction_set are read.
 * GRIT_BAD_STATE: a stress is not finite or a void ratio not in (0, 1e9]; those moduli are NaN. */
GRIT_API grit_status grit_sand_wave_moduli(const grit_sand* sand, const grit_sand_options* options,
                                           ptrdiff_t n, const grit_sand_points* points,
                                           double* moduli, grit_error* error);

/* Rotate stress and h of a point by Q [9] row-major, proper orthogonal; either may be null. */
GRIT_API grit_status grit_sand_rotate(const double Q[9], double* stress, double* state);

typedef struct grit_sand_invariants {
    size_t struct_size;              /* set by the caller; up to relative_density saves its cost */
    double p;                        /* mean pressure [stress], compression positive */
    double q;                        /* sqrt(3/2) |deviator| [stress], >= 0 */
    double lode_angle;               /* [rad] 0 triaxial compression ... pi/3 triaxial extension */
    double tan_psi;                  /* sqrt 3 |T_hat*| of T - p_t I, 0 where p + p_t <= 0 */
    double mobilised_friction_angle; /* asin((s1 - s3)/(s1 + s3)) [rad] of T - p_t I */
    double rho;                      /* |h|/R, 0 without intergranular strain */
    double relative_density; /* (e_c - e)/(e_c - e_d) at the current p: 1 densest, 0 critical */
} grit_sand_invariants;

GRIT_API grit_status grit_sand_invariants_of(const grit_sand* sand, const double stress[6],
                                             const double* state, grit_sand_invariants* invariants);

/* ---- initial states -------------------------------------------------------------------------- */

/* e at pressure p, p_t already added, from e_0 at zero pressure: e = e_0 exp[-(3p/h_s)^n]  (H6). */
GRIT_API grit_status grit_sand_void_ratio_at_pressure(const grit_sand* sand, double e_0, double p,
                                                      double* void_ratio);

/* Stress at rest: vertical = -(unit_weight depth + surcharge) along axis 0, 1 or 2, horizontal
 * K0 times that, shear zero. K0 < 0 asks for 1 - sin(phi_c).
 * unit_weight [stress/length], depth >= 0 [length], surcharge >= 0 [stress]. */
GRIT_API grit_status grit_sand_stress_at_rest(const grit_sand* sand, double unit_weight,
                                              double depth, double surcharge, double K0, int axis,
                                              double stress[6]);

/* Set h = rho R along the strain direction [6] (engineering shear, any length > 0), rho in [0, 1], for
 * a sand with intergranular strain: 0 no memory, 1 fully mobilised, e.g. direction (-1,-1,-1,0,0,0) after isotropic compression. */
GRIT_API grit_status grit_sand_mobilise(const grit_sand* sand, const double direction[6],
                                        double rho, double* state);

#ifdef __cplusplus
}
#endif
