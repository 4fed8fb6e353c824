// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/surface_contacts.hpp"

#include <stdexcept>

namespace grit::mpm {

void SurfaceContacts::add(const SurfaceLaw& law) {
    if (!model.is_alone())
        throw std::invalid_argument("surface contact is for one process: its edges are not cut");
    pairs.emplace_back(law, model.settings, model.grid(), model.shortest, model.fixed_nodes);
}

SurfaceBody SurfaceContacts::body(std::size_t i) {
    Part& part = model.parts[i];
    Body& of = part.body;
    const Vector2 velocity =
        of.rigid() ? of.prescribed_velocity(model.t + model.dt) : Vector2{0.0, 0.0};
    return {part.records.data(), part.motions.data(), of.particles.view(), of.particles.ids(),
            of.particles.size(), part.least_mass,     of.rigid(),          velocity};
}

void SurfaceContacts::correct(Energy& sums) {
    for (SurfacePair& pair : pairs) {
        const SurfaceLaw& law = pair.law();
        const SurfaceBody a = body(law.a), b = body(law.b);
        pair.correct(model.grid(), a, b, model.dt);
        const grit_surface_totals& totals = pair.totals();
        sums.contact += totals.dissipation_normal + totals.dissipation_tangential;
        // What moves a rigid body works against the force that the body feels.
        for (const auto& [of, J] :
             {std::pair{&a, totals.impulse_on_a}, std::pair{&b, totals.impulse_on_b}})
            if (of->rigid) sums.rigid_work -= J[0] * of->velocity[0] + J[1] * of->velocity[1];
    }
}

}  // namespace grit::mpm
