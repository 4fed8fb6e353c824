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

// n.(L:nn).n and |n.N.n| for any unit vector n: the larger of m_R L and L + N.
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
    const Real linear = scale * (square(shape.F) + square(m.a * largest(1.0)));
    const Real nonlinear = scale * f.f_d * m.a * shape.F * largest(2.0);
    return max(igs ? m.m_R * linear : Real(0.0), linear + nonlinear);
}

GRIT_KERNEL_END
