/* SPDX-License-Identifier: BSD-3-Clause
 * Surface contact: impulses between the true surfaces of two bodies that live on a grid, in the plane,
 * in axisymmetry and in space. No stiffness and no power that must be chosen, no strip of the grid that
 * moves along with the surface. Equations (V1)-(V5), (V8) and decisions: docs/contact.md.
 *
 *   surfaces as facets, their vertices with the shape functions that move them
 *     ->  grit_surface_correct after the momentum update  ->  velocities of the nodes, in place
 *
 * A's facets give the normals and carry the pressure: A is the stiffer or less distorted body.
 * Plane: per metre of thickness. Axisymmetric: components are (r, z), impulses and energies per radian,
 * masses too. [length], [time], [mass]: any consistent units. */
#pragma once

#include <stddef.h>

#include <grit/export.h>
#include <grit/status.h>
#include <grit/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- options --------------------------------------------------------------------------------- */

typedef struct grit_surface_options {
    size_t struct_size;     /* set by init */
    int components;         /* 2 (default) or 3 */
    int axisymmetric;       /* 0 (default); 1: components are (r, z), per radian; 2 components */
    int validate_only;      /* 1: reports and totals only; velocities stay */
    int sweep_limit;        /* sweeps over the pressures in [1, 100000], default 500 */
    double sweep_tolerance; /* [-] in (0, 1], default 1e-6: a sweep that changes no velocity by more
                                    than this share of the largest approach is the last one */
    double friction_coefficient; /* mu [-] in [0, 1e6], default 0 */
    double time_step;            /* dt [time] in [1e-30, 1e30], no default */
    double
        spacing; /* [length] in [1e-30, 1e30], no default: of the points that carry pressure, about;
                       two cells of the grid: less is more than its nodes can follow beside ends of
                       a stretch, see end_spacings */
    double
        reach; /* [length] in [1e-30, 1e30], no default: how far apart, or how deep in each other,
                       facets are looked at; about a cell, and more than a step's motion */
    double
        end_spacings; /* [-] in [1, 10], default 1: 2 components: how many spacings the points next
                       to an end of a smooth stretch are away from it. 2 with a spacing of one cell:
                       closer where surfaces curve, and no stiffer at the edge of a punch */
    double
        contact_stiffness; /* eps [stress / length] in [0, 1e30], default 0: rigid, and overlap that is
                       there stays. Else the pressure is eps (overlap + relaxation_time its rate) at
                       the end of the step, implicit, (V8): an elastic layer, the spring of (C9) where the
                       surface is, with a dashpot eps tau */
    double
        relaxation_time; /* tau [time] in [0, 1e30], default 0: overlap that nothing presses leaves at
                       overlap / (tau + time_step), no faster; needs a contact_stiffness */
} grit_surface_options;

GRIT_API grit_status grit_surface_options_init(grit_surface_options* options, size_t struct_size);

/* ---- the surface of a body ------------------------------------------------------------------- */

/* Vertices of no facet are not looked at. Facets are segments (2 components), with the body on the left of
 * the way from the first vertex to the second, or triangles (3), whose vertices go round counter-clockwise as seen from outside. Neighbours
 * that share vertices and turn by less than 30 degrees are one smooth stretch: pressure is continuous
 * there, and jumps where the surface turns by more. Facets of A that are longer than the spacing are
 * allowed, but their pressure is known at their vertices alone. Those thinner than a millionth of the
 * spacing meet nothing, as their normal may be roundoff.
 * Zero-initialise, set struct_size, then what is needed. */
typedef struct grit_surface {
    size_t struct_size;
    int rigid;              /* 1: moves as vertex_velocity says; of nodes nothing is read */
    int nodes_each;         /* nodes per vertex in [1, 64] */
    ptrdiff_t vertices;     /* >= 0 */
    ptrdiff_t facets;       /* >= 0; none: no contact */
    grit_view position;     /* [vertices][components] at the start of the step [length] */
    const ptrdiff_t* facet; /* [facets][components] vertices */
    const ptrdiff_t* node;  /* [vertices][nodes_each] in [0, nodes); not read where weight is 0 */
    const double* weight;   /* [vertices][nodes_each] N_i [-] in [0, 1], sum 1 to 1e-6; momentum
                                  is kept as far as they add up to 1 */
    ptrdiff_t nodes;        /* how many the views hold */
    grit_view mass;         /* [nodes] m_i in [1e-30, 1e30] of the nodes in contact [mass] */
    const int* fixed;       /* [nodes] optional: bit c: component c of the velocity is held */
    grit_mutable_view velocity;  /* [nodes][components] after the momentum update [length / time] */
    grit_view previous_velocity; /* [nodes][components] optional: before it, for the dissipation */
    grit_view vertex_velocity;   /* [vertices][components] of a rigid body [length / time] */
    const double* spacing; /* [facets] optional, of A: in the place of the options' [length] in
                                    [1e-30, 1e30], where cells differ along the surface */
    /* Water that flows through the body with a velocity of its own, optional: mass and velocity above are
     * then those of its grains. None of it passes the surface where that is in contact, (V7). */
    grit_view pores; /* [nodes][3] of the nodes in contact: mass of the water in [0, 1e30], 0:
                                     none is there; impulse of the drag of this step for a velocity against
                                     the grains, implicit, in [0, 1e30], both [mass]; porosity in [0, 1] */
    const int* water_fixed; /* [nodes] optional, of the water; else fixed counts for it as well */
    grit_mutable_view seepage;  /* [nodes][components] of the water against the grains, after the
                                     momentum update and drag [length / time]: needed with pores */
    grit_view previous_seepage; /* [nodes][components] optional: before it, for the dissipation */
    const double*
        pore_pressure; /* [facets] optional: of water in the body there, within +-1e30 [stress]:
                                     its part of the pressure of the contact does not rub, (V4) */
    /* For grit_surface_correct_pairs: pairs that name the same body have its nodes in common. */
    int body; /* >= 0; 0 (default): of no other pair */
    const ptrdiff_t*
        number; /* [nodes] optional: what all pairs call the nodes, where each has memory of its
                                     own for them; null: the same as here */
} grit_surface;

/* What acts on a facet of A. */
typedef struct grit_surface_report {
    double area; /* in contact: length, times r per radian, or area */
    double gap;  /* smallest distance to B along the normal at the start of the step, negative:
                             overlap; +infinity: nothing of B within reach [length] */
    double normal_force;   /* pressure on it, >= 0 [force] */
    double friction_force; /* [force], the resultant's length */
    double force[3];       /* on A [force] */
} grit_surface_report;

/* What one point that carries pressure does, for hosts that go on with velocities after contact: its approach is the
 * sum of direction[k] . v over its terms, and rigid[k]; its impulse k changes the momentum of a node by
 * -impulse direction[k]. k = 0: along the normal; its approach is bound where it bears, which is no law to go on with
 * where there is a contact_stiffness. */
typedef struct grit_surface_row {
    ptrdiff_t first_term, terms;
    double bound;      /* approach that closes the gap and no more [length / time] */
    double rigid[3];   /* by rigid bodies [length / time] */
    double impulse[3]; /* [force time] */
    double water_impulse
        [2]; /* of the water of a and b, whose flow is the sum of n direction[0] . seepage */
} grit_surface_row;
typedef struct grit_surface_term {
    ptrdiff_t node;
    int of_b;               /* 0: of a, 1: of b */
    double direction[3][3]; /* of k [-] */
} grit_surface_term;

typedef struct grit_surface_totals {
    size_t struct_size;     /* set by the caller */
    double impulse_on_a[3]; /* [force time]; on B the opposite, to roundoff */
    double impulse_on_b[3];
    double normal_impulse; /* sum of p A dt [force time] */
    double area;           /* in contact */
    double
        dissipation_normal; /* J . (w_old + w_new) / 2 [energy], what a contact_stiffness takes up and
                               gives back with it; with previous_velocity of all that */
    double dissipation_tangential; /* are not rigid, else 0 */
    double smallest_gap;           /* of all facets; +infinity: none within reach [length] */
    double largest_approach;       /* beyond the bound, without contact [length / time] */
    double residual;     /* largest change of a velocity in the last sweep [length / time] */
    ptrdiff_t points;    /* of integration in contact */
    ptrdiff_t pressures; /* that are > 0 */
    ptrdiff_t sweeps;
    /* In the workspace, until it is used again, be it by a call that fails and leaves these as they were. */
    const grit_surface_row* row;
    const grit_surface_term* term;
    ptrdiff_t rows;
} grit_surface_totals;

/* ---- contact --------------------------------------------------------------------------------- */

/* Bytes of workspace that surfaces of so many facets and vertices need where they lie along each other
 * and their facets are of like size; 0 for impossible counts. Where many small facets lie opposite many
 * others more may be needed: the call fails and needed says how much to try. Any contents, 8-byte
 * aligned; nothing is kept in it between calls. */
GRIT_API size_t grit_surface_workspace_size(const grit_surface* a, const grit_surface* b);

/* Velocities after contact, (V1)-(V5), (V7), (V8), in place.
 *   where     every point of A sees the facet of B that comes first along A's normal, from as deep in A
 *             as reach is to as far outside: a layer of B inside of A hides what is behind it.
 *   when      it is in contact if its gap is overrun at the end of the step, or less than a fiftieth of
 *             the reach; overlap that is there stays, but does not grow. With a contact_stiffness it
 *             grows with the pressure and goes with it.
 *   pressure  >= 0, between points of A that are spacing apart, so that the mean approach around each of
 *             them is what closes the gap; friction opposes the slip that is left, <= mu times what of it
 *             pore water does not bear.
 *   Both bodies feel the same impulses at the same points: linear momentum is kept to roundoff, and no
 *   energy is made in the frame of a rigid body, however many sweeps were taken; with a contact_stiffness
 *   kinetic energy grows by no more than the surfaces held.
 *   All or nothing: on failure nothing is written; error->point is the vertex, facet or node, the
 *   message says whose. GRIT_BAD_CALL: a struct, a view, a list, the workspace; GRIT_BAD_STATE: numbers.
 *   needed: bytes of workspace to try next, where that is what failed; else 0. May be null.
 *   reports [facets of A], totals and error may be null. Deterministic; calls on disjoint data are safe
 *   from several threads. Bodies that touch a third one: grit_surface_correct_pairs. */
GRIT_API grit_status grit_surface_correct(const grit_surface_options* options,
                                          const grit_surface* a, const grit_surface* b,
                                          void* workspace, size_t workspace_size, size_t* needed,
                                          grit_surface_report* reports, grit_surface_totals* totals,
                                          grit_error* error);

/* Of several pairs at once. Where bodies touch more than one other, what bears in one pair is the load of another: a
 * plate between two blocks, layers of ground along a wall. One call after the other leaves an approach,
 * and so an overlap that grows with every step, as long as they are pressed. */
typedef struct grit_surface_pair {
    const grit_surface_options* options; /* the same number of components in all pairs */
    const grit_surface *a, *b;
    grit_surface_report* reports; /* [facets of a]; may be null */
    grit_surface_totals* totals;  /* may be null */
} grit_surface_pair;

/* Bytes of workspace, as grit_surface_workspace_size for each of n pairs; 0 for impossible counts. */
GRIT_API size_t grit_surface_pairs_workspace_size(const grit_surface_pair* pairs, ptrdiff_t n);

/* grit_surface_correct of n pairs, in [0, 1000000], whose sweeps go through all that hang together by nodes of
 * bodies that several of them name, until none of these is changed; the sweep_limit is the largest of theirs.
 * Surfaces meet as they would in a call of their own, with the velocities that are given; those of
 * a node of a body are to be the same in all pairs (the first pair's count), and are after it.
 *   All or nothing: error->message begins with the pair. A pair that hangs together with none has the bits of a call of its own. */
GRIT_API grit_status grit_surface_correct_pairs(const grit_surface_pair* pairs, ptrdiff_t n,
                                                void* workspace, size_t workspace_size,
                                                size_t* needed, grit_error* error);

/* ---- surfaces of particles ------------------------------------------------------------------- */

/* Domains of particles of one body: parallelograms x_p +- r_1 +- r_2 of CPDI, r_1 x r_2 > 0. */
typedef struct grit_surface_domains {
    size_t struct_size;
    ptrdiff_t n;
    const ptrdiff_t* index; /* [n] particles to be taken; null: 0 ... n-1 */
    grit_view position;     /* [2] x_p [length] */
    grit_matrix_view side;  /* [2][2] rows r_1, r_2 [length] */
    double tolerance; /* [-] in (0, 0.5], share of a domain's width: gaps between neighbours up to
                               this wide are none, pieces of an edge up to this long do not
                               make it free, corners this near are one vertex */
} grit_surface_domains;

/* Bytes of workspace for n domains; 0 for impossible counts. */
GRIT_API size_t grit_surface_find_free_workspace_size(ptrdiff_t n);

/* The free edges of domains: those that no neighbour's domain covers, tolerance times a width outside
 * along the other sides, over a piece that is longer than the tolerance, as a share of the edge. They
 * become facets with the body on the left, whole; corners of neighbours that are free and near become
 * one vertex, at their mean.
 *   position  [4 n][2] out: of *vertices vertices, at most
 *   facet     [4 n][2] out: of *facets facets
 *   owner     [4 n] optional out: the entry of index (or the particle) of a facet
 * Deterministic, O(n) for domains of like size. GRIT_BAD_STATE: a position or side is not finite, or a
 * domain has no area. */
GRIT_API grit_status grit_surface_find_free(const grit_surface_domains* domains, void* workspace,
                                            size_t workspace_size, double* position,
                                            ptrdiff_t* facet, ptrdiff_t* owner, ptrdiff_t* vertices,
                                            ptrdiff_t* facets, grit_error* error);

#ifdef __cplusplus
}
#endif
