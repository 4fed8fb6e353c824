// SPDX-License-Identifier: BSD-3-Clause
// The 320 states x 5 increments of verification/data/speed_states.csv: Lausitz sand, kPa, single
// calls with their exact results (integrated to 1e-13).
#pragma once

#include <map>
#include <vector>

#include <grit/grit.h>

namespace benchmarks {

struct Call {
    double stress[6], state[8], strain[6], stress_end[6], h_end[6], e_end;
};

// By increment. Throws std::runtime_error where the file is missing or empty.
const std::map<double, std::vector<Call>>& all_calls();

// Of the increment next to this one.
const std::vector<Call>& calls_of(double increment);

grit_sand lausitz();

// |stress - exact| / |exact|
double stress_error(const Call& call, const double stress[6]);
// |h - exact| / R
double intergranular_error(const Call& call, const double h[6]);

// q in [0, 1]; NaN of nothing.
double percentile(std::vector<double> x, double q);

// What became of a call.
struct Outcome {
    bool failed;
    double error, evaluations;  // evaluations: NaN if nobody tells
};

}  // namespace benchmarks
