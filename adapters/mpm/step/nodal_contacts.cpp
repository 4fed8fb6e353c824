// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/nodal_contacts.hpp"

namespace grit::mpm {

ContactBody NodalContacts::body(std::size_t i) {
    Part& part = model.parts[i];
    return {part.records.data(), part.motions.data(), part.body.particles.view(),
            part.body.particles.size(), part.body.rigid()};
}

void NodalContacts::correct(Energy& sums) {
    for (ContactPair& pair : contacts) {
        const ContactLaw& law = pair.law();
        pair.correct(model.grid(), body(law.a), body(law.b), model.dt, model.exchange);
        const grit_contact_totals& totals = pair.totals();
        sums.contact += totals.dissipation_normal + totals.dissipation_tangential;
        for (const std::size_t i : {law.a, law.b}) {
            const Body& of = model.parts[i].body;
            if (!of.rigid()) continue;
            // What moves a rigid body works against the force that the body feels.
            const double* J = i == law.a ? totals.impulse_on_a : totals.impulse_on_b;
            const Vector2 v = of.prescribed_velocity(model.t + model.dt);
            sums.rigid_work -= J[0] * v[0] + J[1] * v[1];
        }
    }
}

}  // namespace grit::mpm
