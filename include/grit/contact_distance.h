/* SPDX-License-Identifier: BSD-3-Clause
 * The distance s and the gap that grit_contact_correct takes, (C3) and (C4), from the domains of the
 * particles: every node keeps the smallest distance from a body's surface to it, a reduction by
 * minimum that a host runs in its own loop over particles.
 *
 *   reset, then add the particles of A and of B in any order and any number of calls, then finish
 *
 * Threads fill arrays of their own and merge them; processes reduce them with MPI_MIN. A minimum has
 * no roundoff: the result is bitwise the same in any order. */
#pragma once

#include <stddef.h>

#include <grit/export.h>
#include <grit/status.h>
#include <grit/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Nodes as the host stores them, c = components. Zero-initialise, set struct_size, then what is
 * needed. Node ids are in 0 ... nodes-1; lengths are within 1e100 of 0. */
typedef struct grit_contact_surfaces {
    size_t struct_size;
    int components;     /* 2 or 3 */
    int reserved;       /* 0 */
    ptrdiff_t nodes;    /* how many the views hold */
    grit_view position; /* [c] of the node [length]; read by add */
    grit_view normal;   /* [c] unit normal A -> B, |n|^2 within 1e-6 of 1, or all zero where it is
                                  undefined: surface is left alone there; read by add */
    grit_mutable_view surface; /* [2] distance from the surface to the node along n, negative inside
                                      the body [length]: smallest (x_node - x).n over the corners x of
                                      A's particles; smallest (x - x_node).n over those of B's */
    grit_mutable_view centre;  /* [2] optional: smallest |x_p - x_node| over the centres of A's
                                      particles; of B's [length] */
} grit_contact_surfaces;

/* Particles of one body. Particle p has weight at the nodes node[offset[p]] ... node[offset[p+1] - 1],
 * or, where offset is null, at node[p * nodes_each] ... ; an id of -1 is skipped. List those nodes
 * only where its weight is not zero. Its domain is the parallelogram or parallelepiped
 * x_p + sum_j (+-) r_j of CPDI, whose farthest corner along n is at x_p.n + sum_j |r_j.n|. */
typedef struct grit_contact_domains {
    size_t struct_size;
    int body;                /* 0: A, 1: B */
    int sides;               /* half-side vectors per particle, 0 (points) ... 3 */
    const ptrdiff_t* index;  /* [n] particles to be taken; null: 0 ... n-1 */
    const ptrdiff_t* offset; /* [particles + 1] or null */
    ptrdiff_t nodes_each;    /* without offset */
    const ptrdiff_t* node;
    grit_view position;    /* [c] x_p [length] */
    grit_matrix_view side; /* [sides][c] rows r_j [length]; not read with sides 0 */
} grit_contact_domains;

/* What s is. */
enum {
    GRIT_CONTACT_SUPPORT = 0,       /* (C4): surface of the stiffer body to the node, signed */
    GRIT_CONTACT_EDGE = 1,          /* the absolute value of that */
    GRIT_CONTACT_NEAREST_CENTRE = 2 /* nearest centre of the stiffer body: the literal reading */
};

/* What is wanted of the surfaces. At least one of distance and gap. */
typedef struct grit_contact_distances {
    size_t struct_size;
    int stiffer;            /* body whose distance is s, 0: A, 1: B; not read without distance */
    int measure;            /* GRIT_CONTACT_SUPPORT (default) ...; not read without distance */
    const ptrdiff_t* index; /* [n] nodes to be taken; null: 0 ... n-1 */
    grit_mutable_view distance; /* [1] s [length], +infinity where no particle of the stiffer body
                                   reached the node; where n is undefined too, but for
                                   NEAREST_CENTRE */
    grit_mutable_view gap;      /* [1] from A's surface to B's along n [length], negative: overlap;
                                   +infinity unless both bodies reached the node */
} grit_contact_distances;

/* All minima of nodes 0 ... nodes-1 become +infinity. */
GRIT_API grit_status grit_contact_surfaces_reset(const grit_contact_surfaces* surfaces,
                                                 grit_error* error);

/* Add n particles of one body: n = 1 is as good as many.
 *   GRIT_BAD_STATE: position, side or a node's position or normal are not what they must be;
 *   GRIT_BAD_CALL with a particle: its list. Such a particle adds nothing, the others are added; the
 *   first one's status is returned. GRIT_BAD_CALL without a particle: nothing was done. error may be
 *   null. Not safe on the same surfaces from several threads: merge. */
GRIT_API grit_status grit_contact_surfaces_add(const grit_contact_surfaces* surfaces, ptrdiff_t n,
                                               const grit_contact_domains* domains,
                                               grit_error* error);

/* into becomes the smaller of into and from, for every node; NaN if either is. Both have centre, or
 * neither. */
GRIT_API grit_status grit_contact_surfaces_merge(const grit_contact_surfaces* into,
                                                 const grit_contact_surfaces* from,
                                                 grit_error* error);

/* s and gap of n nodes. GRIT_BAD_STATE: a minimum is not above -infinity (never reset?); such a node
 * is untouched, the others are done. GRIT_BAD_CALL without a node: nothing was done. */
GRIT_API grit_status grit_contact_surfaces_finish(const grit_contact_surfaces* surfaces,
                                                  ptrdiff_t n,
                                                  const grit_contact_distances* distances,
                                                  grit_error* error);

#ifdef __cplusplus
}
#endif
