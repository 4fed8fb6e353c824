// SPDX-License-Identifier: BSD-3-Clause
// What the parameters, as far as they are known, say of each reading.
#pragma once

#include <vector>

#include "cli/calibrate/calibration_case.hpp"
#include "cli/calibrate/calibration_result.hpp"

namespace cli {

// Of a test, a value per reading; 95 %. Empty where the test cannot be computed.
struct Band {
    std::vector<double> best;
    std::vector<double> lowest, highest;                    // of the parameters alone
    std::vector<double> lowest_measured, highest_measured;  // and of a measurement with its error
    std::string failure;
};

// From so many draws of the posterior, the same for all tests.
std::vector<Band> bands(const CalibrationCase& file, const CalibrationResult& result, int draws,
                        int threads);

}  // namespace cli
