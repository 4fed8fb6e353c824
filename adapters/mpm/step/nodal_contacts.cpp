// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/nodal_contacts.hpp"

#include <tuple>

namespace grit::mpm {

ContactBody NodalContacts::body(std::size_t i) {
    Part& part = model.parts[i];
    return {part.records.data(), part.motions.data(), part.body.particles.view(),
            part.body.particles.size(), part.body.rigid()};
}

// Of water that flows in one body, at the nodes where the other one presses.
void NodalContacts::bear_pore_pressure(std::size_t contact) {
    const ContactLaw& law = contacts[contact].law();
    if (!water.flows(law.a) && !water.flows(law.b)) return;
    FaceSums sums(model.settings.fixed_point);
    const std::uint8_t* mine = model.exchange.counted();
    for (const auto& [of, other, sign] : {std::tuple{law.a, law.b, 1.0}, {law.b, law.a, -1.0}}) {
        if (!water.flows(of)) continue;
        contacts[contact].each_pressed(
            [&, of = of, other = other, sign = sign](std::size_t node, const double* normal) {
                const double impulse = water.press(of, other, node, {normal[0], normal[1]});
                const double force = sign * impulse / model.dt;
                const double along[] = {force * normal[0], force * normal[1]};
                if (!mine || mine[node]) sums.add(normal, along);
            });
    }
    pore[contact] = sums.of_all(model.exchange);
}

void NodalContacts::change_pressures() {
    const std::uint8_t* mine = model.exchange.counted();
    for (std::size_t body = 0; body < model.parts.size(); ++body) {
        if (!water.is_implicit(body)) continue;
        std::vector<Water::Pressed> pressed;
        std::vector<std::size_t> of;  // contact of each
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const ContactLaw& law = contacts[i].law();
            if (law.a != body && law.b != body) continue;
            contacts[i].each_pressed([&](std::size_t node, const double* normal) {
                pressed.push_back({node, law.a == body ? law.b : law.a, {normal[0], normal[1]}});
                of.push_back(i);
            });
        }
        water.change(body, pressed);
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
            bear_pore_pressure(i);
            pair.correct(a, b, model.dt, model.exchange);
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
