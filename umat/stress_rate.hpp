// SPDX-License-Identifier: BSD-3-Clause
// The rate that is integrated: stress along a straight strain path, (H1) and (G2) per arc length.
#pragma once

#include "umat/hypoplastic_stiffness.hpp"
#include "umat/intergranular_strain.hpp"

GRIT_KERNEL_BEGIN

// A straight strain path from a state: everything that stays constant along it.
template <class Real> struct StraightPath {
    Tensor<Real> D_hat;  // unit direction of straining
    Tensor<Real> tau;    // part of h_0/R across D_hat
    Real length;         // |strain increment|
    Real tr_D;           // tr D_hat
    Real tau_sq;         // tau:tau
    Real u_0;            // h_0:D_hat/R
    Real e_0;            // void ratio at the start
};

template <class Real>
GRIT_INLINE StraightPath<Real> straight_path(const Material& m,
                                             const Tensor<Real>& strain_increment,
                                             const Tensor<Real>& h, const Real& e) {
    StraightPath<Real> path;
    path.length = norm(strain_increment);
    path.D_hat = scaled(strain_increment, 1.0 / path.length);
    path.tr_D = trace(path.D_hat);
    const Tensor<Real> h_R = scaled(h, m.inverse_R);
    path.u_0 = contract(h_R, path.D_hat);
    path.tau = scaled_sum(-path.u_0, path.D_hat, h_R);
    path.tau_sq = contract(path.tau, path.tau);
    path.e_0 = e;
    return path;
}

template <class Real> GRIT_INLINE Real void_ratio(const StraightPath<Real>& path, const Real& s) {
    return fma(1.0 + path.e_0, exp(s * path.tr_D), Real(-1.0));  // (H9)
}

// What is marched along a path.
template <class Real> struct Marched {
    Tensor<Real> T;
    Real P;  // -ln(1 - u)
    Real G;  // -ln g
};

template <class Real> struct InPlane {  // h/R = u D_hat + g tau
    Real u, g;
};

template <class Real>
GRIT_INLINE InPlane<Real> intergranular_strain(const Material& m, const StraightPath<Real>& path,
                                               const Real& s, const Marched<Real>& y,
                                               const MaskOf<Real>& loading) {
    const Real unloading_u = fma(m.inverse_R, s, path.u_0);
    // Beyond these limits h is saturated to the last bit, and derivatives of P and G mean nothing.
    const Real loading_u = select(y.P > Real(36.0), Real(1.0), 1.0 - exp(-max(y.P, Real(0.0))));
    const Real g = select(y.G > Real(80.0), Real(0.0), exp(-y.G));
    return {select(loading, loading_u, min(unloading_u, Real(0.0))), g};
}

// d/ds of T, P and G at arc length s. Finite for every finite T: see stress_shape, scalar_factors.
template <class Real, bool with_intergranular_strain>
inline __attribute__((noinline)) Marched<Real>
marched_rate(const Material& m, const StraightPath<Real>& path, const Real& s,
             const Marched<Real>& y, const MaskOf<Real>& loading) {
    const StressShape<Real> shape = stress_shape(m, y.T);
    const Real p = trace(y.T) * (-1.0 / 3.0);
    const ScalarFactors<Real> f = scalar_factors(m, p, void_ratio(path, s));
    Marched<Real> rate;
    if constexpr (with_intergranular_strain) {
        const InPlane<Real> h = intergranular_strain(m, path, s, y, loading);
        const Mobilisation<Real> mob = mobilisation(h.u, h.g, path.tau_sq);
        const Interpolation<Real> k = interpolation(m, mob.log_rho, loading);
        // M:D_hat = L:(A D_hat + B c h_hat) + N C c, h_hat = (u D_hat + g tau)/rho     (G1), (G2)
        const Real B_c = k.B * mob.c;
        const Real along = fma(B_c, mob.c, k.A);
        const Real across = B_c * h.g / sqrt(mob.rho_sq);
        const Tensor<Real> X = scaled_sum(across, path.tau, scaled(path.D_hat, along));
        rate.T = apply_stiffness(m, shape, f, X, k.C * mob.c);
        const MobilisationRate<Real> h_rate = mobilisation_rate(m, mob, h.u, loading);
        rate.P = h_rate.P;
        rate.G = h_rate.G;
    } else {
        rate.T = apply_stiffness(m, shape, f, path.D_hat, Real(1.0));  // (H1)
        rate.P = Real(0.0);
        rate.G = Real(0.0);
    }
    return rate;
}

GRIT_KERNEL_END
