// SPDX-License-Identifier: BSD-3-Clause
// Boxes of particles.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <adapters/mpm/kernel/elastic.hpp>
#include <adapters/mpm/step/simulation.hpp>

namespace mpm_test {

using namespace grit::mpm;

struct Box {
    double r0, r1, z0, z1;  // [m]
    int n_r, n_z;           // particles
    double density;         // [kg/m3]
};

// With water, its columns are those behind the material's.
inline Body make_box(const Box& box, bool axisymmetric, std::unique_ptr<Material> material,
                     std::optional<PoreWater> water = {}) {
    Body body;
    const int own = material ? material->own_columns() : 0;
    body.particles = Particles(own + (water ? water->columns() : 0));
    if (water) {
        water->first = column::own + own;
        water->void_ratio_column = material->separation().void_ratio;
    }
    body.water = water;
    const double l_r = 0.5 * (box.r1 - box.r0) / box.n_r, l_z = 0.5 * (box.z1 - box.z0) / box.n_z;
    for (int j = 0; j < box.n_z; ++j)
        for (int i = 0; i < box.n_r; ++i)
            body.particles.add(
                {box.r0 + (2 * i + 1) * l_r, box.z0 + (2 * j + 1) * l_z, l_r, l_z, box.density},
                axisymmetric);
    body.material = std::move(material);
    return body;
}

}  // namespace mpm_test
