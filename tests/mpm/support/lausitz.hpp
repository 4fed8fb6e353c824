// SPDX-License-Identifier: BSD-3-Clause
// Lausitz sand of the catalogue, in Pa.
#pragma once

#include <gtest/gtest.h>

#include <adapters/mpm/kernel/sand.hpp>
#include <grit/sand_catalogue.h>

#include "support/box.hpp"

namespace mpm_test {

inline grit_sand lausitz() {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1000.0, &parameters);
    grit_sand sand;
    EXPECT_EQ(grit_sand_prepare(&parameters, &sand, nullptr), GRIT_OK);
    return sand;
}

inline grit_sand_options sand_options() {
    grit_sand_options out;
    grit_sand_options_init(&out, sizeof out);
    out.tolerance = 1e-3;
    return out;
}

}  // namespace mpm_test
