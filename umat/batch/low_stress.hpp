// SPDX-License-Identifier: BSD-3-Clause
// Outside the model's domain: docs/adr/0002-low-stress.md.
//
// A point whose pressure falls below the floor p_f = 1e-8 h_s separates: it carries no stress, has no
// memory of deformation (h = 0), and w, the volumetric strain opened since, is remembered. Stress
// returns when, and only when, w has been closed again; it starts from the floor.
#pragma once

#include "umat/batch/point.hpp"
#include "umat/integrate/integrate.hpp"

GRIT_KERNEL_BEGIN

// A point ready to be integrated: stress shifted by p_t (H10), h and stress turned with Q.
template <class Real> struct PointOf {
    Tensor<Real> T, h, strain_increment;
    Real e, w;
    double advised_step;
    int flags;
    bool resting;      // zero increment
    bool separated;    // at the start
    bool stress_free;  // over the whole increment
};

using Point = PointOf<double>;

inline Point prepare_point(const grit_sand_options& options, const RawPoint& raw) {
    Point p;
    p.T = stress_from_voigt(raw.stress);
    p.h = strain_from_voigt(raw.state);
    p.strain_increment = strain_from_voigt(raw.strain);
    p.e = raw.state[GRIT_SAND_VOID_RATIO];
    p.w = raw.state[GRIT_SAND_SEPARATION];
    p.advised_step = max(raw.substep, 0.0);
    p.flags = 0;
    if (raw.rotates) {
        p.h = rotated(raw.Q, p.h);
        if (!options.stress_is_rotated) p.T = rotated(raw.Q, p.T);
    }
    double largest = 0.0;
    for (double component : p.strain_increment.c) largest = max(largest, fabs(component));
    p.resting = largest < smallest_increment;
    p.stress_free = p.separated = false;
    return p;
}

// h scaled back to R where it is longer; whether it was.
template <class Real> inline bool back_to_R(const MaterialOf<Real>& m, Tensor<Real>& h) {
    const Real length = norm(h);
    if (!(length > m.R * (1.0 + 1e-6))) return false;
    h = scaled(h, m.R / length);
    return true;
}

// Keep h within R, the stress within the cone; find out whether the point carries stress at all.
template <class Real>
inline void enter_domain(const MaterialOf<Real>& m, bool igs, PointOf<Real>& p) {
    if (igs && back_to_R(m, p.h)) p.flags |= GRIT_SAND_H_CLAMPED;
    for (int i = 0; i < 3; ++i) p.T[i] = p.T[i] - m.p_t;  // (H10)
    const double pressure = trace(value(p.T)) * (-1.0 / 3.0);
    p.separated = value(p.w) > 0.0 || !(pressure >= plain(m).p_floor);
    if (p.resting) return;
    if (!p.separated) {
        if (back_into_cone(p.T, true)) p.flags |= GRIT_SAND_OUTSIDE_CONE;
        return;
    }
    const double opened = trace(value(p.strain_increment));
    // Still apart at the end; or no compression beyond the roundoff of an isochoric increment.
    const double noise = 1e-12 * norm(value(p.strain_increment));
    p.stress_free = value(p.w) + opened > -noise;
}

// Where a point starts to carry stress: the whole path, or what is left of it after closing w.
template <class Real, class State> struct Start {
    Tensor<State> T;
    Tensor<Real> h, strain_increment;
    Real e;
};

template <class Real, class State>
inline Start<Real, State> start_of(const MaterialOf<Real>& m, const PointOf<State>& p,
                                   const Tensor<Real>& strain_increment) {
    Start<Real, State> start;
    start.T = p.T;
    for (int i = 0; i < 6; ++i) start.h[i] = Real(p.h[i]);
    start.strain_increment = strain_increment;
    start.e = Real(p.e);
    if (p.separated) {
        const Real tr = trace(strain_increment);
        const Real closing = p.w / -tr;  // fraction of the increment
        start.strain_increment = scaled(strain_increment, 1.0 - closing);
        start.e = fma(1.0 + start.e, exp(closing * tr), Real(-1.0));
        start.T = isotropic(-max(m.p_floor, m.p_t));
        start.h = scaled(strain_increment, m.R / norm(strain_increment));
    }
    return start;
}

GRIT_KERNEL_END
