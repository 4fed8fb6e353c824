// SPDX-License-Identifier: BSD-3-Clause
// From a case to a simulation that is ready for its first step.
#pragma once

#include <functional>
#include <memory>

#include "adapters/mpm/case/since.hpp"
#include "adapters/mpm/space/step/simulation.hpp"
#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

struct BuiltCase {
    std::shared_ptr<Clock> clock;
    std::unique_ptr<Simulation> simulation;         // in the plane ...
    std::unique_ptr<space::Simulation> space = {};  // ... or in space; the other one is null
};

// Throws std::invalid_argument naming body, traction or contact and the limit.
BuiltCase build_case(const Case& plan);

// The parts of build_case that need no outlines, for hosts with particles of their own.
std::function<Vector2(double)> rigid_velocity(const Case& plan, const BodyPlan& body,
                                              const std::shared_ptr<Clock>& clock);
std::function<Vector2(double)> edge_stress(const Case& plan, const TractionPlan& traction,
                                           const std::shared_ptr<Clock>& clock);
// What a surface contact has between the surfaces, (V8), and when its sweeps end.
void set_surface_options(const ContactPlan& contact, double shortest_cell,
                         grit_surface_options& options);
// Of a contact at nodes.
ContactLaw nodal_law(const Case& plan, const ContactPlan& contact, double shortest_cell);
// Fixed nodes are known to a contact when it is made: after these.
void add_boundary(const Case& plan, Simulation& simulation);
void add_contacts(const Case& plan, Simulation& simulation);

// The stage's gravity, damping, PIC rate and CFL from now on.
void apply_stage(const Case& plan, const StagePlan& stage, Simulation& simulation);

}  // namespace grit::mpm
