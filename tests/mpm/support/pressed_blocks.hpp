// SPDX-License-Identifier: BSD-3-Clause
// Two confined blocks, one on the other, pressed by 500 kPa.
#pragma once

#include <cmath>
#include <memory>

#include "support/box.hpp"
#include "support/contact_kind.hpp"

namespace mpm_test {

struct PressedBlocks {
    static constexpr double E = 50e6, nu = 0.2, rho = 2000.0, h = 0.1, pressure = 500e3;
    ContactKind kind = ContactKind::surface;
    double offset = 0.0;  // of the interface against the grid [cells]
    double cfl = 0.4;
    double end = 1.0;  // [s]
    bool axisymmetric = false;

    struct Result {
        double lowest, highest;  // sigma_zz of the particles at the interface [Pa]
        double lowest_of_all, highest_of_all;
        double overlap;  // [h]
    };

    Result run() const {
        constexpr int across = 3, high = 5;  // cells
        const double middle = (7.0 + offset) * h, width = across * h;
        Simulation simulation(Axis::uniform(0.0, width, across), Axis::uniform(0.0, 1.6, 16),
                              {.axisymmetric = axisymmetric, .cfl = cfl, .local_damping = 0.1});
        for (const int k : {0, 1}) {
            const double from = k == 0 ? 0.0 : middle, to = k == 0 ? middle : middle + high * h;
            const int rows = k == 0 ? 14 : 2 * high;
            simulation.add_body(make_box({0.0, width, from, to, 2 * across, rows, rho},
                                         axisymmetric, std::make_unique<LinearElastic>(E, nu)));
        }
        simulation.fix_below(0, 0.0);
        simulation.fix_above(0, width);
        simulation.fix_below(1, 0.0);
        const int count = static_cast<int>(simulation.body(1).particles.size());
        for (int i = 0; i < 2 * across; ++i)
            simulation.add_traction(
                {1, count - 2 * across + i, Edge::top, [](double t) {
                     const double x = std::min(t / 0.05, 1.0);
                     return grit::Vector2{0.0, -pressure * x * x * (3.0 - 2.0 * x)};
                 }});
        add_contact(simulation, kind, 0.0,
                    {p_wave_modulus(E, nu),
                     h,
                     {{{width, middle}, {0.0, middle}}},
                     {{{0.0, middle}, {width, middle}}}});
        while (simulation.time() < end) simulation.step();
        return evaluate(simulation);
    }

  private:
    static Result evaluate(const Simulation& simulation) {
        Result out{0.0, -1e30, 0.0, -1e30, 0.0};
        double top = -1e30, bottom = 1e30;
        for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
            const Particles& q = simulation.body(k).particles;
            double edge = k == 0 ? -1e30 : 1e30;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
                const double z = q(column::z, p);
                edge = k == 0 ? std::max(edge, z) : std::min(edge, z);
            }
            for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
                const double s = q(column::S_zz, p), z = q(column::z, p);
                out.lowest_of_all = std::min(out.lowest_of_all, s);
                out.highest_of_all = std::max(out.highest_of_all, s);
                if (std::fabs(z - edge) > 0.1 * h) continue;
                out.lowest = std::min(out.lowest, s);
                out.highest = std::max(out.highest, s);
                const double side = q(column::F_zz, p) * q(column::l_z, p);
                if (k == 0) top = std::max(top, z + side);
                else bottom = std::min(bottom, z - side);
            }
        }
        out.overlap = (top - bottom) / h;
        return out;
    }
};

}  // namespace mpm_test
