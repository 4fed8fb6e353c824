// SPDX-License-Identifier: BSD-3-Clause
// Where a stress lies in the deviatoric plane, in closed form and to roundoff also where two principal
// values coincide. Tension positive. Not for kernels.
#pragma once

#include <cmath>

#include "umat/notation.hpp"

GRIT_KERNEL_BEGIN

struct DeviatoricPlane {
    double length;  // of the deviator
    double
        angle;  // of Lode: 0 where the middle value is the largest (triaxial compression) ... pi/3

    double largest_less_smallest() const { return root_2 * length * std::sin(third_of_pi + angle); }
    double middle() const { return root_two_thirds * length * std::cos(third_of_pi + angle); }

  private:
    static constexpr double third_of_pi = 0x1.0c152382d7366p+0;
    static constexpr double root_two_thirds = 0x1.a20bd700c2c3ep-1;
};

// With s = A*/|A*| and X the deviator of its cofactors, |X| = 1/sqrt 6 and s:X = 3 det s, so that
// cos(3 angle) = -s:X/|X|. The sine comes from the part of X across s: as an angle between tensors it is
// exact to roundoff where the determinant alone would leave its square root.
inline DeviatoricPlane deviatoric_plane(const Tensor<double>& deviator_of_A) {
    double largest = 0.0;
    for (const double component : deviator_of_A.c) largest = max(largest, fabs(component));
    if (!(largest > 1e-300)) return {0.0, 0.0};
    const Tensor<double> scaled_A = scaled(deviator_of_A, 1.0 / largest);
    const double length = norm(scaled_A);
    const Tensor<double> s = scaled(scaled_A, 1.0 / length);
    const Tensor<double> X = deviator(cofactors(s));
    const double along = contract(s, X);
    return {largest * length, std::atan2(norm(scaled_sum(-along, s, X)), -along) / 3.0};
}

GRIT_KERNEL_END
