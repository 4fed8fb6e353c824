// SPDX-License-Identifier: BSD-3-Clause
// An elastic block in space, on a grid of 24 x 18 x 18 cells of 1 m.
#pragma once

#include <string>

// velocity: "x, y, z". more: tables at the end of the case. until: the end of its stage [s].
inline std::string brick_case(const std::string& velocity, const std::string& until,
                              const std::string& more = "") {
    return R"(
gravity_m_per_s2 = 0.5
[grid]
geometry = "space"
[[grid.x]]
to_m = 24
cells = 24
[[grid.y]]
to_m = 18
cells = 18
[[grid.z]]
to_m = 18
cells = 18
[boundary]
bottom = "roller"
[numerics]
fixed_point = true
local_damping = 0.01
[[body]]
name = "block"
density_kg_per_m3 = 2000
velocity_m_per_s = [)" +
           velocity + R"(]
[[body.box]]
x_m = [2, 6]
y_m = [2, 5]
z_m = [3, 6]
[body.elastic]
youngs_modulus_kPa = 20
poissons_ratio = 0.3
[[stage]]
name = "flight"
[stage.until]
time_s = )" +
           until + "\n[history]\ninterval_s = 0\n" + more;
}
