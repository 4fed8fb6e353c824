// SPDX-License-Identifier: BSD-3-Clause
// What the entry points of the penalty contact ask of their arguments.
#pragma once

#include "contact/penalty/surface.hpp"
#include "support/call_checks.hpp"

namespace grit::penalty {

grit_status read_options(const grit_penalty_options* given, grit_penalty_options& options,
                         grit_error* error);

// struct_size, count, position. name: "surface a", "surface b" or "surface".
grit_status read_surface(const grit_penalty_surface* given, const char* name,
                         grit_penalty_surface& surface, grit_error* error);

// Of vertices in the plane. why: who needs it, if that is said.
template <class View>
grit_status check_vectors(const View& view, Named about, grit_error* error, const char* why = "") {
    GRIT_CHECK(check_base(view, about, error, why));
    return check_components(view, 2, about, error);
}

// As many vertices as make a line.
grit_status check_vertex_count(std::ptrdiff_t count, bool closed, Named about, grit_error* error);

// Views and numbers that forces need, besides the positions.
grit_status check_motion(const grit_penalty_surface& surface, const char* name,
                         const grit_penalty_options& options, grit_error* error);

}  // namespace grit::penalty
