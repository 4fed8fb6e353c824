// SPDX-License-Identifier: BSD-3-Clause
// What calls over many points have in common at the C border.
#pragma once

#include <grit/sand.h>

#include "support/call_checks.hpp"
#include "umat/model/material.hpp"

namespace grit {

inline constexpr grit_sand_options default_options = [] {
    grit_sand_options options{};
    options.struct_size = sizeof options;
    options.tolerance = GRIT_SAND_DEFAULT_TOLERANCE;
    options.evaluation_limit = GRIT_SAND_DEFAULT_EVALUATION_LIMIT;
    return options;
}();

// What a caller's structs say, wherever it stands.
struct SandCall {
    const grit_sand_options* options;
    const grit_sand_points* points;
    grit_sand_options own_options;  // of callers with structs of another length
    grit_sand_points own_points;
};

// Sand, n, options and points of a call of this name; what the caller's structs do not reach has its default.
inline grit_status read_call(const char* name, const grit_sand* sand,
                             const grit_sand_options* options, std::ptrdiff_t n,
                             const grit_sand_points* points, SandCall& call, grit_error* error) {
    static constexpr grit_sand_points nothing{};
    GRIT_CHECK(check_given(sand, {name, "sand"}, error));
    GRIT_CHECK(check_given(points, {name, "points"}, error));
    GRIT_CHECK(check_count(n, {name, "n"}, error));
    GRIT_REQUIRE(material_of(*sand).stamp == material_stamp,
                 "%s: sand was not prepared by grit_sand_prepare of major version %d", name,
                 GRIT_VERSION_MAJOR);
    call.options =
        options ? view_versioned(options, default_options, call.own_options) : &default_options;
    GRIT_CHECK(check_understood(call.options, options, "grit_sand_options",
                                "call grit_sand_options_init first", error));
    call.points = view_versioned(points, nothing, call.own_points);
    return check_understood(call.points, points, "grit_sand_points", set_it_to_sizeof, error);
}

inline grit_status check_point_components(int components, grit_error* error) {
    GRIT_REQUIRE(components == 0 || components == 6 || components == 4,
                 "components must be 6 or 4 (11 22 33 12), got %d", components);
    return GRIT_OK;
}

}  // namespace grit
