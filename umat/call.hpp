// SPDX-License-Identifier: BSD-3-Clause
// What calls over many points have in common at the C border.
#pragma once

#include <grit/sand.h>

#include "support/require.hpp"
#include "support/versioned.hpp"
#include "umat/material.hpp"

namespace grit {

// Sand, n, options and points of a call of this name; options and q keep what the caller's structs do not
// reach.
inline grit_status read_call(const char* name, const grit_sand* sand,
                             const grit_sand_options* given, std::ptrdiff_t n,
                             const grit_sand_points* points, grit_sand_options& options,
                             grit_sand_points& q, grit_error* error) {
    GRIT_REQUIRE(sand, "%s: sand is null", name);
    GRIT_REQUIRE(points, "%s: points is null", name);
    GRIT_REQUIRE(n >= 0, "%s: n must be >= 0, got %td", name, n);
    GRIT_REQUIRE(material_of(*sand).stamp == material_stamp,
                 "%s: sand was not prepared by grit_sand_prepare of major version %d", name,
                 GRIT_VERSION_MAJOR);
    GRIT_REQUIRE(!given || read_versioned(*given, options),
                 "grit_sand_options.struct_size %zu is not understood: call "
                 "grit_sand_options_init first",
                 given->struct_size);
    GRIT_REQUIRE(read_versioned(*points, q),
                 "grit_sand_points.struct_size %zu is not understood: set it to sizeof",
                 points->struct_size);
    return GRIT_OK;
}

}  // namespace grit
