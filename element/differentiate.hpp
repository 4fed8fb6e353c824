// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of an increment that has been solved for: (D1).
#pragma once

#include "element/newton.hpp"

namespace element {

// Derivatives of the task, by the directions of those at its start.
struct TaskSlopes {
    const Slopes& start;
    Matrix6X goal;
    Eigen::RowVectorXd pore_pressure;  // at the end, where it is not unknown
};

// At the end. Throws BadCase where the law has none, or has too few directions; nothing if the restrictions do not
// determine them.
std::optional<Slopes> differentiate(const Law& law, const Task& task, const Solution& solution,
                                    const TaskSlopes& given);

}  // namespace element
