// SPDX-License-Identifier: BSD-3-Clause
// Void ratios and scalar factors of von Wolffersdorff (1996): what depends on p and e only.
#pragma once

#include "umat/model/power.hpp"
#include "umat/model/tensor.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct VoidRatios { Real e_i, e_c, e_d; };

// Of the pressure. y is kept above the half floor's, where no stress is left to compute.
template <class Real> struct Compression {
    Real x;          // (3p/h_s)^n
    Real expansion;  // exp(x): e_i0/e_i = e_c0/e_c = e_d0/e_d     (H6)
};

constexpr double least_y = 1.5 * floor_per_hardness;  // of y = 3p/h_s

template <class Real> GRIT_INLINE Real hardness_ratio(const MaterialOf<Real>& m, const Real& p) {
    return max(m.three_over_hs * p, Real(least_y));
}

template <class Real>
GRIT_INLINE Compression<Real> compression(const MaterialOf<Real>& m, const Real& p) {
    const Real x = exp(m.n * log(hardness_ratio(m, p)));
    return {x, exp(x)};
}

template <class Real> struct ScalarFactors {
    Real f_d;  // (H7)
    Real f_s;  // f_b f_e [stress] (H7), (H8)
};

// (H7) of the void ratio expanded to zero pressure; its slope is infinite at e_d, so that it is replaced by its
// secant very near to it.
template <class Real> GRIT_INLINE Real density_factor(const MaterialOf<Real>& m, const Real& e_0) {
    const Real relative = (e_0 - m.e_d0) * m.inverse_e_range;
    return power(m.alpha_power, max(relative, Real(linear_density))) *
           min(relative * (1.0 / linear_density), Real(1.0));
}

template <class Stress, class Real>
GRIT_INLINE ScalarFactors<Real> scalar_factors(const MaterialOf<Real>& m, const Stress& p,
                                               const Compression<Stress>& k, const Real& e) {
    // Void ratio expanded to zero pressure, continuous outside [e_d0, e_i0].
    const Real e_0 = min(max(e * k.expansion, Real(m.e_d0)), Real(m.e_i0));
    const Real f_d = chained([&](const auto& x) { return density_factor(m, x); }, e_0);
    // f_b f_e = stiffness (1+e_i)/e_i (3p/h_s)^(1-n) (e_c/e)^beta    (H7), (H8)
    const Real f_e = chained([&](const auto& x) { return power(m.beta_power, m.e_c0 / x); }, e_0);
    const Real f_s =
        m.stiffness * fma(k.expansion, m.inverse_e_i0, 1.0) * (hardness_ratio(m, p) / k.x) * f_e;
    return {f_d, f_s};
}

template <class Real>
GRIT_INLINE ScalarFactors<Real> scalar_factors(const MaterialOf<Real>& m, const Real& p,
                                               const Real& e) {
    return scalar_factors(m, p, compression(m, p), e);
}

GRIT_KERNEL_END
