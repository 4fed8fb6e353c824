// SPDX-License-Identifier: BSD-3-Clause
// One explicit step of the marched variables: Heun 2(1) for increments far below R, Dormand & Prince
// 5(4) (1980, J. Comput. Appl. Math. 6:19) beyond.
#pragma once

#include "umat/stress_rate.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct Trial {
    Marched<Real> y;      // at the end of the step
    Marched<Real> rate;   // there, if the method evaluated it (first same as last)
    PlainOf<Real> error;  // estimate for the stress, over its scale
};

// y + ds * sum of weight_i * rate_i
template <class Real, int count>
GRIT_INLINE Marched<Real> advanced(const Marched<Real>& y, const Real& ds,
                                   const double (&weight)[count], const Marched<Real>* rates) {
    const auto sum = [&](auto member) {
        Real total = weight[0] * member(rates[0]);
        for (int i = 1; i < count; ++i)
            if (weight[i] != 0.0) total = fma(weight[i], member(rates[i]), total);
        return fma(ds, total, member(y));
    };
    Marched<Real> r;
    for (int k = 0; k < 6; ++k) r.T[k] = sum([k](const Marched<Real>& x) { return x.T[k]; });
    r.P = sum([](const Marched<Real>& x) { return x.P; });
    r.G = sum([](const Marched<Real>& x) { return x.G; });
    return r;
}

template <class Real> struct StepContext {
    const Material& m;
    const StraightPath<Real>& path;
    Real s;  // arc length at the start of the step
    Real ds;
    MaskOf<Real> loading;
    PlainOf<Real> stress_scale;
    PlainOf<Real> memory_weight;  // stress error per error of h/R
};

template <class Plain> struct StepError {
    Plain stress;  // |dT| / scale
    Plain memory;  // |dh| / R: (1 - u) dP along D_hat, g |tau| dG across
};

template <class Real>
GRIT_INLINE StepError<PlainOf<Real>> step_error(const StepContext<Real>& c, const Marched<Real>& y,
                                                const Tensor<PlainOf<Real>>& dT,
                                                const PlainOf<Real>& dP, const PlainOf<Real>& dG) {
    using Plain = PlainOf<Real>;
    const Plain along = exp(-value(y.P)) * fabs(dP);
    const Plain across = exp(-value(y.G)) * sqrt(value(c.path.tau_sq)) * fabs(dG);
    return {norm(dT) / c.stress_scale, max(along, across)};
}

template <class Real, bool igs>
GRIT_INLINE Trial<Real> heun_step(const StepContext<Real>& c, const Marched<Real>& y,
                                  const Marched<Real>& k1, const PlainOf<Real>& stiffness_change) {
    using Plain = PlainOf<Real>;
    constexpr double euler[] = {1.0};
    constexpr double half[] = {0.5, 0.5};
    Marched<Real> k[2] = {k1, {}};
    const Marched<Real> predicted = advanced(y, c.ds, euler, k);
    k[1] = marched_rate<Real, igs>(c.m, c.path, c.s + c.ds, predicted, c.loading);
    Trial<Real> trial;
    trial.y = advanced(y, c.ds, half, k);
    const Plain half_ds = 0.5 * value(c.ds);
    const Tensor<Plain> dT = scaled(difference(value(k[1].T), value(k[0].T)), half_ds);
    const StepError<Plain> euler_error =
        step_error(c, trial.y, dT, half_ds * (value(k[1].P) - value(k[0].P)),
                   half_ds * (value(k[1].G) - value(k[0].G)));
    // The difference to Euler's result is of second order; the error left is of third: smaller by
    // the relative change of the rate over the step.
    const Plain first_order = value(c.ds) * norm(value(k[0].T)) / c.stress_scale;
    const Plain change = stiffness_change + euler_error.stress / max(first_order, Plain(1e-300));
    trial.error = euler_error.stress * min(change, Plain(1.0)) +
                  c.memory_weight * euler_error.memory * min(stiffness_change, Plain(1.0));
    trial.rate = k[1];
    return trial;
}

template <class Real, bool igs>
GRIT_INLINE Trial<Real> dormand_prince_step(const StepContext<Real>& c, const Marched<Real>& y,
                                            const Marched<Real>& k1) {
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
    Marched<Real> k[7];
    k[0] = k1;
    const auto rate = [&](double at, const Marched<Real>& stage) {
        return marched_rate<Real, igs>(c.m, c.path, fma(at, c.ds, c.s), stage, c.loading);
    };
    k[1] = rate(1.0 / 5.0, advanced(y, c.ds, a2, k));
    k[2] = rate(3.0 / 10.0, advanced(y, c.ds, a3, k));
    k[3] = rate(4.0 / 5.0, advanced(y, c.ds, a4, k));
    k[4] = rate(8.0 / 9.0, advanced(y, c.ds, a5, k));
    k[5] = rate(1.0, advanced(y, c.ds, a6, k));
    Trial<Real> trial;
    trial.y = advanced(y, c.ds, b, k);
    k[6] = rate(1.0, trial.y);
    trial.rate = k[6];

    const auto difference_of = [&](auto member) {
        Plain total = d[0] * value(member(k[0]));
        for (int i = 1; i < 7; ++i)
            if (d[i] != 0.0) total = fma(d[i], value(member(k[i])), total);
        return value(c.ds) * total;
    };
    Tensor<Plain> dT;
    for (int i = 0; i < 6; ++i)
        dT[i] = difference_of([i](const Marched<Real>& x) { return x.T[i]; });
    const StepError<Plain> error =
        step_error(c, trial.y, dT, difference_of([](const auto& x) { return x.P; }),
                   difference_of([](const auto& x) { return x.G; }));
    trial.error = max(error.stress, c.memory_weight * error.memory);
    return trial;
}

GRIT_KERNEL_END
