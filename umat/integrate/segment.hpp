// SPDX-License-Identifier: BSD-3-Clause
// Segments of a straight strain path: smooth pieces between the events of the intergranular strain. There
// are at most two: unloading until h:D_hat = 0, then loading.
#pragma once

#include "umat/integrate/step_control.hpp"

GRIT_KERNEL_BEGIN

// The start of a segment.
template <class Real> struct Segment {
    Course<Real> course;
    Real s, end;    // arc lengths
    Real e, e_end;  // void ratios there
    MaskOf<Real> last;
    Mobilisation<Real> h;
    Waypoint<Real> at;
    Marched<Real> y, rate;  // rate: per step of the course
    Stiffness<PlainOf<Real>, PlainOf<Real>> stiffness;
    PlainOf<Real> memory;                       // see memory_of; without h, 0
    PlainOf<Real> stress_scale, relative_rate;  // |rate of T| over the scale
};

// A point that carries stress opens below this pressure.
template <class M> GRIT_INLINE auto opening_pressure(const M& m) {
    return opening_per_floor * m.p_floor;
}

template <class Real, bool igs, class Stress>
GRIT_INLINE void start_stress(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                              const Tensor<Stress>& T, Segment<Real>& g) {
    if constexpr (igs) {
        g.h = mobilisation_at_start(m, g.course);
        g.at = waypoint(m, g.course.loading, g.h, g.e);
        g.memory = memory_of(g.h, g.course.loading);
    } else {
        g.h = no_mobilisation(g.e);
        g.at = basic_waypoint(m, g.e);
        g.memory = PlainOf<Real>(0.0);
    }
    const Marched<Stress> y = marched(m, T);
    const Stiffness<Stress, Real> k = stiffness(m, y, g.e);
    g.y = converted<Real>(y);
    g.rate = course_rate<Real, igs>(m, path, g.at, y, k);
    g.stiffness = value(k);
    using Plain = PlainOf<Real>;
    g.stress_scale = max(norm(value(T)), Plain(opening_pressure(plain(m))));
    g.relative_rate = norm(value(g.rate.T)) / g.stress_scale;
}

// Arc length where unloading turns to loading, h:D_hat = 0.
template <class Real>
GRIT_INLINE Real reversal_of(const MaterialOf<Real>& m, const StraightPath<Real>& path) {
    return -m.R * path.u_0;
}

template <class Real>
GRIT_INLINE MaskOf<Real> turns_on_the_way(const MaterialOf<Real>& m,
                                          const StraightPath<Real>& path) {
    return MaskOf<Real>((path.u_0 < Real(0.0)) & (reversal_of(m, path) < path.length));
}

template <class Real, bool igs, class Stress>
inline Segment<Real> first_segment(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                                   const Tensor<Stress>& T) {
    Segment<Real> g;
    const Real zero = path.length * 0.0;
    g.s = zero;
    g.end = path.length;
    g.e = path.e_0;
    g.e_end = path.e_end;
    g.last = MaskOf<Real>(true);
    if constexpr (!igs) {
        g.course = {MaskOf<Real>(false), {zero, zero, zero, zero}, zero, zero};
    } else {
        g.course = first_course(m, path);
        g.last = !turns_on_the_way(m, path);
        if (any(!g.last)) {
            const Real reversal = reversal_of(m, path);
            g.end = select(g.last, path.length, reversal);
            g.e_end = select(g.last, path.e_end, void_ratio(path, reversal));
        }
    }
    start_stress<Real, igs>(m, path, T, g);
    return g;
}

// Loading, from where the first segment ended.
template <class Real>
inline Segment<Real> second_segment(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                                    const Segment<Real>& first, const Tensor<Real>& T) {
    Segment<Real> g;
    const Real zero = path.length * 0.0;
    g.course = {MaskOf<Real>(true), loading_curve(m, zero, path.tau_sq), zero, path.tau_sq};
    g.s = first.end;
    g.end = path.length;
    g.e = first.e_end;
    g.e_end = path.e_end;
    g.last = MaskOf<Real>(true);
    start_stress<Real, true>(m, path, T, g);
    return g;
}

GRIT_KERNEL_END
