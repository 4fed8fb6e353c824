// SPDX-License-Identifier: BSD-3-Clause
// Intergranular strain of Niemunis & Herle (1997) along a straight strain path, in closed form.
//
// With D_hat the direction of straining and s the arc length, h never leaves the plane of h_0 and
// D_hat:  h/R = u D_hat + g tau,  tau = the part of h_0/R across D_hat. Its course is told by q, ds = R J dq:
//   unloading  u = u_0 + q, g = 1, J = 1.
//   loading    (G4) makes rho^-beta_r - 1 a power of the sine of the angle between h and D_hat. With
//              h_hat = (sinh z, r)/Y, Y^2 = sinh^2 z + r^2, and q = z - z_0:
//              rho = (1 + kappa Y^-beta_r)^(-1/beta_r),  J = rho cosh(z)/Y.
// Where h is small q is its length over R, where it is saturated the strain over R: stresses are smooth
// functions of q. Everything is written with E = exp(-z), so that z may be as large as it likes.
#pragma once

#include "umat/model/power.hpp"
#include "umat/model/tensor.hpp"

GRIT_KERNEL_BEGIN

// Keep h = 0 free of 0/0 and of log(0).
constexpr double least_square = 1e-60, least_rho = 1e-30;

template <class Real> struct LoadingCurve {
    Real E_sq;    // E^2 at q = 0
    Real across;  // 2 E r / |tau| there
    Real y;       // 2 E there, or what makes kappa 1 - rho_0^beta_r
    Real kappa;
};

template <class Real>
GRIT_INLINE LoadingCurve<Real> loading_curve(const MaterialOf<Real>& m, const Real& u,
                                             const Real& tau_sq) {
    const Real rho = sqrt(fma(u, u, tau_sq) + least_square);
    const Real rho_beta = power(m.beta_r_power, rho);
    const Real left =
        1.0 - rho_beta;  // a little below 0 where a host's h is a little longer than R
    // r = 1: z is artanh of the cosine, as in (G4).
    const Real inverse = 1.0 / (u + rho);
    LoadingCurve<Real> curve{tau_sq * square(inverse), 2.0 * inverse, 2.0 * inverse, left};
    // kappa = 1: from near h = 0, where the angle changes at once and h hardly.
    const MaskOf<Real> small = rho_beta < Real(0.5);
    if (any(small)) {
        const Real scale = power(m.inverse_beta_r_power, 1.0 / max(left, Real(0.5)));
        const Real x = u * scale;
        const Real E = 1.0 / (x + sqrt(fma(x, x, Real(1.0))));
        curve.E_sq = select(small, E * E, curve.E_sq);
        curve.across = select(small, 2.0 * scale * E, curve.across);
        curve.y = select(small, 2.0 * E, curve.y);
        curve.kappa = select(small, Real(1.0), curve.kappa);
    }
    return curve;
}

template <class Real> struct Mobilisation {
    Real rho;                 // |h|/R
    Real c, across;           // h_hat = c D_hat + across tau
    Real J;                   // ds = R J dq
    Real J_growth;            // dJ/dq / J
    OfMemory<Real> rho_beta;  // rho^beta_r while loading, else 1
};

template <class Real> GRIT_INLINE Mobilisation<PlainOf<Real>> value(const Mobilisation<Real>& h) {
    return {value(h.rho), value(h.c),        value(h.across),
            value(h.J),   value(h.J_growth), value(h.rho_beta)};
}

// What does not change along a segment of a path: on which branch, from where.
template <class Real> struct Course {
    MaskOf<Real> loading;
    LoadingCurve<Real> curve;
    Real u_0, tau_sq;  // u at q = 0 while unloading; tau:tau
};

// exp(-q) is held above this.
constexpr double least_decay = 1e-300, longest_decay = 690.77552789821368;

// y^beta_r, whose y has this decay in it: where beta_r is small, and a logarithm is at hand, it falls on.
template <class Real>
GRIT_INLINE Real evolution_power(const MaterialOf<Real>& m, const Real& y, const Real& q) {
    if (m.beta_r_power.quarters >= 0) return power(m.beta_r_power, y);
    return exp(m.beta_r * (log(y) - max(q - longest_decay, Real(0.0))));
}

// decay = exp(-q). Where J is not wanted from there on, its growth is left out.
template <bool goes_on = true, class Real>
GRIT_INLINE Mobilisation<Real> mobilisation(const MaterialOf<Real>& m, const Course<Real>& course,
                                            const Real& q, const Real& decay) {
    const Real one(1.0);
    Real E_sq = one, along = course.u_0 + q, across = one;
    if (any(course.loading)) {
        E_sq = course.curve.E_sq * square(decay);
        along = select(course.loading, 1.0 - E_sq, along);
        across = select(course.loading, course.curve.across * decay, one);
    }
    const Real length_sq = fma(along, along, square(across) * course.tau_sq) + least_square;
    const Real inverse = 1.0 / sqrt(length_sq);
    Mobilisation<Real> r{length_sq * inverse, along * inverse,    across * inverse, one,
                         Real(0.0),           OfMemory<Real>(1.0)};
    if (any(course.loading)) {
        const Real y = course.curve.y * decay * inverse;
        const Real rho_beta = 1.0 / fma(course.curve.kappa, evolution_power(m, y, q), 1.0);
        const Real rho = power(m.inverse_beta_r_power, rho_beta);
        const Real stretch = (1.0 + E_sq) * inverse;
        r.rho = select(course.loading, rho, r.rho);
        r.J = select(course.loading, rho * stretch, r.J);
        r.rho_beta = select(course.loading, of_memory(rho_beta), r.rho_beta);
        if constexpr (goes_on) {
            const Real growth = along / (1.0 + E_sq) - rho_beta * r.c * stretch;
            r.J_growth = select(course.loading, growth, Real(0.0));
        }
    }
    return r;
}

template <class Real>
GRIT_INLINE Mobilisation<Real> mobilisation(const MaterialOf<Real>& m, const Course<Real>& course,
                                            const Real& q) {
    return mobilisation(m, course, q,
                        any(course.loading) ? max(exp(-q), Real(least_decay)) : Real(1.0));
}

template <class Real>
GRIT_INLINE Mobilisation<Real> mobilisation_at_start(const MaterialOf<Real>& m,
                                                     const Course<Real>& course) {
    return mobilisation(m, course, course.u_0 * 0.0, Real(1.0));
}

// Of the basic model.
template <class Real> GRIT_INLINE Mobilisation<Real> no_mobilisation(const Real& like) {
    const Real zero = like * 0.0, one = zero + 1.0;
    return {zero, one, zero, one, zero, OfMemory<Real>(1.0)};
}

template <class Real>
GRIT_INLINE Mobilisation<Real> select(const MaskOf<Real>& mask, const Mobilisation<Real>& yes,
                                      const Mobilisation<Real>& no) {
    return {select(mask, yes.rho, no.rho),           select(mask, yes.c, no.c),
            select(mask, yes.across, no.across),     select(mask, yes.J, no.J),
            select(mask, yes.J_growth, no.J_growth), select(mask, yes.rho_beta, no.rho_beta)};
}

// M = A L + B (L:h_hat) (x) h_hat + C N (x) h_hat     (G1)
template <class Real> struct Interpolation { Real A, B, C; };

template <class Real>
GRIT_INLINE Interpolation<Real> interpolation(const MaterialOf<Real>& m, const Real& rho,
                                              const MaskOf<Real>& loading) {
    using Plain = PlainOf<Real>;
    const Real rho_chi = power(m.chi_power, rho);
    Interpolation<Real> r;
    r.A = fma(m.m_T - m.m_R, rho_chi, m.m_R);
    if constexpr (is_sensitive<Real>) r.B = rho_chi * select(loading, 1.0 - m.m_T, m.m_R - m.m_T);
    else r.B = rho_chi * select(loading, Plain(1.0 - m.m_T), Plain(m.m_R - m.m_T));
    r.C = select(loading, rho_chi, Real(0.0));
    return r;
}

// |dh| in |de| [-]: 1 where h follows the strain, 0 where it is saturated along D_hat     (G3)
template <class Real>
GRIT_INLINE PlainOf<Real> memory_of(const Mobilisation<Real>& h, const MaskOf<Real>& loading) {
    using Plain = PlainOf<Real>;
    const Plain rho_beta = value(h.rho_beta);
    const Plain lost = square(value(h.c)) * rho_beta * (2.0 - rho_beta);
    return select(loading, sqrt(max(1.0 - lost, Plain(0.0))), Plain(1.0));
}

GRIT_KERNEL_END
