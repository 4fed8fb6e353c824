// SPDX-License-Identifier: BSD-3-Clause
// Stress, void ratio and intergranular strain that particles start with.
#pragma once

#include <memory>

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// Null for a rigid body. Throws std::invalid_argument naming the body.
std::unique_ptr<Material> make_material(const BodyPlan& body);

// Of a body that has it; its columns follow those of the material.
PoreWater make_water(const BodyPlan& body, const Material& material);
// Once void ratios and stresses are there: masses of particles and pore pressures.
void fill_pores(const BodyPlan& body, double gravity, const PoreWater& water, Particles& particles);

// gravity: downwards [m/s2]. Throws std::invalid_argument naming the body, the place and the limit.
void set_initial_state(const BodyPlan& body, double gravity, Particles& particles);

}  // namespace grit::mpm
