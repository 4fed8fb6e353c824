// SPDX-License-Identifier: BSD-3-Clause
// What a calibration has found: for the screen, the sand file and the report alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/calibrate/misfit.hpp"
#include "element/calibration/ensemble.hpp"
#include "element/calibration/fit.hpp"

namespace cli {

// 95 %, in the units of the library.
struct ParameterInterval {
    double lowest = 0.0, highest = 0.0;
    bool ends_at_bound = false;  // on one side at least: the bounds, not the tests, say how far
};

struct CalibrationResult {
    calibration::Fit fit;
    grit_sand_parameters best{};
    double independent = 0.0;  // readings
    calibration::Laplace laplace;
    std::optional<calibration::Posterior> posterior;
    std::vector<ParameterInterval> intervals;  // of the free parameters
    Misfits misfits, beside;
    std::vector<std::string> advice, doubts;
    double fit_seconds = 0.0, posterior_seconds = 0.0;
    double fit_processor_seconds = 0.0, posterior_processor_seconds = 0.0;  // of all threads
};

// Of the standard normal distribution: 95 % of it lie within as much on both sides.
inline constexpr double normal_quantile_975 = 1.959963984540054;

// From the samples of the posterior, if there are any; otherwise normal at the best fit, within the bounds and
// e_d0 < e_c0 < e_i0 of the others at their best.
std::vector<ParameterInterval> intervals(const calibration::ParameterSpace& space,
                                         const CalibrationResult& result);

}  // namespace cli
