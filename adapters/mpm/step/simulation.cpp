// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace grit::mpm {

Simulation::Simulation(Axis r, Axis z, const Settings& given, Exchange* others)
    : settings(given), r_axis(std::move(r)), z_axis(std::move(z)),
      fixed_nodes(static_cast<std::size_t>(r_axis.nodes()) *
                  static_cast<std::size_t>(z_axis.nodes())),
      exchange(others ? *others : alone), pool(usable_threads(given.threads)) {
    if (settings.axisymmetric && r_axis[0] < 0.0)
        throw std::invalid_argument("the grid must not reach across the axis");
    if (settings.axisymmetric && r_axis[0] == 0.0) fix_below(0, 0.0);
    double longest = -std::min(r_axis.shortest(), z_axis.shortest());
    exchange.max(&longest, 1);
    shortest = -longest;
}

void Simulation::fix(int direction, Hold hold, const std::function<bool(double)>& where) {
    const std::uint8_t across = direction == 0 ? fixed::r : fixed::z;
    const std::uint8_t bits = hold == Hold::both ? fixed::r | fixed::z : across;
    std::size_t node = 0;
    for (int j = 0; j < z_axis.nodes(); ++j)
        for (int i = 0; i < r_axis.nodes(); ++i, ++node)
            if (where(direction == 0 ? r_axis[i] : z_axis[j])) fixed_nodes[node] |= bits;
}

void Simulation::fix_below(int direction, double at, Hold hold) {
    fix(direction, hold, [at](double x) { return x <= at; });
}

void Simulation::fix_above(int direction, double at, Hold hold) {
    fix(direction, hold, [at](double x) { return x >= at; });
}

void Simulation::absorb(int direction, int line, double cell, const WaveSpeeds& speeds) {
    const int along = direction == 0 ? z_axis.nodes() : r_axis.nodes();
    for (int i = 0; i < along; ++i)
        absorbing_sides.add(static_cast<std::size_t>(direction == 0 ? i * r_axis.nodes() + line
                                                                    : line * r_axis.nodes() + i),
                            direction, cell, speeds);
}

void Simulation::absorb_first(int direction, const WaveSpeeds& speeds) {
    const Axis& axis = direction == 0 ? r_axis : z_axis;
    absorb(direction, 0, axis[1] - axis[0], speeds);
}

void Simulation::absorb_last(int direction, const WaveSpeeds& speeds) {
    const Axis& axis = direction == 0 ? r_axis : z_axis;
    const int last = axis.nodes() - 1;
    absorb(direction, last, axis[last] - axis[last - 1], speeds);
}

void Simulation::set_gravity(Vector gravity) {
    settings.gravity_r = gravity.r;
    settings.gravity_z = gravity.z;
}

// The next step is known already; it does not get longer than it was but by this share.
void Simulation::set_cfl(double cfl) {
    const double before = dt * (cfl / settings.cfl);
    settings.cfl = cfl;
    if (!started) return;
    decide_step();
    dt = std::min(dt, before);
}

Vector Simulation::traction_force(std::size_t body) const {
    std::array<Total, 2> sum;
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        if (tractions[i].body != body) continue;
        const EdgeForces& f = edge_loads[i];
        sum[0].add(f.f_r[0] + f.f_r[1], settings.fixed_point);
        sum[1].add(f.f_z[0] + f.f_z[1], settings.fixed_point);
    }
    exchange.sum(sum, settings.fixed_point);
    return {sum[0].value(), sum[1].value()};
}

double Simulation::damping_impulse(std::size_t body) const {
    if (!(settings.local_damping > 0.0)) return 0.0;
    std::array<Total, 1> sum;
    for (const NodeSums& of_strip : parts[body].node_sums) sum[0] += of_strip.damping_z;
    exchange.sum(sum, settings.fixed_point);
    return sum[0].value();
}

std::size_t Simulation::add_body(Body body) {
    Part part{.body = std::move(body), .strips = Strips(grid())};
    const auto strips = static_cast<std::size_t>(part.strips.count());
    part.records.resize(fixed_nodes.size());
    part.motions.resize(fixed_nodes.size());
    part.internal.resize(fixed_nodes.size());
    if (settings.fixed_point) {
        part.integers.resize(fixed_nodes.size());
        part.fixed_points.resize(strips);
        part.scale.fill(1.0);
    }
    part.gather_sums.resize(strips);
    part.speed.resize(strips);
    part.viscous_loss.resize(strips);
    part.material_seconds.resize(strips);
    part.most_stress.resize(strips);
    part.node_sums.resize(strips);
    part.increments.resize(strips);
    for (Increments& d : part.increments) {
        d = {};
        std::fill_n(d.rotation[8], Increments::capacity, 1.0);
    }
    const ParticleView q = part.body.particles.view();
    double extremes[] = {-std::numeric_limits<double>::infinity(), 0.0};  // -mass, volume
    for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p) {
        extremes[0] = std::max(extremes[0], -q[column::mass][p]);
        extremes[1] = std::max(extremes[1], q[column::V0][p]);
    }
    exchange.max(extremes, 2);
    part.least_mass = std::isfinite(extremes[0]) ? -1e-12 * extremes[0] : 0.0;
    if (part.body.material) part.separation = part.body.material->separation();
    if (settings.cell_mean && !part.body.rigid()) {
        part.cells.resize(static_cast<std::size_t>(r_axis.cells()) *
                          static_cast<std::size_t>(z_axis.cells()));
        part.mean.per_volume = 1.0 / extremes[1];
    }
    absorbing_sides.add_body();
    parts.push_back(std::move(part));
    particles_changed(parts.size() - 1);
    return parts.size() - 1;
}

void Simulation::particles_changed(std::size_t body) {
    Part& part = parts[body];
    const auto count = static_cast<std::size_t>(part.body.particles.size());
    part.by_id.resize(count);
    find_places(part);
    if (!part.cells.empty()) part.deferred.resize(count);
    drift = std::numeric_limits<double>::infinity();  // sorts before the next step
}

// A search: a process may have few of very many ids.
std::ptrdiff_t Simulation::find(std::size_t body, int id) const {
    const Part& part = parts[body];
    const int* ids = part.body.particles.ids();
    const auto at =
        std::lower_bound(part.by_id.begin(), part.by_id.end(), id,
                         [ids](std::ptrdiff_t p, int wanted) { return ids[p] < wanted; });
    return at != part.by_id.end() && ids[*at] == id ? *at : -1;
}

void Simulation::add_traction(Traction traction) {
    parts[traction.body].loads.resize(fixed_nodes.size());
    tractions.push_back(std::move(traction));
    edge_loads.resize(tractions.size());
}

void Simulation::add_contact(const ContactLaw& law) {
    contacts.emplace_back(law, settings, grid(), fixed_nodes);
}

void Simulation::add_contact(const PenaltyLaw& law) {
    if (&exchange != &alone)
        throw std::invalid_argument("penalty contact is for one process: its lines are not cut");
    penalties.emplace_back(law, settings.axisymmetric, fixed_nodes.size());
    for (const std::size_t body : {law.a, law.b}) {
        Part& part = parts[body];
        part.pressed.resize(static_cast<std::size_t>(part.strips.count()));
        if (!part.body.rigid()) part.ahead.resize(fixed_nodes.size());
    }
}

void Simulation::start() {
    started = true;
    sort();
    measure_speed();
    account();
    measure_energy();
    sums.kinetic_0 = sums.kinetic;
    sums.stored_0 = sums.stored;
}

void Simulation::step() {
    if (!started) start();
    Stopwatch watch;
    // Strips allow a row; one more step moves less than the other half.
    if (drift > 0.5 * z_axis.shortest()) sort();
    clear();
    if (settings.scheme == Scheme::usf) {
        scatter(part::mass | part::momentum | part::gradient);
        start_velocities();
        gather(task::deformation, dt);
        scatter(part::force);
    } else {
        scatter(part::all);
    }
    watch.lap(spent.scatter);
    push_contacts();
    watch.lap(spent.contact);
    keep_internal_forces();
    load();
    advance();
    push_absorbing();
    watch.lap(spent.nodes);
    correct_contacts();
    watch.lap(spent.contact);
    close();
    watch.lap(spent.nodes);
    move_contacts();
    watch.lap(spent.contact);
    if (settings.scheme == Scheme::musl) {
        gather(task::velocity, dt);
        remap();
        gather(task::position | task::deform_by_other, dt);
    } else if (settings.scheme == Scheme::usf) {
        gather(task::velocity | task::position, dt);
    } else {
        gather(task::all, dt);
    }
    t += dt;
    ++step_count;
    ++spent.steps;
    account();
    watch.lap(spent.gather);
}

Seconds Simulation::seconds() const {
    Seconds out = spent;
    for (const Part& part : parts)
        for (const double of_strip : part.material_seconds) out.material += of_strip / pool.size();
    return out;
}

Energy Simulation::energy() {
    if (!started) start();
    measure_energy();
    return sums;
}

}  // namespace grit::mpm
