// SPDX-License-Identifier: BSD-3-Clause
// Tensors of the tests: Mandel 6-vectors of Eigen (shear times sqrt 2), so A:B is a dot product.
#pragma once

#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace tests {

using Vec = Eigen::Matrix<double, 6, 1>;
using Mat = Eigen::Matrix<double, 6, 6>;
using Full = Eigen::Matrix3d;
using Voigt = std::array<double, 6>;

inline const double root_2 = std::sqrt(2.0);

inline Vec identity() { return {1.0, 1.0, 1.0, 0.0, 0.0, 0.0}; }
inline Vec principal(double x, double y, double z) { return {x, y, z, 0.0, 0.0, 0.0}; }
inline double trace(const Vec& A) { return A[0] + A[1] + A[2]; }
inline Vec deviator(const Vec& A) { return A - trace(A) / 3.0 * identity(); }

inline Vec stress_from(const double v[6]) {
    return {v[0], v[1], v[2], v[3] * root_2, v[4] * root_2, v[5] * root_2};
}
inline Vec strain_from(const double v[6]) {
    return {v[0], v[1], v[2], v[3] / root_2, v[4] / root_2, v[5] / root_2};
}
inline Voigt voigt_stress(const Vec& A) {
    return {A[0], A[1], A[2], A[3] / root_2, A[4] / root_2, A[5] / root_2};
}
inline Voigt voigt_strain(const Vec& A) {
    return {A[0], A[1], A[2], A[3] * root_2, A[4] * root_2, A[5] * root_2};
}

// d stress / d strain, row-major Voigt to Mandel.
inline Mat stiffness_from(const double v[36]) {
    Mat M;
    for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
            M(r, c) = v[6 * r + c] * (r < 3 ? 1.0 : root_2) * (c < 3 ? 1.0 : root_2);
    return M;
}

inline Full full(const Vec& A) {
    Full M;
    M << A[0], A[3] / root_2, A[4] / root_2, A[3] / root_2, A[1], A[5] / root_2, A[4] / root_2,
        A[5] / root_2, A[2];
    return M;
}
inline Vec mandel(const Full& M) {
    return {M(0, 0), M(1, 1), M(2, 2), M(0, 1) * root_2, M(0, 2) * root_2, M(1, 2) * root_2};
}
inline Vec rotated(const Full& Q, const Vec& A) { return mandel(Q * full(A) * Q.transpose()); }

// Unit deviator in principal axes at angle theta in the deviatoric plane; 0: axis 1 is the largest.
inline Vec deviatoric_direction(double theta) {
    const double third = 2.0943951023931953;
    return std::sqrt(2.0 / 3.0) *
           principal(std::cos(theta), std::cos(theta - third), std::cos(theta + third));
}

// The part of A across the unit tensor n.
inline Vec across(const Vec& A, const Vec& n) { return A - A.dot(n) * n; }

}  // namespace tests
