// SPDX-License-Identifier: BSD-3-Clause
// A cylinder of saturated elastic sand between frictionless plates, loaded and drained all around: its pore pressure
// rises at first (Mandel 1953, Cryer 1963; in the plane de Leeuw 1965).
#pragma once

#include <cmath>
#include <vector>

#include "support/saturated_column.hpp"

namespace mpm_test {

struct SaturatedDisk {
    static constexpr double E = 10e6, nu = 0.2, K_w = 2.2e9, n = 0.4, R = 1.0;
    static constexpr double G = 0.5 * E / (1.0 + nu);
    static constexpr double M = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)), S = n / K_w;
    int cells = 16;
    double conductivity = 1e-3;

    double c_v() const { return conductivity / (1000.0 * standard_gravity * (1.0 / M + S)); }
    // At once, by the load: nothing has left yet.
    static double p_0() { return 1.0 / ((1.0 + S * M) * (1.0 - G / M) + G / M); }

    // In the middle, by p_0, at T = c_v t/R^2. From (lambda + 2G) e - p = A(t), S p' + e' = k/(rho_w g) p'' and
    // A - 2G u(R)/R = -q follows p' + b mean(p)' = c_v div grad p, b = G/((M - G)(1 + S M)), whose solutions are
    // J0(a r/R) - J0(a), with J0(a) (1 + b) = 2 b J1(a)/a.
    static double exact(double T) {
        constexpr double b = G / ((M - G) * (1.0 + S * M));
        const auto J = [](int order, double x) { return std::cyl_bessel_j(order, x); };
        const auto f = [&](double a) { return J(0, a) * (1.0 + b) - 2.0 * b * J(1, a) / a; };
        double sum = 0.0, before = 0.01;
        for (int found = 0; found < 40;) {
            const double next = before + 0.05;
            if (f(before) * f(next) < 0.0) {
                double low = before, high = next;
                for (int i = 0; i < 60; ++i) {
                    const double middle = 0.5 * (low + high);
                    (f(low) * f(middle) <= 0.0 ? high : low) = middle;
                }
                const double a = low, J0 = J(0, a), J1 = J(1, a);
                sum += J1 / a / (0.5 * (J0 * J0 + J1 * J1) - J0 * J1 / a) * (1.0 - J0) *
                       std::exp(-a * a * T);
                ++found;
            }
            before = next;
        }
        return sum;
    }

    struct Result {
        double T, pressure, exact, residual;
    };

    // The load comes within T = 0.01, and T counts from the middle of that.
    std::vector<Result> run(const std::vector<double>& times) const {
        constexpr double load = 1e4;
        const double h = R / cells, unit = R * R / c_v(), ramp = 0.01 * unit;
        Case plan;
        plan.name = "disk";
        plan.settings.cfl = 0.4;
        plan.gravity = 0.0;
        plan.r = {0.0, {{R + 2.0 * h, cells + 2, 1.0}}};
        plan.z = {0.0, {{h, 1, 1.0}}};
        for (const Side side : {Side::left, Side::bottom, Side::top})
            plan.boundary[static_cast<int>(side)] = Boundary::roller;
        BodyPlan body{};
        body.name = "sand";
        body.outlines = {Outline{{{0.0, 0.0}, {R, 0.0}, {R, h}, {0.0, h}}}};
        body.density = 1590.0;
        body.material = ElasticPlan{E, nu};
        body.water = WaterPlan{.drainage = Drainage::flow,
                               .bulk_modulus = K_w,
                               .grain_density = 2650.0,
                               .porosity = n,
                               .conductivity = conductivity};
        plan.bodies = {body};
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
                           exact(T), energy.residual() / energy.external_work});
        }
        return out;
    }
};

}  // namespace mpm_test
