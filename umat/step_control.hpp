// SPDX-License-Identifier: BSD-3-Clause
// What an integration is asked, what it answers, and the constants that steer its steps.
#pragma once

#include "umat/stress_rate.hpp"

GRIT_KERNEL_BEGIN

struct Control {
    double tolerance;
    int evaluation_limit;
};

template <class Real> struct Integrated {
    Marched<Real> y;
    InPlane<Real> h;         // at the end
    MaskOf<Real> failed;     // evaluation limit or step underflow
    MaskOf<Real> separated;  // p fell below the floor: stress-free from separation_at on
    MaskOf<Real> outside_cone;
    Real separation_at;      // arc length
    PlainOf<Real> progress;  // fraction of the path done (where it failed)
    PlainOf<Real> error, substeps, evaluations, next_step;
};

// Constants of the step control, calibrated so that single calls deliver what was asked: see the
// table of docs/accuracy.md.
constexpr double error_safety = 14.0;  // embedded estimates are optimistic where h changes
constexpr double heun_safety = 0.5;    // ... and pessimistic for steps far below R
constexpr double memory_reach = 2.2;   // longest step while h changes, in R tolerance^(1/5)
constexpr double growth_reach = 1.0;   // longest step, in relative stress change / tolerance^(1/5)
constexpr double memory_price = 5.0;   // stress error per error of h, in |stress rate| R
constexpr double slowest_rate =
    10.0;  // of relative stress change per strain that is told from none
constexpr double smallest_fraction = 1e-13;

GRIT_KERNEL_END
