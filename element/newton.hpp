// SPDX-License-Identifier: BSD-3-Clause
// One increment, or a part of one, under six restrictions.
#pragma once

#include <optional>

#include "element/control.hpp"
#include "element/law.hpp"

namespace element {

// The point to start from, and what must hold at the end.
struct Task {
    MaterialPoint point;
    Vector6 strain = Vector6::Zero();  // total, at the start
    double pore_pressure = 0.0;        // kept by the driver
    StrainIncrement increment;         // all but the strain: times, numbers, rotation
    Restrictions rows;
    // rows.stress * (stress - pore pressure) + rows.strain * strain = goal, total values at the end:
    // what one increment misses does not add up.
    Vector6 goal = Vector6::Zero();
    bool undrained = false;           // volumetric strain zero, the pore pressure is unknown
    Vector6 guess = Vector6::Zero();  // of the strain increment
    double tolerance = 1e-9;
    int iteration_limit = 25;
};

struct Solution {
    Outcome outcome = Outcome::done;
    double reduction = 1.0;
    std::string message;
    MaterialPoint end;
    Vector6 strain_increment = Vector6::Zero();
    double pore_pressure = 0.0;
    Matrix6 tangent = Matrix6::Zero();
    int iterations = 0;
    int evaluations = 0;
    std::vector<double> residuals;  // one per update of the law
};

Solution solve(const Law& law, const Task& task);

// Strain increment that meets the rows if the stress answers by this tangent; nothing if singular.
std::optional<Vector6> linear_guess(const Task& task, const Matrix6& tangent);

// Strain increment of least norm that meets the rows as far as strain alone can.
Vector6 strain_only_guess(const Task& task);

}  // namespace element
