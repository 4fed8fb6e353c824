// SPDX-License-Identifier: BSD-3-Clause
// The parameters with the least sum of rho(r^2): Levenberg-Marquardt within bounds, from several starts.
#pragma once

#include "element/calibration/loss.hpp"
#include "element/calibration/problem.hpp"

namespace calibration {

struct FitOptions {
    Loss loss;
    int starts = 5;       // the first is the one given, the others lie around it
    double spread = 0.3;  // +- of a value
    int iteration_limit = 200;
    // After each iteration: the starts that have come to their end. Returning false stops the fit.
    std::function<bool(int)> progress;
};

// What became of one start.
struct Descent {
    Vector start, end;
    double sum = 0.0;  // of rho(r^2) at the end
    int iterations = 0;
    bool converged = false;
    std::string message;
};

struct Fit {
    Vector x;
    double sum = 0.0;     // of rho(r^2)
    Residuals residuals;  // at x, with slopes, as the loss weighs them
    std::vector<Descent> descents;
    std::size_t best = 0;  // of descents
    int agreeing = 0;      // descents that end at the best sum
    bool stopped = false;  // by progress
};

// Throws element::BadCase if no start can be computed.
Fit fit(Problem& problem, const Vector& start, const FitOptions& options);

// Around x within the bounds, the same on every machine: start number i = 1, 2, ... of a Halton sequence.
Vector start_around(const ParameterSpace& space, const Vector& x, double spread, int i);

}  // namespace calibration
