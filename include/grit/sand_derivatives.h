/* SPDX-License-Identifier: BSD-3-Clause
 * Derivatives of an update by parameters of the sand, for calibration: what grit_sand_update makes of stress and
 * state, differentiated along directions that the caller chooses and carries along a path.
 *
 *   end = F(parameters, start, strain increment)
 *   d end = dF/d parameter + dF/d start . d start + dF/d strain increment . d strain increment      (D1)
 *
 * per direction. One direction a parameter; the initial void ratio is a direction without a parameter that starts
 * with d e = 1, an entry of the strain increment one with a strain increment of its own. */
#pragma once

#include <grit/sand.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    GRIT_SAND_NO_PARAMETER = -1,
    GRIT_SAND_LARGEST_DIRECTION_COUNT = 32 /* of a call; they are carried by 16 at once */
};

/* Zero-initialise, set struct_size, then what is needed. Read while a call lasts. */
typedef struct grit_sand_derivatives {
    size_t struct_size;
    int count;    /* directions, 1 ... GRIT_SAND_LARGEST_DIRECTION_COUNT: columns of the views */
    int reserved; /* 0 */
    const int* parameters; /* [count] each as grit_sand_parameter_describe counts them, or
                              GRIT_SAND_NO_PARAMETER; null: none has one */
    grit_matrix_view strain_increment; /* [components x count] base null: it depends on none */
    grit_mutable_matrix_view stress;   /* [components x count] in: of the start, out: of the end */
    grit_mutable_matrix_view state;    /* [GRIT_SAND_STATE_SIZE x count] the same */
} grit_sand_derivatives;

/* grit_sand_update of n points, with the same bits, and the derivatives. Rows are components as in points, in their
 * units; a direction of a parameter is per unit of it (rad, stress or 1).
 *   The derivatives are those of the steps that were taken: how error control chose them is not differentiated.
 *   Where the response has a kink (a reversal of h, the onset of separation, the limits of the void ratio, the cone),
 *   they are of the side on which the point is. A zero increment answers a strain increment of a direction by the part
 *   of the stiffness that both sides have in common, h by all of it. A separated point has no derivative of its stress.
 *   options.tangent may be GRIT_TANGENT_NONE or _CONTINUUM: six directions of strain are the consistent one.
 *   All else holds as there: all or nothing per point, derivatives included. An update whose derivatives are not finite
 *   is GRIT_NOT_CONVERGED. */
GRIT_API grit_status grit_sand_update_differentiated(const grit_sand* sand,
                                                     const grit_sand_options* options,
                                                     const grit_sand_derivatives* derivatives,
                                                     ptrdiff_t n, const grit_sand_points* points,
                                                     grit_sand_report* reports, grit_error* error);

#ifdef __cplusplus
}
#endif
