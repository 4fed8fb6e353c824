// SPDX-License-Identifier: BSD-3-Clause
// What would be worth measuring next: tests that nobody has made yet, computed with the best parameters.
#pragma once

#include <string>
#include <vector>

#include "cli/calibrate/calibration_case.hpp"
#include "cli/calibrate/calibration_result.hpp"

namespace cli {

struct NextTest {
    std::string name;          // "oedometer test of dense sand to 1000 kPa"
    double information = 0.0;  // log of how much smaller the volume of what is possible becomes
    std::string parameter;     // the one that gains most
    double before = 0.0, after = 0.0;  // its standard deviation as a share of the value
};

// The most useful first.
std::vector<NextTest> next_tests(const CalibrationCase& file, const CalibrationResult& result,
                                 int threads);

}  // namespace cli
