/* SPDX-License-Identifier: BSD-3-Clause
 * Contact in one step of a material-point code, from particles to corrected nodal velocities: a plate
 * (A) slides over and presses on the ground (B), plane strain, 4 x 4 nodes. contact_step.f90 does the
 * same in Fortran and prints the same numbers. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <grit/grit.h>

enum { COLUMNS = 4, NODES = 16, PARTICLES = 3, CORNERS = 4 };

/* Nodal data of both bodies; array of structures. */
static double position[NODES][2], mass[2][NODES], velocity[2][NODES][2], gradient[2][NODES][2];
static int fixed[NODES];
static double normal[NODES][2], surface[NODES][2], distance[NODES], gap[NODES];

static void check(grit_status status, const grit_error* error) {
    if (status == GRIT_OK) return;
    fprintf(stderr, "%s: %s\n", grit_status_name(status), error->message);
    exit(EXIT_FAILURE);
}

/* Bilinear weights of a point in its cell, their gradients, and the four nodes. */
static void weights(const double x[2], double N[CORNERS], double dN[CORNERS][2],
                    ptrdiff_t node[CORNERS]) {
    const int column = (int)floor(x[0]), row = (int)floor(x[1]);
    for (int k = 0; k < CORNERS; ++k) {
        const int right = k % 2, up = k / 2;
        const double a = x[0] - column, b = x[1] - row;
        const double N_x = right ? a : 1.0 - a, N_y = up ? b : 1.0 - b;
        N[k] = N_x * N_y;
        dN[k][0] = (right ? 1.0 : -1.0) * N_y;
        dN[k][1] = (up ? 1.0 : -1.0) * N_x;
        node[k] = (row + up) * COLUMNS + column + right;
    }
}

/* Particles of one body to the nodes: mass, momentum (then velocity) and the gradient of (C2). */
static void gather(int body, const double x[PARTICLES][2], double m, const double v[2],
                   ptrdiff_t node[PARTICLES][CORNERS]) {
    for (int p = 0; p < PARTICLES; ++p) {
        double N[CORNERS], dN[CORNERS][2];
        weights(x[p], N, dN, node[p]);
        for (int k = 0; k < CORNERS; ++k) {
            mass[body][node[p][k]] += N[k] * m;
            for (int c = 0; c < 2; ++c) gradient[body][node[p][k]][c] += 0.5 * dN[k][c];
        }
    }
    for (int i = 0; i < NODES; ++i)
        for (int c = 0; c < 2; ++c) velocity[body][i][c] = mass[body][i] > 0.0 ? v[c] : 0.0;
}

int main(void) {
    /* Domains of 1 x 0.5: the plate's lower face is at 1.48, the ground's upper face at 1.5. */
    const double plate[PARTICLES][2] = {{0.5, 1.73}, {1.5, 1.73}, {2.5, 1.73}};
    const double ground[PARTICLES][2] = {{0.5, 1.25}, {1.5, 1.25}, {2.5, 1.25}};
    const double side[2][2] = {{0.5, 0.0}, {0.0, 0.25}};
    const double v_plate[2] = {1.0, -0.5}, v_ground[2] = {0.0, 0.0};
    ptrdiff_t node[2][PARTICLES][CORNERS];
    grit_error error = {0};

    for (int i = 0; i < NODES; ++i) {
        const int row = i / COLUMNS;
        position[i][0] = i - row * COLUMNS;
        position[i][1] = row;
        fixed[i] =
            GRIT_CONTACT_FIXED_1; /* the plate goes on to both sides, no normal has an x component */
    }
    gather(0, plate, 1000.0, v_plate, node[0]);
    gather(1, ground, 850.0, v_ground, node[1]);

    /* (C2): the plate is the stiffer body. Nodes where it is not get a zero normal. */
    grit_contact_gradients normals = {0};
    normals.struct_size = sizeof normals;
    normals.components = 2;
    normals.source = GRIT_CONTACT_NORMAL_OF_A;
    normals.gradient_a = grit_view_of(gradient[0][0], 2, 1);
    normals.fixed = fixed;
    normals.normal = grit_mutable_view_of(normal[0], 2, 1);
    check(grit_contact_normals_from_gradients(NODES, &normals, NULL, &error), &error);

    /* (C3), (C4): distances of both surfaces to the nodes, from the domains of the particles. */
    grit_contact_surfaces surfaces = {0};
    surfaces.struct_size = sizeof surfaces;
    surfaces.components = 2;
    surfaces.nodes = NODES;
    surfaces.position = grit_view_of(position[0], 2, 1);
    surfaces.normal = grit_view_of(normal[0], 2, 1);
    surfaces.surface = grit_mutable_view_of(surface[0], 2, 1);
    check(grit_contact_surfaces_reset(&surfaces, &error), &error);
    for (int body = 0; body < 2; ++body) {
        grit_contact_domains domains = {0};
        domains.struct_size = sizeof domains;
        domains.body = body;
        domains.sides = 2;
        domains.nodes_each = CORNERS;
        domains.node = node[body][0];
        domains.position = grit_view_of(body == 0 ? plate[0] : ground[0], 2, 1);
        domains.side = grit_matrix_view_of(side[0], 0, 2, 1);
        check(grit_contact_surfaces_add(&surfaces, PARTICLES, &domains, &error), &error);
    }
    grit_contact_distances distances = {0};
    distances.struct_size = sizeof distances;
    distances.distance = grit_mutable_view_of(distance, 1, 1);
    distances.gap = grit_mutable_view_of(gap, 1, 1);
    check(grit_contact_surfaces_finish(&surfaces, NODES, &distances, &error), &error);

    /* (C1) to (C6). */
    const double spacing[2] = {1.0, 1.0};
    grit_contact_options options;
    grit_contact_options_init(&options, sizeof options);
    options.components = 2;
    options.penalty_power = 6.0;
    options.friction_coefficient = 0.3;
    options.time_step = 1e-3;
    options.allow_zero_normal = 1;
    grit_contact_nodes nodes = {0};
    nodes.struct_size = sizeof nodes;
    nodes.mass_a = grit_view_of(mass[0], 1, 1);
    nodes.mass_b = grit_view_of(mass[1], 1, 1);
    nodes.normal = grit_view_of(normal[0], 2, 1);
    nodes.distance = grit_view_of(distance, 1, 1);
    nodes.gap = grit_view_of(gap, 1, 1);
    nodes.spacing = grit_view_of(spacing, 0, 1);
    nodes.velocity_a = grit_mutable_view_of(velocity[0][0], 2, 1);
    nodes.velocity_b = grit_mutable_view_of(velocity[1][0], 2, 1);
    grit_contact_report reports[NODES];
    grit_contact_sums sums = {{0}};
    check(grit_contact_correct(&options, NODES, &nodes, reports, &sums, &error), &error);

    for (int i = 4; i < 12; ++i)
        printf("node %2d  state %d  f_p %.6f  v_A %9.6f %9.6f  v_B %9.6f %9.6f\n", i,
               reports[i].state, reports[i].penalty_factor, velocity[0][i][0], velocity[0][i][1],
               velocity[1][i][0], velocity[1][i][1]);
    grit_contact_totals totals = {0};
    totals.struct_size = sizeof totals;
    grit_contact_sums_read(&sums, &totals);
    printf("force on the ground %.3f %.3f N/m\n", totals.force_on_b[0], totals.force_on_b[1]);
    return 0;
}
