// SPDX-License-Identifier: BSD-3-Clause
// A rigid, frictionless, round punch embedded in an elastic body, its wall supported: how stiff it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "support/box.hpp"
#include "support/contact_kind.hpp"

namespace mpm_test {

struct Punch {
    static constexpr double E = 10e6, nu = 0.3, rho = 2000.0, R = 0.3;
    static constexpr double width = 6.0 * R, depth = 6.0 * R, embedded = 2.0 * R;
    ContactKind kind = ContactKind::surface;
    double cells = 4.4;               // in the radius
    double last_cell = 0.0;           // a grid line so far above the bottom [cells]; 0: none
    bool parted_below = true;         // the soil's particles, below the punch's edge
    double moved = 1e-3;              // [m]
    double rise = 0.05, rest = 0.10;  // [s]
    double power = 0.0;               // k of the Geo-contact; 0: its default

    // Force over displacement, all around [N/m].
    double stiffness() const {
        const double h = R / cells;
        const std::vector<double> r = nodes(h, width), down = nodes(h, depth);
        std::vector<double> z;
        for (std::size_t i = down.size(); i-- > 0;) {
            z.push_back(-down[i]);
            if (z.size() == 1 && last_cell > 0.0) z.push_back(last_cell * h - depth);
        }
        for (const int i : {1, 2}) z.push_back(i * h);
        Simulation simulation{
            Axis(r), Axis(z), {.axisymmetric = true, .cfl = 0.4, .local_damping = 0.4}};
        Body punch;
        fill(punch, h, {0.0, R}, {-embedded, 1.5 * h});
        const double speed = 2.0 * moved / rise, until = rise;
        punch.prescribed_velocity = [=](double t) {
            const double x = t / until;  // smooth at both ends
            return grit::Vector2{
                0.0, x < 1.0 ? -speed * std::pow(std::sin(3.141592653589793 * x), 2) : 0.0};
        };
        simulation.add_body(std::move(punch));
        Body soil;
        auto elastic = std::make_unique<LinearElastic>(E, nu);
        soil.particles = Particles(elastic->own_columns());
        const Range below{-depth, -embedded};
        if (parted_below) {
            fill(soil, h, {0.0, R}, below);
            fill(soil, h, {R, width}, below);
        } else {
            fill(soil, h, {0.0, width}, below);
        }
        fill(soil, h, {R, width}, {-embedded, 0.0});
        soil.material = std::move(elastic);
        simulation.add_body(std::move(soil));
        simulation.fix_below(1, -depth);
        simulation.fix_above(0, width);
        const double M = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
        const PenaltyNeeds needs{M,
                                 h,
                                 {{{0.0, -embedded}, {R, -embedded}, {R, h}}},
                                 {{{R, 0.0}, {R, -embedded}, {0.0, -embedded}}}};
        add_contact(simulation, kind, 0.0, needs, power);
        double impulse = 0.0, time = 0.0;
        while (simulation.time() < rise + rest) {
            const double t = simulation.time();
            simulation.step();
            const double dt = simulation.time() - t;
            if (t < rise + 0.8 * rest) continue;
            impulse -= dt * contact_force(simulation, kind, dt)[1];
            time += dt;
        }
        return 2.0 * 3.141592653589793 * impulse / time / moved;
    }

  private:
    // Lines h apart, the last one at the length.
    static std::vector<double> nodes(double h, double length) {
        std::vector<double> out;
        for (int i = 0; i * h < length - 0.5 * h; ++i) out.push_back(i * h);
        out.push_back(length);
        return out;
    }
    struct Range {
        double from, to;
    };
    // Particles of about half a cell that end where the box ends.
    static void fill(Body& body, double h, Range r, Range z) {
        const auto parts = [h](Range x) {
            return std::max(1, static_cast<int>(std::lround(2.0 * (x.to - x.from) / h)));
        };
        const int n_r = parts(r), n_z = parts(z);
        const double l_r = 0.5 * (r.to - r.from) / n_r, l_z = 0.5 * (z.to - z.from) / n_z;
        for (int j = 0; j < n_z; ++j)
            for (int i = 0; i < n_r; ++i)
                body.particles.add(
                    {r.from + (2 * i + 1) * l_r, z.from + (2 * j + 1) * l_z, l_r, l_z, rho}, true);
    }
};

}  // namespace mpm_test
