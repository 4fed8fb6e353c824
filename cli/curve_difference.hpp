// SPDX-License-Identifier: BSD-3-Clause
// A computed path against a reference path that has other points on it.
#pragma once

#include <string>

#include "cli/table.hpp"

namespace cli {

struct CurveDifference {
    std::string problem;      // empty, or why the two cannot be compared
    double stress = 0.0;      // largest |difference of a component|/largest |stress| [-]
    double void_ratio = 0.0;  // largest |difference| [-]
};

// Both run along the strain component that varies most in the reference, between the same turns. The
// result is interpolated at the reference's points by cubics through four of its own.
CurveDifference difference(const Table& result, const Table& reference);

}  // namespace cli
