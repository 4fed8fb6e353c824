// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/nodal_contacts.hpp"

namespace grit::mpm {

ContactBody NodalContacts::body(std::size_t i) {
    Part& part = model.parts[i];
    return {part.records.data(),        water.flows(i) ? water.met_motions(i) : part.motions.data(),
            part.body.particles.view(), part.body.particles.size(),
            part.body.rigid(),          water.flows(i) ? water.met_masses(i) : nullptr};
}

// Grains and water of either body meet the other one together, and rub with what the grains carry.
void NodalContacts::join(ContactPair& contact) {
    const ContactLaw& law = contact.law();
    if (!water.has(law.a) && !water.has(law.b)) return;
    contact.each_found([&](std::size_t node, const Vector2& normal) {
        const double on_b = water.impulse(law.a, node, normal);
        const double on_a = -water.impulse(law.b, node, normal);
        contact.bear(node,
                     water.has(law.a) && water.has(law.b) ? 0.5 * (on_a + on_b) : on_a + on_b);
        for (const std::size_t i : {law.a, law.b})
            if (water.flows(i)) water.join(i, node, normal);
    });
}

void NodalContacts::part(const ContactPair& contact, Energy& sums) {
    const ContactLaw& law = contact.law();
    for (const std::size_t i : {law.a, law.b})
        if (water.flows(i))
            contact.each_pressed([&](std::size_t node, const Vector2& normal) {
                water.part(i, node, normal, sums);
            });
}

void NodalContacts::change_pressures(Energy& sums) {
    for (std::size_t body = 0; body < model.parts.size(); ++body) {
        if (!water.is_implicit(body)) continue;
        std::vector<Water::Pressed> pressed;
        std::vector<std::size_t> of;  // contact of each
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const ContactLaw& law = contacts[i].law();
            if (law.a != body && law.b != body) continue;
            contacts[i].each_pressed([&](std::size_t node, const Vector2& normal) {
                pressed.push_back({node, law.a == body ? law.b : law.a, normal});
                of.push_back(i);
            });
        }
        water.change(body, pressed, sums);
        for (std::size_t k = 0; k < pressed.size(); ++k) {
            const Water::Pressed& p = pressed[k];
            const double sign = contacts[of[k]].law().a == body ? 1.0 : -1.0;
            const double force = sign * p.impulse / model.dt;
            Faces& faces = pore[of[k]];
            const bool faces_z = Faces::is_along_z(p.normal[0], p.normal[1]);
            Vector2& sum = faces_z ? faces.along_z : faces.along_r;
            sum = {sum[0] + force * p.normal[0], sum[1] + force * p.normal[1]};
        }
    }
}

void NodalContacts::correct(Energy& sums) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        ContactPair& pair = contacts[i];
        const ContactLaw& law = pair.law();
        pore[i] = {};
        const ContactBody a = body(law.a), b = body(law.b);
        if (pair.find(model.grid(), a, b, model.exchange)) {
            join(pair);
            pair.correct(a, b, model.dt, model.exchange);
            part(pair, sums);
        }
        const grit_contact_totals& totals = pair.totals();
        sums.contact += totals.dissipation_normal + totals.dissipation_tangential;
        for (const std::size_t which : {law.a, law.b}) {
            const Body& of = model.parts[which].body;
            if (!of.rigid()) continue;
            // What moves a rigid body works against the force that the body feels.
            const double* J = which == law.a ? totals.impulse_on_a : totals.impulse_on_b;
            const Vector2 v = of.prescribed_velocity(model.t + model.dt);
            sums.rigid_work -= J[0] * v[0] + J[1] * v[1];
        }
    }
}

}  // namespace grit::mpm
