// SPDX-License-Identifier: BSD-3-Clause
// Ground under a block of block_case or brick_case, in contact with it at surfaces.
#pragma once

#include <string>

inline constexpr const char* soft_ground =
    "[body.elastic]\nyoungs_modulus_kPa = 400\npoissons_ratio = 0.2";

// box: its keys. material: its table. more: keys of the contact.
inline std::string ground(const std::string& box, const std::string& material,
                          const std::string& more = "") {
    return R"([[body]]
name = "ground"
density_kg_per_m3 = 1500
[[body.box]]
)" + box + '\n' +
           material + R"(
[[contact]]
stiff = "ground"
soft = "block"
law = "surface"
friction_coefficient = 0.3
)" + more;
}
