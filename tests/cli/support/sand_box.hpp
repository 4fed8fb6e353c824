// SPDX-License-Identifier: BSD-3-Clause
// A box of Lausitz sand that falls apart: a small simulation with all that its files can show.
#pragma once

#include <memory>
#include <utility>

#include <adapters/mpm/kernel/elastic.hpp>
#include <adapters/mpm/kernel/sand.hpp>
#include <adapters/mpm/step/simulation.hpp>

#include "../../catalogue.hpp"

namespace cli_test {

struct Block {
    double r, z, side;  // of its lower left corner [m], of a particle [m]
    int n_r, n_z;
    double density;  // [kg/m3]
};

inline grit::mpm::Body block(const Block& block, std::unique_ptr<grit::mpm::Material> material,
                             std::string name) {
    grit::mpm::Body body;
    body.name = std::move(name);
    body.particles = grit::mpm::Particles(material->own_columns());
    for (int j = 0; j < block.n_z; ++j)
        for (int i = 0; i < block.n_r; ++i)
            body.particles.add({block.r + (i + 0.5) * block.side, block.z + (j + 0.5) * block.side,
                                0.5 * block.side, 0.5 * block.side, block.density},
                               true);
    body.material = std::move(material);
    return body;
}

// Under an isotropic pressure [Pa].
inline grit::mpm::Body sand_block(const Block& where, double pressure) {
    namespace c = grit::mpm::column;
    grit::mpm::Body body =
        block(where,
              std::make_unique<grit::mpm::Sand>(catalogue_sand("lausitz", 1000.0),
                                                options_with_tolerance(1e-3)),
              "sand");
    const grit::mpm::ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        for (const int stress : {c::S_rr, c::S_zz, c::S_tt}) q[stress][p] = -pressure;
        q[grit::mpm::Sand::state + GRIT_SAND_VOID_RATIO][p] = 0.65;
    }
    return body;
}

inline std::unique_ptr<grit::mpm::Simulation> sand_box() {
    using namespace grit::mpm;
    auto out = std::make_unique<Simulation>(Axis::uniform(0.0, 0.8, 8), Axis::uniform(0.0, 1.2, 12),
                                            Settings{.gravity_z = -9.81});
    out->add_body(sand_block({0.0, 0.0, 0.05, 10, 10, 1700.0}, 5000.0));
    out->add_body(
        block({0.0, 0.6, 0.05, 4, 4, 2500.0}, std::make_unique<LinearElastic>(1e7, 0.2), "hammer"));
    out->add_contact(contact_law(GRIT_CONTACT_GEO, 0.3));
    out->fix_below(1, 0.0);
    return out;
}

}  // namespace cli_test
