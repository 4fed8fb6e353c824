// SPDX-License-Identifier: BSD-3-Clause
// The rate that is integrated: stress along a straight strain path, (H1) and (G2) per step of its course.
#pragma once

#include "umat/model/hypoplastic_stiffness.hpp"
#include "umat/model/intergranular_strain.hpp"

GRIT_KERNEL_BEGIN

// A straight strain path from a state: everything that stays constant along it.
template <class Real> struct StraightPath {
    Tensor<Real> D_hat;  // unit direction of straining
    Tensor<Real> tau;    // part of h_0/R across D_hat
    Real length;         // |strain increment|
    Real tr_D;           // tr D_hat
    Real tau_sq;         // tau:tau
    Real u_0;            // h_0:D_hat/R
    Real e_0, e_end;     // void ratio at the start and at the end
};

template <class Real> inline StraightPath<PlainOf<Real>> value(const StraightPath<Real>& x) {
    return {value(x.D_hat),  value(x.tau), value(x.length), value(x.tr_D),
            value(x.tau_sq), value(x.u_0), value(x.e_0),    value(x.e_end)};
}

template <class Real> GRIT_INLINE Real void_ratio(const StraightPath<Real>& path, const Real& s) {
    return fma(1.0 + path.e_0, exp(s * path.tr_D), -1.0);  // (H9)
}

constexpr double along_the_strain = 1e-16;  // tau:tau up to which |tau| has no derivative

template <class Real>
GRIT_INLINE StraightPath<Real> straight_path(const MaterialOf<Real>& m,
                                             const Tensor<Real>& strain_increment,
                                             const Tensor<Real>& h, const Real& e) {
    StraightPath<Real> path;
    path.length = norm(strain_increment);
    path.D_hat = scaled(strain_increment, 1.0 / path.length);
    path.tr_D = trace(path.D_hat);
    const Tensor<Real> h_R = scaled(h, m.inverse_R);
    path.u_0 = contract(h_R, path.D_hat);
    path.tau = scaled_sum(-path.u_0, path.D_hat, h_R);
    path.tau_sq = square(path.tau);
    // Turned back as exactly as roundoff lets it, h passes 0 at the distance of what roundoff left across: slopes at 0
    // would be by that, without bound, though what they add up to vanishes with it.
    if constexpr (!std::is_same_v<Real, PlainOf<Real>>)
        path.tau_sq = select(value(path.tau_sq) <= PlainOf<Real>(along_the_strain),
                             Real(value(path.tau_sq)), path.tau_sq);
    path.e_0 = e;
    path.e_end = void_ratio(path, path.length);
    return path;
}

// How h goes on from the start of a path.
template <class Real>
GRIT_INLINE Course<Real> first_course(const MaterialOf<Real>& m, const StraightPath<Real>& path) {
    Course<Real> course{path.u_0 >= Real(0.0), {}, path.u_0, path.tau_sq};
    const Real zero = path.u_0 * 0.0;
    course.curve = {zero, zero, zero, zero};
    if (any(course.loading)) course.curve = loading_curve(m, max(path.u_0, Real(0.0)), path.tau_sq);
    return course;
}

// What the stress rate needs at a point of a course: nothing of it depends on the stress.
template <class Real> struct Waypoint {
    Real ds;             // per step of the course, R J; the rate is linear in this and ...
    Real e;              // void ratio
    Real along, across;  // L is applied to X = along D_hat + across tau ...
    Real flow;           // ... and N to this: M:D_hat ds = L:X + N flow     (G1), (G2)
};

template <class Real> GRIT_INLINE Waypoint<PlainOf<Real>> value(const Waypoint<Real>& w) {
    return {value(w.ds), value(w.e), value(w.along), value(w.across), value(w.flow)};
}

template <class Real>
GRIT_INLINE Waypoint<Real> select(const MaskOf<Real>& mask, const Waypoint<Real>& yes,
                                  const Waypoint<Real>& no) {
    return {select(mask, yes.ds, no.ds), select(mask, yes.e, no.e),
            select(mask, yes.along, no.along), select(mask, yes.across, no.across),
            select(mask, yes.flow, no.flow)};
}

template <class Real>
GRIT_INLINE Waypoint<Real> waypoint(const MaterialOf<Real>& m, const MaskOf<Real>& loading,
                                    const Mobilisation<Real>& h, const Real& e) {
    const Interpolation<Real> k = interpolation(m, h.rho, loading);
    const Real ds = m.R * h.J, B_c = ds * k.B * h.c;
    return {ds, e, fma(B_c, h.c, ds * k.A), B_c * h.across, ds * k.C * h.c};
}

// The basic model: L:D_hat + N     (H1)
template <class Real>
GRIT_INLINE Waypoint<Real> basic_waypoint(const MaterialOf<Real>& m, const Real& e) {
    const Real zero = e * 0.0, ds = zero + m.R;
    return {ds, e, ds, zero, ds};
}

// What is marched along a course. Functions of the pressure go with the stress: within a step they are
// integrated like it, without a logarithm or an exponential; at its ends they are computed from it.
template <class Real> struct Marched {
    Tensor<Real> T;
    Compression<Real> compression;
};

template <class Real>
GRIT_INLINE Marched<Real> marched(const MaterialOf<Real>& m, const Tensor<Real>& T) {
    return {T, compression(m, trace(T) * (-1.0 / 3.0))};
}

template <class Real, class Stress> GRIT_INLINE Marched<Real> converted(const Marched<Stress>& y) {
    return {{Real(y.T[0]), Real(y.T[1]), Real(y.T[2]), Real(y.T[3]), Real(y.T[4]), Real(y.T[5])},
            {Real(y.compression.x), Real(y.compression.expansion)}};
}

template <class Real>
GRIT_INLINE Marched<Real> select(const MaskOf<Real>& mask, const Marched<Real>& yes,
                                 const Marched<Real>& no) {
    return {select(mask, yes.T, no.T),
            {select(mask, yes.compression.x, no.compression.x),
             select(mask, yes.compression.expansion, no.compression.expansion)}};
}

// Of a stage that overshoots to no pressure; the step is rejected.
template <class Real> GRIT_INLINE Compression<Real> bounded(const Compression<Real>& k) {
    return {max(k.x, Real(1e-8)), max(k.expansion, Real(1.0))};
}

// L and N at a stress and a void ratio. Finite for every finite T: see stress_shape, scalar_factors.
template <class Stress, class Real> struct Stiffness {
    StressShape<Stress> shape;
    ScalarFactors<Real> f;
};

template <class Stress, class Real>
GRIT_INLINE Stiffness<PlainOf<Real>, PlainOf<Real>> value(const Stiffness<Stress, Real>& k) {
    return {{value(k.shape.T_hat), value(k.shape.T_hat_dev), value(k.shape.T_hat_sq),
             value(k.shape.F), value(k.shape.inverse_trace)},
            {value(k.f.f_d), value(k.f.f_s)}};
}

template <class Stress, class Real>
GRIT_INLINE Stiffness<Stress, Real> stiffness(const MaterialOf<Real>& m, const Marched<Stress>& y,
                                              const Real& e) {
    return {stress_shape(m, y.T),
            scalar_factors(m, trace(y.T) * (-1.0 / 3.0), bounded(y.compression), e)};
}

template <bool igs, class Stress, class Real>
GRIT_INLINE Tensor<Real> stress_rate(const MaterialOf<Real>& m, const Tensor<Real>& D_hat,
                                     const Tensor<Real>& tau, const Stiffness<Stress, Real>& k,
                                     const Waypoint<Real>& at) {
    Tensor<Real> X = scaled(D_hat, at.along);
    if constexpr (igs) X = scaled_sum(at.across, tau, X);
    return apply_stiffness(m, k.shape, k.f, X, at.flow);
}

// d/dq of what is marched.
// Stress: Real, or its plain number where the stress is given and has no derivatives.
template <class Real, bool igs, class Stress>
GRIT_INLINE Marched<Real> course_rate(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                                      const Waypoint<Real>& at, const Marched<Stress>& y,
                                      const Stiffness<Stress, Real>& k) {
    Marched<Real> rate;
    rate.T = stress_rate<igs>(m, path.D_hat, path.tau, k, at);
    const Compression<Stress> now = bounded(y.compression);
    rate.compression.x = now.x * (m.n * (trace(rate.T) * k.shape.inverse_trace));
    rate.compression.expansion = now.expansion * rate.compression.x;
    return rate;
}

template <class Real, bool igs, class Stress>
inline __attribute__((noinline)) Marched<Real>
course_rate(const MaterialOf<Real>& m, const StraightPath<Real>& path, const Waypoint<Real>& at,
            const Marched<Stress>& y) {
    return course_rate<Real, igs>(m, path, at, y, stiffness(m, y, at.e));
}

GRIT_KERNEL_END
