/* SPDX-License-Identifier: BSD-3-Clause
 * A C11 program uses every kind of call: parameters, material, update, operators, errors. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <grit/grit.h>

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            printf("%s:%d: %s\n", __FILE__, __LINE__, #condition);                                 \
            return 1;                                                                              \
        }                                                                                          \
    } while (0)

static int updates(const grit_sand* sand) {
    enum { n = 3 };
    double strain[6] = {-1e-4, 0, 0, 0, 0, 0};
    double stress[n][6], state[n][GRIT_SAND_STATE_SIZE], tangent[n][36];
    grit_sand_report reports[n];
    grit_sand_options options;
    grit_sand_points points;
    grit_error error;
    int i, c;
    memset(&points, 0, sizeof points);
    memset(stress, 0, sizeof stress);
    memset(state, 0, sizeof state);
    for (i = 0; i < n; ++i) {
        for (c = 0; c < 3; ++c) stress[i][c] = -100.0 * (i + 1);
        state[i][GRIT_SAND_VOID_RATIO] = 0.6;
    }
    CHECK(grit_sand_options_init(&options, sizeof options) == GRIT_OK);
    options.tangent = GRIT_TANGENT_CONSISTENT;
    points.struct_size = sizeof points;
    points.strain_increment = grit_view_of(strain, 0, 1);
    points.stress = grit_mutable_view_of(&stress[0][0], 6, 1);
    points.state = grit_mutable_view_of(&state[0][0], GRIT_SAND_STATE_SIZE, 1);
    points.tangent = grit_mutable_matrix_view_of(&tangent[0][0], 36, 6, 1);
    CHECK(grit_sand_update(sand, &options, n, &points, reports, &error) == GRIT_OK);
    for (i = 0; i < n; ++i) {
        CHECK(reports[i].status == GRIT_OK);
        CHECK(stress[i][0] < -100.0 * (i + 1));
        CHECK(tangent[i][0] > 0.0);
    }
    strain[0] = NAN;
    CHECK(grit_sand_update(sand, &options, n, &points, NULL, &error) == GRIT_BAD_CALL);
    CHECK(error.point == 0 && strstr(error.message, "strain_increment"));
    return 0;
}

static int undrained(const grit_sand* sand) {
    double strain[6] = {-1e-4, 0, 0, 0, 0, 0}, stress[6] = {-100, -100, -100, 0, 0, 0};
    double state[GRIT_SAND_STATE_SIZE] = {0}, p_w = 20.0, total[6], K;
    grit_sand_water water;
    grit_sand_points points;
    memset(&points, 0, sizeof points);
    state[GRIT_SAND_VOID_RATIO] = 0.6;
    points.struct_size = sizeof points;
    points.strain_increment = grit_view_of(strain, 0, 1);
    points.stress = grit_mutable_view_of(stress, 6, 1);
    points.state = grit_mutable_view_of(state, GRIT_SAND_STATE_SIZE, 1);
    CHECK(grit_sand_water_init(&water, sizeof water) == GRIT_OK);
    CHECK(water.largest_tension > 1e308);
    water.bulk_modulus = 2.2e6;
    water.pore_pressure = grit_mutable_view_of(&p_w, 1, 1);
    water.total_stress = grit_mutable_view_of(total, 6, 1);
    CHECK(grit_sand_water_stiffness(&water, p_w, 0.6, &K) == GRIT_OK);
    CHECK(grit_sand_update_undrained(sand, NULL, &water, 1, &points, NULL, NULL) == GRIT_OK);
    CHECK(fabs(p_w - 20.0 - 1e-4 * K) < 1.0);
    CHECK(total[0] == stress[0] - p_w);
    return 0;
}

static int refusals(void) {
    grit_sand_parameters p;
    grit_sand sand;
    grit_error error;
    CHECK(grit_sand_parameters_init(&p, sizeof p) == GRIT_OK);
    CHECK(grit_sand_prepare(&p, &sand, &error) == GRIT_BAD_PARAMETER);
    CHECK(strstr(error.message, "critical_friction_angle"));
    CHECK(strcmp(grit_status_name(GRIT_OK), grit_status_name(error.status)) != 0);
    CHECK(grit_sand_parameter_describe(GRIT_SAND_PARAMETER_COUNT) == NULL);
    CHECK(grit_sand_record_find("no such sand") == -1);
    return 0;
}

int main(void) {
    grit_sand_parameters p;
    grit_sand sand;
    double void_ratios[3];
    CHECK(grit_sand_parameters_init(&p, sizeof p) == GRIT_OK);
    CHECK(grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &p) == GRIT_OK);
    CHECK(grit_sand_prepare(&p, &sand, NULL) == GRIT_OK);
    CHECK(grit_sand_void_ratios(&sand, 100.0, void_ratios) == GRIT_OK);
    CHECK(void_ratios[0] > void_ratios[1] && void_ratios[1] > void_ratios[2]);
    return updates(&sand) || undrained(&sand) || refusals();
}
