// SPDX-License-Identifier: BSD-3-Clause
// Loads and motions over time.
#pragma once

#include <variant>
#include <vector>

namespace grit::mpm {

// Linear between its points, constant before the first and after the last. One point: constant.
struct TimeTable {
    std::vector<double> time;   // ascending [s]
    std::vector<double> value;  // as many
    double at(double t) const;
};

enum class PulseForm { half_sine, triangle };

// count equal pulses, one at the start of each interval.
struct PulseTrain {
    double peak = 0.0;
    PulseForm form = PulseForm::half_sine;
    double duration = 0.0;   // of a pulse [s]
    double peak_time = 0.0;  // of a triangle, since its begin [s]
    double interval = 0.0;   // from begin to begin, no shorter than a pulse [s]
    double start = 0.0;      // of the first one [s]
    int count = 1;
    double at(double t) const;
    // Number of the pulse that began last, from 1; 0 before the first.
    int blow(double t) const;
    // Intervals that are over.
    int over(double t) const;
};

using TimeFunction = std::variant<TimeTable, PulseTrain>;
double value_at(const TimeFunction& function, double t);

// The first multiple of an interval that is after t; t itself where numbers are no longer that fine.
double next_multiple(double interval, double t);

}  // namespace grit::mpm
