/* SPDX-License-Identifier: BSD-3-Clause
 * Undrained sand: water fills the pores and moves with the grains (W1), which keep their volume.
 *
 *   p_w = p_w0 - K_w ln(e/e_0),  or at a constant porosity  p_w0 - (K_w/n) tr(strain increment)
 *
 * p_w is compression positive. The water bears p = max(p_w, -largest_tension): below, it has cavitated, and p_w
 * goes on, so that a cavity must close before the water bears again. */
#pragma once

#include <grit/sand.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Set by name after grit_sand_water_init, which marks K_w as missing (NaN) and leaves the views without a base.
 * Read while a call lasts. */
typedef struct grit_sand_water {
    size_t struct_size;     /* set by init */
    double bulk_modulus;    /* K_w [stress] >= 0, of the water; 0: drained, p_w stays */
    double porosity;        /* n [-] in (0, 1], constant; 1: K_w is that of the mixture, K_w/n;
                                        default 0: e/(1 + e) of the point as it is */
    double largest_tension; /* [stress] >= 0; default infinity: it never cavitates */
    grit_mutable_view pore_pressure; /* [1] p_w [stress], in: start, out: end */
    grit_mutable_view total_stress;  /* [components] out: stress - p 1; base null: not wanted */
} grit_sand_water;

/* struct_size = sizeof(grit_sand_water) as the caller compiled it. */
GRIT_API grit_status grit_sand_water_init(grit_sand_water* water, size_t struct_size);

/* What bears of p_w, and so what a total stress lacks to the effective one; NaN stays NaN. */
static inline double grit_sand_water_borne(const grit_sand_water* water, double pore_pressure) {
    return pore_pressure < -water->largest_tension ? -water->largest_tension : pore_pressure;
}

/* -dp/d tr [stress] of a point, K_w/n, 0 where the water has cavitated: beside grit_sand_wave_modulus that of
 * undrained waves. The views are not looked at. */
GRIT_API grit_status grit_sand_water_stiffness(const grit_sand_water* water, double pore_pressure,
                                               double void_ratio, double* stiffness);

/* grit_sand_update of n points that are undrained: points.stress is effective, in and out; points.tangent is
 * that of the total stress, stress - p 1: what grit_sand_update gives, and dp/d tr of the end on its normal
 * entries, K_w/n, or nothing where the water has cavitated (GRIT_SAND_CAVITATED).
 *   All else holds as there, of pore_pressure and total_stress too: all or nothing per point, output
 *   views must not overlap, a point's result is bitwise the same whatever n, its place and its neighbours are.
 *   GRIT_BAD_PARAMETER of the water: nothing was done and no report written. */
GRIT_API grit_status grit_sand_update_undrained(const grit_sand* sand,
                                                const grit_sand_options* options,
                                                const grit_sand_water* water, ptrdiff_t n,
                                                const grit_sand_points* points,
                                                grit_sand_report* reports, grit_error* error);

#ifdef __cplusplus
}
#endif
