// SPDX-License-Identifier: BSD-3-Clause
// Contact in a step: penalty forces before the momentum update, nodal corrections after it.
#include <algorithm>

#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

void Simulation::correct_contacts() {
    const auto side = [this](std::size_t i) {
        Part& part = parts[i];
        return ContactBody{part.records.data(), part.motions.data(), part.body.particles.view(),
                           part.body.particles.size(), part.body.rigid()};
    };
    for (ContactPair& pair : contacts) {
        const ContactLaw& law = pair.law();
        pair.correct(grid(), side(law.a), side(law.b), dt, exchange);
        const grit_contact_totals& totals = pair.totals();
        sums.contact += totals.dissipation_normal + totals.dissipation_tangential;
        for (const std::size_t i : {law.a, law.b}) {
            if (!parts[i].body.rigid()) continue;
            // What moves a rigid body works against the force that the body feels.
            const double* J = i == law.a ? totals.impulse_on_a : totals.impulse_on_b;
            const Vector v = parts[i].body.prescribed_velocity(t + dt);
            sums.rigid_work -= J[0] * v.r + J[1] * v.z;
        }
    }
}

PenaltyBody Simulation::penalty_body(std::size_t body, Into into) {
    Part& part = parts[body];
    return {into == Into::ahead ? part.ahead.data() : part.records.data(), part.motions.data(),
            part.least_mass, part.body.rigid(), part.body.name};
}

// False where nothing presses. A vertex reaches the nodes of its cell; particles with weight there are no
// farther than two rows from it, and one more from where they were sorted.
bool Simulation::find_pressed_strips() {
    for (Part& part : parts) std::fill(part.pressed.begin(), part.pressed.end(), 0);
    bool any = false;
    for (const PenaltyPair& pair : penalties)
        pair.each_pressed([&, this](double z) {
            any = true;
            const int row = z_axis.view().cell_of(z), last = parts[0].strips.count() - 1;
            for (int s = std::max(row - 4, 0) / Strips::rows;
                 s <= std::min((row + 4) / Strips::rows, last); ++s)
                for (const std::size_t body : {pair.law().a, pair.law().b})
                    parts[body].pressed[static_cast<std::size_t>(s)] = 1;
        });
    return any;
}

// At the end of a step, for the next one: what has just been touched is stiff already.
void Simulation::find_penalty_forces() {
    if (penalties.empty()) return;
    for (PenaltyPair& pair : penalties) pair.find_forces(dt_before);
    const bool any = find_pressed_strips(), first = step_count == 0;
    if (first)  // all vertices are looked at
        for (Part& part : parts) std::fill(part.pressed.begin(), part.pressed.end(), 1);
    if (any || first) {
        for (Part& part : parts) std::fill(part.ahead.begin(), part.ahead.end(), NodeRecord{});
        scatter(part::mass, Into::ahead);
    }
    for (PenaltyPair& pair : penalties) {
        const PenaltyBody a = penalty_body(pair.law().a, Into::ahead);
        const PenaltyBody b = penalty_body(pair.law().b, Into::ahead);
        if (first) pair.check_mass(grid(), a, b, PenaltyPair::Vertices::all);
        pair.find_step(grid(), a, b);
    }
}

void Simulation::push_contacts() {
    for (PenaltyPair& pair : penalties) {
        const PenaltyLaw& law = pair.law();
        pair.push(grid(), penalty_body(law.a, Into::records), penalty_body(law.b, Into::records));
        const grit_penalty_totals& totals = pair.totals();
        for (const std::size_t i : {law.a, law.b}) {
            if (!parts[i].body.rigid()) continue;
            const double* force = i == law.a ? totals.force_on_a : totals.force_on_b;
            const Vector v = parts[i].body.prescribed_velocity(t + dt);
            sums.rigid_work -= dt * (force[0] * v.r + force[1] * v.z);
        }
    }
}

void Simulation::move_contacts() {
    for (PenaltyPair& pair : penalties) {
        pair.move(grid(), penalty_body(pair.law().a, Into::records),
                  penalty_body(pair.law().b, Into::records), dt);
        sums.contact += pair.energy_taken();
    }
}

}  // namespace grit::mpm
