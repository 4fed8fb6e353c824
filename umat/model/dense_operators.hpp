// SPDX-License-Identifier: BSD-3-Clause
// L, N and M as matrices, for tangents and for users: columns are the kernel's own directional
// derivatives. Plain doubles only.
#pragma once

#include "umat/model/stress_rate.hpp"

GRIT_KERNEL_BEGIN

struct Matrix {
    double c[6][6];  // Mandel, [row][column]
};

using PointFactors = Stiffness<double, double>;

GRIT_INLINE PointFactors point_factors(const Material& m, const Tensor<double>& T, double e) {
    return {stress_shape(m, T), scalar_factors(m, trace(T) * (-1.0 / 3.0), e)};
}

GRIT_INLINE Tensor<double> unit(int i) {
    Tensor<double> u = isotropic(0.0);
    u[i] = 1.0;
    return u;
}

inline Matrix dense_L(const Material& m, const PointFactors& k, double factor) {
    Matrix L;
    for (int j = 0; j < 6; ++j) {
        const Tensor<double> column = apply_stiffness(m, k.shape, k.f, unit(j), 0.0);
        for (int i = 0; i < 6; ++i) L.c[i][j] = factor * column[i];
    }
    return L;
}

GRIT_INLINE Tensor<double> dense_N(const Material& m, const PointFactors& k) {
    return apply_stiffness(m, k.shape, k.f, isotropic(0.0), 1.0);
}

// L + N (x) D_hat: the basic model's tangent along D_hat     (H1)
inline Matrix basic_M(const Material& m, const PointFactors& k, const Tensor<double>& D_hat) {
    Matrix M;
    for (int j = 0; j < 6; ++j) {
        const Tensor<double> column = apply_stiffness(m, k.shape, k.f, unit(j), D_hat[j]);
        for (int i = 0; i < 6; ++i) M.c[i][j] = column[i];
    }
    return M;
}

// (G1); the branch is that of the strain rate D.
inline Matrix intergranular_M(const Material& m, const PointFactors& k, const Tensor<double>& h,
                              const Tensor<double>& D) {
    const double h_norm = norm(h);
    const Tensor<double> h_hat = scaled(h, h_norm > 0.0 ? 1.0 / h_norm : 0.0);
    const double rho = max(h_norm * m.inverse_R, least_rho);
    const Interpolation<double> w = interpolation<double>(m, rho, contract(h_hat, D) > 0.0);
    Matrix M;
    for (int j = 0; j < 6; ++j) {
        const Tensor<double> X = scaled_sum(w.B * h_hat[j], h_hat, scaled(unit(j), w.A));
        const Tensor<double> column = apply_stiffness(m, k.shape, k.f, X, w.C * h_hat[j]);
        for (int i = 0; i < 6; ++i) M.c[i][j] = column[i];
    }
    return M;
}

// [rho^chi m_T + (1 - rho^chi) m_R] L, the limit of the tangent at a zero increment.
inline Matrix resting_M(const Material& m, bool igs, const PointFactors& k,
                        const Tensor<double>& h) {
    double factor = 1.0;
    if (igs) {
        const double rho = max(norm(h) * m.inverse_R, least_rho);
        factor = interpolation<double>(m, rho, true).A;
    }
    return dense_L(m, k, factor);
}

GRIT_KERNEL_END
