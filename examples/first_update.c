/* SPDX-License-Identifier: BSD-3-Clause
 * One material point of Lausitz sand, compressed by 0.1 % along axis 11. */
#include <stdio.h>

#include <grit/grit.h>

int main(void) {
    grit_error error = {0};

    /* The material, once: Lausitz sand with stresses in kPa. */
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &parameters);
    grit_sand sand;
    if (grit_sand_prepare(&parameters, &sand, &error) != GRIT_OK) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }

    /* The point: 100 kPa isotropic, e = 0.55, last strained in isotropic compression. */
    double stress[6] = {-100, -100, -100, 0, 0, 0};
    double state[GRIT_SAND_STATE_SIZE] = {0};
    state[GRIT_SAND_VOID_RATIO] = 0.55;
    const double compression[6] = {-1, -1, -1, 0, 0, 0};
    grit_sand_mobilise(&sand, compression, 1.0, state);

    /* The increment, with the consistent tangent. */
    const double strain_increment[6] = {-1e-3, 0, 0, 0, 0, 0};
    double tangent[36];
    grit_sand_options options;
    grit_sand_options_init(&options, sizeof options);
    options.tangent = GRIT_TANGENT_CONSISTENT;
    grit_sand_points points = {0};
    points.struct_size = sizeof points;
    points.strain_increment = grit_view_of(strain_increment, 6, 1);
    points.stress = grit_mutable_view_of(stress, 6, 1);
    points.state = grit_mutable_view_of(state, GRIT_SAND_STATE_SIZE, 1);
    points.tangent = grit_mutable_matrix_view_of(tangent, 36, 6, 1);
    grit_sand_report report;
    if (grit_sand_update(&sand, &options, 1, &points, &report, &error) != GRIT_OK) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }

    printf("stress     %.3f %.3f %.3f kPa\n", stress[0], stress[1], stress[2]);
    printf("void ratio %.6f\n", state[GRIT_SAND_VOID_RATIO]);
    printf("C_1111     %.0f kPa\n", tangent[0]);
    printf("%d evaluations of the stress rate\n", report.evaluations);
    return 0;
}
