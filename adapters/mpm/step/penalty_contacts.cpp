// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/penalty_contacts.hpp"

#include <algorithm>
#include <stdexcept>

namespace grit::mpm {

void PenaltyContacts::add(const PenaltyLaw& law) {
    if (!model.is_alone())
        throw std::invalid_argument("penalty contact is for one process: its lines are not cut");
    pairs.emplace_back(law, model.settings.axisymmetric, model.fixed_nodes.size());
    ahead.resize(model.parts.size());
    for (const std::size_t i : {law.a, law.b}) {
        ahead[i].strips.resize(static_cast<std::size_t>(model.strips()));
        if (!model.parts[i].body.rigid()) ahead[i].records.resize(model.fixed_nodes.size());
    }
}

PenaltyBody PenaltyContacts::body(std::size_t i) {
    Part& part = model.parts[i];
    return {part.records.data(), part.motions.data(), part.least_mass, part.body.rigid(),
            part.body.name};
}

PenaltyBody PenaltyContacts::body_ahead(std::size_t i) {
    Part& part = model.parts[i];
    return {ahead[i].records.data(), part.motions.data(), part.least_mass, part.body.rigid(),
            part.body.name};
}

// False where nothing presses. A vertex reaches the nodes of its cell; particles with weight there are no
// farther than two rows from it, and one more from where they were sorted.
bool PenaltyContacts::find_pressed_strips() {
    for (ScatterTarget& target : ahead) std::fill(target.strips.begin(), target.strips.end(), 0);
    bool any = false;
    for (const PenaltyPair& pair : pairs)
        pair.each_pressed([&, this](double z) {
            any = true;
            const int row = model.z.view().cell_of(z), last = model.strips() - 1;
            for (int s = std::max(row - 4, 0) / Strips::rows;
                 s <= std::min((row + 4) / Strips::rows, last); ++s)
                for (const std::size_t i : {pair.law().a, pair.law().b})
                    ahead[i].strips[static_cast<std::size_t>(s)] = 1;
        });
    return any;
}

void PenaltyContacts::find_forces() {
    if (pairs.empty()) return;
    ahead.resize(model.parts.size());
    for (PenaltyPair& pair : pairs) pair.find_forces(model.dt_before);
    const bool any = find_pressed_strips(), first = model.steps == 0;
    if (first)  // all vertices are looked at
        for (ScatterTarget& target : ahead)
            std::fill(target.strips.begin(), target.strips.end(), 1);
    if (any || first) {
        for (ScatterTarget& target : ahead)
            std::fill(target.records.begin(), target.records.end(), NodeRecord{});
        scatter.into(ahead, part::mass);
    }
    for (PenaltyPair& pair : pairs) {
        const PenaltyBody a = body_ahead(pair.law().a), b = body_ahead(pair.law().b);
        if (first) pair.check_mass(model.grid(), a, b, PenaltyPair::Vertices::all);
        pair.find_step(model.grid(), a, b);
    }
}

void PenaltyContacts::push(Energy& sums) {
    for (PenaltyPair& pair : pairs) {
        const PenaltyLaw& law = pair.law();
        pair.push(model.grid(), body(law.a), body(law.b));
        const grit_penalty_totals& totals = pair.totals();
        for (const std::size_t i : {law.a, law.b}) {
            const Body& of = model.parts[i].body;
            if (!of.rigid()) continue;
            const double* force = i == law.a ? totals.force_on_a : totals.force_on_b;
            const Vector2 v = of.prescribed_velocity(model.t + model.dt);
            sums.rigid_work -= model.dt * (force[0] * v[0] + force[1] * v[1]);
        }
    }
}

void PenaltyContacts::move(Energy& sums) {
    for (PenaltyPair& pair : pairs) {
        pair.move(model.grid(), body(pair.law().a), body(pair.law().b), model.dt);
        sums.contact += pair.energy_taken();
    }
}

}  // namespace grit::mpm
