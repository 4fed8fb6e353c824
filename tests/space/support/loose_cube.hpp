// SPDX-License-Identifier: BSD-3-Clause
// A cube of particles that move and are stressed at random, and a slab that it meets.
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <adapters/mpm/space/kernel/sand.hpp>

#include "../../catalogue.hpp"
#include "support/meeting.hpp"

namespace space_test {

inline Body loose_cube(std::unique_ptr<Material> material) {
    Body body =
        make_brick({{0.21, 0.33, 0.27}, {0.71, 0.73, 0.87}, {9, 8, 11}}, std::move(material));
    const ParticleView q = body.particles.view();
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        for (int k = 0; k < 3; ++k) q[column::v_x + k][p] = any(generator) + (k == 0 ? 2.0 : -1.0);
        for (int k = 0; k < 6; ++k)
            q[column::S_xx + k][p] = 1e4 * any(generator) - (k < 3 ? 2e5 : 0.0);
    }
    return body;
}

inline Body loose_cube_of_sand() {
    Body body = loose_cube(
        std::make_unique<Sand>(catalogue_sand("lausitz", 1000.0), options_with_tolerance(1e-3)));
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
        q[Sand::state + GRIT_SAND_VOID_RATIO][p] = 0.65;
    return body;
}

inline Body slab_above() {
    return make_brick({{0.3, 0.3, 0.9}, {0.9, 0.9, 1.2}, {12, 12, 6}},
                      std::make_unique<LinearElastic>(1e7, 0.3));
}

// ... its pores full of water, whose pressures are as uneven.
inline Body wet(Body dry) {
    const int own = dry.material->own_columns();
    Body out;
    out.water = grit::mpm::PoreWater{.porosity = 0.4,
                                     .first = column::own + own,
                                     .void_ratio_column = dry.material->separation().void_ratio};
    if (out.water->void_ratio_column >= 0) out.water->opening_cap = dry.material->separation().cap;
    out.particles = Particles(own + out.water->columns());
    grit::mpm::ParticleColumns& to = out.particles;
    for (std::ptrdiff_t p = 0; p < dry.particles.size(); ++p) {
        std::vector<double> row;
        for (int c = 0; c < column::own + own; ++c) row.push_back(dry.particles(c, p));
        row.push_back(1e3 * std::sin(static_cast<double>(p)));
        to.add(dry.particles.ids()[p], row.data());
    }
    out.material = std::move(dry.material);
    return out;
}

// Of the slab on the cube, from afar: they press each other from the first step on.
inline ContactLaw not_gated() {
    ContactLaw law = nodal_law(GRIT_CONTACT_GEO, 0.3, 1, 0);
    law.gated = false;
    return law;
}

}  // namespace space_test
