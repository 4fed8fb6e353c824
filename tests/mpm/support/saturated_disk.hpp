// SPDX-License-Identifier: BSD-3-Clause
// A cylinder of saturated elastic sand between frictionless plates, loaded and drained all around: its pore pressure
// rises at first (Mandel 1953, Cryer 1963; in the plane de Leeuw 1965).
#pragma once

#include <cmath>
#include <vector>

#include <adapters/mpm/case/build_case.hpp>

#include "support/alternating.hpp"
#include "support/saturated_elastic.hpp"

namespace mpm_test {

struct SaturatedDisk {
    using Sand = SaturatedElastic;
    static constexpr double R = 1.0;
    int cells = 16;
    double conductivity = 1e-3;

    // At once, by the load: nothing has left yet.
    static double p_0() {
        constexpr double G = Sand::G, M = Sand::M;
        return 1.0 / ((1.0 + Sand::S * M) * (1.0 - G / M) + G / M);
    }

    // In the middle, by p_0, at T = c_v t/R^2. From (lambda + 2G) e - p = A(t), S p' + e' = k/(rho_w g) p'' and
    // A - 2G u(R)/R = -q follows p' + b mean(p)' = c_v div grad p, b = G/((M - G)(1 + S M)), whose solutions are
    // J0(a r/R) - J0(a), with J0(a) (1 + b) = 2 b J1(a)/a.
    static double exact(double T) {
        const auto J = [](int order, double x) { return std::cyl_bessel_j(order, x); };
        constexpr double b = Sand::b;
        const auto f = [&](double a) { return J(0, a) * (1.0 + b) - 2.0 * b * J(1, a) / a; };
        double sum = 0.0, before = 0.01;
        for (int found = 0; found < 40;) {
            const double next = before + 0.05;
            if (f(before) * f(next) < 0.0) {
                const double a = Sand::root(f, before, next), J0 = J(0, a), J1 = J(1, a);
                sum += J1 / a / (0.5 * (J0 * J0 + J1 * J1) - J0 * J1 / a) * (1.0 - J0) *
                       std::exp(-a * a * T);
                ++found;
            }
            before = next;
        }
        return sum;
    }

    struct Result {
        double T, pressure, exact, alternating, residual;
    };

    // The load comes within T = 0.01, and T counts from the middle of that.
    std::vector<Result> run(const std::vector<double>& times) const {
        constexpr double load = 1e4;
        const double h = R / cells, unit = R * R / Sand::c_v(conductivity), ramp = 0.01 * unit;
        Case plan;
        plan.name = "disk";
        plan.settings.cfl = 0.4;
        plan.gravity = 0.0;
        plan.r = {0.0, {{R + 2.0 * h, cells + 2, 1.0}}};
        plan.z = {0.0, {{h, 1, 1.0}}};
        for (const Side side : {Side::left, Side::bottom, Side::top})
            plan.boundary[static_cast<int>(side)] = Boundary::roller;
        plan.bodies = {Sand::box(R, h, conductivity, false)};
        plan.tractions = {{.body = "sand",
                           .edge = Edge::right,
                           .direction = {-1.0, 0.0},
                           .stress = TimeTable{{0.0, ramp}, {0.0, load}}}};
        plan.stages = {StagePlan{.name = "stage", .end = {.time = 1.0}}};
        plan.history.body = "sand";
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        std::vector<Result> out;
        for (const double T : times) {
            while (simulation.time() < T * unit + 0.5 * ramp) simulation.step();
            Body& sand = simulation.body(0);
            const Energy energy = simulation.energy();
            out.push_back({T,
                           sand.water->pressure(sand.particles.view(), simulation.find(0, 0)) /
                               (load * p_0()),
                           exact(T), alternating(pressures_along_r(simulation, 0)) / (load * p_0()),
                           energy.residual() / energy.external_work});
        }
        return out;
    }
};

}  // namespace mpm_test
