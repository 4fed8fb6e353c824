// SPDX-License-Identifier: BSD-3-Clause
// Two bars that stand inclined to the grid, one on the other, with particles of unlike size, pressed from both ends.
#pragma once

#include <cmath>
#include <memory>

#include "support/box.hpp"
#include "support/contact_kind.hpp"

namespace mpm_test {

struct InclinedBars {
    static constexpr double E = 10e6, rho = 2000.0, h = 0.1;
    static constexpr double length = 0.8, breadth = 0.6;
    ContactKind kind = ContactKind::surface;
    double angle = 0.3;  // of the bars' axis to z [rad]
    double friction_coefficient = 0.0;
    double pressure = 1e3;  // [Pa]
    double end =
        3.0;  // [s]; loaded in the first one, slowly: damping moves nodes after contact has

    // Largest difference of a component of stress from that of the pressure, as a share of it.
    double run() const {
        Simulation simulation(Axis::uniform(0.0, 2.0, 20), Axis::uniform(0.0, 2.4, 24),
                              {.axisymmetric = false, .cfl = 0.4, .local_damping = 0.05});
        const grit::Vector2 up{std::sin(angle), std::cos(angle)}, along{up[1], -up[0]};
        const grit::Vector2 middle{1.03, 1.17};  // of the interface
        for (const int k : {0, 1}) {
            const int across = k == 0 ? 7 : 11, high = k == 0 ? 15 : 9;
            const double l_1 = 0.5 * breadth / across, l_2 = 0.5 * length / high;
            Body body;
            auto elastic = std::make_unique<LinearElastic>(E, 0.0);
            body.particles = Particles(elastic->own_columns());
            for (int j = 0; j < high; ++j)
                for (int i = 0; i < across; ++i) {
                    const double x = (2 * i + 1 - across) * l_1;
                    const double y = (2 * j + 1) * l_2 - (k == 0 ? length : 0.0);
                    const grit::Vector2 at = middle + x * along + y * up;
                    body.particles.add({at[0], at[1], l_1, l_2, rho}, false);
                }
            const ParticleView q = body.particles.view();
            for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
                q[column::F_rr][p] = along[0];
                q[column::F_zr][p] = along[1];
                q[column::F_rz][p] = up[0];
                q[column::F_zz][p] = up[1];
            }
            body.material = std::move(elastic);
            simulation.add_body(std::move(body));
            const int first = k == 0 ? 0 : across * (high - 1);
            for (int i = 0; i < across; ++i)
                simulation.add_traction(
                    {static_cast<std::size_t>(k), first + i, k == 0 ? Edge::bottom : Edge::top,
                     [up, k, pressure = pressure](double t) {
                         const double x = std::min(t, 1.0);
                         return (k == 0 ? pressure : -pressure) * x * x * (3.0 - 2.0 * x) * up;
                     }});
        }
        add_contact(simulation, kind, friction_coefficient, {});
        while (simulation.time() < end) simulation.step();
        double worst = 0.0;
        for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
            const Particles& q = simulation.body(k).particles;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p)
                for (const auto& [c, n] : {std::pair{column::S_rr, up[0] * up[0]},
                                           std::pair{column::S_zz, up[1] * up[1]},
                                           std::pair{column::S_rz, up[0] * up[1]}})
                    worst = std::max(worst, std::fabs(q(c, p) / pressure + n));
        }
        return worst;
    }
};

}  // namespace mpm_test
