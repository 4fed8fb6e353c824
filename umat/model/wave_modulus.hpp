// SPDX-License-Identifier: BSD-3-Clause
// Upper bound of the P-wave modulus, for explicit time steps: of one point or of a pack.
#pragma once

#include "umat/model/cone.hpp"
#include "umat/model/principal_bound.hpp"
#include "umat/model/scalar_factors.hpp"

GRIT_KERNEL_BEGIN

// T shifted by p_t (H10), and on the border of the model's domain where it lies outside.
template <class Real> GRIT_INLINE Tensor<Real> stress_in_domain(const Material& m, Tensor<Real> T) {
    for (int c = 0; c < 3; ++c) T[c] = T[c] - m.p_t;
    const MaskOf<Real> inside = trace(T) * (-1.0 / 3.0) >= Real(m.p_floor);
    T = select(inside, T, isotropic(Real(-m.p_floor)));
    back_into_cone(T, inside);
    return T;
}

// The largest n.(M:nn).n for any unit vector n and any h, or little more. M is linear in rho^chi (G1), between m_R L and
// what it is at rho = 1, along h of length 1: there m_T L and, where nn turns back along h, (m_R - m_T) L:h (h:nn), else
// (1 - m_T) L:h (h:nn) + N (h:nn). With x = h:nn, t = n.T_hat.n and T_hat:h between t x -+ sqrt((T_hat:T_hat - t^2)(1 - x^2)),
// nn:L:h x is within (A -+ sqrt(A^2 + B^2))/2, A = F^2 + a^2 t^2, B = a^2 t sqrt(T_hat:T_hat - t^2).
template <class Real>
GRIT_INLINE Real wave_modulus(const Material& m, bool igs, const Tensor<Real>& T, const Real& e) {
    const StressShape<Real> shape = stress_shape(m, T);
    const ScalarFactors<Real> f = scalar_factors(m, trace(T) * (-1.0 / 3.0), e);
    const Tensor<Real>& dev = shape.T_hat_dev;
    const Real J_2 = 0.5 * contract(dev, dev), J_3 = determinant(dev);
    const Real most = largest_principal_bound(J_2, J_3);
    const Real least = -largest_principal_bound(J_2, -J_3);
    // Largest |principal value| of times T_hat_dev + 1/3.
    const auto largest = [&](double times) {
        return max(times * most + 1.0 / 3.0, -(times * least + 1.0 / 3.0));
    };
    const Real scale = f.f_s / shape.T_hat_sq;
    const Real t = largest(1.0), A = square(shape.F) + square(m.a * t);
    const Real nonlinear = scale * f.f_d * m.a * shape.F * largest(2.0);
    if (!igs) return scale * A + nonlinear;
    const Real T_sq = shape.T_hat_sq,
               beside = min(square(t), 0.5 * T_sq);  // where B is largest, if t gets there
    const Real more = 0.5 * (sqrt(square(A) + square(square(m.a)) * beside * (T_sq - beside)) - A);
    return max(scale * (m.m_R * A + (m.m_R - m.m_T) * more),
               scale * (m.m_T * A + (m.m_T - 1.0) * more) + nonlinear);
}

GRIT_KERNEL_END
