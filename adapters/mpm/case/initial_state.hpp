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
// At rest below its water table, suction above; 0 without one. gravity: downwards [m/s2].
double pore_pressure_at(const WaterPlan& water, double gravity, double z);
// The void ratio that its conductivity is of, where that is not the same for all; else 0.
double conductivity_at(const BodyPlan& body);
// Once void ratios and stresses are there: masses of particles and pore pressures.
void fill_pores(const BodyPlan& body, double gravity, const PoreWater& water, Particles& particles);

// gravity: downwards [m/s2]. Throws std::invalid_argument naming the body, the place and the limit.
void set_initial_state(const BodyPlan& body, double gravity, Particles& particles);

}  // namespace grit::mpm
