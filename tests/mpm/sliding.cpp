// SPDX-License-Identifier: BSD-3-Clause
// Bodies that slide, by Coulomb's law.
#include <gtest/gtest.h>

#include "support/rolling_disk.hpp"

namespace {

using namespace mpm_test;

// On a slope of 45 degrees, seen along it, from 5 m/s: 2 m wide, of E 7 GPa.
TEST(SlidingCube, FollowsThePathOfCoulombsLaw) {
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
        Settings settings{.axisymmetric = false, .gravity_r = 6.9296, .gravity_z = -6.9296};
        Simulation simulation(Axis::uniform(0.0, 11.0, 11), Axis::uniform(0.0, 6.0, 6), settings);
        simulation.add_body(make_floor({0.0, 11.0, 1.0, 2.0, 11, 1, 2650.0}, false));
        Body cube = make_box({1.0, 3.0, 2.0, 4.0, 4, 4, 2650.0}, false,
                             std::make_unique<LinearElastic>(7e9, 0.3));
        for (std::ptrdiff_t p = 0; p < cube.particles.size(); ++p)
            cube.particles.view()[column::v_r][p] = 5.0;
        simulation.add_body(std::move(cube));
        simulation.add_contact(contact_law(law, 0.5));
        for (double until = 0.25; until <= 1.0; until += 0.25) {
            while (simulation.time() < until) simulation.step();
            const double t = simulation.time(), expected = 5.0 * t + 1.7324 * t * t;
            const CentreOfMass now = centre_of_mass(simulation.body(1).particles);
            EXPECT_NEAR(now.r - 2.0, expected, 0.02 * expected);
            EXPECT_NEAR(now.z, 3.0, 1e-4);
        }
    }
}

// 1000 kg under 1000 N and a tangential load of 300 N/s: Coulomb's 300 N are reached after 1 s.
TEST(LoadedBlock, SticksUntilTheLoadExceedsFrictionAndThenSlips) {
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
        Simulation simulation(Axis::uniform(0.0, 2.0, 8), Axis::uniform(0.0, 1.5, 6),
                              {.axisymmetric = false});
        simulation.add_body(make_floor({0.0, 2.0, 0.25, 0.5, 8, 1, 2000.0}, false));
        simulation.add_body(make_box({0.5, 1.5, 0.5, 1.0, 8, 4, 2000.0}, false,
                                     std::make_unique<LinearElastic>(1e7, 0.3)));
        simulation.add_contact(contact_law(law, 0.3));
        for (int i = 0; i < 8; ++i)
            simulation.add_traction({1, 3 * 8 + i, Edge::top, [](double) {
                                         return grit::Vector2{0.0, -1000.0};
                                     }});
        simulation.set_body_force(
            [](ParticleView q, std::ptrdiff_t begin, std::ptrdiff_t end, double t) {
                for (std::ptrdiff_t p = begin; p < end; ++p) q[column::b_r][p] = 0.3 * t;
            });
        const auto now = [&] { return centre_of_mass(simulation.body(1).particles); };
        while (simulation.time() < 0.99) simulation.step();
        EXPECT_NEAR(now().r - 1.0, 0.0, 1e-4);
        EXPECT_NEAR(now().v_r, 0.0, 3e-4);
        while (simulation.time() < 1.05) simulation.step();
        // 0.15 (t - t_slip)^2
        EXPECT_NEAR(simulation.time() - std::sqrt(now().v_r / 0.15), 1.0, 0.02);
        while (simulation.time() < 2.0) simulation.step();
        EXPECT_NEAR(now().v_r, 0.15, 0.02 * 0.15);
        EXPECT_NEAR(now().r - 1.0, 0.05, 0.02 * 0.05);
    }
}

TEST(DiskOnASlope, SlidesWhereFrictionIsTooLittleToRollIt) {
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
        RollingDisk disk;
        disk.friction = 0.1;
        disk.law = law;
        EXPECT_NEAR(disk.run(8).way, 1.0, 0.02);
    }
}

}  // namespace
