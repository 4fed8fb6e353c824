// SPDX-License-Identifier: BSD-3-Clause
// What follows the first two lines of the steps that say all six components. Each throws BadInput.
#pragma once

#include <filesystem>

#include "element/incremental_driver/step_commons.hpp"
#include "element/step.hpp"

namespace incremental_driver {

// *Cartesian | *Roscoe | *RoscoeIsomorph | *Rendulic, six lines "ifstress change"
element::Kind read_linear(Lines& lines);
// The same, six lines "ifstress amplitude phase change", phase in rad
element::Kind read_circulating(Lines& lines);
// Nine lines: F 11 22 33 12 21 13 31 23 32 at the end of the step
element::Kind read_deformation_gradient(Lines& lines);
// Six restrictions
element::Kind read_restrictions(Lines& lines);
// Variables, one line: the amplitude; in the plane of the first two variables
element::Kind read_stress_perturbations(Lines& lines);
element::Kind read_strain_perturbations(Lines& lines);
// As read_linear; the changes are the largest of one increment
element::Kind read_random_walk(Lines& lines);

// Variables, six lines "ifstress column [* factor]", and another "column [* factor]" for time if the
// duration of step, which stands for that of one increment here, is not positive. Columns count from
// 1, 0 leaves a component alone. Sets kind, increments and duration of step; returns the file read.
std::filesystem::path read_import(Lines& lines, const Keyword& keyword,
                                  const std::filesystem::path& folder, element::Step& step);

}  // namespace incremental_driver
