// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/measures.hpp"

namespace grit::mpm {
namespace {

// Steps between looks at energies, which go over all particles.
constexpr long look_every = 20;
// Below the energy of such a strain a broken balance does not matter [-].
constexpr double least_strain = 1e-4;

std::string text(double value) {
    char out[32];
    std::snprintf(out, sizeof out, "%.6g", value);
    return out;
}

Energy times(const Energy& e, double factor) {
    return {factor * e.kinetic,  factor * e.stored,        factor * e.kinetic_0,
            factor * e.stored_0, factor * e.external_work, factor * e.rigid_work,
            factor * e.contact,  factor * e.damping,       factor * e.viscosity,
            factor * e.absorbed, factor * e.transfer,      factor * e.pic};
}

}  // namespace

// The pulse train of a case and the time on its own clock.
struct Runner::Blows {
    const PulseTrain* train = nullptr;
    double since = -1.0;
};

Runner::Runner(Case given) : plan(std::move(given)), built(build_case(plan)) {
    if (plan.stages.empty()) throw std::invalid_argument("a case needs a stage");
    driven = plan.body(plan.history.body);
    double weight = 0.0, stiffness = 0.0;
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
        Body& body = built.simulation->body(i);
        const ParticleView q = body.particles.view();
        particle_count += body.particles.size();
        for (std::ptrdiff_t p = 0; p < body.particles.size() && !body.rigid(); ++p) {
            double modulus = 0.0;
            body.material->wave_moduli({q, p, p + 1}, &modulus);
            weight += plan.gravity * q[column::mass][p];
            stiffness += modulus * q[column::V0][p];
        }
    }
    const double cell =
        std::min(built.simulation->axis_r().shortest(), built.simulation->axis_z().shortest());
    least_energy = std::max(weight * cell, 0.5 * least_strain * least_strain * stiffness);
    state_now.stage_time = built.clock->began;
    state_now.start_level = level();
    begin_stage();
}

double Runner::level() {
    return level_of(built.simulation->body(driven).particles, plan.history.depth_of);
}

void Runner::begin_stage() {
    const auto i = static_cast<std::size_t>(state_now.stage);
    built.clock->began[i] = state_now.stage_time[i] = built.simulation->time();
    state_now.stage_level = level();
    apply_stage(plan, plan.stages[i], *built.simulation);
}

void Runner::resume(const RunState& state) {
    state_now = state;
    built.clock->began = state.stage_time;
    due = false;
    if (!finished())
        apply_stage(plan, plan.stages[static_cast<std::size_t>(state.stage)], *built.simulation);
}

void Runner::step() {
    Simulation& simulation = *built.simulation;
    const double before = simulation.time();
    simulation.step();
    const double dt = state_now.last_dt = simulation.time() - before;
    const ContactForces forces = contact_forces(simulation, driven);
    const double now[] = {forces.tip.z, forces.shaft.z, -simulation.traction_force(driven).z,
                          base_reaction(simulation)};
    for (std::size_t k = 0; k < 4; ++k) state_now.impulse[k] += dt * now[k];
    if (simulation.steps() % look_every == 0) check_energy();
    due = simulation.time() >= state_now.next_row;
    const Ended end = end_of_stage();
    if (end == Ended::not_yet) return;
    how = end;
    due = true;
    if (++state_now.stage < static_cast<int>(plan.stages.size())) begin_stage();
}

void Runner::check_energy() {
    Simulation& simulation = *built.simulation;
    const Energy energy = simulation.energy();
    const double turned = turned_over(energy, least_energy), residual = energy.residual();
    // A positive condition, so that NaN fails it.
    if (std::abs(residual) <= plan.residual_limit * turned) return;
    throw std::runtime_error("the energy balance is broken at t = " + text(simulation.time()) +
                             " s, step " + std::to_string(simulation.steps()) +
                             ": its residual is " + text(100.0 * residual / turned) + " % of the " +
                             text(turned) + " J turned over, the limit is " +
                             text(100.0 * plan.residual_limit) + " %; is cfl too large?");
}

Ended Runner::end_of_stage() {
    const StageEnd& end = plan.stages[static_cast<std::size_t>(state_now.stage)].end;
    const double since =
        built.simulation->time() - state_now.stage_time[static_cast<std::size_t>(state_now.stage)];
    if (since >= end.time) return Ended::by_time;
    if (end.depth < unlimited && state_now.stage_level - level() >= end.depth)
        return Ended::by_depth;
    if (end.blows > 0) {
        const Blows now = blows();
        if (now.train && now.since >= now.train->start + end.blows * now.train->interval)
            return Ended::by_blows;
    }
    return at_rest() ? Ended::at_rest : Ended::not_yet;
}

bool Runner::at_rest() {
    const StageEnd& end = plan.stages[static_cast<std::size_t>(state_now.stage)].end;
    Simulation& simulation = *built.simulation;
    if (!(end.unbalanced_share > 0.0) || simulation.steps() % look_every != 0) return false;
    if (!(unbalanced_share(simulation, state_now.last_dt) <= end.unbalanced_share)) return false;
    if (!(end.kinetic_share > 0.0)) return true;
    const Energy energy = simulation.energy();
    return energy.kinetic <= end.kinetic_share * turned_over(energy, least_energy);
}

Runner::Blows Runner::blows() const {
    for (const TractionPlan& traction : plan.tractions)
        if (const auto* train = std::get_if<PulseTrain>(&traction.stress)) {
            const double began = traction.from_stage.empty()
                                     ? 0.0
                                     : state_now.stage_time[plan.stage(traction.from_stage)];
            return {train, built.simulation->time() - began};
        }
    return {};
}

int Runner::blow() const {
    const Blows now = blows();
    return now.train && now.since >= 0.0 ? now.train->blow(now.since) : 0;
}

double Runner::share_done() {
    if (finished()) return 1.0;
    const auto i = static_cast<std::size_t>(state_now.stage);
    const StageEnd& end = plan.stages[i].end;
    double share = NAN;
    if (end.time < unlimited)
        share = (built.simulation->time() - state_now.stage_time[i]) / end.time;
    if (end.depth < unlimited)
        share = std::fmax(share, (state_now.stage_level - level()) / end.depth);
    if (const Blows now = blows(); end.blows > 0 && now.train)
        share = std::fmax(share, now.since / (now.train->start + end.blows * now.train->interval));
    return share < 0.0 ? 0.0 : share;
}

HistoryRow Runner::row() {
    Simulation& simulation = *built.simulation;
    const double full = plan.settings.axisymmetric ? 2.0 * std::numbers::pi : 1.0;
    const double since = simulation.time() - state_now.row_time;
    const double per_time = since > 0.0 ? full / since : 0.0;
    HistoryRow out;
    out.stage = std::min(state_now.stage + 1, static_cast<int>(plan.stages.size()));
    out.step = simulation.steps();
    out.t = simulation.time();
    out.blow = blow();
    out.depth = depth();
    const bool rigid = simulation.rigid(driven);
    const Vector v = rigid ? simulation.body(driven).prescribed_velocity(out.t)
                           : mean_velocity(simulation.body(driven).particles);
    out.velocity = 0.0 - v.z;  // no -0
    out.tip_force = per_time * state_now.impulse[0];
    out.shaft_force = per_time * state_now.impulse[1];
    out.hammer_force = per_time * state_now.impulse[2];
    out.base_force = per_time * state_now.impulse[3];
    const Energy energy = simulation.energy();
    out.energy = times(energy, full);
    const double turned = turned_over(energy, least_energy);
    out.residual_share = turned > 0.0 ? energy.residual() / turned : 0.0;
    out.dt = state_now.last_dt;
    out.largest_gap = contact_forces(simulation, driven).largest_gap;
    out.unbalanced_share =
        state_now.last_dt > 0.0 ? unbalanced_share(simulation, state_now.last_dt) : 0.0;
    state_now.impulse = {};
    state_now.row_time = out.t;
    while (state_now.next_row <= out.t && plan.history.interval > 0.0)
        state_now.next_row += plan.history.interval;
    due = false;
    return out;
}

}  // namespace grit::mpm
