// SPDX-License-Identifier: BSD-3-Clause
// Intergranular strain of Niemunis & Herle (1997) along a straight strain path.
//
// With D_hat the direction of straining and s the arc length, h never leaves the plane of h_0 and
// D_hat:  h/R = u D_hat + g tau,  tau = the part of h_0/R across D_hat, u and g two scalars.
//   u <= 0 (unloading)  u = u_0 + s/R, g = 1                                   closed form of (G3)
//   u > 0  (loading)    P = -ln(1 - u), G = -ln g are marched beside the stress: they are not stiff
//                       where u -> 1 and g -> 0 exponentially, and keep rho <= 1 without a clamp.
#pragma once

#include "umat/material.hpp"
#include "umat/tensor.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct Mobilisation {
    Real rho_sq;  // (|h|/R)^2
    Real c;       // h_hat:D_hat
    Real log_rho;
};

template <class Real>
GRIT_INLINE Mobilisation<Real> mobilisation(const Real& u, const Real& g, const Real& tau_sq) {
    Mobilisation<Real> r;
    r.rho_sq = fma(u, u, g * g * tau_sq) + 1e-40;
    r.log_rho = 0.5 * log(r.rho_sq);
    r.c = u / sqrt(r.rho_sq);
    return r;
}

// M = A L + B (L:h_hat) (x) h_hat + C N (x) h_hat     (G1)
template <class Real> struct Interpolation { Real A, B, C; };

template <class Real>
GRIT_INLINE Interpolation<Real> interpolation(const Material& m, const Real& log_rho,
                                              const MaskOf<Real>& loading) {
    const Real rho_chi = exp(m.chi * log_rho);
    Interpolation<Real> r;
    r.A = fma(m.m_T - m.m_R, rho_chi, Real(m.m_R));
    r.B = rho_chi * select(loading, Real(1.0 - m.m_T), Real(m.m_R - m.m_T));
    r.C = select(loading, rho_chi, Real(0.0));
    return r;
}

// Rates per arc length of P and G while loading:
//   du/ds = (1 - rho^beta_r c^2)/R,  dg/ds = -rho^(beta_r - 1) c g/R                     (G3)
template <class Real> struct MobilisationRate { Real P, G; };

template <class Real>
GRIT_INLINE MobilisationRate<Real> mobilisation_rate(const Material& m, const Mobilisation<Real>& h,
                                                     const Real& u, const MaskOf<Real>& loading) {
    const Real rho_beta = exp(m.beta_r * h.log_rho);
    // Closer to saturation than roundoff can tell, P stands still.
    constexpr double saturated = 1e-12;
    const Real P = max(1.0 - rho_beta * square(h.c), Real(0.0)) / max(1.0 - u, Real(saturated));
    const Real G = rho_beta * u / h.rho_sq;
    const Real zero(0.0);
    const MaskOf<Real> moving = loading & (1.0 - u > Real(saturated));
    return {select(moving, m.inverse_R * P, zero), select(loading, m.inverse_R * G, zero)};
}

GRIT_KERNEL_END
