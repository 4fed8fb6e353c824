// SPDX-License-Identifier: BSD-3-Clause
// Parameters straight from tests, one after the other, as Herle & Gudehus (1999) find them: where a fit starts.
#pragma once

#include <optional>

#include "element/calibration/problem.hpp"

namespace calibration {

struct Estimate {
    double value = 0.0;  // in the unit of the library
    std::string origin;  // in words
};

// What is measured without an element test.
struct IndexTests {
    std::optional<double> angle_of_repose;  // [rad]
    std::optional<double> least_void_ratio, largest_void_ratio;
};

// Of every parameter. given: those that need no estimate, NaN otherwise; of the five of the intergranular strain all or
// none. The void ratios are moved so that every test can start.
std::vector<Estimate> estimate(const std::vector<Experiment>& tests, const IndexTests& index,
                               const grit_sand_parameters& given);

// f_d at a peak of drained triaxial compression, where the stress stops to grow: |L^-1 N| = 1 with sigma_1/sigma_3.
double density_factor_at_peak(double critical_friction_angle, double stress_ratio);

// A compression curve e = e_0 exp[-(3p/h_s)^n] (H6) by its ends.
struct Compression {
    double hardness = 0.0, exponent = 0.0, void_ratio = 0.0;  // e_0
};
std::optional<Compression> compression_curve(const std::vector<double>& pressure,
                                             const std::vector<double>& void_ratio);

}  // namespace calibration
