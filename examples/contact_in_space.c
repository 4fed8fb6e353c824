/* SPDX-License-Identifier: BSD-3-Clause
 * Geo-contact in one step of a material-point code in three dimensions, from particles to corrected
 * nodal velocities: the plate (A) of contact_step.c, three metres wide, slides over the ground (B)
 * between two grid lines, along (0.6, 0.8). By metre of width it must meet what contact_step prints. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <grit/grit.h>

enum { EDGE = 4, NODES = EDGE * EDGE * EDGE, ACROSS = 3, PARTICLES = ACROSS * ACROSS, CORNERS = 8 };

/* Nodal data of both bodies; array of structures. */
static double position[NODES][3], mass[2][NODES], velocity[2][NODES][3], gradient[2][NODES][3];
static int fixed[NODES];
static double normal[NODES][3], surface[NODES][2], distance[NODES], gap[NODES];

static void check(grit_status status, const grit_error* error) {
    if (status == GRIT_OK) return;
    fprintf(stderr, "%s: %s\n", grit_status_name(status), error->message);
    exit(EXIT_FAILURE);
}

/* Trilinear weights of a point in its cell, their gradients, and the eight nodes. */
static void weights(const double x[3], double N[CORNERS], double dN[CORNERS][3],
                    ptrdiff_t node[CORNERS]) {
    for (int k = 0; k < CORNERS; ++k) {
        const int far_side[3] = {k % 2, k / 2 % 2, k / 4};
        double part[3], slope[3];
        ptrdiff_t at[3];
        for (int c = 0; c < 3; ++c) {
            const double cell = floor(x[c]), a = x[c] - cell;
            part[c] = far_side[c] ? a : 1.0 - a;
            slope[c] = far_side[c] ? 1.0 : -1.0;
            at[c] = (ptrdiff_t)cell + far_side[c];
        }
        N[k] = part[0] * part[1] * part[2];
        for (int c = 0; c < 3; ++c) dN[k][c] = slope[c] * part[(c + 1) % 3] * part[(c + 2) % 3];
        node[k] = (at[2] * EDGE + at[1]) * EDGE + at[0];
    }
}

/* Particles of one body to the nodes: mass, velocity and the gradient of (C2). */
static void gather(int body, const double x[PARTICLES][3], double m, const double v[3],
                   ptrdiff_t node[PARTICLES][CORNERS]) {
    const double volume = 0.5;
    for (int p = 0; p < PARTICLES; ++p) {
        double N[CORNERS], dN[CORNERS][3];
        weights(x[p], N, dN, node[p]);
        for (int k = 0; k < CORNERS; ++k) {
            mass[body][node[p][k]] += N[k] * m;
            for (int c = 0; c < 3; ++c) gradient[body][node[p][k]][c] += volume * dN[k][c];
        }
    }
    for (int i = 0; i < NODES; ++i)
        for (int c = 0; c < 3; ++c) velocity[body][i][c] = mass[body][i] > 0.0 ? v[c] : 0.0;
}

int main(void) {
    /* Domains of 1 x 1 x 0.5: the plate's lower face is at 1.48, the ground's upper face at 1.5. */
    double plate[PARTICLES][3], ground[PARTICLES][3];
    const double side[3][3] = {{0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}, {0.0, 0.0, 0.25}};
    const double v_plate[3] = {0.6, 0.8, -0.5}, v_ground[3] = {0.0, 0.0, 0.0};
    static ptrdiff_t node[2][PARTICLES][CORNERS];
    grit_error error = {0};

    for (int p = 0; p < PARTICLES; ++p)
        for (int c = 0; c < 3; ++c) {
            const double level = c == 2;
            plate[p][c] = level ? 1.73 : (c == 0 ? p % ACROSS : p / ACROSS) + 0.5;
            ground[p][c] = level ? 1.25 : plate[p][c];
        }
    for (int i = 0; i < NODES; ++i) {
        const int row = i / EDGE, layer = row / EDGE;
        position[i][0] = i - row * EDGE;
        position[i][1] = row - layer * EDGE;
        position[i][2] = layer;
        fixed[i] = GRIT_CONTACT_FIXED_1 | GRIT_CONTACT_FIXED_2; /* the plate goes on to all sides */
    }
    gather(0, plate, 1000.0, v_plate, node[0]);
    gather(1, ground, 850.0, v_ground, node[1]);

    /* (C2): the plate is the stiffer body. Nodes where it is not get a zero normal. */
    grit_contact_gradients normals = {0};
    normals.struct_size = sizeof normals;
    normals.components = 3;
    normals.source = GRIT_CONTACT_NORMAL_OF_A;
    normals.gradient_a = grit_view_of(gradient[0][0], 3, 1);
    normals.fixed = fixed;
    normals.normal = grit_mutable_view_of(normal[0], 3, 1);
    check(grit_contact_normals_from_gradients(NODES, &normals, NULL, &error), &error);

    /* (C3), (C4): distances of both surfaces to the nodes; a domain is a parallelepiped. */
    grit_contact_surfaces surfaces = {0};
    surfaces.struct_size = sizeof surfaces;
    surfaces.components = 3;
    surfaces.nodes = NODES;
    surfaces.position = grit_view_of(position[0], 3, 1);
    surfaces.normal = grit_view_of(normal[0], 3, 1);
    surfaces.surface = grit_mutable_view_of(surface[0], 2, 1);
    check(grit_contact_surfaces_reset(&surfaces, &error), &error);
    for (int body = 0; body < 2; ++body) {
        grit_contact_domains domains = {0};
        domains.struct_size = sizeof domains;
        domains.body = body;
        domains.sides = 3;
        domains.nodes_each = CORNERS;
        domains.node = node[body][0];
        domains.position = grit_view_of(body == 0 ? plate[0] : ground[0], 3, 1);
        domains.side = grit_matrix_view_of(side[0], 0, 3, 1);
        check(grit_contact_surfaces_add(&surfaces, PARTICLES, &domains, &error), &error);
    }
    grit_contact_distances distances = {0};
    distances.struct_size = sizeof distances;
    distances.distance = grit_mutable_view_of(distance, 1, 1);
    distances.gap = grit_mutable_view_of(gap, 1, 1);
    check(grit_contact_surfaces_finish(&surfaces, NODES, &distances, &error), &error);

    /* (C1) to (C6). */
    const double spacing[3] = {1.0, 1.0, 1.0};
    grit_contact_options options;
    grit_contact_options_init(&options, sizeof options); /* three components are the default */
    options.penalty_power = 6.0;
    options.friction_coefficient = 0.3;
    options.time_step = 1e-3;
    options.allow_zero_normal = 1;
    grit_contact_nodes nodes = {0};
    nodes.struct_size = sizeof nodes;
    nodes.mass_a = grit_view_of(mass[0], 1, 1);
    nodes.mass_b = grit_view_of(mass[1], 1, 1);
    nodes.normal = grit_view_of(normal[0], 3, 1);
    nodes.distance = grit_view_of(distance, 1, 1);
    nodes.gap = grit_view_of(gap, 1, 1);
    nodes.spacing = grit_view_of(spacing, 0, 1);
    nodes.velocity_a = grit_mutable_view_of(velocity[0][0], 3, 1);
    nodes.velocity_b = grit_mutable_view_of(velocity[1][0], 3, 1);
    static grit_contact_report reports[NODES];
    static grit_contact_sums sums;
    check(grit_contact_correct(&options, NODES, &nodes, reports, &sums, &error), &error);

    /* Of the nodes in contact one inside, one at an edge and one at a corner of the plate. */
    for (int layer = 1; layer < 3; ++layer)
        for (int k = 0; k < 3; ++k) {
            const int i = (layer * EDGE + k / 2) * EDGE + (k + 1) / 2;
            printf("node %2d  state %d  f_p %.6f  v_A %9.6f %9.6f %9.6f  v_B %9.6f %9.6f %9.6f\n",
                   i, reports[i].state, reports[i].penalty_factor, velocity[0][i][0],
                   velocity[0][i][1], velocity[0][i][2], velocity[1][i][0], velocity[1][i][1],
                   velocity[1][i][2]);
        }
    grit_contact_totals totals = {0};
    totals.struct_size = sizeof totals;
    grit_contact_sums_read(&sums, &totals);
    const double* force = totals.force_on_b;
    printf("force on the ground %.3f %.3f %.3f N\n", force[0], force[1], force[2]);
    printf("per metre of width %.3f %.3f N/m\n", hypot(force[0], force[1]) / ACROSS,
           force[2] / ACROSS);
    return 0;
}
