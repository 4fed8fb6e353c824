// SPDX-License-Identifier: BSD-3-Clause
// Contact in a step: penalty forces before the momentum update, nodal corrections after it.
#include "adapters/mpm/simulation.hpp"

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

PenaltyBody Simulation::penalty_body(std::size_t body) {
    Part& part = parts[body];
    return {part.records.data(), part.motions.data(), part.least_mass, part.body.rigid()};
}

void Simulation::push_contacts() {
    for (PenaltyPair& pair : penalties) {
        const PenaltyLaw& law = pair.law();
        pair.push(grid(), penalty_body(law.a), penalty_body(law.b), dt_before);
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
        pair.move(grid(), penalty_body(pair.law().a), penalty_body(pair.law().b), dt);
        sums.contact += pair.energy_taken();
    }
}

}  // namespace grit::mpm
