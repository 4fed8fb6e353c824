// SPDX-License-Identifier: BSD-3-Clause
// One explicit step of the stress along its course: Heun 2(1) for increments far below R, third order on averaged
// waypoints about R, Dormand & Prince 5(4) (1980, J. Comput. Appl. Math. 6:19) beyond.
#pragma once

#include "umat/integrate/averaged_course.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct Trial {
    Marched<Real> y;      // at the end of the step
    Marched<Real> rate;   // there
    PlainOf<Real> error;  // estimate for the stress, over its scale
    PlainOf<Real> order;  // of the error in the step; Dormand & Prince
};

// y + dq * sum of weight_i * rate_i
template <class Real, int count, class Member>
GRIT_INLINE Real advanced(const Marched<Real>& y, const Real& dq, const double (&weight)[count],
                          const Marched<Real>* rates, Member member) {
    Real total = weight[0] * member(rates[0]);
    for (int i = 1; i < count; ++i)
        if (weight[i] != 0.0) total = fma(weight[i], member(rates[i]), total);
    return fma(dq, total, member(y));
}

template <class Real, int count>
GRIT_INLINE Marched<Real> advanced(const Marched<Real>& y, const Real& dq,
                                   const double (&weight)[count], const Marched<Real>* rates) {
    Marched<Real> r;
    for (int i = 0; i < 6; ++i)
        r.T[i] = advanced(y, dq, weight, rates, [i](const auto& of) { return of.T[i]; });
    r.compression.x =
        advanced(y, dq, weight, rates, [](const auto& of) { return of.compression.x; });
    r.compression.expansion =
        advanced(y, dq, weight, rates, [](const auto& of) { return of.compression.expansion; });
    return r;
}

template <class Real> struct StepContext {
    const MaterialOf<Real>& m;
    const StraightPath<Real>& path;
    Real dq;   // of the course, over the step
    Real arc;  // length of the step
    PlainOf<Real> stress_scale;
};

// What a method's own quadrature of the arc length misses goes into the stress with the rate at the end of
// the step: most of that quadrature's error is then gone from the stress, near h = 0 above all.
template <class Real>
GRIT_INLINE void meet_end(const StepContext<Real>& c, const Real& own_arc, const Real& ds,
                          const Marched<Real>& rate, Marched<Real>& y) {
    const Real dq = (c.arc - own_arc) / ds;
    y.T = scaled_sum(dq, rate.T, y.T);
    y.compression.x = fma(dq, rate.compression.x, y.compression.x);
    y.compression.expansion = fma(dq, rate.compression.expansion, y.compression.expansion);
}

// Relative change of the stress at the larger of two rates per q, over the step: more than the net one where the stress
// turns back.
template <class Plain, class Real>
GRIT_INLINE Plain growth_of(const StepContext<Real>& c, const Plain& rate, const Plain& other) {
    return value(c.dq) * max(rate, other) / c.stress_scale;
}

template <class Plain>
GRIT_INLINE Waypoint<Plain> combined(const double (&weight)[3], const Waypoint<Plain>& a,
                                     const Waypoint<Plain>& b, const Waypoint<Plain>& c) {
    const auto sum = [&](const Plain& x, const Plain& y, const Plain& z) {
        return fma(weight[0], x, fma(weight[1], y, weight[2] * z));
    };
    return {sum(a.ds, b.ds, c.ds), a.e, sum(a.along, b.along, c.along),
            sum(a.across, b.across, c.across), sum(a.flow, b.flow, c.flow)};
}

// What a step misses that passes by the hydrostatic axis: F has the tip of a cone there (H5), a corner that the
// difference of two methods does not see. Over the stress scale; of second order in the step. From the stress at one
// end of the step and T_hat* at the other.
template <class Plain>
GRIT_INLINE Plain axis_error(const Tensor<Plain>& T, const Tensor<Plain>& other_dev,
                             const Plain& growth) {
    const Tensor<Plain> dev = deviator(T);
    const MaskOf<Plain> turns = contract(dev, other_dev) * trace(T) < Plain(0.0);
    if (!any(turns)) return Plain(0.0);
    const Tensor<Plain> from = scaled(dev, 1.0 / trace(T)), way = difference(other_dev, from);
    const Plain way_sq = square(way), along = contract(from, way);
    const Plain near_sq = max(square(from) - square(along) / way_sq, Plain(0.0));
    // A way that stays farther off than half its length meets no corner.
    const Plain corner = max(sqrt(way_sq) - 2.0 * sqrt(near_sq), Plain(0.0));
    return select(turns, axis_safety * growth * corner, Plain(0.0));
}

// The void ratios of a step, expanded to zero pressure, over e_d0.
template <class Plain> struct Looseness {
    Plain low, high;
    // Of the step on the way to e_d, where the slope of f_d is infinite: 0 far from there, 1 from there on.
    Plain nearing() const { return min((high - low) / max(high, Plain(1e-300)), Plain(1.0)); }
};

template <class Real>
GRIT_INLINE Looseness<PlainOf<Real>> looseness(const MaterialOf<Real>& m, const Marched<Real>& y,
                                               const Real& e, const Marched<Real>& end,
                                               const Real& end_e) {
    const auto one = value(e) * value(y.compression.expansion),
               other = value(end_e) * value(end.compression.expansion);
    return {min(one, other) - plain(m).e_d0, max(one, other) - plain(m).e_d0};
}

// What a step misses that comes to e_d, where f_d of (H7) has an infinite slope, cut off by its linear part: the difference
// of two methods does not see it. Over the stress scale.
template <class Plain>
GRIT_INLINE Plain density_error(const Material& m, const Looseness<Plain>& over_e_d,
                                const Plain& growth) {
    const Plain low = over_e_d.low, high = over_e_d.high, nearing = over_e_d.nearing();
    const Plain linear(linear_density / m.inverse_e_range);
    const MaskOf<Plain> near =
        (high > Plain(0.0)) & ((nearing > Plain(0.75)) | ((low < linear) & (high > linear)));
    if (!any(near)) return Plain(0.0);
    const Plain f_d = density_factor(m, max(high, Plain(0.0)) + m.e_d0);
    return select(near, density_safety * growth * f_d * nearing, Plain(0.0));
}

// The stress takes the mean of the rates per arc length at both ends: the stress changes the rate along the arc, and J
// may grow by several times over a step from near h = 0.
template <class Real, bool igs>
GRIT_INLINE Trial<Real> heun_step(const StepContext<Real>& c, const Segment<Real>& start,
                                  const Waypoint<Real>& end,
                                  const PlainOf<Real>& stiffness_change) {
    using Plain = PlainOf<Real>;
    constexpr double euler[] = {1.0};
    constexpr double half[] = {0.5, 0.5};
    const Real by_start = c.arc / start.at.ds, ratio = start.at.ds / end.ds;
    Marched<Real> k[2];
    k[0] = start.rate;
    k[1] = course_rate<Real, igs>(c.m, c.path, end, advanced(start.y, by_start, euler, k));
    for (int i = 0; i < 6; ++i) k[1].T[i] = ratio * k[1].T[i];
    Trial<Real> trial;
    trial.y = advanced(start.y, by_start, half, k);
    const Plain euler_error =
        0.5 * value(by_start) * norm(difference(value(k[1].T), value(k[0].T))) / c.stress_scale;
    // The difference to Euler's result is of second order; the error left is of third: smaller by
    // the relative change of the rate over the step. What of that h does not explain is the stress's doing,
    // which goes on for the whole path, while h has turned after a few R.
    const Plain first_order = value(by_start) * norm(value(k[0].T)) / c.stress_scale;
    const Plain of_rate = euler_error / max(first_order, Plain(1e-300));
    const Plain of_stress = max(of_rate - stiffness_change, Plain(0.0));
    const Looseness<Plain> over_e_d = looseness(c.m, start.y, start.e, trial.y, end.e);
    const Plain share =
        fma(heun_safety, stiffness_change + over_e_d.nearing(), heun_stress_safety * of_stress);
    trial.error = fma(euler_error, min(share, Plain(heun_safety)),
                      axis_error(value(trial.y.T), start.stiffness.shape.T_hat_dev, first_order) +
                          density_error(plain(c.m), over_e_d, first_order));
    return trial;
}

// Bogacki & Shampine (1989, Appl. Math. Lett. 2:321) without their last stage, on averaged waypoints.
template <class Real, bool igs, class Nodes>
GRIT_INLINE Trial<Real> third_order_step(const StepContext<Real>& c, const Segment<Real>& start,
                                         const AveragedCourse<Real, Nodes>& course,
                                         const PlainOf<Real>& stiffness_change) {
    using Plain = PlainOf<Real>;
    constexpr double a2[] = {1.0 / 2.0};
    constexpr double a3[] = {0.0, 3.0 / 4.0};
    constexpr double b[] = {2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0};
    constexpr double d[] = {2.0 / 9.0, -2.0 / 3.0, 4.0 / 9.0};  // less the midpoint rule
    const Waypoint<Real>* const at = course.at;
    const Marched<Real>& y = start.y;
    Marched<Real> k[3];
    k[0] = start.rate;
    k[1] = course_rate<Real, igs>(c.m, c.path, at[0], advanced(y, c.dq, a2, k));
    k[2] = course_rate<Real, igs>(c.m, c.path, at[1], advanced(y, c.dq, a3, k));
    Trial<Real> trial;
    trial.y = advanced(y, c.dq, b, k);
    trial.rate = k[2];
    // What the change of the stress makes of the increment is of second order.
    const auto unstressed = [&](const double(&weight)[3]) {
        return stress_rate<igs>(plain(c.m), value(c.path.D_hat), value(c.path.tau), start.stiffness,
                                combined(weight, value(start.at), value(at[0]), value(at[1])));
    };
    const Tensor<Plain> unchanged = unstressed(b);
    const Tensor<Plain> increment = difference(value(trial.y.T), value(y.T));
    const Plain coupling = norm(scaled_sum(-value(c.dq), unchanged, increment)) / c.stress_scale;
    const Plain growth = norm(increment) / c.stress_scale;
    const Looseness<Plain> over_e_d = looseness(c.m, y, start.e, trial.y, at[1].e);
    const Plain change = min(stiffness_change + growth + over_e_d.nearing(), Plain(1.0));
    // The embedded midpoint rule, less what is due to the waypoints.
    const Tensor<Plain> due = unstressed(d);
    Tensor<Plain> bend;
    for (int j = 0; j < 6; ++j)
        bend[j] =
            fma(d[0], value(k[0].T[j]), fma(d[1], value(k[1].T[j]), d[2] * value(k[2].T[j]))) -
            due[j];
    const Plain midpoint_error = value(c.dq) * norm(bend) / c.stress_scale;
    trial.error = max(third_order_safety * coupling * change, midpoint_safety * midpoint_error) +
                  roughness_safety * course.roughness *
                      growth_of<Plain>(c, norm(value(k[0].T)), norm(value(k[2].T))) +
                  axis_error(value(trial.y.T), start.stiffness.shape.T_hat_dev, growth) +
                  density_error(plain(c.m), over_e_d, growth);
    const Real own_mean = fma(b[0], start.at.ds, fma(b[1], at[0].ds, b[2] * at[1].ds));
    meet_end(c, c.dq * own_mean, at[1].ds, k[2], trial.y);
    return trial;
}

// Dormand & Prince 5(4) (1980, J. Comput. Appl. Math. 6:19) on averaged waypoints.
template <class Real, bool igs, class Nodes>
GRIT_INLINE Trial<Real> dormand_prince_step(const StepContext<Real>& c, const Marched<Real>& y,
                                            const Marched<Real>& k1, const Waypoint<Real>& start,
                                            const AveragedCourse<Real, Nodes>& course) {
    using Plain = PlainOf<Real>;
    constexpr double a2[] = {1.0 / 5.0};
    constexpr double a3[] = {3.0 / 40.0, 9.0 / 40.0};
    constexpr double a4[] = {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0};
    constexpr double a5[] = {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0};
    constexpr double a6[] = {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0,
                             -5103.0 / 18656.0};
    constexpr double b[] = {35.0 / 384.0,     0.0,        500.0 / 1113.0, 125.0 / 192.0,
                            -2187.0 / 6784.0, 11.0 / 84.0};
    constexpr double d[] = {71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                            -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
    const Waypoint<Real>* const at = course.at;
    Marched<Real> k[6];
    k[0] = k1;
    const auto rate = [&](int stage, const Marched<Real>& there) {
        return course_rate<Real, igs>(c.m, c.path, at[stage], there);
    };
    k[1] = rate(0, advanced(y, c.dq, a2, k));
    k[2] = rate(1, advanced(y, c.dq, a3, k));
    k[3] = rate(2, advanced(y, c.dq, a4, k));
    k[4] = rate(3, advanced(y, c.dq, a5, k));
    k[5] = rate(4, advanced(y, c.dq, a6, k));
    Trial<Real> trial;
    trial.y = marched(c.m, advanced(y, c.dq, b, k).T);
    const Stiffness<Real, Real> at_end = stiffness(c.m, trial.y, course.end.e);
    trial.rate = course_rate<Real, igs>(c.m, c.path, course.end, trial.y, at_end);

    // What the waypoints alone make of the stress is exact in both methods.
    const Tensor<Plain> k7 = stress_rate<igs>(plain(c.m), value(c.path.D_hat), value(c.path.tau),
                                              value(at_end), value(at[4]));
    Tensor<Plain> error;
    for (int j = 0; j < 6; ++j) {
        Plain total = fma(d[0], value(k[0].T[j]), d[6] * k7[j]);
        for (int i = 2; i < 6; ++i) total = fma(d[i], value(k[i].T[j]), total);
        error[j] = value(c.dq) * total;
    }
    // The difference to the embedded method is of fifth order in the step; the error left is of sixth: smaller by the
    // relative change of the rate over the step, of which the difference itself tells the fourth power.
    const Plain growth = growth_of<Plain>(c, norm(value(k1.T)), norm(value(trial.rate.T)));
    const Plain embedded = norm(error) / c.stress_scale;
    const Plain change = change_safety * sqrt(sqrt(embedded / max(growth, Plain(1e-300))));
    trial.error = fma(error_safety * min(change, Plain(1.0)), embedded,
                      roughness_safety * course.roughness * growth);
    trial.order = select(change < Plain(1.0), Plain(6.0), Plain(5.0));
    const Plain corner =
        axis_error(value(y.T), value(at_end.shape.T_hat_dev), growth) +
        density_error(plain(c.m), looseness(c.m, y, start.e, trial.y, course.end.e), growth);
    trial.order = select(corner > trial.error, Plain(2.0), trial.order);
    trial.error = trial.error + corner;
    // Stages 5 and 6 are at the same place.
    const Real own_mean =
        fma(b[0], start.ds,
            fma(b[2], at[1].ds, fma(b[3], at[2].ds, fma(b[4], at[3].ds, b[5] * at[4].ds))));
    meet_end(c, c.dq * own_mean, course.end.ds, trial.rate, trial.y);
    return trial;
}

GRIT_KERNEL_END
