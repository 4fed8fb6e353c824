// SPDX-License-Identifier: BSD-3-Clause
// A computed path against a reference path that has other points on it.
#pragma once

#include <string>
#include <vector>

#include "cli/table/table.hpp"

namespace cli {

struct CurveDifference {
    std::string problem;      // empty, or why the two cannot be compared
    double stress = 0.0;      // largest |difference| of a stress/largest |stress| [-]
    double void_ratio = 0.0;  // largest |difference| [-]
};

// Both run along the strain that varies most in the reference, between the same turns. Compared is what
// the reference has of void ratio and stress components, or, without those, deviator and p; the result
// is interpolated at the reference's points by cubics through four of its own.
CurveDifference difference(const Table& result, const Table& reference);

// Why no run can be compared with this reference, empty if one can.
std::string incomparable(const Table& reference);

// Columns of the result that a comparison with this reference looks at.
std::vector<std::string> compared_columns(const Table& reference);

}  // namespace cli
