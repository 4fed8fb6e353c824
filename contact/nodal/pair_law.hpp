// SPDX-License-Identifier: BSD-3-Clause
// The impulse between two bodies at a node, (C1) to (C6) of docs/contact.md: Geo-contact of Ma, Wang &
// Randolph (2014), frictional contact of Bardenhagen et al. (2000).
#pragma once

#include <grit/contact.h>

#include "contact/normals/limits.hpp"
#include "support/elementary.hpp"
#include "support/vector.hpp"

GRIT_KERNEL_BEGIN

template <class Real, int C>
GRIT_INLINE Real fused_dot(const Vector<Real, C>& a, const Vector<Real, C>& b) {
    Real sum = a[0] * b[0];
    for (int i = 1; i < C; ++i) sum = fma(a[i], b[i], sum);
    return sum;
}

// s a + b
template <class Real, int C>
GRIT_INLINE Vector<Real, C> fused_sum(const Real& s, const Vector<Real, C>& a,
                                      const Vector<Real, C>& b) {
    Vector<Real, C> r;
    for (int i = 0; i < C; ++i) r[i] = fma(s, a[i], b[i]);
    return r;
}

// The constants of a pair, from its options.
struct Law {
    explicit Law(const grit_contact_options& o)
        : springs(o.contact_stiffness > 0.0),
          part(o.relaxation_time > 0.0 ? o.time_step / o.relaxation_time : 1.0),
          k(springs ? o.penalty_power : o.penalty_power * part),  // (C9)
          stiffness_dt2(o.contact_stiffness * o.time_step * o.time_step),
          mu(o.friction_coefficient), c_a_dt(o.adhesion * o.time_step),
          gap_tolerance(o.gap_tolerance), mass_tolerance(o.mass_tolerance),
          inverse_dt(o.time_step > 0.0 ? 1.0 / o.time_step : 0.0), adheres(o.adhesion > 0.0),
          frictionless(o.friction_coefficient == 0.0 && !adheres), geo(o.law == GRIT_CONTACT_GEO),
          allow_zero_normal(o.allow_zero_normal != 0), rigid_a(o.rigid == GRIT_CONTACT_A_RIGID),
          rigid_b(o.rigid == GRIT_CONTACT_B_RIGID) {}
    bool springs;
    double part;  // dt/tau
    double k, stiffness_dt2, mu, c_a_dt, gap_tolerance, mass_tolerance, inverse_dt;
    bool adheres, frictionless, geo, allow_zero_normal, rigid_a, rigid_b;
};

// x^k of x in [0, 1] with 0^k = 0: by multiplication where k is a small whole number, as it mostly is.
template <class Real> GRIT_INLINE Real power(const Real& x, double k) {
    constexpr double largest_whole = 64.0;
    if (k >= 1.0 && k <= largest_whole && k == static_cast<double>(static_cast<int>(k))) {
        auto bits = static_cast<unsigned>(k);
        Real square = x;
        while (!(bits & 1)) {
            square = square * square;
            bits >>= 1;
        }
        Real result = square;
        while (bits >>= 1) {
            square = square * square;
            if (bits & 1) result = result * square;
        }
        return result;
    }
    const Real general = exp(Real(k) * log(max(x, Real(0x1p-1022))));
    return select(x > Real(0.0), general, Real(0.0));
}

template <class Real> struct Cell {
    Real d, inverse;  // along the normal, and 1/d
};

template <class Real>
GRIT_INLINE Real penalty_factor(const Real& s, const Cell<Real>& cell, double k) {
    const Real share = min(max(s, Real(0.0)) * cell.inverse, Real(1.0));
    return Real(1.0) - power(share, k);  // (C4)
}

// Masses at a node: are there two bodies, and how do they share an impulse?
template <class Real> struct Shares {
    MaskOf<Real> active;
    Real a, b;  // velocity change of A and of B per J / m_r [-]
    Real m_r;
};

constexpr double no_mass = 1e-200;  // [mass] shares of less would lose their meaning
constexpr double no_slip = 1e-150;  // [velocity]: hosts may trap a division by zero

template <class Real>
GRIT_INLINE Shares<Real> shares_of(const Law& law, const Real& m_a, const Real& m_b) {
    const Real zero(0.0), one(1.0);
    if (law.rigid_a || law.rigid_b) {
        const MaskOf<Real> active = (m_a > Real(no_mass)) & (m_b > Real(no_mass));
        if (law.rigid_a) return {active, zero, one, m_b};  // (C5)
        return {active, one, zero, m_a};
    }
    const Real sum = m_a + m_b;
    const Real least = max(Real(law.mass_tolerance) * sum, Real(no_mass));
    const Real inverse = one / max(sum, Real(no_mass));
    const Real a = m_b * inverse;
    const MaskOf<Real> active = (m_a > least) & (m_b > least);
    return {active, a, m_a * inverse, m_a * a};  // (C1)
}

// What an active node brings along, beside its masses.
template <class Real, int C> struct Approach {
    Vector<Real, C> w, n;  // w = v_A - v_B
    Real s = Real(0.0);    // of Geo-contact only, as is the cell
    Cell<Real> cell = {Real(1.0), Real(1.0)};
    Real gap;               // -infinity where none is known
    Real area = Real(0.0);  // with adhesion or springs only
    bool has_pores = false;
    Real pore_impulse = Real(0.0);  // what of J_n is water's, which does not rub
};

template <class Real, int C> struct Response {
    MaskOf<Real> touches, slips;
    Real f_p, w_n, w_t, u_n, u_t;  // u = J / m_r: what the impulse does to w
    Vector<Real, C> u;             // on B
};

// Of u_t, after the penalty, (C5).
template <class Real, int C>
GRIT_INLINE Real friction_limit(const Law& law, const Shares<Real>& shares,
                                const Approach<Real, C>& x, const Response<Real, C>& r) {
    Real bearing = r.u_n;
    if (x.has_pores)
        bearing = max(r.u_n - x.pore_impulse / max(shares.m_r, Real(no_mass)), Real(0.0));
    const Real friction = Real(law.mu) * bearing;
    if (!law.adheres) return friction;
    return friction + r.f_p * Real(law.c_a_dt) * x.area / max(shares.m_r, Real(no_mass));
}

// Of a spring with a dashpot, implicit in w, (C9): u_n = (w_n + push) / (1 + yield).
template <class Real> struct Resistance { Real yield, push; };

template <class Real, int C>
GRIT_INLINE Resistance<Real> resistance(const Law& law, const Shares<Real>& shares,
                                        const Approach<Real, C>& x, const Real& f_p) {
    const Real free = Real(1.0) - f_p;
    // K dt^2 / m_r, and never so much that a product overflows.
    const Real stiff = min(Real(law.stiffness_dt2) * x.area / max(shares.m_r, Real(no_mass)),
                           Real(largest_number));
    const Real overlap = max(-x.gap, Real(0.0));
    const Real yield = free / max(fma(free, stiff, Real(law.part) * f_p), Real(no_mass));
    return {yield, yield * (stiff * (overlap * Real(law.inverse_dt)))};
}

template <class Real, int C>
GRIT_INLINE Response<Real, C> respond(const Law& law, const Shares<Real>& shares,
                                      const Approach<Real, C>& x) {
    const Real zero(0.0), one(1.0);
    Response<Real, C> r;
    r.w_n = fused_dot(x.w, x.n);
    r.f_p = one;
    r.u_n = r.w_n;
    r.touches = shares.active & (r.w_n > zero) & (x.gap <= Real(law.gap_tolerance));  // (C3)
    if (law.geo) {
        r.f_p = penalty_factor(x.s, x.cell, law.k);
        r.u_n = r.f_p * r.w_n;  // (C5)
        const MaskOf<Real> reaches = (x.s < x.cell.d) & (r.f_p > zero);
        r.touches = r.touches & reaches;
        if (law.springs) {
            const Resistance<Real> spring = resistance(law, shares, x, r.f_p);
            r.u_n = (r.w_n + spring.push) / (one + spring.yield);  // (C9)
            const MaskOf<Real> closed = x.gap <= Real(law.gap_tolerance);
            r.touches = shares.active & closed & reaches & (r.u_n > zero);
        }
    }
    const Vector<Real, C> w_t = fused_sum(-r.w_n, x.n, x.w);
    r.w_t = sqrt(fused_dot(w_t, w_t));
    const Real limit = friction_limit(law, shares, x, r);
    r.slips = r.touches & (limit < r.w_t);
    const Real part = select(r.slips, limit / max(r.w_t, Real(no_slip)), one);
    r.u_t = min(r.w_t, limit);
    for (int i = 0; i < C; ++i) r.u[i] = fma(part, w_t[i], r.u_n * x.n[i]);  // (C6)
    return r;
}

GRIT_KERNEL_END
