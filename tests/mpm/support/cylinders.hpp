// SPDX-License-Identifier: BSD-3-Clause
// Two equal cylinders in axisymmetry, sides free, that close a gap.
#pragma once

#include <cmath>
#include <memory>

#include "support/box.hpp"
#include "support/contact_kind.hpp"

namespace mpm_test {

struct Cylinders {
    static constexpr double h = 0.025, gap = 0.05, closing = 1.0, high = 0.2;
    ContactKind kind = ContactKind::surface;
    double radius = 0.2;   // [m]; on a grid line or not
    double offset = 0.0;   // of the gap along the axis [cells]
    bool average = false;  // normals, of the nodal contacts

    struct Result {
        double first;     // when a force appeared [s]
        double momentum;  // that the upper one has lost before the gap is closed [share]
    };

    Result run() const {
        Simulation simulation(Axis::uniform(0.0, 0.3, 12), Axis::uniform(0.0, 0.65, 26),
                              {.axisymmetric = true, .cfl = 0.4});
        const int across = static_cast<int>(std::lround(2.0 * radius / h));
        for (const int k : {0, 1}) {
            const double from = 0.05 + offset * h + k * (high + gap);
            Body body = make_box({0.0, radius, from, from + high, across, 16, 2000.0}, true,
                                 std::make_unique<LinearElastic>(10e6, 0.3));
            for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
                body.particles.view()[column::v_z][p] = (k == 0 ? 0.5 : -0.5) * closing;
            simulation.add_body(std::move(body));
        }
        const double low = 0.05 + offset * h + high, up = low + gap;
        add_contact(simulation, kind, 0.0,
                    {1.35e7, h, {{{radius, low}, {0.0, low}}}, {{{0.0, up}, {radius, up}}}});
        Result out{NAN, 0.0};
        const auto momentum = [&] {
            const Particles& q = simulation.body(1).particles;
            double sum = 0.0;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p)
                sum += q(column::mass, p) * q(column::v_z, p);
            return sum;
        };
        const double start = momentum();
        while (simulation.time() < 1.1 * gap / closing) {
            if (simulation.time() < 0.998 * gap / closing) out.momentum = 1.0 - momentum() / start;
            const double t = simulation.time();
            simulation.step();
            const double force = contact_force(simulation, kind, simulation.time() - t)[1];
            if (std::isnan(out.first) && force != 0.0) out.first = t;
        }
        return out;
    }
};

}  // namespace mpm_test
