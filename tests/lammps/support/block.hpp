// SPDX-License-Identifier: BSD-3-Clause
// An elastic block on a grid of 24 x 24 cells of 1 m, without gravity: quick, for what needs no sand.
#pragma once

#include <string>

// velocity: "r, z". more: tables at the end of the case. until: the end of its stage [s].
inline std::string block_case(const std::string& velocity, const std::string& until,
                              const std::string& more = "") {
    return R"(
gravity_m_per_s2 = 0.0
[grid]
geometry = "plane_strain"
[[grid.r]]
to_m = 24
cells = 24
[[grid.z]]
to_m = 24
cells = 24
[numerics]
fixed_point = true
[[body]]
name = "block"
density_kg_per_m3 = 2000
velocity_m_per_s = [)" +
           velocity + R"(]
[[body.box]]
r_m = [2, 6]
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

// ... that flies, pressed on its top.
inline std::string loaded_block_case(const std::string& until) {
    return block_case("1, 0.5", until, R"([[traction]]
body = "block"
edge = "top"
time_s = [0]
stress_kPa = [1]
)");
}
