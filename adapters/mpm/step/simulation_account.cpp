// SPDX-License-Identifier: BSD-3-Clause
// What holds for all particles of all processes: energies, lost particles, the next step.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "adapters/mpm/io/text.hpp"
#include "adapters/mpm/step/for_strips.hpp"
#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

void Simulation::measure_speed() {
    for_strips(pool, parts, [](Part& part, int strip) {
        const auto s = static_cast<std::size_t>(strip);
        const ParticleView q = part.body.particles.view();
        const std::ptrdiff_t end = part.strips.begin(strip + 1);
        double fastest = 0.0, most_v2 = 0.0;
        for (std::ptrdiff_t p = part.strips.begin(strip); p < end; ++p) {
            double modulus = 0.0;
            if (!part.body.rigid()) part.body.material->wave_moduli({q, p, p + 1}, &modulus);
            fastest = std::max(fastest, modulus * q[column::V0][p] * q.J(p) / q[column::mass][p]);
            const double v_r = q[column::v_r][p], v_z = q[column::v_z][p];
            most_v2 = std::max(most_v2, v_r * v_r + v_z * v_z);
        }
        part.speed[s] = std::sqrt(fastest);
        part.gather_sums[s].most_v2 = most_v2;
    });
}

// The first that is found; another process may have it.
void Simulation::report_lost(long count) const {
    std::string which;
    for (const Part& part : parts) {
        const Particles& q = part.body.particles;
        for (std::ptrdiff_t p = 0; p < q.size() && which.empty(); ++p) {
            const double r = q(column::r, p), z = q(column::z, p);
            const bool is_inside = r >= r_axis[0] && r <= r_axis[r_axis.nodes() - 1] &&
                                   z >= z_axis[0] && z <= z_axis[z_axis.nodes() - 1];
            if (is_inside) continue;
            which = ", among them particle " + std::to_string(q.ids()[p]) + " of body " +
                    part.body.name + " at r = " + std::to_string(r) +
                    " m, z = " + std::to_string(z) + " m";
        }
    }
    throw std::runtime_error(std::to_string(count) +
                             " particles left the grid at t = " + std::to_string(t) + " s" + which);
}

// v + c of a body, its largest ones wherever they are: however strips and processes cut it, the same.
void Simulation::find_largest() {
    constexpr std::size_t each = 3;  // c, v2, way along z
    maxima.assign(each * parts.size(), 0.0);
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t s = 0; s < parts[i].speed.size(); ++s) {
            const GatherSums& g = parts[i].gather_sums[s];
            double* of_body = &maxima[each * i];
            of_body[0] = std::max(of_body[0], parts[i].speed[s]);
            of_body[1] = std::max(of_body[1], g.most_v2);
            of_body[2] = std::max(of_body[2], g.most_dz);
        }
    exchange.max(maxima.data(), static_cast<int>(maxima.size()));
    largest_speed = 0.0;
    double way = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double* of_body = &maxima[each * i];
        largest_speed = std::max(largest_speed, of_body[0] + std::sqrt(of_body[1]));
        way = std::max(way, of_body[2]);
    }
    drift += way;
}

// Sums of all strips in their order, and the next step.
void Simulation::account() {
    enum {
        lost,
        external_work,
        traction_work,
        damping,
        viscosity,
        absorption,
        pic,
        transfer,
        count
    };
    std::array<Total, count> step;
    for (Part& part : parts)
        for (std::size_t s = 0; s < part.speed.size(); ++s) {
            const GatherSums& g = part.gather_sums[s];
            const NodeSums& n = part.node_sums[s];
            step[lost].add(g.outside, settings.fixed_point);
            (step[external_work] += g.body_work) += n.gravity_work;
            step[damping] += n.damping_work;
            step[viscosity] += part.viscous_loss[s];
            step[pic] += g.pic_loss;
            (((step[transfer] += n.change) -= g.kept) += g.pic_loss) += n.mapped_away;
        }
    (step[external_work] += load_work) += held_work;
    step[traction_work] += load_work;
    step[absorption] += absorbed;
    exchange.sum(step, settings.fixed_point);
    sums.external_work += step[external_work].value();
    sums.traction_work += step[traction_work].value();
    sums.damping += step[damping].value();
    sums.viscosity += step[viscosity].value();
    sums.absorbed += step[absorption].value();
    sums.pic += step[pic].value();
    sums.transfer += step[transfer].value();
    const double count_lost = step[lost].value();
    if (count_lost > 0.0) report_lost(static_cast<long>(count_lost));
    find_largest();
    dt_before = dt;
    find_penalty_forces();
    decide_step();
}

// What moves a rigid body in a step is its velocity at the end of the step.
void Simulation::decide_step() {
    dt = stable_step(std::max(largest_speed, rigid_speed(t)));
    while (std::isfinite(dt) && shorten_step()) {
    }
    if (!(dt > 0.0) || !std::isfinite(dt))
        throw std::runtime_error("no finite time step: is anything able to move?");
}

// By 1 % at the least, and no more than by half: an end that is much farther off says little.
bool Simulation::shorten_step() {
    const double limit = stable_step(std::max(largest_speed, rigid_speed(t + dt)));
    if (dt <= limit) return false;
    dt = std::max(0.5 * dt, std::min(0.99 * dt, limit));
    return true;
}

double Simulation::rigid_speed(double at) const {
    double speed = 0.0;
    for (const Part& part : parts) {
        if (!part.body.rigid()) continue;
        const Vector v = part.body.prescribed_velocity(at);
        const double size = std::hypot(v.r, v.z);
        if (!std::isfinite(size))
            throw std::runtime_error("body " + part.body.name +
                                     ": its prescribed velocity at t = " + text(at) + " s is (" +
                                     text(v.r) + ", " + text(v.z) + ") m/s");
        speed = std::max(speed, size);
    }
    return speed;
}

double Simulation::stable_step(double speed) const {
    double inverse2 = speed * speed / (shortest * shortest);
    for (const PenaltyPair& pair : penalties)
        inverse2 += 1.0 / (pair.stable_step() * pair.stable_step());
    return std::min(settings.cfl / std::sqrt(inverse2), settings.largest_step);
}

void Simulation::measure_energy() {
    std::array<Total, 2> energies;  // kinetic, stored
    for (Part& part : parts) {
        if (part.body.rigid()) continue;
        const ParticleView q = part.body.particles.view();
        for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p) {
            const double v_r = q[column::v_r][p], v_z = q[column::v_z][p];
            energies[0].add(0.5 * q[column::mass][p] * (v_r * v_r + v_z * v_z),
                            settings.fixed_point);
            energies[1].add(part.body.material->energy(q, p), settings.fixed_point);
        }
    }
    exchange.sum(energies, settings.fixed_point);
    sums.kinetic = energies[0].value();
    sums.stored = energies[1].value();
}

}  // namespace grit::mpm
