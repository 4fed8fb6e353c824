// SPDX-License-Identifier: BSD-3-Clause
// What an integration is asked, what it answers, and the constants that steer its steps.
#pragma once

#include "umat/integrate/arc_length.hpp"
#include "umat/model/stress_rate.hpp"

GRIT_KERNEL_BEGIN

// x^(1/order), to 0.3 %, for x in [1e-300, 1e300]: enough to choose a step.
template <class Plain, class Order> GRIT_INLINE Plain rough_root(Plain x, Order order) {
    const Plain octaves = split_exponent(x);
    const Plain t = x - 1.0;
    const Plain log2 = octaves + t * fma(t, fma(t, Plain(0.45), Plain(-0.7213)), Plain(1.4427));
    const Plain exponent = log2 * (1.0 / order);
    const Plain magic(0x1.8p52);
    const Plain whole = (exponent + magic) - magic;
    const Plain f = exponent - whole;
    const Plain power =
        fma(f, fma(f, fma(f, Plain(0.0555), Plain(0.2402)), Plain(0.6931)), Plain(1.0));
    return power * exp2_integer(whole);
}

struct Control {
    double tolerance;
    int evaluation_limit;
    double reach = rough_root(tolerance, 5.0);
    bool next_step_wanted = true;

    // Arc lengths are met to this share of them, and resolved near h = 0 to this panel.
    double tolerated_excess() const { return 0.1 * square(reach); }
    Panels panels(const Material& m) const {
        return {m, reach * reach * reach, tolerated_excess()};
    }
};

template <class Real> struct Integrated {
    Marched<Real> y;
    Real s;                  // arc length
    Mobilisation<Real> h;    // at the end ...
    OfMemory<Real> h_late;   // ... but for this arc length
    MaskOf<Real> failed;     // evaluation limit or step underflow
    MaskOf<Real> separated;  // p fell below the floor: stress-free from separation_at on
    MaskOf<Real> outside_cone;
    Real separation_at;      // arc length
    PlainOf<Real> progress;  // fraction of the path done (where it failed)
    PlainOf<Real> error, substeps, evaluations;
    PlainOf<Real> next_step;  // [strain]
};

// All but the functions of the pressure.
template <class Real> inline Integrated<PlainOf<Real>> value(const Integrated<Real>& x) {
    Integrated<PlainOf<Real>> r;
    r.y.T = value(x.y.T);
    r.s = value(x.s);
    r.h = value(x.h);
    r.h_late = value(x.h_late);
    r.failed = x.failed;
    r.separated = x.separated;
    r.outside_cone = x.outside_cone;
    r.separation_at = value(x.separation_at);
    r.progress = x.progress;
    r.error = x.error;
    r.substeps = x.substeps;
    r.evaluations = x.evaluations;
    r.next_step = x.next_step;
    return r;
}

// Constants of the step control, calibrated so that single calls deliver what was asked: see the
// table of docs/accuracy.md.
constexpr double error_safety = 10.0;   // of the embedded method's error ...
constexpr double change_safety = 60.0;  // ... times the change of the rate
constexpr double heun_safety = 1.5;     // of Euler's error times the change of the rate, by h ...
constexpr double heun_stress_safety = 5.0;   // ... and by the stress
constexpr double third_order_safety = 0.07;  // of what the stress makes of the increment
constexpr double midpoint_safety = 0.5;      // of a method of second order for one of third
// Of the change of the stress, times that of its ratio past the axis, and times f_d past e_d:
constexpr double axis_safety = 0.2, density_safety = 0.2;
constexpr double roughness_safety = 1.0;  // of what a quadrature might miss
constexpr double longest_averaged = 2.0;  // in R: beyond, waypoints are too rough as a rule
constexpr double resolution = 0.1;  // largest error of a falling stress, of what is left of it
constexpr double start_reach = 3.0;
constexpr double growth_reach = 0.7;  // longest step, in relative stress change / tolerance^(1/5)
constexpr double slowest_rate = 3.0;  // of relative stress change per strain that is told from none
constexpr double turning_share = 0.1;  // of the tolerance, for a turn of h by R
constexpr double turned_share = 0.25;  // of what a call is allowed, for its steps past a turn of h
constexpr double smallest_fraction = 1e-13;

// What the call may add to the error: the tolerance times the share of the stress it changes, so that errors
// over many small increments sum to what one large increment is allowed; or a share for h, which has turned after a few R
// however many calls that takes. rate: |dT/ds| over the stress scale; turning: the strain that moves h, over R.
template <class Plain>
GRIT_INLINE Plain allowed_error(const Control& control, const Plain& length, const Plain& rate,
                                const Plain& turning) {
    const Plain share = length * max(rate, Plain(slowest_rate));
    return control.tolerance * min(max(share, turning_share * turning), Plain(1.0));
}

GRIT_KERNEL_END
