// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/meeting.hpp"

namespace {

using namespace space_test;

TEST(SpaceContact, LetsACubeSlideDownASlopeByCoulombsLaw) {
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
        const SlidingCube::Result result = SlidingCube{law}.run();
        EXPECT_LT(result.way, 0.01) << law;
        EXPECT_LT(result.across, 0.01) << law;
    }
}

// Two bricks that run into each other, one of them heavier and askew to the grid's lines in its motion.
TEST(SpaceContact, KeepsMomentumAndTheMomentOfForces) {
    Simulation simulation(cube_of_cells(1.6, 16), {});
    const auto material = [] { return std::make_unique<LinearElastic>(1e6, 0.3); };
    simulation.add_body(
        make_brick({{0.3, 0.4, 0.3}, {0.8, 0.9, 0.8}, {10, 10, 10}, 1000.0}, material()));
    Body other = make_brick({{0.83, 0.52, 0.41}, {1.2, 1.1, 0.9}, {8, 11, 10}, 2500.0}, material());
    for (std::ptrdiff_t p = 0; p < other.particles.size(); ++p) {
        other.particles.view()[column::v_x][p] = -3.0;
        other.particles.view()[column::v_y][p] = 1.0;
    }
    simulation.add_body(std::move(other));
    simulation.add_contact(nodal_law(GRIT_CONTACT_GEO, 0.3, 1, 0));
    const auto momentum = [&] {
        Vector3 sum{0.0, 0.0, 0.0};
        for (const std::size_t b : {0u, 1u}) {
            const Particles& q = simulation.body(b).particles;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p)
                for (int k = 0; k < 3; ++k) sum[k] += q(column::mass, p) * q(column::v_x + k, p);
        }
        return sum;
    };
    const Vector3 before = momentum();
    double pushed = 0.0, balance = 0.0;
    for (int i = 0; i < 90; ++i) {
        simulation.step();
        const grit_contact_totals& totals = simulation.contact(0).totals();
        pushed = std::max(pushed, std::fabs(totals.force_on_a[0]));
        for (int k = 0; k < 3; ++k)
            balance = std::max({balance, std::fabs(totals.force_on_a[k] + totals.force_on_b[k]),
                                std::fabs(totals.moment_on_a[k] + totals.moment_on_b[k])});
    }
    EXPECT_GT(pushed, 100.0);
    EXPECT_LT(balance, 1e-9 * pushed);
    EXPECT_LT(norm(momentum() - before), 1e-12 * norm(before));
    const Particles& hit = simulation.body(0).particles;
    EXPECT_LT(centre_of_mass(hit)[0], 0.55 - 0.005);
    const grit::mpm::Energy e = simulation.energy();
    EXPECT_GT(e.contact, 0.0);
    EXPECT_LT(std::fabs(e.residual()), 0.01 * e.kinetic_0);
}

TEST(SpaceContact, LeavesBodiesAloneThatAreApart) {
    Simulation simulation(cube_of_cells(1.0, 5), {});
    simulation.add_body(make_floor({{0.0, 0.0, 0.2}, {1.0, 1.0, 0.4}, {10, 10, 2}}));
    Body stone = make_brick({{0.4, 0.4, 0.45}, {0.6, 0.6, 0.65}, {2, 2, 2}},
                            std::make_unique<LinearElastic>(1e6, 0.3));
    for (std::ptrdiff_t p = 0; p < 8; ++p) stone.particles.view()[column::v_z][p] = -0.5;
    simulation.add_body(std::move(stone));
    simulation.add_contact(nodal_law(GRIT_CONTACT_GEO, 0.3, 0, 1));
    double gap_at_touch = -1.0;
    while (simulation.time() < 0.2 && gap_at_touch < 0.0) {
        simulation.step();
        const Particles& q = simulation.body(1).particles;
        if (simulation.contact(0).totals().impulse_on_b[2] > 0.0)
            gap_at_touch = centre_of_mass(q)[2] - 0.1 - 0.4;
    }
    EXPECT_GE(gap_at_touch, -1e-3);
    EXPECT_LT(gap_at_touch, 1e-3);
}

// See BlocksOnSprings of the plane.
TEST(SpaceContact, WithSpringsLeavesBodiesAloneThatAreThinnerThanACell) {
    constexpr double h = 0.1, E = 1e6;
    for (const int normal :
         {GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B, GRIT_CONTACT_NORMAL_AVERAGE}) {
        Simulation simulation(cube_of_cells(0.8, 8), {});
        simulation.add_body(make_brick({{0.25, 0.25, 0.31}, {0.45, 0.45, 0.36}, {4, 4, 2}, 1000.0},
                                       std::make_unique<LinearElastic>(E, 0.0)));
        simulation.add_body(make_brick({{0.25, 0.25, 0.36}, {0.45, 0.45, 0.42}, {4, 4, 2}, 1000.0},
                                       std::make_unique<LinearElastic>(E, 0.0)));
        ContactLaw law = nodal_law(GRIT_CONTACT_GEO, 0.0, 0, 1);
        law.gated = true;
        law.normal = normal;
        law.options.contact_stiffness = grit::mpm::contact_stiffness(1.0, E, h);
        simulation.add_contact(law);
        for (int i = 0; i < 20; ++i) simulation.step();
        EXPECT_LT(simulation.energy().kinetic, 1e-20 * E * h * h * h) << normal;
    }
}

// On a coarse grid; finer ones: space_convergence, docs/space.md.
TEST(SpaceContact, OfAParaboloidOnAPlaneIsThatOfHertz) {
    const Hertz::Result result = Hertz{.rise = 0.03, .rest = 0.02}.run();
    EXPECT_GT(result.force, 1000.0);
    EXPECT_LT(std::fabs(result.sum_error), 0.01);
    EXPECT_LT(std::fabs(result.radius_error), 0.1);
    EXPECT_LT(std::fabs(result.pressure_error), 0.1);
    EXPECT_LT(result.askew, 1e-9);
}

}  // namespace
