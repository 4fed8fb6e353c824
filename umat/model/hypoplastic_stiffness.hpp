// SPDX-License-Identifier: BSD-3-Clause
// L and N of von Wolffersdorff (1996) applied to a direction, without ever forming a 6 x 6 matrix.
#pragma once

#include "umat/model/dual_tensor.hpp"
#include "umat/model/scalar_factors.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct StressShape {
    Tensor<Real> T_hat;      // T / tr T
    Tensor<Real> T_hat_dev;  // T_hat - I/3
    Real T_hat_sq;           // T_hat:T_hat
    Real F;                  // (H5)
    Real inverse_trace;      // 1 / tr T
};

// (H5) for tan psi and q3 = sqrt 2 tan psi cos 3 theta, both clamped so that F > 0.
template <class Real>
GRIT_INLINE Real lode_factor(const Real& dev_sq, const Real& determinant_dev) {
    constexpr double limit = cone_limit * root_2;
    // The 1e-30 keeps the hydrostatic axis free of 0/0; there F = 1.
    const Real tan_psi = min(sqrt(fma(3.0, dev_sq, 1e-30)), Real(limit));
    const Real bound = root_2 * tan_psi;
    const Real raw = -18.0 * determinant_dev / (dev_sq + 1e-30);
    const Real q3 = max(min(raw, bound), -bound);
    const Real tan_sq = tan_psi * tan_psi;
    return sqrt(fma(0.125, tan_sq, (2.0 - tan_sq) / (2.0 + q3))) - (0.25 * root_2) * tan_psi;
}

template <class Real>
GRIT_INLINE StressShape<Real> stress_shape(const MaterialOf<Real>& m, const Tensor<Real>& T) {
    StressShape<Real> s;
    s.inverse_trace = 1.0 / min(trace(T), Real(-1.5 * m.p_floor));
    s.T_hat = scaled(T, s.inverse_trace);
    s.T_hat_dev = deviator(s.T_hat);
    const Real dev_sq = square(s.T_hat_dev);
    s.T_hat_sq = dev_sq + 1.0 / 3.0;
    s.F = chained(
        [](const auto& x, const auto& y)
            __attribute__((always_inline)) { return lode_factor(x, y); },
        dev_sq, determinant(s.T_hat_dev));
    return s;
}

// L:X + N C for a direction X and a scalar C, per f_s:
//   (F^2 X + a^2 T_hat (T_hat:X) + f_d a F (T_hat + T_hat*) C) / (T_hat:T_hat)     (H2), (H3)
template <class Stress, class Real>
GRIT_INLINE Tensor<Real> apply_stiffness(const MaterialOf<Real>& m, const StressShape<Stress>& s,
                                         const ScalarFactors<Real>& f, const Tensor<Real>& X,
                                         const Real& C) {
    const Real scale = f.f_s / s.T_hat_sq;
    const Real along_X = scale * square(s.F);
    const Real flow = scale * (m.a * f.f_d) * s.F * C;
    const Real along_T = fma(scale * (m.a * m.a), contract(s.T_hat, X), flow);
    Tensor<Real> rate;
    for (int i = 0; i < 6; ++i)
        rate[i] = fma(along_X, X[i], fma(along_T, s.T_hat[i], flow * s.T_hat_dev[i]));
    return rate;
}

GRIT_KERNEL_END
