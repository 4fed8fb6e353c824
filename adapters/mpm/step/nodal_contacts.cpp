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

void NodalContacts::part(const ContactPair& contact) {
    const ContactLaw& law = contact.law();
    for (const std::size_t i : {law.a, law.b})
        if (water.flows(i))
            contact.each_pressed([&](std::size_t node, const Vector2& normal, double) {
                water.part(i, node, normal);
            });
}

void NodalContacts::change_pressures(SurfaceContacts& surfaces) {
    const std::uint8_t* mine = model.exchange.counted();
    for (std::size_t body = 0; body < model.parts.size(); ++body) {
        if (!water.is_implicit(body)) continue;
        std::vector<Water::Pressed> pressed;
        std::vector<std::size_t> of;  // contact of each
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const ContactLaw& law = contacts[i].law();
            if (law.a != body && law.b != body) continue;
            contacts[i].each_pressed([&](std::size_t node, const Vector2& normal, double share) {
                pressed.push_back({node, law.a == body ? law.b : law.a, normal, share});
                of.push_back(i);
            });
        }
        water.change(body, pressed, surfaces.rows_of(body));
        std::vector<FaceSums> sums(contacts.size(), FaceSums(model.settings.fixed_point));
        for (std::size_t k = 0; k < pressed.size(); ++k) {
            const Water::Pressed& p = pressed[k];
            const double sign = contacts[of[k]].law().a == body ? 1.0 : -1.0;
            const double force = sign * p.impulse / model.dt;
            const double along[] = {force * p.normal[0], force * p.normal[1]};
            if (!mine || mine[p.node]) sums[of[k]].add(p.normal.c, along);
        }
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const ContactLaw& law = contacts[i].law();
            if (law.a != body && law.b != body) continue;
            const Faces more = sums[i].of_all(model.exchange);
            pore[i] = {pore[i].along_r + more.along_r, pore[i].along_z + more.along_z};
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
            part(pair);
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
