// SPDX-License-Identifier: BSD-3-Clause
// A brick in space on rollers, eight particles a cell, that was at rest and is pressed together: of elastic material, or
// of Lausitz sand whose increments are about 1e-6 to 1e-5 per step.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include <adapters/mpm/space/kernel/elastic.hpp>
#include <adapters/mpm/space/kernel/sand.hpp>
#include <adapters/mpm/space/step/simulation.hpp>

#include "mpm_column.hpp"

namespace benchmarks {

struct BrickPlan {
    int cells;  // along each side: 8 cells^3 particles
    bool sand = false;
    int threads = 1;
    double particles() const { return 8.0 * cells * cells * cells; }
};

inline std::unique_ptr<grit::mpm::space::Simulation> brick(const BrickPlan& plan) {
    using namespace grit::mpm::space;
    const double side = 1.0, cell = side / plan.cells, l = 0.25 * cell;
    const grit::mpm::Axis across = grit::mpm::Axis::uniform(0.0, side, plan.cells);
    const grit::mpm::Axis up = grit::mpm::Axis::uniform(0.0, side + 2.0 * cell, plan.cells + 2);
    Settings settings;
    settings.threads = plan.threads;
    auto out =
        std::make_unique<Simulation>(std::array<grit::mpm::Axis, 3>{across, across, up}, settings);
    Body body;
    if (plan.sand) {
        const grit::mpm::SandPlan given = lausitz_plan();
        grit_sand sand;
        grit_sand_prepare(&given.parameters, &sand, nullptr);
        body.material = std::make_unique<Sand>(sand, given.options);
    } else {
        body.material = std::make_unique<LinearElastic>(1e7, 0.3);
    }
    body.particles = Particles(body.material->own_columns());
    const int n = 2 * plan.cells;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                body.particles.add(
                    {{(2 * i + 1) * l, (2 * j + 1) * l, (2 * k + 1) * l}, {l, l, l}, 1600.0});
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        const double z = q[column::z][p], vertical = -(1000.0 + 1600.0 * 9.81 * (side - z));
        q[column::v_z][p] = -0.1 * std::sin(0.5 * std::numbers::pi * z / side);  // the first mode
        for (int d = 0; d < 3; ++d) q[column::S_xx + d][p] = d == 2 ? vertical : 0.45 * vertical;
        if (!plan.sand) continue;
        q[Sand::state + GRIT_SAND_H33][p] = -1e-4;
        q[Sand::state + GRIT_SAND_VOID_RATIO][p] = 0.65;
    }
    out->add_body(std::move(body));
    for (int d = 0; d < 3; ++d) out->fix_below(d, 0.0);
    for (int d = 0; d < 2; ++d) out->fix_above(d, side);
    out->set_gravity({0.0, 0.0, -9.81});
    return out;
}

}  // namespace benchmarks
