// SPDX-License-Identifier: BSD-3-Clause
// Sands of the catalogue.
#pragma once

#include <gtest/gtest.h>

#include <grit/sand.h>
#include <grit/sand_catalogue.h>

// per_kPa: the unit of stress, 1 for kPa, 1000 for Pa.
inline grit_sand_parameters catalogue_parameters(const char* name, double per_kPa) {
    grit_sand_parameters parameters{};
    grit_sand_parameters_init(&parameters, sizeof parameters);
    EXPECT_EQ(grit_sand_record_parameters(grit_sand_record_find(name), per_kPa, &parameters),
              GRIT_OK);
    return parameters;
}

inline grit_sand catalogue_sand(const char* name, double per_kPa) {
    const grit_sand_parameters parameters = catalogue_parameters(name, per_kPa);
    grit_sand sand{};
    EXPECT_EQ(grit_sand_prepare(&parameters, &sand, nullptr), GRIT_OK);
    return sand;
}

inline grit_sand_options options_with_tolerance(double tolerance) {
    grit_sand_options options{};
    grit_sand_options_init(&options, sizeof options);
    options.tolerance = tolerance;
    return options;
}
