// SPDX-License-Identifier: BSD-3-Clause
// An elastic disk that is put on a rigid slope, in plane strain, seen along the slope.
#pragma once

#include "support/contact_kind.hpp"
#include "support/shapes.hpp"

namespace mpm_test {

struct RollingDisk {
    static constexpr double g = 9.81, R = 0.5, rho = 1000.0, nu = 0.3;
    double angle = std::numbers::pi / 6.0, friction = 0.5;
    double E = 4e6;  // [Pa]
    ContactKind kind = ContactKind::geo;
    Scheme scheme = Scheme::usl;
    double cfl = 0.6, run_time = 1.0;  // [-], [s]

    // Along the slope from rest: g t^2 sin(angle) / 3 rolling, g t^2 (sin - mu cos) / 2 sliding.
    double acceleration() const {
        const bool rolls = std::tan(angle) <= 3.0 * friction;
        return rolls ? 2.0 / 3.0 * g * std::sin(angle)
                     : g * (std::sin(angle) - friction * std::cos(angle));
    }

    struct Result {
        double way;       // of what a rigid disk does [-]
        double residual;  // of the energy, as a share of the work of the weight [-]
    };

    // cells: in a radius, each with 2 x 2 particles.
    Result run(int cells) const {
        const double h = R / cells, length = R + 0.7 + 0.6 * acceleration() * run_time * run_time;
        const int n_r = static_cast<int>(std::ceil(length / h)), n_z = 2 * cells + 5;
        Simulation simulation(Axis::uniform(0.0, n_r * h, n_r), Axis::uniform(0.0, n_z * h, n_z),
                              {.axisymmetric = false,
                               .scheme = scheme,
                               .cfl = cfl,
                               .gravity_r = g * std::sin(angle),
                               .gravity_z = -g * std::cos(angle)});
        simulation.add_body(make_floor({0.0, n_r * h, h, 2.0 * h, n_r, 1, rho}, false));
        const grit::Vector2 middle{std::ceil(0.6 / h) * h, 2.0 * h + R};
        simulation.add_body(
            make_disk(middle, R, 2 * cells, rho, std::make_unique<LinearElastic>(E, nu)));
        PenaltyNeeds needs{p_wave_modulus(E, nu), h, {}, rim_of_disk(middle, R, 2 * cells)};
        needs.line_a.points = {{n_r * h, 2.0 * h}, {0.0, 2.0 * h}};
        add_contact(simulation, kind, friction, needs);
        const double start = centre_of_mass(simulation.body(1).particles).r;
        while (simulation.time() < run_time) simulation.step();
        const double t = simulation.time();
        const Energy energy = simulation.energy();
        return {(centre_of_mass(simulation.body(1).particles).r - start) /
                    (0.5 * acceleration() * t * t),
                energy.residual() / energy.external_work};
    }
};

}  // namespace mpm_test
