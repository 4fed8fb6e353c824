// SPDX-License-Identifier: BSD-3-Clause
// Stress, void ratio and intergranular strain that particles start with.
#pragma once

#include <memory>

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// Null for a rigid body. Throws std::invalid_argument naming the body.
std::unique_ptr<Material> make_material(const BodyPlan& body);

// gravity: downwards [m/s2]. Throws std::invalid_argument naming the body, the place and the limit.
void set_initial_state(const BodyPlan& body, double gravity, Particles& particles);

}  // namespace grit::mpm
