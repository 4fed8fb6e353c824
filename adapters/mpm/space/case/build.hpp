// SPDX-License-Identifier: BSD-3-Clause
// From a case in space to a simulation that is ready for its first step.
#pragma once

#include <memory>

#include "adapters/mpm/case/since.hpp"
#include "adapters/mpm/space/step/simulation.hpp"

namespace grit::mpm::space {

// Throws std::invalid_argument naming body, traction or contact and the limit, or what is not there in space.
std::unique_ptr<Simulation> build(const Case& plan, const std::shared_ptr<Clock>& clock);

// The stage's gravity, damping, PIC rate and CFL from now on.
void apply_stage(const Case& plan, const StagePlan& stage, Simulation& simulation);

}  // namespace grit::mpm::space
