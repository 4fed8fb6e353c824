// SPDX-License-Identifier: BSD-3-Clause
// Blocks that slide by Coulomb's law, in plane strain: a cube on a slope, and one that is pushed until it slips.
#pragma once

#include <vector>

#include "support/contact_kind.hpp"
#include "support/shapes.hpp"

namespace mpm_test {

// On a slope of 45 degrees, seen along it, from 5 m/s: 2 m wide, of E 7 GPa, on cells of 1 m.
struct SlidingCube {
    static constexpr double E = 7e9, nu = 0.3, g = 6.9296, mu = 0.5;
    ContactKind kind = ContactKind::geo;

    struct Result {
        double
            way;  // largest error at four times within 1 s, as a share of the way of a rigid cube
        double height;  // largest motion of its centre across the slope [m]
    };

    Result run() const {
        const Settings settings{.axisymmetric = false, .gravity_r = g, .gravity_z = -g};
        Simulation simulation(Axis::uniform(0.0, 11.0, 11), Axis::uniform(0.0, 6.0, 6), settings);
        simulation.add_body(make_floor({0.0, 11.0, 1.0, 2.0, 11, 1, 2650.0}, false));
        Body cube = make_box({1.0, 3.0, 2.0, 4.0, 4, 4, 2650.0}, false,
                             std::make_unique<LinearElastic>(E, nu));
        for (std::ptrdiff_t p = 0; p < cube.particles.size(); ++p)
            cube.particles.view()[column::v_r][p] = 5.0;
        simulation.add_body(std::move(cube));
        add_contact(simulation, kind, mu,
                    {p_wave_modulus(E, nu),
                     1.0,
                     {{{11.0, 2.0}, {0.0, 2.0}}},
                     {{{1.0, 2.0}, {3.0, 2.0}, {3.0, 4.0}, {1.0, 4.0}}, true}});
        Result out{0.0, 0.0};
        for (double until = 0.25; until <= 1.0; until += 0.25) {
            while (simulation.time() < until) simulation.step();
            const double t = simulation.time(), expected = 5.0 * t + 0.5 * g * (1.0 - mu) * t * t;
            const CentreOfMass now = centre_of_mass(simulation.body(1).particles);
            out.way = std::max(out.way, std::fabs((now.r - 2.0) / expected - 1.0));
            out.height = std::max(out.height, std::fabs(now.z - 3.0));
        }
        return out;
    }
};

// 1000 kg under 1000 N and a tangential load of 300 N/s: Coulomb's 300 N are reached after 1 s.
struct LoadedBlock {
    static constexpr double E = 1e7, nu = 0.3, mu = 0.3;
    ContactKind kind = ContactKind::geo;

    struct Result {
        double crept, creep_velocity;  // before it slips, at 0.99 s [m], [m/s]
        double slips_at;               // [s]
        double velocity, way;          // at 2 s, as shares of 0.15 m/s and 0.05 m
    };

    Result run() const {
        Simulation simulation(Axis::uniform(0.0, 2.0, 8), Axis::uniform(0.0, 1.5, 6),
                              {.axisymmetric = false});
        simulation.add_body(make_floor({0.0, 2.0, 0.25, 0.5, 8, 1, 2000.0}, false));
        simulation.add_body(make_box({0.5, 1.5, 0.5, 1.0, 8, 4, 2000.0}, false,
                                     std::make_unique<LinearElastic>(E, nu)));
        add_contact(simulation, kind, mu,
                    {p_wave_modulus(E, nu),
                     0.25,
                     {{{2.0, 0.5}, {0.0, 0.5}}},
                     {{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.0}, {0.5, 1.0}}, true}});
        for (int i = 0; i < 8; ++i)
            simulation.add_traction({1, 3 * 8 + i, Edge::top, [](double) {
                                         return grit::Vector2{0.0, -1000.0};
                                     }});
        simulation.set_body_force(
            [](ParticleView q, std::ptrdiff_t begin, std::ptrdiff_t end, double t) {
                for (std::ptrdiff_t p = begin; p < end; ++p) q[column::b_r][p] = 0.3 * t;
            });
        const auto now = [&] { return centre_of_mass(simulation.body(1).particles); };
        Result out{};
        while (simulation.time() < 0.99) simulation.step();
        out.crept = now().r - 1.0;
        out.creep_velocity = now().v_r;
        while (simulation.time() < 1.05) simulation.step();
        out.slips_at = simulation.time() -
                       std::sqrt(std::max(now().v_r, 0.0) / 0.15);  // v = 0.15 (t - t_slip)^2
        while (simulation.time() < 2.0) simulation.step();
        out.velocity = now().v_r / 0.15;
        out.way = (now().r - 1.0) / 0.05;
        return out;
    }
};

}  // namespace mpm_test
