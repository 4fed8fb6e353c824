// SPDX-License-Identifier: BSD-3-Clause
// Largest principal value of a deviator without its eigenvectors.
#pragma once

#include "umat/model/tensor.hpp"

GRIT_KERNEL_BEGIN

// The largest root of x^3 - J_2 x - J_3, by Newton's method from 2 sqrt(J_2/3), which is no less: there
// the cubic is convex, so that every iterate is an upper bound. Five leave it within 4 % where the root
// is double (triaxial extension) and closer elsewhere.
template <class Real> GRIT_INLINE Real largest_principal_bound(const Real& J_2, const Real& J_3) {
    Real x = 2.0 * sqrt(J_2 * (1.0 / 3.0));
    for (int i = 0; i < 5; ++i) {
        const Real slope = 3.0 * x * x - J_2;
        const Real next = x - ((x * x - J_2) * x - J_3) / slope;
        x = select(slope > Real(0.0), next, x);
    }
    return x;
}

GRIT_KERNEL_END
