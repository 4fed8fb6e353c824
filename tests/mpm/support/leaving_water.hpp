// SPDX-License-Identifier: BSD-3-Clause
// What water crosses the surfaces and sides of a body, by the velocities of its nodes alone.
#pragma once

#include <cstddef>
#include <vector>

#include <adapters/mpm/step/simulation.hpp>

namespace mpm_test {

using namespace grit::mpm;

// The surface of a body as its nodes see it: their forces for a pressure of 1 Pa [m2].
inline std::vector<NodeRecord> areas(const Simulation& simulation, std::size_t i) {
    const Body& body = simulation.body(i);
    Particles unit = body.particles;
    PoreWater water = *body.water;
    water.bulk_modulus = 1.0;
    const ParticleView q = unit.view();
    for (std::ptrdiff_t p = 0; p < unit.size(); ++p) q[water.first][p] = 1.0;
    const GridView grid{simulation.axis_r().view(), simulation.axis_z().view()};
    const std::size_t cells =
        static_cast<std::size_t>(grid.r.cells) * static_cast<std::size_t>(grid.z.cells);
    const std::vector<WaterCell> none(cells);
    std::vector<NodeRecord> out(static_cast<std::size_t>(grid.nodes_r()) *
                                    (static_cast<std::size_t>(grid.z.cells) + 1),
                                NodeRecord{});
    const Settings& settings = simulation.current_settings();
    std::vector<NodeRecord> of_grains(out);
    const WaterScatter of_water{&water, none.data(), out.data()};
    kernels().scatter(settings.shape, settings.axisymmetric,
                      {.grid = grid,
                       .particles = q,
                       .begin = 0,
                       .end = unit.size(),
                       .nodes = of_grains.data(),
                       .parts = part::all,
                       .water = &of_water});
    return out;
}

// What left in the last step, per radian or per metre [kg].
inline double left(const Simulation& simulation, std::size_t i,
                   const std::vector<NodeRecord>& areas, double dt) {
    double sum = 0.0;
    for (std::size_t node = 0; node < areas.size(); ++node)
        for (int k = 0; k < 2; ++k)
            sum += areas[node][water_record::f_r + k] *
                   simulation.pore_water().seepage(i, node)[static_cast<std::size_t>(k)];
    return simulation.body(i).water->density * dt * sum;
}

}  // namespace mpm_test
