// SPDX-License-Identifier: BSD-3-Clause
// A slab in plane strain, one cell across, and the plane's driver beside it, x = r.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <utility>

#include <adapters/mpm/kernel/elastic.hpp>
#include <adapters/mpm/step/simulation.hpp>

#include "support/bricks.hpp"

namespace space_test {

class BesidePlane {
  public:
    static constexpr double width = 0.2, g = 9.81;

    // Its grid begins at 0, 0 and ends at 2 m, 1.6 m.
    explicit BesidePlane(grit::mpm::Settings settings)
        : plane(x, z, with_gravity(settings)),
          space({x, Axis::uniform(0.0, width, 1), z}, settings) {
        space.set_gravity({0.0, 0.0, -g});
        plane.fix_below(1, 0.0);
        space.fix_below(2, 0.0);
        space.fix_below(1, 0.0);
        space.fix_above(1, width);
    }

    // Rows of particles 0.1 m apart along x and z.
    struct Block {
        double x, z;  // centre of the first one [m]
        int across, high;
        double density;
        double v_x = 0.0, v_z = 0.0;
    };
    // water: its columns are put behind those that all particles have.
    template <class PlaneLaw, class SpaceLaw>
    void add(const Block& block, double E, double nu,
             const std::optional<grit::mpm::PoreWater>& water = {}) {
        grit::mpm::Body flat;
        Body brick;
        flat.water = brick.water = water;
        if (water) {
            flat.water->first = grit::mpm::column::own;
            brick.water->first = column::own;
            flat.particles = grit::mpm::Particles(water->columns());
            brick.particles = Particles(water->columns());
        }
        for (int j = 0; j < block.high; ++j)
            for (int i = 0; i < block.across; ++i) {
                const double at_x = block.x + 0.1 * i, at_z = block.z + 0.1 * j;
                flat.particles.add({at_x, at_z, 0.05, 0.05, block.density, block.v_x, block.v_z},
                                   false);
                brick.particles.add({{at_x, 0.5 * width, at_z},
                                     {0.05, 0.5 * width, 0.05},
                                     block.density,
                                     {block.v_x, 0.0, block.v_z}});
            }
        flat.material = std::make_unique<PlaneLaw>(E, nu);
        brick.material = std::make_unique<SpaceLaw>(E, nu);
        plane.add_body(std::move(flat));
        space.add_body(std::move(brick));
    }
    void step() {
        plane.step();
        space.step();
    }
    // Times and places are the same; take(of the plane, its particle, of space, its particle) compares the rest.
    template <class Take> void expect_same(const Take& take) const {
        EXPECT_NEAR(space.time(), plane.time(), 1e-12 * plane.time());
        for (std::size_t body = 0; body < space.bodies(); ++body) {
            const grit::mpm::Particles& a = plane.body(body).particles;
            const Particles& b = space.body(body).particles;
            for (int id = 0; id < a.size(); ++id) {
                const std::ptrdiff_t p = plane.find(body, id), s = space.find(body, id);
                EXPECT_NEAR(b(column::x, s), a(grit::mpm::column::r, p), 1e-11)
                    << body << ' ' << id;
                EXPECT_NEAR(b(column::z, s), a(grit::mpm::column::z, p), 1e-11)
                    << body << ' ' << id;
                take(a, p, b, s);
            }
        }
    }

  private:
    static grit::mpm::Settings with_gravity(grit::mpm::Settings settings) {
        settings.gravity_z = -g;
        return settings;
    }
    Axis x = Axis::uniform(0.0, 2.0, 10), z = Axis::uniform(0.0, 1.6, 8);

  public:
    grit::mpm::Simulation plane;
    Simulation space;
};

}  // namespace space_test
