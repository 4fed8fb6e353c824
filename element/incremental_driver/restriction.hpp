// SPDX-License-Identifier: BSD-3-Clause
// A line of *ObeyRestrictions: "-sd1 + sd2 + 3.0*sd3 = -10". sd1 ... sd6 are increments of stress
// 11 22 33 12 13 23, ed1 ... ed6 of strain (engineering shear); the right-hand side is that of the
// whole step.
#pragma once

#include "element/incremental_driver/lines.hpp"
#include "element/vectors.hpp"

namespace incremental_driver {

struct Restriction {
    element::Vector6 stress = element::Vector6::Zero();
    element::Vector6 strain = element::Vector6::Zero();
    double change = 0.0;
};

// Terms may appear twice: they add up. A remark starts with # or !. Throws BadInput.
Restriction read_restriction(const Lines& lines, const Line& line);

}  // namespace incremental_driver
