// SPDX-License-Identifier: BSD-3-Clause
// Void ratios and scalar factors of von Wolffersdorff (1996): what depends on p and e only.
#pragma once

#include "umat/material.hpp"
#include "umat/tensor.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct VoidRatios { Real e_i, e_c, e_d; };

// log(3p/h_s); p is kept above half the floor, where no stress is left to compute.
template <class Real> GRIT_INLINE Real log_pressure(const Material& m, const Real& p) {
    return log(m.three_over_hs * max(p, Real(0.5 * m.p_floor)));
}

template <class Real> struct Compression {
    Real x;  // (3p/h_s)^n
    Real E;  // exp(-x): e_i/e_i0 = e_c/e_c0 = e_d/e_d0
};

template <class Real>
GRIT_INLINE Compression<Real> compression(const Material& m, const Real& log_3p_hs) {
    const Real x = exp(m.n * log_3p_hs);
    return {x, exp(-x)};  // (H6)
}

template <class Real> struct ScalarFactors {
    Real f_d;  // (H7)
    Real f_s;  // f_b f_e [stress] (H7), (H8)
};

template <class Real>
GRIT_INLINE ScalarFactors<Real> scalar_factors(const Material& m, const Real& p, const Real& e) {
    const Real l = log_pressure(m, p);
    const Compression<Real> k = compression(m, l);
    const Real e_i = m.e_i0 * k.E;
    const Real e_d = m.e_d0 * k.E;
    const Real e_c = m.e_c0 * k.E;
    const Real e_in = min(max(e, e_d), e_i);  // continuous outside [e_d, e_i]
    const Real relative = (e_in - e_d) / (e_c - e_d);
    // (H7); its slope is infinite at e_d, so that it is replaced by its secant very near to it.
    const Real f_d = exp(m.alpha * log(max(relative, Real(linear_density)))) *
                     min(relative * (1.0 / linear_density), Real(1.0));
    // f_b f_e = stiffness (1+e_i)/e_i (3p/h_s)^(1-n) (e_c/e)^beta    (H7), (H8)
    const Real log_f_e = m.beta * (m.log_e_c0 - k.x - log(e_in));
    const Real f_s = m.stiffness * (1.0 + 1.0 / e_i) * exp(fma(1.0 - m.n, l, log_f_e));
    return {f_d, f_s};
}

GRIT_KERNEL_END
