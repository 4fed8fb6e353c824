// SPDX-License-Identifier: BSD-3-Clause
// Saturated elastic sand that another body presses on, at nodes or at surfaces.
#pragma once

#include <optional>
#include <utility>

#include <adapters/mpm/run/measures.hpp>

#include "support/saturated_column.hpp"

namespace mpm_test {

inline ContactPlan contact_with(const std::string& stiff, const std::string& soft,
                                bool at_surfaces) {
    ContactPlan out;
    out.stiff = stiff;
    out.soft = soft;
    out.law = GRIT_CONTACT_FRICTIONAL;
    out.at_surfaces = at_surfaces;
    return out;
}

// A column under a rigid piston that no water passes; as it is given it sinks by 15 µm within 20 ms.
inline Case under_a_piston(const SaturatedColumn& column, bool at_surfaces = false,
                           const TimeTable& velocity = {{0.0, 0.005, 0.015, 0.02},
                                                        {0.0, -1e-3, -1e-3, 0.0}}) {
    Case plan = column.plan();
    BodyPlan piston{};
    piston.name = "piston";
    const double h = column.cell(), L = column.height;
    piston.outlines = {Outline{{{0.0, L}, {h, L}, {h, L + h}, {0.0, L + h}}}};
    piston.density = 1000.0;
    RigidPlan motion;
    motion.velocity_r = TimeTable{{0.0}, {0.0}};
    motion.velocity_z = velocity;
    piston.material = motion;
    plan.bodies.push_back(piston);
    plan.contacts = {contact_with("piston", "sand", at_surfaces)};
    plan.history.body = "piston";
    return plan;
}

// A Geo-contact of that power that nodes answer to wherever both bodies are.
inline void make_geo(ContactPlan& contact, double power) {
    contact.law = GRIT_CONTACT_GEO;
    contact.penalty_power = power;
    contact.gated = false;
}

// A block, dry or not, hits the top of a free column at 0.1 m/s. power: of a Geo-contact, 0.3 of a cell away from nodes; 0:
// frictional contact at nodes.
inline BuiltCase hit_by_a_block(const SaturatedColumn& column, bool at_surfaces = false,
                                const std::optional<WaterPlan>& in_block = {}, double power = 0.0) {
    Case plan = column.plan();
    const double h = column.cell(), L = column.height;
    plan.boundary[static_cast<int>(Side::bottom)] = Boundary::free;
    const double lower = (power > 0.0 ? -4.3 : -4.0) * h;
    plan.z = {lower, {{lower + 36 * h, 36, 1.0}}};
    BodyPlan block{};
    block.name = "block";
    block.outlines = {Outline{{{0.0, L}, {h, L}, {h, 1.5 * L}, {0.0, 1.5 * L}}}};
    block.density = 2000.0;
    block.material = ElasticPlan{1e8, 0.0};
    block.water = in_block;
    plan.bodies.push_back(block);
    plan.contacts = {contact_with("block", "sand", at_surfaces)};
    if (power > 0.0) make_geo(plan.contacts[0], power);
    BuiltCase built = build_case(plan);
    Body& falling = built.simulation->body(1);
    for (std::ptrdiff_t p = 0; p < falling.particles.size(); ++p)
        falling.particles.view()[column::v_z][p] = -0.1;
    return built;
}

// Of grains and water [N s].
inline double momentum_z(Simulation& simulation, std::size_t which) {
    Body& body = simulation.body(which);
    const ParticleView of = body.particles.view();
    double sum = 0.0;
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        sum += of[column::mass][p] * of[column::v_z][p];
        if (body.water && body.water->flows)
            sum += body.water->mass(of, p) *
                   (of[column::v_z][p] + of[body.water->velocity_column() + 1][p]);
    }
    return sum;
}

// A plate that presses on a block and then slides on it: K_w = E n, so that water carries half of what presses.
inline Case plate_on_a_block(std::optional<WaterPlan> water, bool at_surfaces = false) {
    constexpr double L = 1.0, E = 10e6, n = 0.4;
    Case plan;
    plan.name = "plate";
    plan.settings.axisymmetric = false;
    plan.r = {0.0, {{L, 8, 1.0}}};
    plan.z = {0.0, {{0.5 * L, 4, 1.0}, {0.75 * L, 2, 1.0}}};
    for (const Side side : {Side::left, Side::right, Side::bottom})
        plan.boundary[static_cast<int>(side)] = Boundary::roller;
    BodyPlan block{}, plate{};
    block.name = "block";
    block.outlines = {Outline{{{0.0, 0.0}, {L, 0.0}, {L, 0.5 * L}, {0.0, 0.5 * L}}}};
    block.density = 1590.0;
    block.material = ElasticPlan{E, 0.0};
    if (water) {
        water->bulk_modulus = E * n;
        water->porosity = n;
        water->grain_density = 2650.0;
        if (water->drainage == Drainage::undrained) block.density += n * water->density;
        block.water = water;
    }
    plate.name = "plate";
    plate.outlines = {Outline{{{0.0, 0.5 * L}, {L, 0.5 * L}, {L, 0.625 * L}, {0.0, 0.625 * L}}}};
    plate.density = 1000.0;
    RigidPlan motion;
    motion.velocity_r = TimeTable{{0.0, 0.05, 0.06}, {0.0, 0.0, 0.02}};
    motion.velocity_z = TimeTable{{0.0, 0.02, 0.04}, {0.0, -1e-2, 0.0}};
    plate.material = motion;
    plan.bodies = {block, plate};
    plan.contacts = {contact_with("plate", "block", at_surfaces)};
    plan.contacts[0].friction_coefficient = 0.3;
    plan.stages = {StagePlan{.name = "stage", .end = {.time = 1.0}}};
    plan.history.body = "plate";
    return plan;
}

// ... its mean force along its way once it slides [N].
inline double rubbing_force(const std::optional<WaterPlan>& water, bool at_surfaces = false) {
    BuiltCase built = build_case(plate_on_a_block(water, at_surfaces));
    Simulation& simulation = *built.simulation;
    double force = 0.0;
    int count = 0;
    while (simulation.time() < 0.12) {
        simulation.step();
        if (simulation.time() < 0.07) continue;
        const ContactForces forces = contact_forces(simulation, 1);
        force -= forces.tip[0] + forces.shaft[0];
        ++count;
    }
    return force / count;
}

}  // namespace mpm_test
