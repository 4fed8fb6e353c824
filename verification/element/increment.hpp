// SPDX-License-Identifier: BSD-3-Clause
// One increment under mixed control of strain and stress.
#pragma once

#include <string>

#include "element/material.hpp"

namespace element {

struct Goal {
    std::array<Control, 6> control{};
    Vector6 strain_increment =
        Vector6::Zero();               // prescribed where control is strain, a guess elsewhere
    Vector6 stress = Vector6::Zero();  // at the end, prescribed where control is stress [kPa]
    double tolerance = 1e-6;           // |stress residual| / |stress|
};

struct Increment {
    bool converged = false;
    bool retry_smaller = false;  // otherwise a smaller increment will not help
    int iterations = 0;          // linear systems solved
    int evaluations = 0;         // of the stress rate
    Vector6 strain_increment = Vector6::Zero();
    std::string reason;  // why not converged: value, limit, unit
};

// Newton's method with the consistent tangent; point is untouched unless converged.
Increment solve_increment(const Material& material, const Goal& goal, Point& point);

}  // namespace element
