// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/run/run.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/run/measures.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

// Steps between looks at energies, which go over all particles.
constexpr long look_every = 20;
// Below the energy of such a strain a broken balance does not matter [-].
constexpr double least_strain = 1e-4;

// Of the time that a wave needs for a cell: no steps are that short [-].
constexpr double least_share = 1e-6;

// The traction whose pulses a stage counts: one that begins with it, else the one that began last. Null:
// there is none.
const TractionPlan* counted_by(const Case& plan, std::size_t stage) {
    const TractionPlan* out = nullptr;
    std::ptrdiff_t latest = -2;
    for (const TractionPlan& traction : plan.tractions) {
        if (!std::holds_alternative<PulseTrain>(traction.stress)) continue;
        const std::ptrdiff_t from =
            traction.from_stage.empty()
                ? -1  // with the run
                : static_cast<std::ptrdiff_t>(plan.stage(traction.from_stage));
        if (from > static_cast<std::ptrdiff_t>(stage) || from <= latest) continue;
        latest = from;
        out = &traction;
    }
    return out;
}

// What can be known before: a stage has a train to count, with enough blows left.
void check_blows(const Case& plan, const std::vector<StagePlan>& stages) {
    std::map<const TractionPlan*, int> taken;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const int wanted = stages[i].end.blows;
        if (wanted == 0) continue;
        const std::string waits = "stage " + stages[i].name + " waits for " +
                                  std::to_string(wanted) + (wanted == 1 ? " blow" : " blows");
        const TractionPlan* traction = counted_by(plan, i);
        if (!traction)
            throw std::invalid_argument(waits + ", but no traction with pulses has begun by then");
        const int before = taken[traction], count = std::get<PulseTrain>(traction->stress).count;
        if (wanted > count - before)
            throw std::invalid_argument(
                waits + " of a train of " + std::to_string(count) +
                (before > 0 ? ", of which earlier stages take " + std::to_string(before) : ""));
        taken[traction] += wanted;
    }
}

}  // namespace

// The pulse train that a stage counts: its own one, else the one that began last. Times are on the clock
// of the train: now, and when the stage began.
struct Runner::Blows {
    const PulseTrain* train = nullptr;
    double since = -1.0, stage_since = -1.0;

    int done() const { return train->over(since) - train->over(stage_since); }
    int left_at_begin() const { return train->count - train->over(stage_since); }
    double duration(int blows) const {
        return train->start + (train->over(stage_since) + blows) * train->interval - stage_since;
    }
};

Runner::Runner(const Case& given) : Runner(given, build_case(given)) {}

Runner::Runner(Case given, BuiltCase ready)
    : plan(std::move(given)), built(std::move(ready)),
      run_on(built.space ? subject_of(*built.space) : subject_of(*built.simulation)) {
    if (plan.stages.empty()) throw std::invalid_argument("a case needs a stage");
    driven = plan.body(plan.history.body);
    whole = plan.settings.axisymmetric && !plan.space ? 2.0 * std::numbers::pi : 1.0;
    check_blows(plan, plan.stages);
    measure_bodies();
    check_interval("history.interval_s", plan.history.interval);
    state_now.stage_time = built.clock->began;
    state_now.profile.assign(plan.history.profile.numbers(), 0.0);
    state_now.start_level = level();
    begin_stage();
}

void Runner::measure_bodies() {
    const Subject::Bodies bodies = run_on->measure(plan.gravity, driven);
    particle_count = bodies.particles;
    mass_of_driven = whole * bodies.mass;
    const double cell = run_on->shortest_cell();
    wave_time = bodies.fastest2 > 0.0 ? cell / std::sqrt(bodies.fastest2) : 0.0;
    least_energy =
        std::max(bodies.weight * cell, 0.5 * least_strain * least_strain * bodies.stiffness);
}

void Runner::check_interval(const std::string& name, double interval) const {
    const double least = least_share * wave_time;
    if (interval == 0.0 || interval >= least) return;
    throw std::invalid_argument(
        name + " must be 0 or no less than " + text(least) + " s, " + text(least_share) +
        " of the time that a wave needs for the shortest cell, got " + text(interval));
}

double Runner::level() { return run_on->level(driven, plan.history.depth_of); }

void Runner::begin_stage() {
    const auto i = static_cast<std::size_t>(state_now.stage);
    built.clock->began[i] = state_now.stage_time[i] = run_on->time();
    state_now.stage_level = level();
    run_on->apply(plan, plan.stages[i]);
}

void Runner::begin(const std::string& stage,
                   const std::function<StagePlan(const StagePlan&)>& describe) {
    const std::size_t wanted = plan.stage(stage);
    const auto now = static_cast<std::size_t>(state_now.stage);
    if (wanted != now && wanted != now + 1)
        throw std::invalid_argument("stage " + stage + " is not the next one");
    if (wanted != now && !(run_on->time() > state_now.stage_time[now]))
        throw std::invalid_argument("stage " + stage + " cannot begin: stage " +
                                    plan.stages[now].name + " has not done a step yet");
    const StagePlan given = describe(plan.stages[wanted]);
    std::vector<StagePlan> stages = plan.stages;
    for (std::size_t i = wanted; i < stages.size(); ++i) {
        StagePlan next = given;
        next.name = stages[i].name;
        if (i > wanted) next.end = {};
        stages[i] = next;
    }
    check_blows(plan, stages);
    plan.stages = std::move(stages);
    if (wanted != now) {
        ++state_now.stage;
        begin_stage();
    } else {
        run_on->apply(plan, plan.stages[wanted]);
    }
}

void Runner::resume(const RunState& state) {
    state_now = state;
    built.clock->began = state.stage_time;
    due = false;
    if (!finished()) run_on->apply(plan, plan.stages[static_cast<std::size_t>(state.stage)]);
}

void Runner::take_steps() {
    if (!finished())
        run_on->take_steps(plan, plan.stages[static_cast<std::size_t>(state_now.stage)]);
}

void Runner::step() {
    Subject& simulation = *run_on;
    const double before = simulation.time();
    simulation.step();
    const double dt = state_now.last_dt = simulation.time() - before;
    const Subject::Forces forces = simulation.forces(driven);
    const double now[] = {forces.tip, forces.shaft, -forces.traction, forces.base};
    for (std::size_t k = 0; k < 4; ++k) state_now.impulse[k] += dt * now[k];
    state_now.impulse[4] += forces.damping_impulse;
    for (std::size_t k = 0; k < 6; ++k) state_now.impulse[5 + k] += forces.contact_impulse[k];
    if (!state_now.profile.empty())
        simulation.add_profile(driven, plan.history.profile, state_now.profile);
    if (simulation.steps() % look_every == 0) check_energy();
    due = simulation.time() >= state_now.next_row;
    const Ended end = end_of_stage();
    if (end == Ended::not_yet) return;
    simulation.energy().check_finite(simulation.time());
    how = end;
    due = true;
    if (++state_now.stage < static_cast<int>(plan.stages.size())) begin_stage();
}

void Runner::check_energy() {
    Subject& simulation = *run_on;
    const std::string words =
        imbalance(times(simulation.energy(), whole), whole * least_energy, plan.residual_limit);
    if (words.empty()) return;
    throw std::runtime_error("the energy balance is broken at t = " + text(simulation.time()) +
                             " s, step " + std::to_string(simulation.steps()) + ": " + words +
                             "; is cfl too large?");
}

Ended Runner::end_of_stage() {
    const auto stage = static_cast<std::size_t>(state_now.stage);
    const StageEnd& end = plan.stages[stage].end;
    const double since = run_on->time() - state_now.stage_time[stage];
    if (since >= end.time) return Ended::by_time;
    if (end.depth < unlimited && state_now.stage_level - level() >= end.depth)
        return Ended::by_depth;
    if (end.blows > 0) {
        const Blows now = blows();
        if (now.done() >= end.blows) return Ended::by_blows;
        if (now.left_at_begin() < end.blows && now.train->over(now.since) == now.train->count &&
            !(end.time < unlimited || end.depth < unlimited || end.unbalanced_share > 0.0))
            throw std::runtime_error("stage " + plan.stages[stage].name + " waits for " +
                                     std::to_string(end.blows) + " blows, but had " +
                                     std::to_string(now.done()) + " of the train's " +
                                     std::to_string(now.train->count) + " and no more follow");
    }
    return at_rest() ? Ended::at_rest : Ended::not_yet;
}

bool Runner::at_rest() {
    const StageEnd& end = plan.stages[static_cast<std::size_t>(state_now.stage)].end;
    Subject& simulation = *run_on;
    if (!(end.unbalanced_share > 0.0) || simulation.steps() % look_every != 0) return false;
    if (!(simulation.unbalanced_share(state_now.last_dt) <= end.unbalanced_share)) return false;
    if (!(end.kinetic_share > 0.0)) return true;
    const Energy energy = simulation.energy();
    return energy.kinetic <= end.kinetic_share * turned_over(energy, least_energy);
}

Runner::Blows Runner::blows() const {
    const std::size_t stage =
        std::min(static_cast<std::size_t>(state_now.stage), plan.stages.size() - 1);
    const TractionPlan* traction = counted_by(plan, stage);
    if (!traction) return {};
    const double began =
        traction->from_stage.empty() ? 0.0 : state_now.stage_time[plan.stage(traction->from_stage)];
    return {&std::get<PulseTrain>(traction->stress), run_on->time() - began,
            state_now.stage_time[stage] - began};
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
    if (end.time < unlimited) share = (run_on->time() - state_now.stage_time[i]) / end.time;
    if (end.depth < unlimited)
        share = std::fmax(share, (state_now.stage_level - level()) / end.depth);
    if (const Blows now = blows(); end.blows > 0)
        share = std::fmax(share, (now.since - now.stage_since) / now.duration(end.blows));
    return share < 0.0 ? 0.0 : share;
}

HistoryRow Runner::row_so_far() {
    Subject& simulation = *run_on;
    const double since = simulation.time() - state_now.row_time;
    const double per_time = since > 0.0 ? whole / since : 0.0;
    HistoryRow out;
    out.stage = std::min(state_now.stage + 1, static_cast<int>(plan.stages.size()));
    out.step = simulation.steps();
    out.t = simulation.time();
    out.blow = blow();
    out.depth = depth();
    out.velocity = 0.0 - simulation.velocity_z(driven);  // no -0
    out.tip_force = per_time * state_now.impulse[0];
    out.shaft_force = per_time * state_now.impulse[1];
    out.hammer_force = per_time * state_now.impulse[2];
    out.base_force = per_time * state_now.impulse[3];
    out.damping_force = per_time * state_now.impulse[4];
    for (std::size_t k = 0; k < 6; ++k) out.contact[k] = per_time * state_now.impulse[5 + k];
    for (const double impulse : state_now.profile) out.profile.push_back(per_time * impulse);
    const Energy energy = simulation.energy();
    out.energy = times(energy, whole);
    out.driven_stored = whole * simulation.stored_energy(driven);
    const double turned = turned_over(energy, least_energy);
    out.residual_share = turned > 0.0 ? energy.residual() / turned : 0.0;
    out.dt = state_now.last_dt;
    out.largest_gap = simulation.forces(driven).largest_gap;
    const Extremes pore = simulation.pore_pressures();
    out.least_pore_pressure = pore.least;
    out.largest_pore_pressure = pore.largest;
    out.water_mass = whole * simulation.water_mass();
    out.unbalanced_share =
        state_now.last_dt > 0.0 ? simulation.unbalanced_share(state_now.last_dt) : 0.0;
    return out;
}

HistoryRow Runner::row() {
    const HistoryRow out = row_so_far();
    state_now.impulse = {};
    std::fill(state_now.profile.begin(), state_now.profile.end(), 0.0);
    state_now.row_time = out.t;
    if (plan.history.interval > 0.0)
        state_now.next_row = next_multiple(plan.history.interval, out.t);
    due = false;
    return out;
}

}  // namespace grit::mpm
