/* SPDX-License-Identifier: BSD-3-Clause
 * Normals for grit_contact_correct: one unit normal per node and pair of bodies, pointing from A to B,
 * (C2). Sources: the gradient of the stiffer body, the average of both gradients, vectors that the
 * host has, or a logistic regression of the two particle clouds.
 *
 *   a node at the right of A and the left of B has n = +1 along x, whatever the source is
 *
 * Where a normal is undefined it is all zero: give grit_contact_correct allow_zero_normal = 1.
 * Two components: plane strain or axisymmetry (r, z). */
#pragma once

#include <stddef.h>

#include <grit/export.h>
#include <grit/status.h>
#include <grit/view.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { GRIT_CONTACT_BODY_A = 0, GRIT_CONTACT_BODY_B = 1 };

/* Bits of fixed: components that symmetry keeps at zero (the radial one on the axis, the one across a
 * symmetry plane). They are left out before the vector is normalised. */
enum { GRIT_CONTACT_FIXED_1 = 1, GRIT_CONTACT_FIXED_2 = 2, GRIT_CONTACT_FIXED_3 = 4 };

/* How many nodes of a call ended how. Set struct_size. */
typedef struct grit_contact_normal_counts {
    size_t struct_size;
    ptrdiff_t defined;   /* a unit normal was written */
    ptrdiff_t undefined; /* zeros were written */
    ptrdiff_t failed;    /* bad input: untouched */
} grit_contact_normal_counts;

/* ---- from gradients or given vectors ----------------------------------------------------------- */

enum {
    GRIT_CONTACT_NORMAL_OF_A = 0,    /* A is the stiffer body: n = g_A / |g_A| */
    GRIT_CONTACT_NORMAL_OF_B = 1,    /* B is the stiffer body: n = -g_B / |g_B| */
    GRIT_CONTACT_NORMAL_AVERAGE = 2, /* n along g_A - g_B */
    GRIT_CONTACT_NORMAL_GIVEN = 3    /* n along given */
};

/* n nodes as the host stores them, c = components. Zero-initialise, set struct_size, then what is
 * needed; what the source does not use is not read. g = sum_p V_p grad N(x_p) points out of its body;
 * in axisymmetry with areas V_p / r_p and the unweighted shape functions, (A2) with k = 0. */
typedef struct grit_contact_gradients {
    size_t struct_size;
    int components;         /* 2 or 3 */
    int source;             /* GRIT_CONTACT_NORMAL_... */
    const ptrdiff_t* index; /* [n] nodes to be taken, all distinct; null: 0 ... n-1 */
    grit_view gradient_a;   /* [c] of body A, any unit */
    grit_view gradient_b;   /* [c] of body B, the unit of gradient_a */
    grit_view given;        /* [c] from A to B, of any length */
    grit_view scale;        /* [1] optional, >= 0: size of what a gradient sums, say
                                   sum_p V_p |grad N|; without it a node inside a body has the normal
                                   that roundoff gives it */
    double threshold; /* [-] in [0, 1); 0 means 1e-8. Undefined: |v| <= threshold * size, v what
                                   is left without the fixed components, size the larger of scale
                                   and what went into v: |g|, or |g_A| + |g_B| */
    const int* fixed; /* optional: bits GRIT_CONTACT_FIXED_... per node */
    ptrdiff_t fixed_stride;   /* in ints; 0 means 1 */
    grit_status* status;      /* [n] optional, out, in the order of the call */
    grit_mutable_view normal; /* [c] out; may be the memory of an input view */
} grit_contact_gradients;

/* Normals of n nodes. Any finite size of the vectors is good: nothing overflows.
 *   GRIT_BAD_STATE: a component or scale is not finite; GRIT_BAD_CALL: fixed has unknown bits. Such a
 *   node is untouched, the others are done; the first one's status is returned.
 *   GRIT_BAD_CALL without a node: nothing was done. n = 0 is no error. counts and error may be null.
 *   Nodes are independent: safe on disjoint ranges from several threads. */
GRIT_API grit_status grit_contact_normals_from_gradients(ptrdiff_t n,
                                                         const grit_contact_gradients* gradients,
                                                         grit_contact_normal_counts* counts,
                                                         grit_error* error);

/* ---- logistic regression of two particle clouds ------------------------------------------------ */

/* The particles around n nodes. Zero-initialise, set struct_size, then what is needed.
 * The normal is w / |w| of the plane w.x + b = 0 that minimises
 *
 *   sum_p a_p log(1 + exp(-y_p (w.x_p + b)))  +  ridge / 2 |w|^2
 *
 * with y = -1 for A, +1 for B, x in units of length, and a_p the particle's share of the weight of its
 * body times 1/2: an idea of Nairn, Hammerquist & Smith (2020), "New material point method contact
 * algorithms for improved accuracy, large-deformation problems, and proper null-space filtering".
 * The minimum is unique, whether the clouds overlap, can be separated,
 * or lie on a line; it does not depend on the origin, nor on the order of the particles but for
 * roundoff. Fixed components of w are zero throughout: half a symmetric cloud gives the normal of the
 * whole. Undefined: one body alone, or clouds that do not differ (coincident particles). */
typedef struct grit_contact_clouds {
    size_t struct_size;
    int components;            /* 2 or 3 */
    int instruction_set;       /* GRIT_ISA_..., default best */
    const ptrdiff_t* index;    /* [n] nodes to be taken, all distinct; null: 0 ... n-1 */
    const ptrdiff_t* offset;   /* node i has particle[offset[i]] ... particle[offset[i + 1] - 1] */
    const ptrdiff_t* particle; /* ids; null: the k-th entry is particle k */
    ptrdiff_t particles;       /* ids are in 0 ... particles-1 */
    grit_view position;        /* [c] x_p [length] */
    const int* body;           /* per particle: GRIT_CONTACT_BODY_A or _B */
    ptrdiff_t body_stride;     /* in ints; 0 means 1 */
    grit_view weight; /* [1] optional, 0 or [1e-100, 1e100], any unit, say V_p; 0: not there */
    double length;    /* [length] > 0, the cell; a cloud extends over 200 of it at most per axis */
    double ridge;     /* [-] in [1e-6, 1e3]; 0 means 1e-3. Small: the widest gap between the
                                      outermost particles; large: the line of the centroids */
    int iteration_limit;      /* evaluations of the loss; 0 means 100 */
    int reserved;             /* 0 */
    const int* fixed;         /* optional: bits GRIT_CONTACT_FIXED_... per node */
    ptrdiff_t fixed_stride;   /* in ints; 0 means 1 */
    grit_status* status;      /* [n] optional, out, in the order of the call */
    grit_mutable_view normal; /* [c] out */
} grit_contact_clouds;

/* Bytes of workspace that a call needs whose nodes have at most so many particles; 0 if an argument
 * makes no sense. One workspace per thread. */
GRIT_API size_t grit_contact_regression_workspace_size(ptrdiff_t most_particles_per_node,
                                                       int components);

/* Normals of n nodes, to about 1e-11.
 *   workspace  of any alignment, workspace_size bytes; too small for a node of the call is
 *              GRIT_BAD_CALL and nothing is done.
 *   GRIT_BAD_STATE: position, weight or distance between particles out of range; GRIT_BAD_CALL: list,
 *   id, body label or fixed; GRIT_NOT_CONVERGED: iteration_limit. Such a node is untouched, the others
 *   are done; the first one's status is returned. GRIT_BAD_CALL without a node: nothing was done.
 *   n = 0 is no error. counts and error may be null.
 *   A node's result is bitwise the same whatever n, its place and its neighbours are. */
GRIT_API grit_status grit_contact_normals_by_regression(ptrdiff_t n,
                                                        const grit_contact_clouds* clouds,
                                                        void* workspace, size_t workspace_size,
                                                        grit_contact_normal_counts* counts,
                                                        grit_error* error);

#ifdef __cplusplus
}
#endif
