// SPDX-License-Identifier: BSD-3-Clause
// A step takes no memory from the heap.
#include <gtest/gtest.h>

#include "../counted_allocations.hpp"
#include "support/box.hpp"
#include "support/pressed_sand.hpp"

namespace {

using namespace mpm_test;

TEST(Step, AllocatesNothing) {
    for (const Scheme scheme : {Scheme::usl, Scheme::musl, Scheme::usf})
        for (const bool fixed_point : {false, true}) {
            Settings settings{.scheme = scheme, .gravity_z = -10.0, .fixed_point = fixed_point};
            settings.threads = 2;
            Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 3.0, 60),
                                  settings);
            simulation.add_body(make_box({0.0, 1.0, 0.1, 0.5, 20, 16, 2000.0}, true,
                                         std::make_unique<LinearElastic>(1e6, 0.3)));
            simulation.add_body(make_box({0.0, 0.5, 0.5, 1.0, 10, 20, 2000.0}, true,
                                         std::make_unique<NeoHooke>(1e6, 0.3)));
            for (std::size_t b : {0u, 1u})
                for (std::ptrdiff_t p = 0; p < simulation.body(b).particles.size(); ++p)
                    simulation.body(b).particles.view()[column::v_z][p] = b == 0 ? 4.0 : 3.0;
            simulation.add_contact(contact_law(GRIT_CONTACT_GEO, 0.3));
            simulation.add_traction({1, 0, Edge::top, [](double) {
                                         return grit::Vector2{0.0, -1.0};
                                     }});
            // Until the particles have been sorted once more, by rows that they have crossed.
            const double start = simulation.time();
            while (simulation.time() - start < 0.05) simulation.step();
            const long before = allocations;
            while (simulation.time() - start < 0.15) simulation.step();
            EXPECT_EQ(allocations, before);
        }
}

// A block that slides over another one: what is near has been as much before.
TEST(Step, AllocatesNothingForContactAtSurfaces) {
    Simulation simulation(Axis::uniform(0.0, 2.0, 20), Axis::uniform(0.0, 2.0, 20),
                          {.axisymmetric = false, .local_damping = 0.1, .gravity_z = -10.0});
    simulation.add_body(make_box({0.0, 2.0, 0.0, 0.5, 40, 10, 2000.0}, false,
                                 std::make_unique<LinearElastic>(1e6, 0.3)));
    simulation.add_body(make_box({0.3, 0.8, 0.5, 1.0, 10, 10, 2000.0}, false,
                                 std::make_unique<LinearElastic>(1e6, 0.3)));
    for (std::ptrdiff_t p = 0; p < simulation.body(1).particles.size(); ++p)
        simulation.body(1).particles.view()[column::v_r][p] = 1.0;
    simulation.add_contact(surface_law(0.1));
    simulation.fix_below(1, 0.0, Hold::both);
    while (simulation.time() < 0.15) simulation.step();
    const long before = allocations;
    while (simulation.time() < 0.3) simulation.step();
    EXPECT_EQ(allocations, before);
    EXPECT_GT(simulation.surface_contact(0).totals().impulse_on_b[1], 0.0);
}

// Sand under a block and beside a ring, dry, undrained and with water that flows by explicit steps; implicit ones have
// vectors of their own.
TEST(Step, AllocatesNothingForSandAndItsWater) {
    enum class Pores { dry, undrained, flowing };
    for (const Pores pores : {Pores::dry, Pores::undrained, Pores::flowing})
        for (const bool at_surfaces : {false, true}) {
            PressedSand made;
            made.block_velocity = -0.1;
            made.at_surfaces = at_surfaces;
            made.settings.threads = 2;
            if (pores != Pores::dry)
                made.water = PressedSand::soft_water(pores == Pores::flowing, false);
            const auto simulation = made.build();
            while (simulation->time() < 0.04) simulation->step();
            const long before = allocations;
            while (simulation->time() < 0.06) simulation->step();
            EXPECT_EQ(allocations, before) << static_cast<int>(pores) << at_surfaces;
        }
}

}  // namespace
