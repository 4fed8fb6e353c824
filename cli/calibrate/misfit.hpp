// SPDX-License-Identifier: BSD-3-Clause
// How far a sand is from what was measured, by kind of test and quantity, and test by test.
#pragma once

#include <string>
#include <vector>

#include "element/calibration/experiment.hpp"

namespace cli {

struct Misfit {
    std::string kind, quantity, unit;  // quantity empty: all of the kind, each over its error
    bool fitted = true;
    int tests = 0, failed = 0;  // that cannot be computed with this sand
    double root_mean_square = 0.0;
    double relative = 0.0;  // each over the largest of its test
};

// Of one test: each reading over its error.
struct TestMisfit {
    double root_mean_square = 0.0;           // NaN: it cannot be computed with this sand
    double worst = 0.0;                      // of one quantity
    std::string quantity;                    // that it is
    double squares = 0.0, neighbours = 0.0;  // sums of r_i^2 and, along a quantity, of r_i r_(i+1)
};

struct Misfits {
    std::vector<Misfit>
        by_kind;  // and quantity, and whether they were fitted, in the order of the tests
    std::vector<TestMisfit> by_test;  // in their order
};

Misfits misfits(const std::vector<calibration::Experiment>& tests, const grit_sand_parameters& sand,
                int threads);

}  // namespace cli
