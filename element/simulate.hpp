// SPDX-License-Identifier: BSD-3-Clause
// Runs a program of steps on a sample.
#pragma once

#include "element/law.hpp"
#include "element/record.hpp"
#include "element/step.hpp"

namespace element {

// The material point and what the driver keeps beside it.
struct Sample {
    MaterialPoint point;
    Vector6 strain = Vector6::Zero();  // total
    double pore_pressure = 0.0;        // kept by the driver in undrained steps; excess [stress]
    double time = 0.0;
    double temperature = 0.0;
    Slopes slopes;  // where something is to be differentiated: start_slopes
};

struct Settings {
    // Newton's method stops where every row is met within tolerance: a row of stress relative to
    // the norm of the stress, a row of strain relative to the strain that this much stress makes.
    double tolerance = 1e-9;
    int iteration_limit = 25;     // 2 to 5 with a consistent tangent; more for laws without
    double smallest_part = 1e-6;  // of an increment, below which cutting back gives up
    bool keep_residuals = false;  // in every record
    bool record_start = true;
};

inline constexpr long run_limit = 1000000000;  // increments of a run

// Increments of a program, repetitions counted through.
long count_increments(const Program& program);
long count_steps(const Program& program);

// Throws BadCase before anything is computed if the program makes no sense, naming the step. A
// computation that cannot go on ends with history.failure; sample is then as far as it got.
History simulate(const Law& law, Sample& sample, const Program& program,
                 const Settings& settings = {}, const Listeners& listeners = {});

}  // namespace element
