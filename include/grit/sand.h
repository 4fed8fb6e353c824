/* SPDX-License-Identifier: BSD-3-Clause
 * The sand: hypoplasticity of von Wolffersdorff (1996), doi 10.1002/(SICI)1099-1484(199607)1:3,
 * with the intergranular strain of Niemunis & Herle (1997).
 *
 *   parameters --prepare--> sand (immutable, shareable) --update--> stress, state, tangent
 */
#pragma once

#include <stddef.h>

#include <grit/export.h>
#include <grit/status.h>
#include <grit/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- parameters ------------------------------------------------------------------------------ */

/* Stress in any unit, the same for hardness and p_t; angle in radians. Set by name after
 * grit_sand_parameters_init, which marks all but the optional ones as missing (NaN). */
typedef struct grit_sand_parameters {
    size_t struct_size;             /* set by init */
    double critical_friction_angle; /* phi_c [rad]     [10, 60] degrees */
    double granulate_hardness;      /* h_s   [stress]  [1e-30, 1e30] */
    double stiffness_exponent;      /* n     [-]       [0.01, 0.99] */
    double densest_void_ratio;      /* e_d0  [-]       0.01 <= e_d0 < e_c0, at zero pressure */
    double critical_void_ratio;     /* e_c0  [-]       e_d0 < e_c0 < e_i0 */
    double loosest_void_ratio;      /* e_i0  [-]       e_c0 < e_i0 <= 5 */
    double pyknotropy_exponent;     /* alpha [-]       [0.001, 2] */
    double stiffness_void_exponent; /* beta  [-]       [0, 5] */
    double pressure_shift;          /* p_t   [stress]  [0, h_s], (H10), a cohesion: 0 unless set */
    /* Intergranular strain: give all five, or none (then it is off for this material). */
    double reversal_stiffness;               /* m_R    [-]  [1, 20] */
    double transverse_stiffness;             /* m_T    [-]  [1, m_R] */
    double elastic_strain_radius;            /* R      [-]  [1e-6, 1e-2] */
    double evolution_exponent;               /* beta_r [-]  [0.01, 2] */
    double stiffness_interpolation_exponent; /* chi [-]  [0.5, 20] */
} grit_sand_parameters;

/* struct_size = sizeof(grit_sand_parameters) as the caller compiled it. */
GRIT_API grit_status grit_sand_parameters_init(grit_sand_parameters* parameters,
                                               size_t struct_size);

/* Places of the parameters, for all that counts them. */
enum {
    GRIT_SAND_CRITICAL_FRICTION_ANGLE = 0,
    GRIT_SAND_GRANULATE_HARDNESS = 1,
    GRIT_SAND_STIFFNESS_EXPONENT = 2,
    GRIT_SAND_DENSEST_VOID_RATIO = 3,
    GRIT_SAND_CRITICAL_VOID_RATIO = 4,
    GRIT_SAND_LOOSEST_VOID_RATIO = 5,
    GRIT_SAND_PYKNOTROPY_EXPONENT = 6,
    GRIT_SAND_STIFFNESS_VOID_EXPONENT = 7,
    GRIT_SAND_PRESSURE_SHIFT = 8,
    GRIT_SAND_REVERSAL_STIFFNESS = 9,
    GRIT_SAND_TRANSVERSE_STIFFNESS = 10,
    GRIT_SAND_ELASTIC_STRAIN_RADIUS = 11,
    GRIT_SAND_EVOLUTION_EXPONENT = 12,
    GRIT_SAND_STIFFNESS_INTERPOLATION_EXPONENT = 13,
    GRIT_SAND_PARAMETER_COUNT = 14
};

typedef struct grit_sand_parameter_info {
    const char* name;   /* as the member of grit_sand_parameters */
    const char* symbol; /* as in the papers: "phi_c", "h_s", ... */
    const char* unit;   /* "rad", "stress" or "-" */
    double lowest;      /* limits that need no other parameter */
    double highest;
    int optional; /* 0 required, 1 optional, 2 one of the five of the intergranular strain */
} grit_sand_parameter_info;

/* Description of parameter index = 0 ... GRIT_SAND_PARAMETER_COUNT - 1, null otherwise. */
GRIT_API const grit_sand_parameter_info* grit_sand_parameter_describe(int index);
GRIT_API grit_status grit_sand_parameter_get(const grit_sand_parameters* parameters, int index,
                                             double* value);
GRIT_API grit_status grit_sand_parameter_set(grit_sand_parameters* parameters, int index,
                                             double value);

/* ---- the prepared material ------------------------------------------------------------------- */

/* Validated parameters and derived constants in the caller's memory: immutable, may be copied as
 * bytes and shared between threads; refused by the library if another major version prepared it. */
typedef struct grit_sand {
    double opaque[64];
} grit_sand;

/* GRIT_BAD_PARAMETER with name, value, limit and unit in error; sand is untouched then. */
GRIT_API grit_status grit_sand_prepare(const grit_sand_parameters* parameters, grit_sand* sand,
                                       grit_error* error);

/* The parameters a sand was prepared from. parameters must have been initialised. */
GRIT_API grit_status grit_sand_parameters_of(const grit_sand* sand,
                                             grit_sand_parameters* parameters);

/* ---- state ----------------------------------------------------------------------------------- */

/* Components of the state of a point. A new point is all zero but for the void ratio. */
enum {
    GRIT_SAND_H11 = 0, /* h, intergranular strain: engineering shear, extension + */
    GRIT_SAND_H22 = 1,
    GRIT_SAND_H33 = 2,
    GRIT_SAND_H12 = 3,
    GRIT_SAND_H13 = 4,
    GRIT_SAND_H23 = 5,
    GRIT_SAND_VOID_RATIO = 6, /* e [-] */
    GRIT_SAND_SEPARATION = 7, /* w >= 0 [-], opening to be closed before stress returns */
    GRIT_SAND_STATE_SIZE = 8
};

/* ---- update ---------------------------------------------------------------------------------- */

enum {
    GRIT_TANGENT_NONE = 0,
    GRIT_TANGENT_CONTINUUM = 1, /* M of (G1) at the end, along the increment */
    GRIT_TANGENT_CONSISTENT = 2 /* derivative of the stress by the strain increment */
};
#define GRIT_SAND_DEFAULT_TOLERANCE 2e-4 /* whole paths within 2e-4 of the exact stress */
#define GRIT_SAND_LEAST_TOLERANCE 1e-12
#define GRIT_SAND_LARGEST_TOLERANCE 0.1
#define GRIT_SAND_DEFAULT_EVALUATION_LIMIT 20000
#define GRIT_SAND_LEAST_EVALUATION_LIMIT 2
#define GRIT_SAND_LARGEST_EVALUATION_LIMIT 1000000
typedef struct grit_sand_options {
    size_t struct_size;    /* set by init */
    double tolerance;      /* of the stress, see grit_sand_update; LEAST to LARGEST */
    int evaluation_limit;  /* of the rate per point, LEAST to LARGEST */
    int intergranular_off; /* 1: basic hypoplasticity (H1), h left alone; default 0 */
    int tangent;           /* GRIT_TANGENT_..., default NONE */
    int instruction_set;   /* GRIT_ISA_..., default best */
    int stress_is_rotated; /* 1: the host has applied rotation_increment to it */
    int validate_only;     /* 1: check every point and report, change nothing */
} grit_sand_options;

GRIT_API grit_status grit_sand_options_init(grit_sand_options* options, size_t struct_size);

/* n points as the host stores them. Zero-initialise, set struct_size, then what is needed.
 * The tangent, d stress / d strain, may be left out with GRIT_TANGENT_NONE; substep is advice that is
 * handed back for the next call. This struct and the options are read while a call lasts: nobody may
 * change them meanwhile. */
typedef struct grit_sand_points {
    size_t struct_size;
    int components;               /* 6, or 4 (11 22 33 12: axisymmetric, plane strain); 0 means 6 */
    int reserved;                 /* 0 */
    const ptrdiff_t* index;       /* [n] points to be taken, all distinct; null: 0 ... n-1 */
    grit_view strain_increment;   /* [components] engineering shear, end configuration */
    grit_view rotation_increment; /* [9] row-major Q, proper orthogonal; base null: none */
    grit_mutable_view stress;     /* [components] Cauchy, in: start, out: end */
    grit_mutable_view state;      /* [GRIT_SAND_STATE_SIZE], in: start, out: end */
    grit_mutable_matrix_view tangent; /* [components x components], unsymmetric */
    grit_mutable_view substep;        /* [1] first step to try [strain], 0 none; base null: off */
} grit_sand_points;

/* Bits of grit_sand_report.flags */
enum {
    GRIT_SAND_STRESS_FREE = 1,  /* the point is separated or below the pressure floor */
    GRIT_SAND_VOID_CLAMPED = 2, /* at the end e < e_d or > e_i: f_d, f_e as at the limit */
    GRIT_SAND_OUTSIDE_CONE = 4, /* tan psi >= sqrt 2: deviator scaled back */
    GRIT_SAND_H_CLAMPED = 8,    /* |h| above R by no more than 1 %: scaled to R */
    GRIT_SAND_CAVITATED = 16    /* undrained: at the end the water bears its largest tension */
};

typedef struct grit_sand_report {
    grit_status status;
    int flags;
    int substeps;          /* accepted */
    int evaluations;       /* of the stress rate, rejected steps included */
    double error_estimate; /* of the stress, as controlled: safety factors included */
    double step_reduction; /* 1, or the factor (0, 1) to apply before trying again */
    double reserved[2];
} grit_sand_report;

/* Integrate n points over their strain increments.
 *   tolerance  bounds the stress error of a call, relative to the larger of the stress norms at its
 *              start and end, times the share of it that the call changes where that is below 1.
 *   All or nothing per point: a point that fails keeps stress, state, tangent and substep bitwise,
 *   its report and the return value (the first failed point's status) say why; the others are done.
 *   GRIT_BAD_CALL without a point: nothing was done and no report written. n = 0 is no error.
 *   Output views must not overlap. options, reports [n] and error may be null.
 *   A point's result is bitwise the same whatever n, its place and its neighbours are. */
GRIT_API grit_status grit_sand_update(const grit_sand* sand, const grit_sand_options* options,
                                      ptrdiff_t n, const grit_sand_points* points,
                                      grit_sand_report* reports, grit_error* error);

#ifdef __cplusplus
}
#endif
