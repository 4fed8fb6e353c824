// SPDX-License-Identifier: BSD-3-Clause
// V3: a solution of axisymmetric neo-Hookean dynamics, made by choosing the motion
//   u_r = G sin(pi R) sin(c pi t),  u_z = G sin(pi Z) sin(c pi t + pi)
// and computing the body force that it needs.
#pragma once

#include <cmath>
#include <numbers>

#include "support/box.hpp"

namespace mpm_test {

struct ManufacturedErrors {
    double rms = 0.0;   // largest in time of the volume-weighted RMS of the displacement [m]
    double axis = 0.0;  // largest error of the particles at the axis [m]
};

class Manufactured {
  public:
    static constexpr double E = 1e7, nu = 0.3, rho = 1000.0, G = 0.05, pi = std::numbers::pi;
    const double c = std::sqrt(E / rho);

    static ManufacturedErrors run(int cells, const Settings& given) {
        const Manufactured exact;
        Settings settings = given;
        settings.axisymmetric = true;
        Simulation simulation(Axis::uniform(0.0, 1.0, cells), Axis::uniform(0.0, 1.0, cells),
                              settings);
        Body body = make_box({0.0, 1.0, 0.0, 1.0, 2 * cells, 2 * cells, rho}, true,
                             std::make_unique<NeoHooke>(E, nu));
        const ParticleView initial = body.particles.view();
        std::vector<double> R, Z;
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            R.push_back(initial[column::r][p]);
            Z.push_back(initial[column::z][p]);
            initial[column::v_r][p] = G * exact.c * pi * std::sin(pi * R.back());
            initial[column::v_z][p] = -G * exact.c * pi * std::sin(pi * Z.back());
        }
        simulation.add_body(std::move(body));
        simulation.fix_above(0, 1.0);
        simulation.fix_below(1, 0.0);
        simulation.fix_above(1, 1.0);
        const Particles& particles = simulation.body(0).particles;
        simulation.set_body_force(
            [&](ParticleView q, std::ptrdiff_t begin, std::ptrdiff_t end, double t) {
                for (std::ptrdiff_t p = begin; p < end; ++p) {
                    const auto id = static_cast<std::size_t>(particles.ids()[p]);
                    const grit::Vector2 b = exact.body_force(R[id], Z[id], t);
                    q[column::b_r][p] = b[0];
                    q[column::b_z][p] = b[1];
                }
            });
        ManufacturedErrors largest;
        while (simulation.time() < 2.0 / exact.c) {
            simulation.step();
            exact.compare(particles, R, Z, simulation.time(), largest);
        }
        return largest;
    }

  private:
    // rho0 b = rho0 u'' - DIV P, with P_i = lambda ln J / F_i + mu (F_i - 1/F_i).
    grit::Vector2 body_force(double R, double Z, double t) const {
        const LameConstants law = lame_constants(E, nu);
        const double s_r = std::sin(c * pi * t), s_z = std::sin(c * pi * t + pi);
        const double u_r = G * std::sin(pi * R) * s_r, u_z = G * std::sin(pi * Z) * s_z;
        const double F_r = 1.0 + G * pi * std::cos(pi * R) * s_r;
        const double F_z = 1.0 + G * pi * std::cos(pi * Z) * s_z, F_t = 1.0 + u_r / R;
        const double dF_r = -pi * pi * u_r, dF_z = -pi * pi * u_z, dF_t = (F_r - F_t) / R;
        const double log_J = std::log(F_r * F_z * F_t);
        const auto P = [&](double F) { return law.lambda * log_J / F + law.mu * (F - 1.0 / F); };
        const auto dP_dF = [&](double F) {
            return -law.lambda * log_J / (F * F) + law.mu * (1.0 + 1.0 / (F * F));
        };
        const double dlog_r = dF_r / F_r + dF_t / F_t, dlog_z = dF_z / F_z;
        const double div_r = dP_dF(F_r) * dF_r + law.lambda * dlog_r / F_r + (P(F_r) - P(F_t)) / R;
        const double div_z = dP_dF(F_z) * dF_z + law.lambda * dlog_z / F_z;
        const double omega2 = c * c * pi * pi;
        return grit::Vector2{-omega2 * u_r - div_r / rho, -omega2 * u_z - div_z / rho};
    }

    void compare(const Particles& q, const std::vector<double>& R, const std::vector<double>& Z,
                 double t, ManufacturedErrors& largest) const {
        double sum = 0.0, volume = 0.0;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            const auto id = static_cast<std::size_t>(q.ids()[p]);
            const double u_r = G * std::sin(pi * R[id]) * std::sin(c * pi * t);
            const double u_z = G * std::sin(pi * Z[id]) * std::sin(c * pi * t + pi);
            const double e_r = q(column::r, p) - R[id] - u_r, e_z = q(column::z, p) - Z[id] - u_z;
            const double e2 = e_r * e_r + e_z * e_z, V = q(column::V0, p);
            sum += V * e2;
            volume += V;
            if (R[id] < 1.5 * q(column::l_r, p))
                largest.axis = std::max(largest.axis, std::sqrt(e2));
        }
        largest.rms = std::max(largest.rms, std::sqrt(sum / volume));
    }
};

}  // namespace mpm_test
