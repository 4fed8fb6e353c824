// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "adapters/mpm/space/kernel/place.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm::space {

void Simulation::step() {
    if (!started) start();
    Stopwatch watch;
    model.sort_if_moved();
    scatter();
    watch.lap(spent.scatter);
    loads.find();
    advance();
    watch.lap(spent.nodes);
    correct_contacts();
    watch.lap(spent.contact);
    damp_and_close();
    loads.find_work();
    watch.lap(spent.nodes);
    gather();
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
    measure_energy();
    energies.kinetic_0 = energies.kinetic;
    energies.stored_0 = energies.stored;
}

NodeCall Simulation::node_call(std::size_t body, std::size_t begin, std::size_t end) {
    Part& part = model.parts[body];
    return {part.records.data(),
            part.motions.data(),
            loads.forces(body),
            model.fixed_nodes.data(),
            static_cast<std::ptrdiff_t>(begin),
            static_cast<std::ptrdiff_t>(end),
            part.least_mass,
            model.dt,
            model.dt_before,
            model.gravity,
            model.settings.local_damping,
            model.settings.fixed_point,
            model.exchange.counted()};
}

// v = v_old + dt (f/m + g); rigid bodies have the velocity of the end of the step.
void Simulation::advance() {
    for (std::size_t body = 0; body < model.parts.size(); ++body)
        if (model.parts[body].body.rigid()) begin_rigid(body);
    model.for_nodes(
        [this](std::size_t body, std::size_t chunk, std::size_t begin, std::size_t end) {
            NodeSums& sums = node_sums[body][chunk] = {};
            Part& part = model.parts[body];
            if (!part.body.rigid()) return advance_nodes(node_call(body, begin, end), sums);
            model.set_rigid_nodes(part, begin, end);
        });
}

void Simulation::begin_rigid(std::size_t body) {
    RigidMotion& motion = *model.parts[body].body.motion;
    Twist load;
    if (const Vector3* force = loads.forces(body)) {
        TwistSum sum(model.settings.fixed_point);
        const std::uint8_t* mine = model.exchange.counted();
        for (std::size_t node = 0; node < model.nodes(); ++node) {
            if (mine && !mine[node]) continue;
            if (force[node][0] == 0.0 && force[node][1] == 0.0 && force[node][2] == 0.0) continue;
            const Vector3 impulse = model.dt * force[node];
            sum.add(
                {impulse, baseline::cross(model.place_of_node(node) - motion.centre(), impulse)});
        }
        load = sum.of_all(model.exchange);
    }
    motion.begin(model.t + model.dt, model.dt, model.gravity, load);
    energies.external_work += motion.energy_of_start();
    // What moves it as it is told works against its loads.
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const Twist& u = motion.velocity();
        if (!motion.free()[i]) energies.rigid_work -= load.along[k] * u.along[k];
        if (!motion.free()[i + 3]) energies.rigid_work -= load.about[k] * u.about[k];
    }
}

void Simulation::correct_contacts() {
    for (ContactPair& pair : contacts) {
        pair.correct(model);
        const grit_contact_totals& totals = pair.totals();
        energies.contact += totals.dissipation_normal + totals.dissipation_tangential;
        for (const std::size_t which : {pair.law().a, pair.law().b})
            if (const Body& body = model.parts[which].body; body.rigid())
                push_rigid(which, pair.impulse_on(which, body.motion->centre()),
                           pair.velocity_found());
    }
    surface_calls.clear();
    for (SurfacePair& pair : surfaces) pair.add_call(model, water, surface_calls);
    surface_calls.solve();
    for (SurfacePair& pair : surfaces) {
        if (!pair.was_called()) continue;
        pair.take_call(model);
        energies.contact += pair.totals().dissipation;
        for (const std::size_t which : {pair.law().a, pair.law().b})
            if (const Body& body = model.parts[which].body; body.rigid())
                push_rigid(which, pair.impulse_on(which, body.motion->centre()),
                           body.motion->velocity());
    }
    for (std::size_t body = 0; body < model.parts.size(); ++body)
        if (model.parts[body].body.rigid()) finish_rigid(body);
}

// What moves a rigid body works against the force that the body feels; where that moves it, contact took what it has
// for the velocity that it was found with, and the body ends with another one.
void Simulation::push_rigid(std::size_t body, const Twist& impulse, const Twist& found) {
    RigidMotion& motion = *model.parts[body].body.motion;
    const Twist trial = motion.velocity();
    motion.push(impulse);
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double along = impulse.along[k], about = impulse.about[k];
        if (motion.free()[i])
            energies.contact += 0.5 * along * (found.along[k] - motion.velocity().along[k]);
        else energies.rigid_work -= along * trial.along[k];
        if (motion.free()[i + 3])
            energies.contact += 0.5 * about * (found.about[k] - motion.velocity().about[k]);
        else energies.rigid_work -= about * trial.about[k];
    }
    if (!motion.any_free()) return;
    model.for_nodes([this, body](std::size_t of, std::size_t, std::size_t begin, std::size_t end) {
        if (of == body) model.set_rigid_nodes(model.parts[of], begin, end);
    });
}

void Simulation::finish_rigid(std::size_t body) {
    RigidMotion& motion = *model.parts[body].body.motion;
    for (int k = 0; k < 3; ++k)
        if (motion.free()[static_cast<std::size_t>(k)])
            energies.external_work +=
                0.5 * model.dt * motion.mass() * model.gravity[k] *
                (motion.velocity().along[k] + motion.velocity_before().along[k]);
    motion.finish(model.dt);
}

void Simulation::damp_and_close() {
    model.for_nodes(
        [this](std::size_t body, std::size_t chunk, std::size_t begin, std::size_t end) {
            if (model.parts[body].body.rigid()) return;
            const NodeCall call = node_call(body, begin, end);
            if (model.settings.local_damping > 0.0) damp_nodes(call, node_sums[body][chunk]);
            close_nodes(call, node_sums[body][chunk]);
        });
}

// Sums of the step that is done, and the size of the next one.
void Simulation::finish() {
    add_up();
    measure_speeds();
    model.dt_before = model.dt;
    decide_step();
}

// In the order of pencils and chunks, which no number of threads changes.
void Simulation::add_up() {
    enum {
        lost,
        external_work,
        traction_work,
        damping,
        viscosity,
        pic,
        transfer,
        pore_water,
        half_step,
        count
    };
    const bool fixed_point = model.settings.fixed_point;
    std::array<Total, count> step;
    for (std::size_t body = 0; body < model.parts.size(); ++body) {
        for (const Gather::OfPencil& pencil : gather.pencils(body)) {
            const GatherSums& g = pencil.sums;
            step[lost].add(static_cast<double>(g.outside), fixed_point);
            step[external_work] += g.body_work;
            step[viscosity] += pencil.viscous_loss;
            step[half_step] += pencil.half;
            step[pic] += g.pic_loss;
            (step[transfer] += g.pic_loss) -= g.kept;
        }
        for (const NodeSums& n : node_sums[body]) {
            step[external_work] += n.gravity_work;
            step[damping] += n.damping_work;
            (step[transfer] += n.change) += n.mapped_away;
        }
    }
    for (std::size_t body = 0; body < model.parts.size(); ++body)
        for (const Water::OfPencil& pencil : water.pencils(body)) {
            step[pore_water] += pencil.work;
            step[half_step] += pencil.half;
        }
    step[traction_work] += loads.work();
    model.exchange.sum(step, fixed_point);
    energies.external_work += step[external_work].value() + step[traction_work].value();
    energies.traction_work += step[traction_work].value();
    energies.damping += step[damping].value();
    energies.viscosity += step[viscosity].value();
    energies.pic += step[pic].value();
    energies.transfer += step[transfer].value();
    energies.pore_water += step[pore_water].value();
    energies.half = step[half_step].value();
    if (const double found = step[lost].value(); found > 0.0)
        report_lost(static_cast<std::ptrdiff_t>(found));
    // Sums in fixed point have an end, beyond which they are no numbers.
    if (!fixed_point) energies.check_finite(model.t);
}

// The first that is found; another process may have it.
void Simulation::report_lost(std::ptrdiff_t count) const {
    const GridView grid = model.grid();
    std::string which;
    for (const Part& part : model.parts) {
        const Particles& q = part.body.particles;
        for (std::ptrdiff_t p = 0; p < q.size() && which.empty(); ++p) {
            const Vector3 at{q(column::x, p), q(column::y, p), q(column::z, p)};
            if (grid.has(at)) continue;
            which = ", among them particle " + std::to_string(q.ids()[p]) + " of body " +
                    part.body.name + " at (" + text(at[0]) + ", " + text(at[1]) + ", " +
                    text(at[2]) + ") m";
        }
    }
    throw std::runtime_error(std::to_string(count) +
                             " particles left the grid at t = " + text(model.t) + " s" + which);
}

void Simulation::measure_speeds() {
    constexpr std::size_t each = 3;                     // c, v2, what pore water adds to c2 ...
    maxima.assign(each * model.parts.size() + 2, 0.0);  // ... and behind them ways along y and z
    double* way = maxima.data() + each * model.parts.size();
    for (std::size_t body = 0; body < model.parts.size(); ++body) {
        double* of_body = &maxima[each * body];
        for (const Gather::OfPencil& pencil : gather.pencils(body)) {
            of_body[0] = std::max(of_body[0], pencil.speed);
            of_body[1] = std::max(of_body[1], pencil.sums.most_v2);
            for (const std::size_t k : {0, 1}) way[k] = std::max(way[k], pencil.sums.farthest[k]);
        }
        of_body[2] = water.speed2(body);
    }
    model.exchange.max(maxima.data(), static_cast<int>(maxima.size()));
    largest_speed = 0.0;
    for (std::size_t body = 0; body < model.parts.size(); ++body) {
        const double* of_body = &maxima[each * body];
        const double more = of_body[2];
        const double c = more > 0.0 ? std::sqrt(of_body[0] * of_body[0] + more) : of_body[0];
        largest_speed = std::max(largest_speed, c + std::sqrt(of_body[1]));
    }
    for (const std::size_t k : {0, 1}) model.drift[k] += way[k];
}

double Simulation::fastest_rigid(double at) const {
    double fastest = 0.0;
    for (const Part& part : model.parts) {
        if (!part.body.rigid()) continue;
        const double size = part.body.motion->speed(at);
        if (!std::isfinite(size))
            throw std::runtime_error("body " + part.body.name +
                                     ": its velocity at t = " + text(at) + " s is no number");
        fastest = std::max(fastest, size);
    }
    return fastest;
}

double Simulation::stable(double at) const {
    const double speed = std::max(largest_speed, fastest_rigid(at));
    return std::min(model.settings.cfl * model.shortest / speed, model.settings.largest_step);
}

// By 1 % at the least, and no more than by half: an end that is much farther off says little.
bool Simulation::shorten_step() {
    const double limit = stable(model.t + model.dt);
    if (model.dt <= limit) return false;
    model.dt = std::max(0.5 * model.dt, std::min(0.99 * model.dt, limit));
    return true;
}

// What moves a rigid body in a step is its velocity at the end of the step.
void Simulation::decide_step() {
    model.dt = stable(model.t);
    while (std::isfinite(model.dt) && model.dt > 0.0 && shorten_step()) {
    }
    if (!std::isfinite(model.dt))
        throw std::runtime_error("no finite time step: is anything able to move?");
    if (!(model.dt > 0.0))
        throw std::runtime_error("no time step is short enough: something would move at " +
                                 text(std::max(largest_speed, fastest_rigid(model.t))) +
                                 " m/s at t = " + text(model.t) + " s, over cells of " +
                                 text(model.shortest) + " m");
}

void Simulation::measure_energy() {
    const bool fixed_point = model.settings.fixed_point;
    std::array<Total, 2> sums;  // kinetic, stored
    for (Part& part : model.parts) {
        if (part.body.rigid()) continue;
        const ParticleView q = part.body.particles.view();
        for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p) {
            const Vector3 v = q.vector(column::v_x, p);
            sums[0].add(0.5 * q[column::mass][p] * dot(v, v), fixed_point);
            sums[1].add(part.body.material->energy(q, p), fixed_point);
        }
    }
    model.exchange.sum(sums, fixed_point);
    for (const Part& part : model.parts)
        if (part.body.rigid()) sums[0].add(part.body.motion->kinetic_energy(), fixed_point);
    energies.kinetic = sums[0].value();
    energies.stored = sums[1].value();
}

Energy Simulation::energy() {
    if (!started) start();
    measure_energy();
    return energies;
}

std::size_t Simulation::add_body(Body body) {
    model.add_body(std::move(body));
    means.add_body();
    water.add_body();
    scatter.add_body();
    gather.add_body();
    loads.add_body();
    node_sums.emplace_back(model.chunks());
    return model.parts.size() - 1;
}

void Simulation::add_contact(const ContactLaw& law) {
    for (const std::size_t body : {law.a, law.b}) scatter.add_slopes(body);
    contacts.emplace_back(law, model);
}

void Simulation::add_contact(const SurfaceLaw& law) {
    for (const std::size_t body : {law.a, law.b})
        if (const Body& of = model.parts[body].body; of.rigid() && of.motion->any_free())
            throw std::invalid_argument("body " + of.name +
                                        ": what moves freely has no surface contact in space");
    surfaces.emplace_back(law, model);
}

void Simulation::fix(int direction, Hold hold, const std::function<bool(double)>& where) {
    const std::uint8_t bits = hold == Hold::all ? fixed::all : fixed::along(direction);
    const GridView grid = model.grid();
    std::vector<char> held;
    const Axis& along = axis(direction);
    for (int i = 0; i < along.nodes(); ++i) held.push_back(where(along[i]));
    for (std::size_t node = 0; node < model.fixed_nodes.size(); ++node) {
        const auto step = static_cast<std::size_t>(grid.step(direction));
        const std::size_t i = node / step % held.size();
        if (held[i]) model.fixed_nodes[node] |= bits;
    }
}

void Simulation::fix_below(int direction, double at, Hold hold) {
    fix(direction, hold, [at](double x) { return x <= at; });
}

void Simulation::fix_above(int direction, double at, Hold hold) {
    fix(direction, hold, [at](double x) { return x >= at; });
}

// The next step is known already; it does not get longer than it was but by this share.
void Simulation::set_cfl(double cfl) {
    const double before = model.dt * (cfl / model.settings.cfl);
    model.settings.cfl = cfl;
    if (!started) return;
    decide_step();
    model.dt = std::min(model.dt, before);
}

void Simulation::set_largest_step(double step) {
    model.settings.largest_step = step;
    if (started) model.dt = std::min(model.dt, step);
}

double Simulation::damping_impulse(std::size_t body) const {
    if (!(model.settings.local_damping > 0.0)) return 0.0;
    std::array<Total, 1> sum;
    for (const NodeSums& n : node_sums[body]) sum[0] += n.damping_z;
    model.exchange.sum(sum, model.settings.fixed_point);
    return sum[0].value();
}

Seconds Simulation::seconds() const {
    Seconds out = spent;
    for (std::size_t body = 0; body < model.parts.size(); ++body)
        for (const Gather::OfPencil& pencil : gather.pencils(body))
            out.material += pencil.material_seconds / model.pool.size();
    return out;
}

void Simulation::particles_changed(std::size_t body) {
    model.particles_changed(body);
    means.particles_changed(body);
    water.particles_changed(body);
}

void Simulation::index_ids() {
    for (Part& part : model.parts) part.index_ids();
}

}  // namespace grit::mpm::space
