// SPDX-License-Identifier: BSD-3-Clause
// What an engineer would look at twice before believing a calibration, in sentences.
#pragma once

#include <string>
#include <vector>

#include "cli/calibrate/calibration_case.hpp"
#include "cli/calibrate/calibration_result.hpp"

namespace cli {

// Quantities that the parameters at the start would give with the other sign, or a thousand times as large.
std::vector<std::string> doubts_about_units(const CalibrationCase& file, int threads);

// Those of the case, and what the fit itself looks like: starts that disagree, parameters at their bounds, tests that
// are much farther off than the others.
std::vector<std::string> doubts(const CalibrationCase& file, const CalibrationResult& result);

}  // namespace cli
