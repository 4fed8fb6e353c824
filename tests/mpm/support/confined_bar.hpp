// SPDX-License-Identifier: BSD-3-Clause
// V4: a confined bar that vibrates in its first mode.
#pragma once

#include <cmath>
#include <numbers>

#include "support/box.hpp"

namespace mpm_test {

// First mode of a bar fixed at z = 0 and confined at its side: error of its centre of mass, relative in
// the norm over time, and energy that it has lost or won.
struct ModeError {
    double velocity, energy, residual;
};

inline ModeError vibrate(int cells, bool axisymmetric, Scheme scheme = Scheme::usl,
                         double pic_rate = 0.0) {
    constexpr double E = 1e7, rho = 1000.0, L = 1.0, v0 = 0.1, period = 0.04;
    constexpr double pi = std::numbers::pi;
    const double c = std::sqrt(E / rho), h = L / cells;
    Settings settings{
        .axisymmetric = axisymmetric, .scheme = scheme, .cfl = 0.1, .pic_rate = pic_rate};
    Simulation simulation(Axis::uniform(0.0, h, 1), Axis::uniform(0.0, L + 2.0 * h, cells + 2),
                          settings);
    Body body = make_box({0.0, h, 0.0, L, 1, 2 * cells, rho}, axisymmetric,
                         std::make_unique<LinearElastic>(E, 0.0));
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
        q[column::v_z][p] = v0 * std::sin(0.5 * pi * q[column::z][p] / L);
    simulation.add_body(std::move(body));
    simulation.fix_below(0, 0.0);
    simulation.fix_above(0, h);
    simulation.fix_below(1, 0.0);
    const Particles& particles = simulation.body(0).particles;
    double difference = 0.0, size = 0.0;
    while (simulation.time() < 3.0 * period) {
        simulation.step();
        double momentum = 0.0, mass = 0.0;
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
            momentum += particles(column::mass, p) * particles(column::v_z, p);
            mass += particles(column::mass, p);
        }
        const double exact = v0 * 2.0 / pi * std::cos(0.5 * pi * c * simulation.time() / L);
        difference += std::pow(momentum / mass - exact, 2);
        size += exact * exact;
    }
    const Energy energy = simulation.energy();
    return {std::sqrt(difference / size), (energy.kinetic + energy.stored) / energy.kinetic_0 - 1.0,
            energy.residual() / energy.kinetic_0};
}

}  // namespace mpm_test
