// SPDX-License-Identifier: BSD-3-Clause
// Strain and rotation from a deformation gradient.
#pragma once

#include "element/step.hpp"

namespace element {

struct Motion {
    Vector6 strain;    // in the configuration at the end
    Matrix3 rotation;  // from start to end
};

// F at the share x of the step.
Matrix3 gradient_at(const DeformationGradient& step, double x);

Motion motion_between(const Matrix3& F_0, const Matrix3& F_1,
                      DeformationGradient::Increments increments);

}  // namespace element
