// SPDX-License-Identifier: BSD-3-Clause
// An elastic block thrown on sand and pushed by a traction, next to a rigid ring that leaves: everything
// that a simulation keeps from step to step.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "support/lausitz.hpp"

namespace mpm_test {

struct PressedSand {
    Settings settings{.pic_rate = 20.0, .local_damping = 0.02, .gravity_z = -9.81};
    int cells_z = 24;
    bool ring = true;
    bool hyperelastic = false;  // the block, whose energy the linear law keeps to its strains alone
    double block_density = 2500.0, block_velocity = -10.0;

    double relaxation_time = 0.0, stiffness = 0.0;  // of the contact [s], [Pa/m]
    double growth = 1.0;                            // of a cell to the next one
    bool at_surfaces = false;                       // contact, not at nodes
    std::optional<PoreWater> water = {};            // of the sand

    // The whole grid along r (0) or z (1).
    Axis axis(int direction) const {
        const int cells = direction == 0 ? 8 : cells_z;
        std::vector<double> nodes{0.0};
        double length = 1.0;
        for (int i = 0; i < cells; ++i, length *= growth) nodes.push_back(nodes.back() + length);
        const double scale = 0.05 * cells / nodes.back();
        for (double& node : nodes) node *= scale;
        nodes.back() = 0.05 * cells;
        return Axis(nodes);
    }

    std::unique_ptr<Simulation> build() const {
        const int begin[] = {0, 0}, end[] = {8, cells_z};
        return build(nullptr, begin, end, [](Body&) {});
    }

    // Of cells [begin, end), a process that shares the grid; keep: leaves its particles in a body.
    std::unique_ptr<Simulation> build(Exchange* exchange, const int* begin, const int* end,
                                      const std::function<void(Body&)>& keep) const {
        auto out = std::make_unique<Simulation>(axis(0).part(begin[0], end[0]),
                                                axis(1).part(begin[1], end[1]), settings, exchange);
        std::unique_ptr<Material> elastic;
        if (hyperelastic) elastic = std::make_unique<NeoHooke>(1e7, 0.2);
        else elastic = std::make_unique<LinearElastic>(1e7, 0.2);
        Body block =
            make_box({0.0, 0.2, 0.51, 0.71, 8, 8, block_density}, true, std::move(elastic));
        block.name = "block";
        const ParticleView v = block.particles.view();
        for (std::ptrdiff_t p = 0; p < block.particles.size(); ++p)
            v[column::v_z][p] = block_velocity;
        keep(block);
        out->add_body(std::move(block));
        Body below = sand();
        keep(below);
        out->add_body(std::move(below));
        if (ring) {
            Body rigid = make_box({0.25, 0.3, 0.55, 0.65, 2, 4, 1000.0}, true, nullptr);
            rigid.name = "ring";
            rigid.prescribed_velocity = [](double t) {
                return grit::Vector2{0.0, 4.0 + 100.0 * t};
            };
            keep(rigid);
            out->add_body(std::move(rigid));
        }
        for (int id = 56; id < 64; ++id)
            out->add_traction({0, id, Edge::top, [](double t) {
                                   return grit::Vector2{0.0, -1e5 * std::sin(500.0 * t)};
                               }});
        if (at_surfaces) {
            out->add_contact(surface_law(0.3));
        } else {
            ContactLaw law = contact_law(GRIT_CONTACT_GEO, 0.3);
            law.options.relaxation_time = relaxation_time;
            law.options.contact_stiffness = stiffness;
            out->add_contact(law);
        }
        out->fix_below(1, 0.0);
        if (water) out->fix_above(0, axis(0)[8]);
        else if (end[0] == 8) out->absorb_last(0, {200.0, 100.0});
        if (water) out->drain_below(1, 0.0);
        return out;
    }

    // Water as soft as the sand: it does not limit the step.
    static PoreWater soft_water(bool flows, bool implicit) {
        return {.flows = flows, .implicit = implicit, .bulk_modulus = 1e7, .conductivity = 1e-3};
    }

  private:
    Body sand() const {
        Body body = make_box({0.0, 0.4, 0.0, 0.5, 16, 20, 1700.0}, true,
                             std::make_unique<Sand>(lausitz(), sand_options()), water);
        body.name = "sand";
        const ParticleView q = body.particles.view();
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            for (const int c : {column::S_rr, column::S_zz, column::S_tt})
                q[c][p] = -1000.0 - 17000.0 * (0.5 - q[column::z][p]);
            q[Sand::state + GRIT_SAND_VOID_RATIO][p] = 0.65;
            if (water) q[body.water->first][p] = 9810.0 * (0.5 - q[column::z][p]);
            if (water && water->flows) q[body.water->content_column()][p] = body.water->mass(q, p);
        }
        return body;
    }
};

}  // namespace mpm_test
