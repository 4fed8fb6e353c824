// SPDX-License-Identifier: BSD-3-Clause
// The arc length that a course of the intergranular strain takes, ds = R J dq, and back.
#pragma once

#include "umat/integrate/course_lanes.hpp"

GRIT_KERNEL_BEGIN

// Gauss & Legendre, four points: order 8, above that of the integration.
constexpr int gauss_points = 4;
constexpr double gauss_x[] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                              0.93056815579702629};
constexpr double gauss_w[] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                              0.17392742256872693};

// Mean of J over [q, q + dq].
template <class Real>
GRIT_INLINE Real mean_J_one_by_one(const MaterialOf<Real>& m, const Course<Real>& course,
                                   const Real& q, const Real& dq) {
    Real sum = gauss_w[0] * mobilisation(m, course, fma(Real(gauss_x[0]), dq, q)).J;
    for (int i = 1; i < gauss_points; ++i)
        sum = fma(Real(gauss_w[i]), mobilisation(m, course, fma(Real(gauss_x[i]), dq, q)).J, sum);
    return sum;
}

// The places of one point at once, with the bits of those one by one.
template <class Real>
GRIT_INLINE Real mean_J_in_lanes(const MaterialOf<Real>& m, const Course<Real>& course,
                                 const Real& q, const Real& dq) {
    using Places = Pack<gauss_points>;
    const auto all = [](const Real& x) { return in_lanes<gauss_points>(x); };
    const Places x = Places::each([](int i) { return gauss_x[i]; });
    const auto J =
        mobilisation(m, course_in_lanes<gauss_points>(course), fma(x, all(dq), all(q))).J;
    Real sum = gauss_w[0] * of_lane(J, 0);
    for (int i = 1; i < gauss_points; ++i) sum = fma(gauss_w[i], of_lane(J, i), sum);
    return sum;
}

template <class Real>
GRIT_INLINE Real mean_J(const MaterialOf<Real>& m, const Course<Real>& course, const Real& q,
                        const Real& dq) {
    if constexpr (takes_lanes<Real>) return mean_J_in_lanes(m, course, q, dq);
    else return mean_J_one_by_one(m, course, q, dq);
}

// Near h = 0, J changes as rho^beta_r: panels that shrink towards the start of the step, down to the finest length, or
// until one more changes the arc length by no more than a share. Where beta_r is small no length is short: J changes
// by as much in every octave.
struct Panels {
    double finest, settled;

    Panels(const Material& m, double longest_smooth, double tolerated_share)
        : finest(m.beta_r < 0.25 ? 0.0 : longest_smooth),
          settled(m.beta_r < 0.25 ? 0.1 * tolerated_share : 0.0) {}

    template <class Plain> MaskOf<Plain> needed(const Plain& rho, const Plain& size) const {
        return (rho < 0.25 * size) & (size > Plain(finest));
    }
};

constexpr int most_panels = 60;  // 4^-60

template <class Real>
GRIT_INLINE Real arc_length(const MaterialOf<Real>& m, const Course<Real>& course, const Real& q,
                            const Real& dq, const PlainOf<Real>& rho, const Panels& panels) {
    using Plain = PlainOf<Real>;
    Real panel = dq, coarse = dq * mean_J(m, course, q, dq), length = coarse;
    MaskOf<Real> open = course.loading;
    for (int i = 0; i < most_panels; ++i) {
        const MaskOf<Real> sharp = open & panels.needed<Plain>(rho, value(panel));
        if (!any(sharp)) break;
        const Real first = 0.25 * panel;
        const Real rest = panel - first;
        const Real near = first * mean_J(m, course, q, first);
        const Real fine = fma(rest, mean_J(m, course, q + first, rest), near);
        const Real change = fine - coarse;
        length = select(sharp, length + change, length);
        open = sharp & (fabs(value(change)) > panels.settled * value(length));
        panel = first;
        coarse = near;
    }
    return m.R * select(course.loading, length, dq);
}

// dq for an arc length ds, to second order.
template <class Real>
GRIT_INLINE Real predicted_course(const MaterialOf<Real>& m, const Real& J, const Real& J_growth,
                                  const Real& ds) {
    const Real straight = m.inverse_R * ds;
    const Real first = straight / J;
    const Real bend = max(fma(2.0 * J_growth, first, Real(1.0)), Real(0.1));
    // From near h = 0, where J is next to nothing, it takes some 1/beta_r to get away.
    return min(2.0 * first / (1.0 + sqrt(bend)), fma(3.0, straight, Real(10.0 / m.beta_r)));
}

GRIT_KERNEL_END
