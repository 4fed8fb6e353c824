// SPDX-License-Identifier: BSD-3-Clause
// Stress, void ratio and intergranular strain that particles start with.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// Null for a rigid body. Throws std::invalid_argument naming the body.
std::unique_ptr<Material> make_material(const BodyPlan& body);

// In the plane and in space. All throw std::invalid_argument naming the body.
grit_sand prepared_sand(const BodyPlan& body, const SandPlan& plan);
void check_stress_at_rest(const BodyPlan& body);
// Effective stress of a body that has one at rest.
class StressAtRest {
  public:
    // body: outlives this; gravity: downwards [m/s2]; levels: of its particles [m].
    StressAtRest(const BodyPlan& body, double gravity, std::span<const double> levels);
    ~StressAtRest();
    StressAtRest(const StressAtRest&) = delete;
    StressAtRest& operator=(const StressAtRest&) = delete;
    // [6] in the order of the library, at a level [m]; vertical: axis, from 0.
    void find(double z, int vertical, double* stress) const;

  private:
    class EffectiveWeight;
    double depth(double z) const;

    const BodyPlan& body;
    double unit_weight;
    std::optional<grit_sand> sand;               // of a body of sand
    std::unique_ptr<EffectiveWeight> effective;  // of a body with water
};
// [GRIT_SAND_STATE_SIZE] of a particle under this mean pressure, at this level [m].
void find_start(const BodyPlan& body, const SandPlan& plan, const grit_sand& sand, double pressure,
                double z, double* state);

// Of a body that has it; its columns follow those of the material. first_column: of these, separation: that of the material.
PoreWater make_water(const BodyPlan& body, const Material& material);
PoreWater make_water(const BodyPlan& body, int first_column, const Separation& separation);
// At rest below its water table, suction above; 0 without one. gravity: downwards [m/s2].
double pore_pressure_at(const WaterPlan& water, double gravity, double z);
// The void ratio that its conductivity is of, where that is not the same for all; else 0.
double conductivity_at(const BodyPlan& body);
// Of a particle with this void ratio at this level [m], whose pores are full: the density that it begins with, of grains and of
// water that moves with them, and the pore pressure.
struct FullPores {
    double density, pressure;
};
FullPores full_pores(const BodyPlan& body, double gravity, double e, double z);
// Once void ratios and stresses are there: masses of particles and pore pressures.
void fill_pores(const BodyPlan& body, double gravity, const PoreWater& water, Particles& particles);

// gravity: downwards [m/s2]. Throws std::invalid_argument naming the body, the place and the limit.
void set_initial_state(const BodyPlan& body, double gravity, Particles& particles);

}  // namespace grit::mpm
