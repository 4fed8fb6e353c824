// SPDX-License-Identifier: BSD-3-Clause
// Runs a case: one straight loading from an isotropic state.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "element/case.hpp"

namespace element {

struct Row {
    Vector6 stress;           // [kPa]
    Vector6 strain;           // logarithmic, since the start [-]
    Vector6 h;                // intergranular strain [-]
    double void_ratio = 0.0;  // e [-]
    grit_sand_invariants invariants{};
    int iterations = 0;   // of Newton's method, in this increment
    int evaluations = 0;  // of the stress rate, in this increment
};

struct Run {
    std::vector<Row> rows;  // the start and every increment that was reached
    std::string failure;    // empty, or why it stopped early
    int halvings = 0;       // increments that had to be cut
};

using Observer = std::function<void(int increment, int increments)>;

// Throws BadCase before anything is computed. An increment that fails is halved; where that no
// longer helps, the run ends with failure set and the rows so far.
Run run(const Case& test, const Observer& observer = {});

}  // namespace element
