// SPDX-License-Identifier: BSD-3-Clause
// From a case to a simulation that is ready for its first step.
#pragma once

#include <memory>

#include "adapters/mpm/case.hpp"
#include "adapters/mpm/simulation.hpp"

namespace grit::mpm {

// When stages began [s]; infinite: not yet. Loads and motions that start with a stage look here.
struct Clock {
    std::vector<double> began;
};

struct BuiltCase {
    std::shared_ptr<Clock> clock;
    std::unique_ptr<Simulation> simulation;
};

// Throws std::invalid_argument naming body, traction or contact and the limit.
BuiltCase build_case(const Case& plan);

// The stage's gravity, damping, PIC rate and CFL from now on.
void apply_stage(const Case& plan, const StagePlan& stage, Simulation& simulation);

}  // namespace grit::mpm
