/* SPDX-License-Identifier: BSD-3-Clause
 * Contact of bodies at the nodes of a grid: the Geo-contact of Ma, Wang & Randolph (2014),
 * doi 10.1002/nag.2266 (GCA), and the frictional contact of Bardenhagen et al. (2000)
 * (FCA), which is its case f_p = 1. Equations (C1)-(C7) and decisions: docs/contact.md.
 *
 *   each body maps mass and velocity to the nodes  ->  grit_contact_correct  ->  corrected velocities
 *
 * Two components: plane strain (per metre) or axisymmetry (mass, area and force per radian).
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include <grit/export.h>
#include <grit/status.h>
#include <grit/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- options --------------------------------------------------------------------------------- */

enum {
    GRIT_CONTACT_GEO = 0,       /* GCA: the normal impulse is scaled by f_p(s), (C4) */
    GRIT_CONTACT_FRICTIONAL = 1 /* FCA: f_p = 1; distance, cell_size and spacing are not read */
};

enum { GRIT_CONTACT_NONE_RIGID = 0, GRIT_CONTACT_A_RIGID = 1, GRIT_CONTACT_B_RIGID = 2 };

#define GRIT_CONTACT_DEFAULT_PENALTY_POWER 6.0
typedef struct grit_contact_options {
    size_t struct_size;          /* set by init */
    int components;              /* 2 or 3, default 3 */
    int law;                     /* GRIT_CONTACT_GEO (default) or _FRICTIONAL */
    double penalty_power;        /* k [-] in (0, 1e6], default GRIT_CONTACT_DEFAULT_PENALTY_POWER */
    double friction_coefficient; /* mu [-] >= 0, default 0 */
    double adhesion;       /* c_a [stress] >= 0, default 0; needs contact_area and time_step */
    double time_step;      /* dt [time] > 0; 0 (default): not given, see grit_contact_nodes */
    double mass_tolerance; /* [-] in [0, 0.5), default 1e-10, (C1) */
    double gap_tolerance;  /* [length], default 0, (C3) */
    int rigid;             /* GRIT_CONTACT_..._RIGID, default NONE */
    int allow_zero_normal; /* 1: a node whose normal is all zero is open; 0 (default): refused */
    int instruction_set;   /* GRIT_ISA_..., default best */
    int validate_only;     /* 1: check every node and report, change nothing */
    /* Geo-contact that does not depend on the step, (C9); both need time_step. */
    double
        relaxation_time; /* tau [time] > 0: f_p is of this time, w_n falls to (1 - f_p) w_n in it;
                               0 (default): of a step, as published */
    double
        contact_stiffness; /* epsilon [stress/length] >= 0 against the overlap max(0, -gap); needs
                                 gap and contact_area; 0 (default): none */
} grit_contact_options;

GRIT_API grit_status grit_contact_options_init(grit_contact_options* options, size_t struct_size);

/* ---- a pair of bodies ------------------------------------------------------------------------ */

/* n nodes as the host stores them, c = components. Zero-initialise, set struct_size, then what is
 * needed. Optional views are off with a null base. A node is inactive unless both masses exceed
 * 1e-200 and mass_tolerance times their sum (with a rigid body: 1e-200 only): its other numbers may be
 * anything, NaN too, but their memory must exist, and velocities may be rewritten with the same bits. Inputs may repeat (point_stride 0); what is written may not overlap.
 * By as much as |n|^2 is off 1, what is left of an approach is off, as a share of it. */
typedef struct grit_contact_nodes {
    size_t struct_size;
    const ptrdiff_t* index; /* [n] nodes to be taken, all distinct; null: 0 ... n-1 */
    grit_view mass_a;       /* [1] nodal mass of body A [mass] in [0, 1e100] */
    grit_view mass_b;       /* [1] of body B */
    grit_view normal;       /* [c] unit normal A -> B [-], |n|^2 within 1e-6 of 1 (see above) */
    grit_view distance;     /* [1] s [length]: surface of the stiffer body to the node, negative
                                       inside the body; +infinity: none (GEO only) */
    grit_view cell_size;    /* [1] d [length] > 0, the cell along n (GEO only); or ... */
    grit_view spacing;      /* [c] ... edges of the cell [length] > 0, d follows from (C4) */
    grit_view gap;          /* [1] optional: surface of A to that of B along n [length] */
    grit_view contact_area; /* [1] A_c [area] >= 0, with adhesion or contact_stiffness only */
    grit_mutable_view velocity_a; /* [c] in: after the momentum update, out: corrected */
    grit_mutable_view velocity_b;
    grit_mutable_view acceleration_a; /* [c] optional, needs time_step: corrected alike */
    grit_mutable_view acceleration_b;
    grit_view previous_velocity_a; /* [c] optional: before the step's forces, for the dissipation */
    grit_view previous_velocity_b;
    grit_view position; /* [c] optional: of the node, for the moments in the sums */
    grit_view
        pore_impulse; /* [1] optional: of pore water's pressure between A and B in the step, dt p_w
                                   A_c [mass velocity], tension negative: the rest of J_n rubs */
} grit_contact_nodes;

enum {
    GRIT_CONTACT_INACTIVE = 0, /* one body only, or none */
    GRIT_CONTACT_OPEN = 1,     /* two bodies that part (and no stiffness pushes), are apart, or
                                  s >= d: bitwise untouched */
    GRIT_CONTACT_STICK = 2,
    GRIT_CONTACT_SLIP = 3 /* always without friction and adhesion */
};

typedef struct grit_contact_report {
    grit_status status;
    int state; /* GRIT_CONTACT_INACTIVE ... SLIP */
    double
        penalty_factor; /* f_p [-], 0 where open; of the step if there is a relaxation time, of that
                              time if there is a contact_stiffness too */
    double impulse[3];  /* J [mass velocity] on B, -J on A; third component 0 in the plane */
    double force[3];    /* J / dt, 0 without time_step */
    /* Energies taken from the trial velocities, each >= 0 (D_n not with contact_stiffness, which gives
     * back). Not the contact's share of an energy balance: a sustained contact counts its load again in
     * every step. */
    double trial_energy_normal;     /* D_n = J_n (w_n - J_n / (2 m_r)) */
    double trial_energy_tangential; /* D_t = J_t (|w_t| - J_t / (2 m_r)) */
    /* J . (w_old + w_new) / 2: what closes the balance of a leapfrog step; needs both
     * previous_velocity views, 0 without. */
    double dissipation_normal;
    double dissipation_tangential;
    double reserved[4];
} grit_contact_report;

/* ---- sums over nodes --------------------------------------------------------------------------- */

/* Exact sums over nodes: whatever the order of the nodes and however they are cut into calls, threads
 * or processes, the totals are the correctly rounded sums. Caller's memory; all zero is empty. Sums of
 * several threads are added by grit_contact_sums_add, of processes by adding words as integers
 * (MPI_SUM of MPI_INT64_T); where processes share nodes, each node may be in the sums of one only: make
 * a call of its own, without sums, for the nodes that another process owns. Holds 2^30 nodes in contact;
 * for the impulse of a long run read the sums of a step and add the totals. */
enum { GRIT_CONTACT_SUMS_WORDS = 1200 };

typedef struct grit_contact_sums {
    int64_t word[GRIT_CONTACT_SUMS_WORDS];
} grit_contact_sums;

typedef struct grit_contact_totals {
    size_t struct_size;                      /* set by the caller */
    double impulse_on_a[3], impulse_on_b[3]; /* in axisymmetry [0] is radial: a sum, no resultant */
    double force_on_a[3], force_on_b[3];     /* [force], 0 without time_step */
    double moment_on_a[3], moment_on_b[3]; /* of the forces about the origin; in the plane [2] only,
                                                x f_y - y f_x (no moment in axisymmetry); 0 without
                                                position */
    double trial_energy_normal, trial_energy_tangential;
    double dissipation_normal, dissipation_tangential;
    ptrdiff_t inactive, open, stick, slip, failed; /* nodes */
} grit_contact_totals;

GRIT_API grit_status grit_contact_sums_add(grit_contact_sums* into, const grit_contact_sums* from);
/* GRIT_BAD_STATE: more than 2^30 nodes in contact were added. */
GRIT_API grit_status grit_contact_sums_read(const grit_contact_sums* sums,
                                            grit_contact_totals* totals);

/* Remove the approach velocity of bodies A and B at n nodes, with one impulse per node, (C1)-(C6).
 *   Each node alone: momentum is kept, kinetic energy never grows without contact_stiffness, friction obeys Coulomb after the
 *   penalty: J_t <= mu max(0, J_n - pore_impulse) + adhesion.
 *   With contact_stiffness, C = m_r f_p / ((1 - f_p) tau), K = epsilon A_c and delta = max(0, -gap):
 *   J_n = dt [(C + K dt) w_n + K delta] / [1 + (C + K dt) dt / m_r] where that is > 0, (C9): spring and
 *   dashpot, implicit; energy is that of velocities and of K delta^2 / 2 then.
 *   All or nothing per node: a bad node keeps velocities and accelerations bitwise, its report and
 *   the return value (the first bad node's status) say why; the others are corrected.
 *   GRIT_BAD_CALL without a node: nothing was done and no report written. n = 0 is no error.
 *   options (null: defaults), reports [n], sums and error may be null. sums are added to.
 *   Nodes are independent: safe on disjoint ranges from several threads, and a node's result is
 *   bitwise the same whatever n, its place and its neighbours are. */
GRIT_API grit_status grit_contact_correct(const grit_contact_options* options, ptrdiff_t n,
                                          const grit_contact_nodes* nodes,
                                          grit_contact_report* reports, grit_contact_sums* sums,
                                          grit_error* error);

/* The penalty factor f_p = 1 - (min(max(s, 0), d) / d)^k of (C4), with 0^k = 0.
 * GRIT_BAD_CALL unless s > -infinity, d > 0, k in (0, 1e6]. */
GRIT_API grit_status grit_contact_penalty_factor(double s, double d, double k, double* f_p);

/* ---- more than two bodies at a node ------------------------------------------------------------ */

enum { GRIT_CONTACT_MOST_BODIES = 8 };

/* One pair of bodies: who they are, their law (options; null: defaults), and what lies between them.
 * A body is rigid in all of its pairs or in none. */
typedef struct grit_contact_pair {
    size_t struct_size;
    int a, b;                            /* bodies 0 ... count - 1 */
    const grit_contact_options* options; /* components, instruction_set, validate_only: not read */
    grit_view normal;                    /* these seven as in grit_contact_nodes */
    grit_view distance;
    grit_view cell_size;
    grit_view spacing;
    grit_view gap;
    grit_view contact_area;
    grit_view pore_impulse;
} grit_contact_pair;

typedef struct grit_contact_bodies {
    size_t struct_size;
    int components;                        /* 2 or 3 */
    int count;                             /* m in [2, GRIT_CONTACT_MOST_BODIES] */
    const ptrdiff_t* index;                /* [n] nodes, all distinct; null: 0 ... n-1 */
    const grit_view* mass;                 /* [m] views [1] */
    const grit_mutable_view* velocity;     /* [m] views [c] */
    const grit_mutable_view* acceleration; /* [m] views [c], or null */
    const grit_view* previous_velocity;    /* [m] views [c], or null */
    grit_view position;                    /* [c] optional */
    double sweep_tolerance; /* largest velocity change / largest approach that ends the sweeps [-]
                               in (0, 1]; 0 means 1e-3 */
    int sweep_limit;        /* >= 0; 0 means 50 */
    int instruction_set;    /* GRIT_ISA_... */
    int validate_only;      /* 0 or 1 */
    int reserved;           /* 0 */
} grit_contact_bodies;

/* Correct the velocities of m bodies at n nodes. Nodes where one pair is active get what
 * grit_contact_correct gives. Where several are, sweeps alternate between all normal impulses, solved
 * together, and friction pair after pair in the given order: at the end each pair's impulse is that of
 * (C5) for the velocities which the others leave. Momentum is kept by every sweep.
 *   pairs [pair_count], all of the same struct_size; at most one pair for two bodies, none for two
 *   rigid ones. Any bad pair at a node: the node is untouched.
 *   Normals of pairs at a node that differ by less than 1e-6 are taken for one, that of the first of them. Where roundoff leaves more
 *   approach than 1e-6 of the relative speed, or impulses are beyond all measure, it is done again with 1e-5, then with 1e-4.
 *   The sweeps end when no velocity changes by more than sweep_tolerance times the largest approach of
 *   those that can touch, or after sweep_limit. Where friction then gains energy (Coulomb's law at several normals may), or has
 *   not settled and more than a tenth of the approach is left, the node gets normal impulses only.
 *   GRIT_NOT_CONVERGED: no normal impulses keep the bodies apart (one is squeezed between two rigid
 *   ones that move differently, or would have to leave them 1e4 times as fast or under 1e10 times the load
 *   that what is free could take; or a spring presses around a ring); that node is untouched.
 *   reports [n][pair_count] and sums [pair_count] as above, per pair; may be null. */
GRIT_API grit_status grit_contact_correct_many(const grit_contact_bodies* bodies, int pair_count,
                                               const grit_contact_pair* pairs, ptrdiff_t n,
                                               grit_contact_report* reports,
                                               grit_contact_sums* sums, grit_error* error);

#ifdef __cplusplus
}
#endif
