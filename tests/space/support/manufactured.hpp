// SPDX-License-Identifier: BSD-3-Clause
// A solution of neo-Hookean dynamics in a unit cube, made by choosing the motion
//   u_i = G_i sin(pi X_i) sin(c pi t)
// and computing the body force that it needs.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "support/bricks.hpp"

namespace space_test {

class Manufactured {
  public:
    static constexpr double E = 1e7, nu = 0.3, rho = 1000.0, pi = std::numbers::pi;
    static constexpr double G[3] = {0.05, -0.05, 0.03};
    const double c = std::sqrt(E / rho);

    // Largest in time of the volume-weighted RMS of the displacement's error [m].
    static double run(int cells, const Settings& settings) {
        const Manufactured exact;
        Simulation simulation(cube_of_cells(1.0, cells), settings);
        Body body =
            make_brick({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {2 * cells, 2 * cells, 2 * cells}, rho},
                       std::make_unique<NeoHooke>(E, nu));
        const ParticleView initial = body.particles.view();
        std::vector<Vector3> X;
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            X.push_back(initial.position(p));
            for (int k = 0; k < 3; ++k)
                initial[column::v_x + k][p] = G[k] * std::sin(pi * X.back()[k]) * exact.c * pi;
        }
        simulation.add_body(std::move(body));
        for (int d = 0; d < 3; ++d) {
            simulation.fix_below(d, 0.0);
            simulation.fix_above(d, 1.0);
        }
        const Particles& particles = simulation.body(0).particles;
        simulation.set_body_force(
            [&](ParticleView q, std::ptrdiff_t begin, std::ptrdiff_t end, double t) {
                for (std::ptrdiff_t p = begin; p < end; ++p)
                    for (int k = 0; k < 3; ++k)
                        q[column::b_x + k][p] =
                            exact.body_force(X[static_cast<std::size_t>(particles.ids()[p])], k, t);
            });
        double largest = 0.0;
        while (simulation.time() < 1.0 / exact.c) {
            simulation.step();
            double sum = 0.0;
            for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
                for (int k = 0; k < 3; ++k) {
                    const double start = X[static_cast<std::size_t>(particles.ids()[p])][k];
                    const double error = particles(column::x + k, p) - start -
                                         exact.displacement(start, k, simulation.time());
                    sum += particles(column::V0, p) * error * error;
                }
            largest = std::max(largest, std::sqrt(sum));
        }
        return largest;
    }

  private:
    double displacement(double X, int k, double t) const {
        return G[k] * std::sin(pi * X) * std::sin(c * pi * t);
    }
    // rho0 b = rho0 u'' - DIV P, with P_i = lambda ln J / F_i + mu (F_i - 1/F_i).
    double body_force(const Vector3& X, int k, double t) const {
        const grit::mpm::LameConstants law = grit::mpm::lame_constants(E, nu);
        double F[3], log_J = 0.0;
        for (int i = 0; i < 3; ++i) {
            F[i] = 1.0 + G[i] * pi * std::cos(pi * X[i]) * std::sin(c * pi * t);
            log_J += std::log(F[i]);
        }
        const double u = displacement(X[k], k, t), dF = -pi * pi * u, f = F[k];
        const double dP_dF = -law.lambda * log_J / (f * f) + law.mu * (1.0 + 1.0 / (f * f));
        const double div = dP_dF * dF + law.lambda * (dF / f) / f;
        return -c * c * pi * pi * u - div / rho;
    }
};

}  // namespace space_test
