// SPDX-License-Identifier: BSD-3-Clause
// Mandel's slab (1953), in plane strain: saturated elastic sand between rigid plates without friction that a force presses
// together, drained at its sides. Half of it, and above its middle.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <adapters/mpm/case/build_case.hpp>

#include "support/alternating.hpp"
#include "support/saturated_elastic.hpp"

namespace mpm_test {

struct MandelSlab {
    using Sand = SaturatedElastic;
    static constexpr double a = 1.0;
    int cells = 16, rows = 2;
    double conductivity = 1e-4;  // slow: beside the time of waves through it
    bool implicit = false;

    // Of the load on the plates, compression positive: by it at once.
    static double p_0() { return 0.5 / (1.0 + Sand::S * (Sand::M - Sand::G)); }
    // The share of p_0 at x and T = c_v t/a^2, of a load that comes as (1 - cos(pi T/ramp))/2.
    //
    // u_z = -eps z. No total stress along x: M e = p + 2G eps_zz; the plates: 4G eps_zz - 2G mean(e) = -q. With
    // S p' + e' = k/(rho_w g) p_xx follows p' + b mean(p)' = c_v p_xx, b = G/((M - G)(1 + S M)): modes
    // cos(s x/a) - cos(s), (1 + b) cos s = b sin(s)/s, whose shares of a constant are Mandel's.
    static double exact(double x, double T, double ramp) {
        constexpr double b = Sand::b;
        const auto f = [&](double s) { return (1.0 + b) * std::cos(s) * s - b * std::sin(s); };
        const double w = std::acos(-1.0) / ramp;
        double sum = 0.0;
        for (int i = 0; i < 40; ++i) {
            const double low = i == 0 ? 1e-3 : (i + 1e-9) * std::acos(-1.0);
            const double s = Sand::root(f, low, (i + 0.5) * std::acos(-1.0)), decay = s * s;
            const double reached = 0.5 * w * w *
                                   (std::exp(-decay * (T - ramp)) + std::exp(-decay * T)) /
                                   (decay * decay + w * w);
            sum += 2.0 * std::sin(s) / (s - std::sin(s) * std::cos(s)) *
                   (std::cos(s * x / a) - std::cos(s)) * reached;
        }
        return sum;
    }

    struct Result {
        double T, pressure, exact;  // of the middle by p_0
        double profile_error;       // of all cells of the lowest row, RMS, by p_0
        double alternating;         // of them, by p_0
        double residual;            // of the energy, by the work of the load
    };

    std::vector<Result> run(const std::vector<double>& times) const {
        constexpr double load = 1e2, ramp = 0.05;
        const double h = a / cells, height = rows * h, unit = a * a / Sand::c_v(conductivity);
        Case plan;
        plan.name = "mandel";
        plan.settings.cfl = 0.4;
        plan.settings.axisymmetric = false;
        plan.gravity = 0.0;
        plan.r = {0.0, {{a + 2.0 * h, cells + 2, 1.0}}};
        plan.z = {0.0, {{height + h, rows + 1, 1.0}}};
        for (const Side side : {Side::left, Side::bottom})
            plan.boundary[static_cast<int>(side)] = Boundary::roller;
        plan.boundary[static_cast<int>(Side::top)] = Boundary::platen;
        plan.platen_level[static_cast<int>(Side::top)] = height;
        plan.bodies = {Sand::box(a, height, conductivity, implicit)};
        TimeTable table;
        for (int i = 0; i <= 64; ++i) {
            table.time.push_back(ramp * unit * i / 64.0);
            table.value.push_back(0.5 * load * (1.0 - std::cos(std::acos(-1.0) * i / 64.0)));
        }
        plan.tractions = {
            {.body = "sand", .edge = Edge::top, .direction = {0.0, -1.0}, .stress = table}};
        plan.stages = {StagePlan{.name = "stage", .end = {.time = 1.0}}};
        plan.history.body = "sand";
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        std::vector<Result> out;
        for (const double T : times) {
            while (simulation.time() < T * unit) simulation.step();
            Body& sand = simulation.body(0);
            const ParticleView q = sand.particles.view();
            std::vector<double> sum(static_cast<std::size_t>(cells)), count(sum.size());
            for (std::ptrdiff_t p = 0; p < sand.particles.size(); ++p) {
                const auto cell = static_cast<std::size_t>(
                    std::min(static_cast<int>(q[column::r][p] / h), cells - 1));
                sum[cell] += sand.water->pressure(q, p) / (load * p_0());
                count[cell] += 1.0;
            }
            double squares = 0.0;
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i] /= count[i];
                const double x = (static_cast<double>(i) + 0.5) * h;
                const double error = sum[i] - exact(x, simulation.time() / unit, ramp);
                squares += error * error;
            }
            const Energy energy = simulation.energy();
            out.push_back({T, sum[0], exact(0.5 * h, simulation.time() / unit, ramp),
                           std::sqrt(squares / cells), alternating(sum),
                           energy.residual() / energy.external_work});
        }
        return out;
    }
};

}  // namespace mpm_test
