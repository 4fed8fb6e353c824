// SPDX-License-Identifier: BSD-3-Clause
// Largest principal value of a deviator without its eigenvectors.
#pragma once

#include "umat/tensor.hpp"

GRIT_KERNEL_BEGIN

// The largest root of x^3 - J_2 x - J_3, by Newton's method from 2 sqrt(J_2/3), which is no less: there
// the cubic is convex, so that every iterate is an upper bound. Five leave it within 4 % where the root
// is double (triaxial extension) and closer elsewhere.
inline double largest_principal_bound(double J_2, double J_3) {
    double x = 2.0 * sqrt(J_2 * (1.0 / 3.0));
    for (int i = 0; i < 5; ++i) {
        const double slope = 3.0 * x * x - J_2;
        if (!(slope > 0.0)) break;
        x -= ((x * x - J_2) * x - J_3) / slope;
    }
    return x;
}

GRIT_KERNEL_END
