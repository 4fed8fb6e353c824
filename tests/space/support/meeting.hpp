// SPDX-License-Identifier: BSD-3-Clause
// Bodies that meet in space.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <grit/contact.h>

#include "support/bricks.hpp"

namespace space_test {

inline ContactLaw nodal_law(int law, double mu, std::size_t stiff, std::size_t soft) {
    ContactLaw out = grit::mpm::contact_law(law, mu);
    out.a = stiff;
    out.b = soft;
    return out;
}

// A cube that slides down a slope of 45 degrees, along a diagonal of the grid's lower plane, from 5 m/s; 2 m wide, of E
// 7 GPa, on cells of 1 m.
struct SlidingCube {
    static constexpr double E = 7e9, nu = 0.3, g = 6.9296, mu = 0.5;
    int law = GRIT_CONTACT_GEO;

    struct Result {
        double
            way;  // largest error at two times within 0.5 s, as a share of the way of a rigid cube
        double across;  // largest motion of its centre off its course [m]
    };

    Result run() const {
        const double part = 1.0 / std::numbers::sqrt2;
        Simulation simulation(
            {Axis::uniform(0.0, 8.0, 8), Axis::uniform(0.0, 8.0, 8), Axis::uniform(0.0, 6.0, 6)},
            {});
        simulation.set_gravity({part * g, part * g, -g});
        simulation.add_body(make_floor({{0.0, 0.0, 1.0}, {8.0, 8.0, 2.0}, {8, 8, 1}}));
        Body cube = make_brick({{1.0, 1.0, 2.0}, {3.0, 3.0, 4.0}, {4, 4, 4}, 2650.0},
                               std::make_unique<LinearElastic>(E, nu));
        for (std::ptrdiff_t p = 0; p < cube.particles.size(); ++p)
            for (const int v : {column::v_x, column::v_y}) cube.particles.view()[v][p] = part * 5.0;
        simulation.add_body(std::move(cube));
        simulation.add_contact(nodal_law(law, mu, 0, 1));
        Result out{0.0, 0.0};
        for (const double until : {0.25, 0.5}) {
            while (simulation.time() < until) simulation.step();
            const double t = simulation.time(), expected = 5.0 * t + 0.5 * g * (1.0 - mu) * t * t;
            const Vector3 way =
                centre_of_mass(simulation.body(1).particles) - Vector3{2.0, 2.0, 3.0};
            out.way = std::max(out.way, std::fabs(part * (way[0] + way[1]) / expected - 1.0));
            out.across = std::max({out.across, std::fabs(way[2]), std::fabs(way[0] - way[1])});
        }
        return out;
    }
};

// Hertz: a quarter of an elastic paraboloid of radius R at its tip, pressed on a rigid plane.
struct Hertz {
    static constexpr double E = 1e7, nu = 0.3, rho = 1000.0, R = 1.0, a = 0.05;
    int cells = 3;       // in a
    double width = 4.0;  // of the body, in a; as high as wide
    int law = GRIT_CONTACT_GEO;
    double rise = 0.05, rest = 0.04;  // [s]

    struct Result {
        double force;                         // of the plane on the body, all around [N]
        double sum_error;                     // of that against the contact's own sum
        double radius_error, pressure_error;  // against what Hertz has for that force
        double askew;  // largest difference of pressures across the diagonal, as a share of p0
    };

    // From `from` to at least `to`: cells of h up to `fine`, then growing by a share each.
    static std::vector<double> graded(double from, double to, double h, double fine) {
        std::vector<double> nodes{from};
        for (double length = h; nodes.back() < to; length *= nodes.back() < fine ? 1.0 : 1.2)
            nodes.push_back(nodes.back() + length);
        return nodes;
    }

    Result run() const {
        const double h = a / cells, extent = width * a;
        const std::vector<double> across = graded(0.0, extent, h, 1.6 * a);
        std::vector<double> up{-2.0 * h, -h};
        const double rise_of_edge = across.back() * across.back() / R;
        for (const double node : graded(0.0, extent + 1.5 * rise_of_edge, h, 1.2 * a))
            up.push_back(node);
        Simulation simulation({Axis(across), Axis(across), Axis(up)},
                              {.cfl = 0.7, .local_damping = 0.5});
        Body plane;
        for (std::size_t j = 0; j + 1 < across.size(); ++j)
            for (std::size_t i = 0; i + 1 < across.size(); ++i)
                add_brick(plane.particles, {{across[i], across[j], -2.0 * h},
                                            {across[i + 1], across[j + 1], 0.0},
                                            {2, 2, 4}});
        plane.make_rigid({});
        simulation.add_body(std::move(plane));
        simulation.add_body(make_body(across, up, extent));
        for (const int d : {0, 1}) simulation.fix_below(d, 0.0);
        press(simulation, 2 * static_cast<int>(across.size()) - 2);
        simulation.add_contact(nodal_law(law, 0.0, 0, 1));
        double dt = 0.0;
        while (simulation.time() < rise + rest) {
            dt = simulation.next_step();
            simulation.step();
        }
        return evaluate(simulation, across,
                        4.0 * simulation.contact(0).totals().impulse_on_b[2] / dt);
    }

  private:
    static Body make_body(const std::vector<double>& across, const std::vector<double>& up,
                          double height) {
        Body body;
        for (std::size_t k = 2; k + 1 < up.size() && up[k + 1] <= height * (1.0 + 1e-9); ++k)
            for (const double z : {0.25, 0.75})
                for (std::size_t j = 0; j + 1 < across.size(); ++j)
                    for (const double y : {0.25, 0.75})
                        for (std::size_t i = 0; i + 1 < across.size(); ++i)
                            for (const double x : {0.25, 0.75}) {
                                const Vector3 l{0.25 * (across[i + 1] - across[i]),
                                                0.25 * (across[j + 1] - across[j]),
                                                0.25 * (up[k + 1] - up[k])};
                                Vector3 at{across[i] + 4.0 * x * l[0], across[j] + 4.0 * y * l[1],
                                           up[k] + 4.0 * z * l[2]};
                                // Its bottom is a chord of the paraboloid over its four corners.
                                at[2] +=
                                    (at[0] * at[0] + l[0] * l[0] + at[1] * at[1] + l[1] * l[1]) /
                                    (2.0 * R);
                                const std::ptrdiff_t p = body.particles.size();
                                body.particles.add({at, l, rho});
                                body.particles.view()[column::F_zx][p] = at[0] / R;
                                body.particles.view()[column::F_zy][p] = at[1] / R;
                            }
        body.material = std::make_unique<LinearElastic>(E, nu);
        return body;
    }

    // A pressure on the upper faces that Hertz expects to give a, applied slowly.
    void press(Simulation& simulation, int rows) const {
        const double load = E / (1.0 - nu * nu) * a * a * a / (3.0 * R);
        const Particles& q = simulation.body(1).particles;
        const std::ptrdiff_t first = q.size() - std::ptrdiff_t{rows} * rows;
        double area = 0.0;
        for (std::ptrdiff_t p = first; p < q.size(); ++p)
            area += 4.0 * q(column::l_x, p) * q(column::l_y, p);
        for (std::ptrdiff_t p = first; p < q.size(); ++p)
            simulation.add_traction(
                {1, static_cast<int>(p), {2, true}, [=, rising = rise](double t) {
                     const double x = std::min(t / rising, 1.0);
                     return Vector3{0.0, 0.0, -load / area * x * x * (3.0 - 2.0 * x)};
                 }});
    }

    Result evaluate(const Simulation& simulation, const std::vector<double>& across,
                    double own_sum) const {
        // At rest contact balances the inner forces at the nodes that both bodies reach.
        const std::size_t n = across.size();
        std::vector<double> force(n * n);
        double sum = 0.0;
        for (std::size_t node = 0; node < simulation.records(1).size(); ++node)
            if (simulation.records(0)[node][record::m] > 0.0 &&
                simulation.records(1)[node][record::m] > 0.0) {
                const std::size_t column = node % (n * n);
                force[column] -= simulation.records(1)[node][record::f_z];
                sum -= simulation.records(1)[node][record::f_z];
            }
        const auto hat = [&](std::size_t i) {  // integral of the hat function
            return 0.5 * (across[std::min(i + 1, n - 1)] - across[i > 0 ? i - 1 : 0]);
        };
        Result out{4.0 * sum, 4.0 * sum / own_sum - 1.0, 0.0, 0.0, 0.0};
        const double radius = std::cbrt(0.75 * out.force * R * (1.0 - nu * nu) / E);
        const double p0 = 1.5 * out.force / (std::numbers::pi * radius * radius);
        std::vector<double> r, pressure, area;
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < n; ++i) {
                area.push_back(hat(i) * hat(j));
                r.push_back(std::hypot(across[i], across[j]));
                pressure.push_back(force[j * n + i] / area.back());
                out.askew = std::max(
                    out.askew, std::fabs(pressure.back() - force[i * n + j] / area.back()) / p0);
            }
        // p0 sqrt(1 - r^2/a^2) by least squares over areas: p0 follows from a, and a is found by trying.
        double least = 1e300;
        for (double trial = 0.5 * radius; trial < 1.5 * radius; trial += 1e-3 * radius) {
            double with = 0.0, square = 0.0, all = 0.0;
            for (std::size_t i = 0; i < r.size(); ++i) {
                const double shape = std::sqrt(std::max(0.0, 1.0 - r[i] * r[i] / (trial * trial)));
                with += area[i] * shape * pressure[i];
                square += area[i] * shape * shape;
                all += area[i] * pressure[i] * pressure[i];
            }
            const double misfit = all - with * with / square;
            if (misfit >= least) continue;
            least = misfit;
            out.radius_error = trial / radius - 1.0;
            out.pressure_error = with / square / p0 - 1.0;
        }
        return out;
    }
};

}  // namespace space_test
