// SPDX-License-Identifier: BSD-3-Clause
// From a case in space to a simulation that is ready for its first step.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "adapters/mpm/case/since.hpp"
#include "adapters/mpm/space/step/simulation.hpp"

namespace grit::mpm::space {

// Throws std::invalid_argument naming body, traction or contact and the limit, or what is not there in space.
std::unique_ptr<Simulation> build(const Case& plan, const std::shared_ptr<Clock>& clock);

// The parts of build that need no shapes, for hosts with particles of their own. Null: a rigid body.
std::unique_ptr<Material> material_of(const BodyPlan& body);
// Of its material; none: the body is dry.
std::optional<PoreWater> water_of(const BodyPlan& body, const Material* material);
RigidCourse course_of(const Case& plan, std::size_t body, const std::shared_ptr<Clock>& clock);
std::function<Vector3(double)> face_stress(const Case& plan, std::size_t traction,
                                           const std::shared_ptr<Clock>& clock);
// Fixed nodes are known to a contact when it is made: after these.
void hold_sides(const Case& plan, Simulation& simulation);
void add_contacts(const Case& plan, Simulation& simulation);
// A plane of symmetry halves what lies at it: it cannot move across, nor turn about what lies within the plane. Of a rigid
// body; exchange: of processes that have some of its particles, or null. Throws std::invalid_argument.
void check_free_at_sides(const Case& plan, std::size_t number, const Body& body,
                         Exchange* exchange);

// The stage's gravity, damping, PIC rate and CFL from now on.
void apply_stage(const Case& plan, const StagePlan& stage, Simulation& simulation);

}  // namespace grit::mpm::space
