// SPDX-License-Identifier: BSD-3-Clause
// Of what a host may give.
#pragma once

namespace grit {

constexpr double largest_number = 1e100;  // of masses, velocities and lengths: products stay finite
constexpr double normal_tolerance = 1e-6;  // |n|^2 of a unit normal may be off by this

}  // namespace grit
