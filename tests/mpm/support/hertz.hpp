// SPDX-License-Identifier: BSD-3-Clause
// Hertz: an elastic paraboloid of radius R at its tip, pressed on a rigid plane.
#pragma once

#include <vector>

#include "support/contact_kind.hpp"
#include "support/shapes.hpp"

namespace mpm_test {

// From `from` to at least `to`: cells of h up to `fine`, then growing by a share each.
inline std::vector<double> graded(double from, double to, double h, double fine,
                                  double growth = 0.1) {
    std::vector<double> nodes{from};
    for (double length = h; nodes.back() < to; length *= nodes.back() < fine ? 1.0 : 1.0 + growth)
        nodes.push_back(nodes.back() + length);
    return nodes;
}

struct Hertz {
    static constexpr double E = 1e7, nu = 0.3, rho = 1000.0, R = 1.0, a = 0.05;
    int cells = 10;       // in a
    double width = 8.0;   // of the body, in a; as high as wide
    double beyond = 0.0;  // the plane above a grid line [cells]
    ContactKind kind = ContactKind::geo;
    double rise = 0.05, rest = 0.04;  // [s]

    struct Result {
        double force;             // [N], all around
        double radius, pressure;  // fitted a [m], p0 [Pa]
        double radius_error, pressure_error;
        double sum_error;  // of the pressures against the contact's own sum
    };

    Result run() const {
        const double h = a / cells, extent = width * a;
        const std::vector<double> r = graded(0.0, extent, h, 1.6 * a, 0.2);
        std::vector<double> z;
        for (int j = 4; j > 0; --j) z.push_back(-j * h);
        for (const double node : graded(0.0, extent * (1.0 + 0.5 * width * a / R), h, 1.2 * a, 0.2))
            z.push_back(node);
        const double surface = beyond * h;
        Simulation simulation(Axis(r), Axis(z),
                              {.axisymmetric = true, .cfl = 0.7, .local_damping = 0.5});
        simulation.add_body(make_floor(
            {0.0, r.back(), surface - 2.0 * h, surface, 2 * static_cast<int>(r.size()), 4, rho},
            true));
        simulation.add_body(make_body(r, z, surface));
        load(simulation, static_cast<int>(r.size()) - 1, r.back());
        PenaltyNeeds needs{p_wave_modulus(E, nu), h, {}, underside(r, surface)};
        needs.line_a.points = {{extent, surface}, {0.0, surface}};
        add_contact(simulation, kind, 0.0, needs);
        double dt = 0.0;
        while (simulation.time() < rise + rest) {
            const double t = simulation.time();
            simulation.step();
            dt = simulation.time() - t;
        }
        return evaluate(simulation, kind, r, surface, contact_force(simulation, kind, dt)[1]);
    }

    // Through the corners of the lowest row of particles.
    static BoundaryLine underside(const std::vector<double>& r, double tip) {
        BoundaryLine line;
        for (std::size_t i = 0; i + 1 < r.size(); ++i)
            for (const double x : {r[i], 0.5 * (r[i] + r[i + 1])})
                line.points.push_back({x, tip + x * x / (2.0 * R)});
        line.points.push_back({r.back(), tip + r.back() * r.back() / (2.0 * R)});
        return line;
    }

    // A pressure on the upper edge that Hertz expects to give a, applied slowly.
    void load(Simulation& simulation, int across, double edge) const {
        const double force = 4.0 / 3.0 * E / (1.0 - nu * nu) * a * a * a / R;
        const double pressure = force / (std::numbers::pi * edge * edge);
        const auto count = static_cast<int>(simulation.body(1).particles.size());
        const double rising = rise;
        for (int i = 0; i < 2 * across; ++i)
            simulation.add_traction(
                {1, count - 2 * across + i, Edge::top, [=](double t) {
                     const double x = std::min(t / rising, 1.0);
                     return grit::Vector2{0.0, -pressure * x * x * (3.0 - 2.0 * x)};
                 }});
    }

    static constexpr std::size_t top_rows = 8;  // of cells, for the rise of its upper edge
    static Body make_body(const std::vector<double>& r, const std::vector<double>& z, double tip) {
        Body body;
        for (std::size_t j = 4; j + top_rows < z.size(); ++j)
            for (const double y : {0.25, 0.75})
                for (std::size_t i = 0; i + 1 < r.size(); ++i)
                    for (const double x : {0.25, 0.75}) {
                        const double l_r = 0.25 * (r[i + 1] - r[i]), l_z = 0.25 * (z[j + 1] - z[j]);
                        const double middle = r[i] + 4.0 * x * l_r;
                        const double bottom = tip + (middle * middle + l_r * l_r) / (2.0 * R);
                        add_parallelogram(body.particles, {middle, bottom + z[j] + 4.0 * y * l_z},
                                          {l_r, l_r * middle / R}, {0.0, l_z}, rho, true);
                    }
        body.material = std::make_unique<LinearElastic>(E, nu);
        return body;
    }

    // At rest contact balances the inner forces at the nodes that both bodies reach. Penalty contact has its force
    // among these: there pressure is what the springs of its vertices say.
    static Result evaluate(const Simulation& simulation, ContactKind kind,
                           const std::vector<double>& r, double surface, double force) {
        Result out = kind == ContactKind::penalty ? by_springs(simulation, surface)
                                                  : by_nodes(simulation, r);
        out.sum_error = out.force / force - 1.0;
        out.force = 2.0 * std::numbers::pi * force;
        const double stiffness = E / (1.0 - nu * nu);
        const double radius = std::cbrt(0.75 * out.force * R / stiffness);
        out.radius_error = out.radius / radius - 1.0;
        out.pressure_error =
            out.pressure / (1.5 * out.force / (std::numbers::pi * radius * radius)) - 1.0;
        return out;
    }
    // Fitted radius and pressure, and the sum of all pressures per radian.
    static Result by_nodes(const Simulation& simulation, const std::vector<double>& r) {
        const std::size_t n = r.size();
        std::vector<double> pressure(n);
        double sum = 0.0;
        for (std::size_t node = 0; node < simulation.records(1).size(); ++node)
            if (simulation.records(0)[node][record::m] > 0.0 &&
                simulation.records(1)[node][record::m] > 0.0) {
                pressure[node % n] -= simulation.records(1)[node][record::f_z];
                sum -= simulation.records(1)[node][record::f_z];
            }
        for (std::size_t i = 0; i < n; ++i) {
            const double before = i > 0 ? r[i - 1] : r[0], behind = i + 1 < n ? r[i + 1] : r[i];
            // Integral of the hat function times r.
            const double area = ((behind - r[i]) * (2.0 * r[i] + behind) +
                                 (r[i] - before) * (2.0 * r[i] + before)) /
                                6.0;
            pressure[i] /= area;
        }
        Result out = fit(r, pressure);
        out.force = sum;
        return out;
    }
    static Result by_springs(const Simulation& simulation, double surface) {
        const std::vector<double>& x = simulation.penalty_contact(0).vertices(1);
        const double eps = simulation.penalty_contact(0).law().options.normal_stiffness;
        std::vector<double> r, pressure;
        double sum = 0.0;
        for (std::size_t v = 0; v < x.size(); v += 2) {
            r.push_back(x[v]);
            pressure.push_back(std::max(eps * (surface - x[v + 1]), 0.0));
            const std::size_t i = r.size() - 1;
            if (i > 0)
                sum += 0.5 * (r[i] - r[i - 1]) * (pressure[i] * r[i] + pressure[i - 1] * r[i - 1]);
        }
        Result out = fit(r, pressure);
        out.force = sum;
        return out;
    }

    // p0 sqrt(1 - r^2/a^2) by least squares: p0 follows from a, and a is found by trying.
    static Result fit(const std::vector<double>& r, const std::vector<double>& pressure) {
        Result best{};
        double least = 1e300;
        for (double radius = 0.5 * a; radius < 1.5 * a; radius += 1e-4 * a) {
            double with = 0.0, square = 0.0, all = 0.0;
            for (std::size_t i = 0; i < r.size(); ++i) {
                const double shape =
                    std::sqrt(std::max(0.0, 1.0 - r[i] * r[i] / (radius * radius)));
                with += shape * pressure[i];
                square += shape * shape;
                all += pressure[i] * pressure[i];
            }
            const double misfit = all - with * with / square;
            if (misfit < least) {
                least = misfit;
                best.radius = radius;
                best.pressure = with / square;
            }
        }
        return best;
    }
};

}  // namespace mpm_test
