// SPDX-License-Identifier: BSD-3-Clause
// What the tests say about the parameters near the best ones, as far as residuals are linear there.
#pragma once

#include "element/calibration/problem.hpp"

namespace calibration {

// Of the weights of a combination: what is less is not spoken of.
inline constexpr double share_that_counts = 0.3;

// A combination of coordinates, each over the range of its bounds.
struct Combination {
    Vector weights;          // of unit length
    double singular = 0.0;   // of the weighed Jacobian
    double deviation = 0.0;  // standard deviation of the combination, as a share of the range
    bool determined = true;  // to less than what the bounds say already
};

struct Laplace {
    Matrix covariance, correlation;  // of the coordinates
    Vector deviation;
    double inflation =
        1.0;  // of the stated errors: sqrt(chi^2/degrees of freedom), where that exceeds 1
    double misfit = 0.0;  // chi^2/degrees of freedom
    bool overdetermined =
        true;  // by more independent readings than parameters: residuals tell of errors
    std::vector<Combination> combinations;  // the best determined first

    // Has one of the combinations that are not determined this coordinate in it?
    bool determines(Eigen::Index coordinate) const;
};

// From residuals and slopes as the loss weighs them. Bounds count as a normal distribution with the variance of the
// uniform one. inflate: where residuals are larger than their errors allow, errors are larger than stated.
Laplace laplace(const Problem& problem, const Residuals& residuals, bool inflate);

}  // namespace calibration
