// SPDX-License-Identifier: BSD-3-Clause
// A controlled step as functions of the share x = 0 ... 1 of it that is done.
#pragma once

#include <functional>

#include "element/simulate.hpp"

namespace element {

struct Path {
    Restrictions rows;
    std::function<Vector6(double)> change;  // c(x), zero at x = 0
    std::function<Vector6(double)> rate;    // dc/dx; at a knot, of the increment that ends there
    std::function<double(double)> time;     // since the step began
    std::vector<double> knots;              // ends of the increments, from 0
    bool straight = false;                  // c is proportional to x
};

// Of a step of any kind but DeformationGradient, Perturbations and Repetition. The stress of absolute
// rows is the total one in an undrained step.
Path path_of(const Step& step, const Sample& sample);

// Ends of the increments of a step of any kind, from 0 to 1.
std::vector<double> knots_of(const Step& step);

// Number of them.
int increments_of(const Step& step);

}  // namespace element
