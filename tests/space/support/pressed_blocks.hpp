// SPDX-License-Identifier: BSD-3-Clause
// Two blocks in space, one on the other, pressed by 500 kPa between rollers; and two bars that stand inclined to the grid.
#pragma once

#include <algorithm>
#include <cmath>

#include <adapters/mpm/space/kernel/place.hpp>

#include "support/bricks.hpp"

namespace space_test {

inline double risen(double t, double within) {
    const double x = std::min(t / within, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

struct PressedBlocks {
    static constexpr double E = 50e6, nu = 0.2, rho = 2000.0, h = 0.1, pressure = 500e3;
    double offset = 0.0;  // of the interface against the grid [cells]
    int rows = 2;         // of particles in a cell of the upper block, across
    double end = 0.3;     // [s]

    struct Result {
        double lowest, highest;  // sigma_zz of all particles [Pa]
    };

    Result run() const {
        constexpr int across = 2, high = 3;  // cells
        const double middle = (4.0 + offset) * h, width = across * h, top = middle + high * h;
        const Axis side = Axis::uniform(0.0, width, across);
        Simulation simulation({side, side, Axis::uniform(0.0, 0.9, 9)},
                              {.cfl = 0.4, .local_damping = 0.2});
        const int n = rows * across;
        simulation.add_body(
            make_brick({{0.0, 0.0, 0.0}, {width, width, middle}, {2 * across, 2 * across, 8}, rho},
                       std::make_unique<LinearElastic>(E, nu)));
        simulation.add_body(
            make_brick({{0.0, 0.0, middle}, {width, width, top}, {n, n, 2 * high}, rho},
                       std::make_unique<LinearElastic>(E, nu)));
        for (const int d : {0, 1}) {
            simulation.fix_below(d, 0.0);
            simulation.fix_above(d, width);
        }
        simulation.fix_below(2, 0.0);
        const auto count = static_cast<int>(simulation.body(1).particles.size());
        for (int i = count - n * n; i < count; ++i)
            simulation.add_traction({1, i, {2, true}, [](double t) {
                                         return Vector3{0.0, 0.0, -pressure * risen(t, 0.05)};
                                     }});
        SurfaceLaw law = surface_law(0.0);
        simulation.add_contact(law);
        while (simulation.time() < end) simulation.step();
        Result out{1e30, -1e30};
        for (const std::size_t body : {0u, 1u}) {
            const Particles& q = simulation.body(body).particles;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
                out.lowest = std::min(out.lowest, q(column::S_zz, p));
                out.highest = std::max(out.highest, q(column::S_zz, p));
            }
        }
        return out;
    }
};

// The patch test: unlike particles, an interface that lies askew to all planes of the grid.
struct InclinedBars {
    static constexpr double E = 10e6, rho = 2000.0, h = 0.1, pressure = 1e3;
    static constexpr double length = 0.3, breadth = 0.3;
    double angle = 0.3;  // of the bars' axis to z, about (1, -1/2, 0) [rad]
    double friction_coefficient = 0.0;
    double end = 0.5;  // [s]; loaded in the first 0.2

    // Largest difference of a component of stress from that of the pressure, as a share of it.
    double run() const {
        Simulation simulation(
            {Axis::uniform(0.0, 1.3, 13), Axis::uniform(0.0, 1.3, 13), Axis::uniform(0.0, 1.4, 14)},
            {.cfl = 0.4, .local_damping = 0.1});
        const Vector3 axis = Vector3{1.0, -0.5, 0.0} / std::sqrt(1.25);
        const double c = std::cos(angle), s = std::sin(angle);
        const auto turned = [&](const Vector3& x) {
            const Vector3 across = grit::mpm::space::baseline::cross(axis, x);
            return c * x + s * across + ((1.0 - c) * dot(axis, x)) * axis;
        };
        const Vector3 e[3] = {turned({1.0, 0.0, 0.0}), turned({0.0, 1.0, 0.0}),
                              turned({0.0, 0.0, 1.0})};
        const Vector3 middle{0.63, 0.66, 0.71};  // of the interface
        for (const int k : {0, 1}) {
            const int across = k == 0 ? 4 : 5, high = k == 0 ? 5 : 4;
            const Vector3 l{0.5 * breadth / across, 0.5 * breadth / across, 0.5 * length / high};
            Body body;
            for (int m = 0; m < high; ++m)
                for (int j = 0; j < across; ++j)
                    for (int i = 0; i < across; ++i)
                        body.particles.add(
                            {middle + ((2 * i + 1 - across) * l[0]) * e[0] +
                                 ((2 * j + 1 - across) * l[1]) * e[1] +
                                 ((2 * m + 1) * l[2] - (k == 0 ? length : 0.0)) * e[2],
                             l, rho});
            const ParticleView q = body.particles.view();
            for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) q[column::F_xx + 3 * i + j][p] = e[j][i];
            body.material = std::make_unique<LinearElastic>(E, 0.0);
            simulation.add_body(std::move(body));
            const int first = k == 0 ? 0 : across * across * (high - 1);
            for (int i = 0; i < across * across; ++i)
                simulation.add_traction(
                    {static_cast<std::size_t>(k), first + i, {2, k == 1}, [up = e[2], k](double t) {
                         const double p = pressure * risen(t, 0.2);
                         return (k == 0 ? p : -p) * up;
                     }});
        }
        simulation.add_contact(surface_law(friction_coefficient));
        while (simulation.time() < end) simulation.step();
        double worst = 0.0;
        for (const std::size_t k : {0u, 1u}) {
            const Particles& q = simulation.body(k).particles;
            constexpr int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
            for (std::ptrdiff_t p = 0; p < q.size(); ++p)
                for (int m = 0; m < 6; ++m)
                    worst = std::max(worst, std::fabs(q(column::S_xx + m, p) / pressure +
                                                      e[2][of[m][0]] * e[2][of[m][1]]));
        }
        return worst;
    }
};

}  // namespace space_test
