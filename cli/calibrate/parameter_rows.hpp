// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a sand that was found, as they are told: on the screen and in the report.
#pragma once

#include <string>
#include <vector>

#include "cli/calibrate/calibration_case.hpp"
#include "cli/calibrate/calibration_result.hpp"

namespace cli {

struct ParameterRow {
    const grit_sand_parameter_info* info;
    std::string unit, start, best, lowest, highest;  // no interval where it was not sought
    std::string origin;                              // of the start; "fixed"
    std::string doubt;                               // "not determined", empty: none
};

// Of all that the sand has, in their order.
std::vector<ParameterRow> parameter_rows(const CalibrationCase& file,
                                         const CalibrationResult& result);

}  // namespace cli
