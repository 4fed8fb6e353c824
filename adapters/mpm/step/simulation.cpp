// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/simulation.hpp"

#include <algorithm>

namespace grit::mpm {

void Simulation::step() {
    if (!started) start();
    const Scheme scheme = model.settings.scheme;
    Stopwatch watch;
    model.sort_if_moved();
    scatter.clear();
    if (scheme == Scheme::usf) {
        scatter(part::mass | part::momentum | part::gradient);
        momentum.start_velocities();
        gather(task::deformation);
        scatter(part::force);
    } else {
        scatter(part::all);
    }
    water.push();
    watch.lap(spent.scatter);
    penalties.push(account.sums());
    watch.lap(spent.contact);
    momentum.keep_internal_forces();
    loads.push();
    momentum.advance();
    water.drag();
    sides.push(model, momentum);
    watch.lap(spent.nodes);
    contacts.correct(account.sums());
    surfaces.correct(account.sums());
    platens.tie(account.sums());
    watch.lap(spent.contact);
    sides.find_work(model, momentum);
    momentum.damp(water, platens.any(), surfaces.any_after_damping());
    if (model.settings.local_damping > 0.0) {
        platens.tie(account.sums());
        surfaces.correct_damped(account.sums());
    }
    surfaces.keep_damped();
    contacts.change_pressures(surfaces);
    surfaces.take_changes(account.sums());
    platens.move();
    momentum.close();
    loads.find_work();
    watch.lap(spent.nodes);
    penalties.move(account.sums());
    watch.lap(spent.contact);
    water.close();
    if (scheme == Scheme::musl) {
        gather(task::velocity);
        momentum.forget();
        scatter(part::momentum);
        momentum.remap();
        gather(task::position | task::deform_by_other);
    } else if (scheme == Scheme::usf) {
        gather(task::velocity | task::position);
    } else {
        gather(task::all);
    }
    water.update();
    model.t += model.dt;
    ++model.steps;
    ++spent.steps;
    finish();
    watch.lap(spent.gather);
}

void Simulation::start() {
    started = true;
    model.sort();
    gather.measure();
    water.measure();
    finish();
    account.start();
}

// Sums of the step that is done, and the size of the next one.
void Simulation::finish() {
    account.add_step(gather, momentum, loads, sides, water);
    step_size.measure(gather);
    model.dt_before = model.dt;
    penalties.find_forces();
    step_size.decide();
}

Simulation::Simulation(Axis r, Axis z, const Settings& settings, Exchange* exchange)
    : model(std::move(r), std::move(z), settings, exchange) {
    if (settings.axisymmetric && model.r[0] == 0.0) fix_below(0, 0.0);
}

std::size_t Simulation::add_body(Body body) {
    model.add_body(std::move(body));
    means.add_body();
    scatter.add_body();
    momentum.add_body();
    water.add_body();
    loads.add_body();
    sides.add_body();
    gather.add_body();
    return model.parts.size() - 1;
}

void Simulation::particles_changed(std::size_t body) {
    model.particles_changed(body);
    means.particles_changed(body);
}

void Simulation::index_ids() {
    for (Part& part : model.parts) part.index_ids();
}

namespace {

// take(node) for those whose place along a direction is where this says.
template <class Where, class Take>
void each_node(const Model& model, int direction, const Where& where, const Take& take) {
    std::size_t node = 0;
    for (int j = 0; j < model.z.nodes(); ++j)
        for (int i = 0; i < model.r.nodes(); ++i, ++node)
            if (where(direction == 0 ? model.r[i] : model.z[j])) take(node);
}

void fix(Model& model, int direction, Hold hold, const std::function<bool(double)>& where) {
    const std::uint8_t across = direction == 0 ? fixed::r : fixed::z;
    const std::uint8_t bits = hold == Hold::both ? fixed::r | fixed::z : across;
    each_node(model, direction, where, [&](std::size_t node) {
        model.fixed_nodes[node] |= bits;
        model.closed_nodes[node] |= across;
    });
}

void drain(const Model& model, Water& water, int direction,
           const std::function<bool(double)>& where) {
    each_node(model, direction, where, [&](std::size_t node) { water.drain(direction, node); });
}

std::vector<std::size_t> nodes_where(const Model& model, int direction,
                                     const std::function<bool(double)>& where) {
    std::vector<std::size_t> out;
    each_node(model, direction, where, [&](std::size_t node) { out.push_back(node); });
    return out;
}

// Nodes of a line across a direction, at the end of a cell.
void absorb(const Model& model, AbsorbingSides& sides, int direction, int line, double cell,
            const WaveSpeeds& speeds) {
    const int n_r = model.r.nodes(), along = direction == 0 ? model.z.nodes() : n_r;
    for (int i = 0; i < along; ++i)
        sides.add(static_cast<std::size_t>(direction == 0 ? i * n_r + line : line * n_r + i),
                  direction, cell, speeds);
}

}  // namespace

void Simulation::fix_below(int direction, double at, Hold hold) {
    fix(model, direction, hold, [at](double x) { return x <= at; });
}

void Simulation::fix_above(int direction, double at, Hold hold) {
    fix(model, direction, hold, [at](double x) { return x >= at; });
}

void Simulation::drain_below(int direction, double at) {
    drain(model, water, direction, [at](double x) { return x <= at; });
}

void Simulation::drain_above(int direction, double at) {
    drain(model, water, direction, [at](double x) { return x >= at; });
}

void Simulation::pour_below(int direction, double at, std::function<double(double)> speed) {
    water.pour({direction, 1.0, nodes_where(model, direction, [at](double x) { return x <= at; }),
                std::move(speed)});
}

void Simulation::pour_above(int direction, double at, std::function<double(double)> speed) {
    water.pour({direction, -1.0, nodes_where(model, direction, [at](double x) { return x >= at; }),
                std::move(speed)});
}

void Simulation::tie_below(int direction, int line) {
    const Axis& axis = direction == 0 ? model.r : model.z;
    const int outer = std::min(line, axis.nodes() - 2);
    const double at = axis[line];
    platens.add(direction, axis[outer + 1] - axis[outer],
                nodes_where(model, direction, [at](double x) { return x <= at; }));
}

void Simulation::tie_above(int direction, int line) {
    const Axis& axis = direction == 0 ? model.r : model.z;
    const int inner = std::max(line, 1);
    const double at = axis[line];
    platens.add(direction, axis[inner] - axis[inner - 1],
                nodes_where(model, direction, [at](double x) { return x >= at; }));
}

void Simulation::absorb_first(int direction, const WaveSpeeds& speeds) {
    const Axis& axis = direction == 0 ? model.r : model.z;
    absorb(model, sides, direction, 0, axis[1] - axis[0], speeds);
}

void Simulation::absorb_last(int direction, const WaveSpeeds& speeds) {
    const Axis& axis = direction == 0 ? model.r : model.z;
    const int last = axis.nodes() - 1;
    absorb(model, sides, direction, last, axis[last] - axis[last - 1], speeds);
}

void Simulation::set_gravity(Vector2 gravity) {
    model.settings.gravity_r = gravity[0];
    model.settings.gravity_z = gravity[1];
}

// The next step is known already; it does not get longer than it was but by this share.
void Simulation::set_cfl(double cfl) {
    const double before = model.dt * (cfl / model.settings.cfl);
    model.settings.cfl = cfl;
    if (!started) return;
    step_size.decide();
    model.dt = std::min(model.dt, before);
}

void Simulation::set_largest_step(double step) {
    model.settings.largest_step = step;
    if (started) model.dt = std::min(model.dt, step);
}

Seconds Simulation::seconds() const {
    Seconds out = spent;
    for (std::size_t body = 0; body < model.parts.size(); ++body)
        for (const Gather::OfStrip& strip : gather.strips(body))
            out.material += strip.material_seconds / model.pool.size();
    return out;
}

Energy Simulation::energy() {
    if (!started) start();
    account.measure();
    return account.sums();
}

}  // namespace grit::mpm
