// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace grit::mpm {

Simulation::Simulation(Axis r, Axis z, const Settings& given, Exchange* others)
    : settings(given), r_axis(std::move(r)), z_axis(std::move(z)),
      fixed_nodes(static_cast<std::size_t>(r_axis.nodes()) *
                  static_cast<std::size_t>(z_axis.nodes())),
      exchange(others ? *others : alone), pool(given.threads) {
    if (settings.axisymmetric && r_axis[0] < 0.0)
        throw std::invalid_argument("the grid must not reach across the axis");
    if (settings.axisymmetric && r_axis[0] == 0.0) fix_below(0, 0.0);
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

// The next step is known already.
void Simulation::set_cfl(double cfl) {
    dt = std::min(dt * (cfl / settings.cfl), settings.largest_step);
    settings.cfl = cfl;
}

Vector Simulation::traction_force(std::size_t body) const {
    Vector sum{0.0, 0.0};
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        if (tractions[i].body != body) continue;
        sum.r += loads[i].f_r[0] + loads[i].f_r[1];
        sum.z += loads[i].f_z[0] + loads[i].f_z[1];
    }
    return sum;
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
    part.slot.resize(static_cast<std::size_t>(part.body.particles.size()));
    part.gather_sums.resize(strips);
    part.speed.resize(strips);
    part.viscous_loss.resize(strips);
    part.most_stress.resize(strips);
    part.node_sums.resize(strips);
    part.increments.resize(strips);
    for (Increments& d : part.increments) {
        d = {};
        std::fill_n(d.rotation[8], Increments::capacity, 1.0);
    }
    const ParticleView q = part.body.particles.view();
    double lightest = part.body.particles.size() > 0 ? q[column::mass][0] : 0.0, largest = 0.0;
    for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p) {
        lightest = std::min(lightest, q[column::mass][p]);
        largest = std::max(largest, q[column::V0][p]);
    }
    part.least_mass = 1e-12 * lightest;
    if (part.body.material) part.separation = part.body.material->separation();
    if (settings.cell_mean && !part.body.rigid()) {
        part.cells.resize(static_cast<std::size_t>(r_axis.cells()) *
                          static_cast<std::size_t>(z_axis.cells()));
        part.deferred.resize(part.slot.size());
        exchange.max(&largest, 1);
        part.mean.per_volume = 1.0 / largest;
    }
    absorbing_sides.add_body();
    parts.push_back(std::move(part));
    return parts.size() - 1;
}

void Simulation::add_traction(Traction traction) {
    tractions.push_back(std::move(traction));
    loads.resize(tractions.size());
}

void Simulation::add_contact(const ContactLaw& law) {
    contacts.emplace_back(law, settings.axisymmetric, grid(), fixed_nodes);
}

void Simulation::add_contact(const PenaltyLaw& law) {
    penalties.emplace_back(law, settings.axisymmetric, fixed_nodes.size());
}

void Simulation::start() {
    started = true;
    sort();
    measure_speed();
    account();
    sums.kinetic_0 = sums.kinetic = kinetic_energy();
    sums.stored_0 = sums.stored = stored_energy();
}

void Simulation::step() {
    if (!started) start();
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
    push_contacts();
    keep_internal_forces();
    load();
    // What has just been touched is stiff already. With stress first, the step has begun.
    if (settings.scheme != Scheme::usf) dt = std::min(dt, stable_step());
    advance();
    push_absorbing();
    correct_contacts();
    close();
    move_contacts();
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
    account();
}

Energy Simulation::energy() {
    if (!started) start();
    sums.kinetic = kinetic_energy();
    sums.stored = stored_energy();
    return sums;
}

double Simulation::kinetic_energy() const {
    double sum = 0.0;
    for (const Part& part : parts) {
        const Particles& q = part.body.particles;
        for (std::ptrdiff_t p = 0; p < q.size() && !part.body.rigid(); ++p) {
            const double v_r = q(column::v_r, p), v_z = q(column::v_z, p);
            sum += 0.5 * q(column::mass, p) * (v_r * v_r + v_z * v_z);
        }
    }
    return sum;
}

double Simulation::stored_energy() const {
    double sum = 0.0;
    for (const Part& part : parts) {
        if (part.body.rigid()) continue;
        const ParticleView q = const_cast<Part&>(part).body.particles.view();
        for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p)
            sum += part.body.material->energy(q, p);
    }
    return sum;
}

}  // namespace grit::mpm
