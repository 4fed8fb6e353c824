// SPDX-License-Identifier: BSD-3-Clause
// What the entry points of the surface contact ask of their arguments.
#pragma once

#include <grit/contact_surface.h>

#include "support/call_checks.hpp"

namespace grit::surface {

constexpr std::ptrdiff_t largest_count = std::ptrdiff_t(1) << 40;
constexpr double largest_number = 1e30;  // of lengths, velocities and times

grit_status read_options(const grit_surface_options* given, grit_surface_options& options,
                         grit_error* error);

// Struct, views, lists and numbers of a surface. name: "surface a" or "surface b".
grit_status read_surface(const grit_surface* given, const char* name,
                         const grit_surface_options& options, grit_surface& surface,
                         grit_error* error);

}  // namespace grit::surface
