/* SPDX-License-Identifier: BSD-3-Clause
 * Penalty contact of two bodies with linear surface elements (PCA), plane or axisymmetric: the
 * standard node-to-segment penalty, both bodies in turn as slave. Equations (S1)-(S5) and decisions:
 * docs/contact.md.
 *
 *   each body carries the polyline of its boundary  ->  grit_penalty_forces  ->  external forces,
 *   which the host scatters to its grid before the momentum update
 *
 * Plane: per metre of thickness. Axisymmetric: components are (r, z), forces and energies per radian.
 * [stress], [length], [time], [mass]: any consistent units. More than two bodies: one call per pair,
 * each with its own history; forces are added up. */
#pragma once

#include <stddef.h>

#include <grit/export.h>
#include <grit/status.h>
#include <grit/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- options --------------------------------------------------------------------------------- */

typedef struct grit_penalty_options {
    size_t struct_size;          /* set by init */
    int axisymmetric;            /* 0 (default): plane; 1: components are (r, z), per radian */
    int validate_only;           /* 1: reports and totals only; force, stiffness, history stay */
    double normal_stiffness;     /* eps_n [stress / length] in (0, 1e60], no default */
    double tangential_stiffness; /* eps_t [stress / length]; 0 (default): eps_n */
    double friction_coefficient; /* mu [-] in [0, 1e6], default 0 */
    double depth_max;            /* [length] in (0, 1e30], about a cell of the grid, no default */
    double time_step;            /* dt [time] in (0, 1e30], no default; read with friction only */
} grit_penalty_options;

GRIT_API grit_status grit_penalty_options_init(grit_penalty_options* options, size_t struct_size);

/* eps_n = multiple * modulus / cell_size, with the P-wave modulus of the softer body, (S2).
 * multiple 0 means 1: the surfaces overlap by what one cell is compressed under the same stress, and
 * (S5) asks for about the step that the grid asks for. GRIT_BAD_CALL unless multiple in [0, 1e6],
 * modulus [stress] > 0, cell_size [length] > 0 and the result is in (0, 1e60]. */
GRIT_API grit_status grit_penalty_stiffness(double multiple, double modulus, double cell_size,
                                            double* normal_stiffness);

/* ---- the surface of a body ------------------------------------------------------------------- */

/* History of a vertex with its partner: all zero is no contact. */
enum {
    GRIT_PENALTY_TANGENTIAL_TRACTION = 0, /* t_t [stress] on the partner, along its line's travel */
    GRIT_PENALTY_NORMAL_TRACTION = 1,     /* t_n [stress] >= 0, pressure + */
    GRIT_PENALTY_HISTORY_SIZE = 2
};

enum { GRIT_PENALTY_OPEN = 0, GRIT_PENALTY_STICK = 1, GRIT_PENALTY_SLIP = 2 };

/* What a vertex sees as slave. */
typedef struct grit_penalty_report {
    int state; /* GRIT_PENALTY_OPEN ... SLIP; without friction a contact slips */
    int reserved;
    ptrdiff_t segment;      /* of the partner, -1 if open; segment j joins vertices j and j + 1 */
    double place;           /* xi in [0, 1] along it */
    double gap;             /* g [length] < 0, 0 if open */
    double normal[2];       /* outward normal of the partner there [-] */
    double area;            /* A_v [area per metre or radian], its share of the contact */
    double normal_traction; /* t_n [stress] */
    double tangential_traction; /* t_t [stress], as in the history */
    double slip_rate;           /* Delta g_t / dt [length / time] along the partner's travel */
} grit_penalty_report;

/* The boundary of one body, or a part of it: vertices 0 ... count - 1 and the segments between them.
 * The body lies on the left of the direction of travel, so that the outward normal points right. An
 * open line ends where the body meets the axis, a plane of symmetry or the border of the model:
 * nothing is found beyond its ends. Vertices move with their own body.
 * Zero-initialise, set struct_size, then what is needed. What is written may not overlap anything. */
typedef struct grit_penalty_surface {
    size_t struct_size;
    int closed; /* 1: the last vertex is joined to the first */
    int reserved;
    ptrdiff_t count;           /* n >= 2, closed n >= 3 */
    grit_view position;        /* [2] x, y or r, z [length]; r >= 0 but for roundoff */
    grit_view velocity;        /* [2] that took the vertices here [length / time]; with friction */
    grit_mutable_view history; /* [GRIT_PENALTY_HISTORY_SIZE]; with friction, else optional */
    grit_mutable_view force;   /* [2] added to [force per metre or radian] */
    grit_mutable_view stiffness;  /* [1] optional, added to: for the step, (S5) */
    grit_penalty_report* reports; /* [n] optional */
} grit_penalty_surface;

/* ---- forces ---------------------------------------------------------------------------------- */

typedef struct grit_penalty_totals {
    size_t struct_size;                  /* set by the caller */
    double force_on_a[2], force_on_b[2]; /* [force per metre or radian] */
    double moment_on_a, moment_on_b;     /* about the origin, x f_y - y f_x; plane only */
    double contact_area;                 /* sum of A_v */
    double normal_force;                 /* sum of t_n A_v */
    double energy_normal;                /* stored, sum of t_n^2 A_v / (2 eps_n) >= 0 */
    double energy_tangential;            /* stored, sum of t_t^2 A_v / (2 eps_t) >= 0 */
    double dissipation;                  /* by friction in this step >= 0 */
    double largest_penetration;          /* [length] >= 0 */
    ptrdiff_t contacts_a, contacts_b;    /* vertices of A, of B that are in contact as slaves */
    ptrdiff_t slips;                     /* of these, with friction at its limit */
    ptrdiff_t tests;                     /* of boxes and segments in the search: what it cost */
} grit_penalty_totals;

/* Bytes of workspace for surfaces of n_a and n_b vertices; 0 for impossible counts. Any contents, 8-byte
 * aligned; nothing is kept in it between calls. */
GRIT_API size_t grit_penalty_workspace_size(ptrdiff_t n_a, ptrdiff_t n_b);

/* Forces of contact between A and B from where their vertices are, (S1)-(S4).
 *   search    each vertex of one body takes the nearest point of the other's line, ties by segment; it
 *             is in contact if -depth_max <= g < 0 and one of its own segments faces that point. At a
 *             re-entrant corner the normal points from the vertex to the corner.
 *   area      A_v: the length of the partner's line (times r) that lies opposite the halves of the
 *             vertex' segments, as far as both face each other and overlap; what is less than half as
 *             deep as the vertex counts less. Where the partner's vertices see the same place the
 *             stiffness is halved, and less so the less they see of half this depth, so that no force
 *             jumps. In flush contact A_v is half its two segments, as in (S2).
 *   friction  trial t_t + eps_t Delta g_t, returned to mu t_n; zeroed on release. Delta g_t is free of
 *             rigid motions of both; in the first step of a contact it counts from the touch on.
 *   Action equals reaction to roundoff. Moments balance but for friction, whose two forces act a
 *   distance |g| apart.
 *   All or nothing: on failure nothing is written; error->point is the vertex, the message says whose.
 *   The search is rebuilt in each call: O(n_a + n_b) for lines that overlap along their length,
 *   whatever the lengths of their segments. Body swap changes roundoff only.
 *   totals and error may be null. Calls on disjoint data are safe from several threads. */
GRIT_API grit_status grit_penalty_forces(const grit_penalty_options* options,
                                         const grit_penalty_surface* a,
                                         const grit_penalty_surface* b, void* workspace,
                                         size_t workspace_size, grit_penalty_totals* totals,
                                         grit_error* error);

/* ---- stable step ----------------------------------------------------------------------------- */

/* Add to stiffness, before there is any contact, what each vertex would get if the whole line were in
 * flush contact: max(eps_n, eps_t) A_v, half its two segments (times r). Reads position, writes
 * stiffness; the rest of surface may be empty. The options as in grit_penalty_forces. */
GRIT_API grit_status grit_penalty_flush_stiffness(const grit_penalty_options* options,
                                                  const grit_penalty_surface* surface,
                                                  grit_error* error);

/* (S5): the host scatters the stiffness of the vertices to its nodes by the shape functions that
 * scatter the forces, k_i = sum of N_i k_v, per body and over all its contacts; then
 *   step = 2 / sqrt(max_A k_i / m_i + max_B k_i / m_i) [time]
 * is stable: an upper bound of the frequency, exact for one spring between two masses. A body that
 * cannot move has n = 0, then it is 2 sqrt(m_i / k_i). For more bodies take the two with the largest
 * ratios. Together with the stable step of the bodies themselves: 1 / step^2 = sum of 1 / step^2.
 * A contact whose area grows with its depth, a tip, is stiffer than its reported t_n A_v / |g| (by up
 * to 3 for a cone): take grit_penalty_flush_stiffness, or a factor on the step, where tips matter.
 * No stiffness anywhere: infinity. mass, stiffness [n][1]; a node with stiffness needs mass > 0. */
GRIT_API grit_status grit_penalty_stable_step(ptrdiff_t n_a, const grit_view* mass_a,
                                              const grit_view* stiffness_a, ptrdiff_t n_b,
                                              const grit_view* mass_b, const grit_view* stiffness_b,
                                              double* step, grit_error* error);

/* ---- splitting and merging ------------------------------------------------------------------- */

/* In: a line. Out: the line with segments no longer than longest and, where its shape allows, no
 * shorter than shortest. Zero-initialise, set struct_size. Old and new memory may not overlap. */
typedef struct grit_penalty_remeshing {
    size_t struct_size;
    int closed;
    int reserved;
    double longest; /* [length] > 0, about a cell; longer segments are split into equal parts */
    double
        shortest; /* [length] in [0, longest / 2]; shorter segments lose a vertex; 0: none does */
    double tolerance;   /* [length] in [0, shortest]: how far a vertex may be from the line that
                         replaces it; a corner moves by no more */
    ptrdiff_t count;    /* of old vertices */
    grit_view position; /* [2] old */
    grit_view history;  /* [GRIT_PENALTY_HISTORY_SIZE] old, optional */
    ptrdiff_t capacity; /* of the new arrays */
    grit_mutable_view new_position; /* [2] */
    grit_mutable_view new_history;  /* [GRIT_PENALTY_HISTORY_SIZE], with history */
    ptrdiff_t* parents;             /* [capacity][2] old vertices of a new one */
    double* weight;                 /* [capacity] of the second: x = (1 - w) x_0 + w x_1 */
} grit_penalty_remeshing;

GRIT_API size_t grit_penalty_remesh_workspace_size(ptrdiff_t count);

/* Split and merge, (S5). A vertex that stays is copied bitwise (parents equal, weight 0), history of a
 * new one is interpolated; use parents and weight for any other data of the vertices. Vertex 0 and the
 * last of an open line stay, a closed line keeps three vertices. Of the ends of a short segment the
 * one goes that the line misses less: a corner goes only next to another corner. Deterministic, O(n).
 * A line that fits is returned as it is; repeated calls settle, since no part is shorter than
 * longest / 2 and each merge leaves one short segment less (a call takes at most 63 neighbours out).
 * capacity too small: GRIT_BAD_CALL, *new_count says what is needed, nothing else is written. */
GRIT_API grit_status grit_penalty_remesh(const grit_penalty_remeshing* remeshing, void* workspace,
                                         size_t workspace_size, ptrdiff_t* new_count,
                                         grit_error* error);

#ifdef __cplusplus
}
#endif
