/* SPDX-License-Identifier: BSD-3-Clause
 * A host's loop over points: a column of two sands at rest, compressed and sheared in steps.
 * The host keeps its data as structure of arrays; Grit reads and writes it in place. host_loop.f90
 * does the same in Fortran and prints the same numbers. */
#include <stdio.h>
#include <stdlib.h>

#include <grit/grit.h>

enum { POINTS = 1000, STEPS = 50 };

static double strain_increment[6][POINTS], stress[6][POINTS], state[GRIT_SAND_STATE_SIZE][POINTS];

static void stop(const char* what, const grit_error* error) {
    fprintf(stderr, "%s: %s\n", what, error->message);
    exit(EXIT_FAILURE);
}

static grit_sand prepare(const char* name) {
    grit_sand_parameters parameters;
    grit_sand sand;
    grit_error error = {0};
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(grit_sand_record_find(name), 1.0, &parameters); /* kPa */
    if (grit_sand_prepare(&parameters, &sand, &error)) stop(name, &error);
    return sand;
}

/* At rest under 9 kN/m3 at depths 0.1 m ... 100 m, e from e_0 = 0.75 at zero pressure. */
static void initialise(const grit_sand* sand, int point) {
    const double depth = 0.1 * (point + 1);
    double at_rest[6], e;
    grit_sand_stress_at_rest(sand, 9.0, depth, 0.0, -1.0, 2, at_rest);
    grit_sand_void_ratio_at_pressure(sand, 0.75, -(at_rest[0] + at_rest[1] + at_rest[2]) / 3.0, &e);
    for (int c = 0; c < 6; ++c) stress[c][point] = at_rest[c];
    state[GRIT_SAND_VOID_RATIO][point] = e;
}

int main(void) {
    const grit_sand sands[2] = {prepare("lausitz"), prepare("hochstetten")};
    ptrdiff_t points_of[2][POINTS / 2]; /* every other point is of the same sand */
    for (int i = 0; i < POINTS; ++i) {
        points_of[i % 2][i / 2] = i;
        initialise(&sands[i % 2], i);
    }

    grit_sand_options options;
    grit_sand_options_init(&options, sizeof options);
    options.tolerance = 1e-6;
    grit_sand_points view = {0};
    view.struct_size = sizeof view;
    view.strain_increment = grit_view_of(strain_increment[0], 1, POINTS);
    view.stress = grit_mutable_view_of(stress[0], 1, POINTS);
    view.state = grit_mutable_view_of(state[0], 1, POINTS);

    for (int step = 0; step < STEPS; ++step) {
        for (int i = 0; i < POINTS; ++i) {
            strain_increment[2][i] = -2e-5; /* compression along 33 */
            strain_increment[5][i] = 1e-4;  /* shear 23, engineering */
        }
        for (int s = 0; s < 2; ++s) { /* disjoint index lists: could be two threads */
            grit_error error = {0};
            view.index = points_of[s];
            if (grit_sand_update(&sands[s], &options, POINTS / 2, &view, NULL, &error))
                stop("update", &error);
        }
    }
    for (int i = 0; i < POINTS; i += 333)
        printf("point %4d  sigma_33 %12.6f  sigma_23 %12.6f kPa  e %.9f\n", i, stress[2][i],
               stress[5][i], state[GRIT_SAND_VOID_RATIO][i]);
    return EXIT_SUCCESS;
}
