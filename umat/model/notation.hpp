// SPDX-License-Identifier: BSD-3-Clause
// Voigt (the ABI: 11 22 33 12 13 23, engineering shear strain) to Mandel (the kernel) and back:
// the one file that knows the square root of two of the notation.
#pragma once

#include "umat/model/tensor.hpp"

GRIT_KERNEL_BEGIN

constexpr double root_2 = 0x1.6a09e667f3bcdp+0;
constexpr double root_half = 0x1.6a09e667f3bcdp-1;

GRIT_INLINE Tensor<double> stress_from_voigt(const double v[6]) {
    return {v[0], v[1], v[2], v[3] * root_2, v[4] * root_2, v[5] * root_2};
}
GRIT_INLINE void stress_to_voigt(const Tensor<double>& A, double v[6]) {
    for (int i = 0; i < 6; ++i) v[i] = i < 3 ? A[i] : A[i] * root_half;
}
GRIT_INLINE Tensor<double> strain_from_voigt(const double v[6]) {
    return {v[0], v[1], v[2], v[3] * root_half, v[4] * root_half, v[5] * root_half};
}
GRIT_INLINE void strain_to_voigt(const Tensor<double>& A, double v[6]) {
    for (int i = 0; i < 6; ++i) v[i] = i < 3 ? A[i] : A[i] * root_2;
}
// Factor from d(Mandel stress r)/d(Mandel strain c) to Voigt.
GRIT_INLINE double stiffness_to_voigt(int row, int column) {
    return (row < 3 ? 1.0 : root_half) * (column < 3 ? 1.0 : root_half);
}

template <class Real> GRIT_INLINE Real determinant(const Tensor<Real>& A) {
    const Real normal = A[0] * A[1] * A[2];
    const Real shear = A[3] * A[4] * A[5];
    const Real mixed = fma(A[0], square(A[5]), fma(A[1], square(A[4]), A[2] * square(A[3])));
    return normal + root_half * shear - 0.5 * mixed;
}

// The derivative of the determinant.
template <class Real> GRIT_INLINE Tensor<Real> cofactors(const Tensor<Real>& A) {
    const auto normal = [&](int i, int j, int k) { return A[i] * A[j] - 0.5 * square(A[k]); };
    const auto shear = [&](int i, int j, int k) {
        return root_half * A[i] * A[j] - A[k] * A[6 - k - 1];
    };
    return {normal(1, 2, 5), normal(0, 2, 4), normal(0, 1, 3),
            shear(4, 5, 3),  shear(3, 5, 4),  shear(3, 4, 5)};
}

// Q A Q^T, Q row-major.
template <class Real> GRIT_INLINE Tensor<Real> rotated(const Real Q[9], const Tensor<Real>& A) {
    const Real a[9] = {A[0], A[3] * root_half, A[4] * root_half, A[3] * root_half,
                       A[1], A[5] * root_half, A[4] * root_half, A[5] * root_half,
                       A[2]};
    Real QA[9];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            QA[3 * i + j] = Q[3 * i] * a[j] + Q[3 * i + 1] * a[3 + j] + Q[3 * i + 2] * a[6 + j];
    const auto entry = [&](int i, int j) {
        return QA[3 * i] * Q[3 * j] + QA[3 * i + 1] * Q[3 * j + 1] + QA[3 * i + 2] * Q[3 * j + 2];
    };
    return {entry(0, 0),          entry(1, 1),          entry(2, 2),
            entry(0, 1) * root_2, entry(0, 2) * root_2, entry(1, 2) * root_2};
}

GRIT_KERNEL_END
