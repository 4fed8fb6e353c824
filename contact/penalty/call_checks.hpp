// SPDX-License-Identifier: BSD-3-Clause
// What the entry points of the penalty contact ask of their arguments.
#pragma once

#include "contact/penalty/surface.hpp"
#include "support/require.hpp"

namespace grit::penalty {

inline bool is_aligned(const void* memory) {
    return reinterpret_cast<std::size_t>(memory) % alignof(double) == 0;
}

grit_status read_options(const grit_penalty_options* given, grit_penalty_options& options,
                         grit_error* error);

// struct_size, count, position. name: "surface a", "surface b" or "surface".
grit_status read_surface(const grit_penalty_surface* given, const char* name,
                         grit_penalty_surface& surface, grit_error* error);

// A view that is written to.
grit_status check_output(const grit_mutable_view& view, const char* name, const char* member,
                         std::ptrdiff_t components, grit_error* error);

// Views and numbers that forces need, besides the positions.
grit_status check_motion(const grit_penalty_surface& surface, const char* name,
                         const grit_penalty_options& options, grit_error* error);

}  // namespace grit::penalty
