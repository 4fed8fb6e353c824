// SPDX-License-Identifier: BSD-3-Clause
// Parameters as people write them: angles in degrees, stresses in kPa.
#pragma once

#include <string>

#include <grit/classic_layout.h>
#include <grit/grit.h>

namespace cli {

inline constexpr double degree = GRIT_DEGREE;  // [rad]

// "deg", "kPa" or "-", and what one of it is in the unit of the library (rad, kPa, 1).
struct Unit {
    std::string name;
    double size;
};
Unit unit_of(const grit_sand_parameter_info& info);

// As files call it: "granulate_hardness_kPa", "critical_friction_angle_deg", "stiffness_exponent".
std::string parameter_key(const grit_sand_parameter_info& info);

}  // namespace cli
