// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/surface_contacts.hpp"

#include <algorithm>
#include <utility>

namespace grit::mpm {

void SurfaceContacts::add(const SurfaceLaw& law) {
    // A vertex keeps its place between the sides of a domain, so that these must stay what they are.
    if (!law.line_a.points.empty()) model.parts[law.a].reduces_domains = false;
    const bool axisymmetric = model.settings.axisymmetric;
    pairs.emplace_back(
        law, model.shortest,
        ContactZone(model.grid(), model.exchange.whole(), axisymmetric, model.fixed_nodes),
        axisymmetric);
    are_near.resize(pairs.size());
}

SurfaceBody SurfaceContacts::body(std::size_t i) {
    Part& part = model.parts[i];
    Body& of = part.body;
    const Vector2 velocity =
        of.rigid() ? of.prescribed_velocity(model.t + model.dt) : Vector2{0.0, 0.0};
    return {part.records.data(),
            part.motions.data(),
            of.particles.view(),
            of.particles.ids(),
            of.particles.size(),
            part.least_mass,
            of.rigid(),
            velocity,
            &water,
            i};
}

void SurfaceContacts::correct(Energy& sums) {
    if (pairs.empty()) return;
    for (SurfacePair& pair : pairs) pair.find_riders(body(pair.law().a), model.exchange);
    // Masses say where bodies are near: contacts change none.
    for (std::size_t i = 0; i < pairs.size(); ++i)
        are_near[i] = pairs[i].find(body(pairs[i].law().a), body(pairs[i].law().b)) ? 1.0 : 0.0;
    model.exchange.max(are_near.data(), static_cast<int>(are_near.size()));
    correct(false, sums);
}

bool SurfaceContacts::is_implicit() const {
    for (std::size_t i = 0; i < model.parts.size(); ++i)
        if (water.is_implicit(i)) return true;
    return false;
}

std::vector<SurfaceRows*> SurfaceContacts::rows_of(std::size_t body) {
    std::vector<SurfaceRows*> out;
    for (SurfacePair& pair : pairs)
        if (pair.law().a == body || pair.law().b == body) out.push_back(&pair.rows());
    return out;
}

void SurfaceContacts::keep_damped() {
    if (!is_implicit()) return;
    for (SurfacePair& pair : pairs)
        for (SurfaceRow& row : pair.rows().rows) {
            const std::array<double, 4> damped = water.values(pair.rows(), row, true);
            row.on_damped = 0.0;
            for (std::size_t k = 0; k < 4; ++k)
                row.on_damped += 0.5 * row.of_contact[k] * damped[k];
        }
}

// Work of impulses is that on the mean of the velocities before the step and at its end. Up to what damping left, contact
// and damping have counted it; beyond that too where something acts once more after damping.
void SurfaceContacts::take_changes(Energy& sums) {
    if (!is_implicit()) return;
    const bool counted_on = model.settings.local_damping > 0.0 && any_after_damping();
    for (SurfacePair& pair : pairs) {
        const SurfaceRows& of = pair.rows();
        double taken = 0.0;
        for (const SurfaceRow& row : of.rows) {
            const std::array<double, 4> end = water.values(of, row, true);
            const std::array<double, 4> start = water.values(of, row, false);
            const double impulse[] = {row.impulse[0], row.impulse[1], row.water_impulse[0],
                                      row.water_impulse[1]};
            for (std::size_t k = 0; k < 4; ++k)
                taken += 0.5 * (impulse[k] * (start[k] + end[k]) -
                                row.of_contact[k] * (start[k] + (counted_on ? end[k] : 0.0)));
            if (!counted_on) taken -= row.on_damped;
            sums.rigid_work += (row.impulse[0] - row.of_contact[0]) * row.rigid[0];
        }
        sums.contact += taken;
        pair.take_rows(model.dt);
    }
}

void SurfaceContacts::correct_damped(Energy& sums) { correct(true, sums); }

bool SurfaceContacts::any_after_damping() const {
    return std::any_of(pairs.begin(), pairs.end(),
                       [](const SurfacePair& pair) { return pair.law().after_damping; });
}

void SurfaceContacts::correct(bool damped, Energy& sums) {
    calls.clear();
    called.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        SurfacePair& pair = pairs[i];
        const SurfaceLaw& law = pair.law();
        if (!(are_near[i] > 0.0) || (damped && !law.after_damping)) continue;
        pair.add_call(body(law.a), body(law.b), model.dt, model.exchange, calls);
        if (pair.was_called()) called.push_back(&pair);
    }
    calls.solve();
    for (SurfacePair* pair : called) {
        const SurfaceBody a = body(pair->law().a), b = body(pair->law().b);
        pair->take_call(a, b, !damped && is_implicit());
        const grit_surface_totals& totals = pair->totals_of_call();
        sums.contact += totals.dissipation_normal + totals.dissipation_tangential;
        // What moves a rigid body works against the force that the body feels.
        for (const auto& [of, J] :
             {std::pair{&a, totals.impulse_on_a}, std::pair{&b, totals.impulse_on_b}})
            if (of->rigid) sums.rigid_work -= J[0] * of->velocity[0] + J[1] * of->velocity[1];
    }
}

}  // namespace grit::mpm
