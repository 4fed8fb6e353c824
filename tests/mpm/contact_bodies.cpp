// SPDX-License-Identifier: BSD-3-Clause
// Bodies that meet, slide and rest on each other, in the driver.
#include <gtest/gtest.h>

#include <cmath>

#include "support/box.hpp"

namespace {

using namespace mpm_test;

// A block on a rigid floor that slopes at angle theta, seen along the floor, after 0.5 s: its way, as a
// share of g t^2/2, and the residual of its energy as a share of the work of its weight.
struct Slide {
    double way, residual;
};

Slide slide(double angle, double mu, int law) {
    constexpr double g = 9.81, T = 0.5;
    Settings settings{.axisymmetric = false,
                      .pic_rate = 20.0,
                      .gravity_r = g * std::sin(angle),
                      .gravity_z = -g * std::cos(angle)};
    Simulation simulation(Axis::uniform(0.0, 3.0, 30), Axis::uniform(0.0, 1.2, 12), settings);
    Body floor = make_box({0.0, 3.0, 0.2, 0.5, 60, 6, 1000.0}, false, nullptr);
    floor.prescribed_velocity = [](double) { return Vector{0.0, 0.0}; };
    simulation.add_body(std::move(floor));
    simulation.add_body(make_box({0.5, 0.9, 0.5, 0.9, 8, 8, 1000.0}, false,
                                 std::make_unique<LinearElastic>(1e6, 0.3)));
    simulation.add_contact(contact_law(law, mu));
    const Particles& q = simulation.body(1).particles;
    const auto middle = [&] {
        double sum = 0.0;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) sum += q(column::r, p);
        return sum / static_cast<double>(q.size());
    };
    const double start = middle();
    while (simulation.time() < T) simulation.step();
    const Energy energy = simulation.energy();
    return {(middle() - start) / (0.5 * g * simulation.time() * simulation.time()),
            energy.residual() / energy.external_work};
}

TEST(BlockOnASlope, RestsBelowTheFrictionAngleAndSlidesAboveIt) {
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
        EXPECT_NEAR(slide(0.3, 0.5, law).way, 0.0, 0.01);
        const Slide sliding = slide(0.7, 0.3, law);
        const double expected = std::sin(0.7) - 0.3 * std::cos(0.7);
        EXPECT_NEAR(sliding.way, expected, 0.02 * expected);
        EXPECT_NEAR(sliding.residual, 0.0, 0.01);
    }
}

TEST(TwoBars, TouchWhenTheGapIsClosedPressWithTheirImpedanceAndPartAfterTheWave) {
    constexpr double E = 1000.0, rho = 1000.0, L = 1.0, h = 0.05, v = 0.01, width = 2.0 * h;
    const double c = std::sqrt(E / rho);
    for (const double offset : {0.0, 0.4}) {
        Settings settings{.axisymmetric = false, .cfl = 0.1};
        Simulation simulation(Axis::uniform(0.0, width, 2), Axis::uniform(0.0, 3.0, 60), settings);
        const double gap = 2.5 * h, bottom = (8.0 + offset) * h, top = bottom + L + gap;
        for (const int k : {0, 1}) {
            const double z = k == 0 ? bottom : top;
            Body bar = make_box({0.0, width, z, z + L, 4, 40, rho}, false,
                                std::make_unique<LinearElastic>(E, 0.0));
            for (std::ptrdiff_t p = 0; p < bar.particles.size(); ++p)
                bar.particles.view()[column::v_z][p] = k == 0 ? v : -v;
            simulation.add_body(std::move(bar));
        }
        simulation.fix_below(0, 0.0);
        simulation.fix_above(0, width);
        simulation.add_contact(contact_law(GRIT_CONTACT_GEO, 0.0));
        double first = -1.0, last = -1.0, impulse = 0.0, middle = 0.0, middle_time = 0.0;
        const double touch = gap / (2.0 * v);
        while (simulation.time() < touch + 4.0 * L / c) {
            const double t = simulation.time(), dt = simulation.next_step();
            simulation.step();
            const double force = simulation.contact(0).totals().force_on_b[1] / width;
            EXPECT_NEAR(simulation.contact(0).totals().force_on_a[1] / width, -force, 1e-12);
            if (force == 0.0) continue;
            if (first < 0.0) first = t;
            last = t + dt;
            impulse += force * dt;
            if (t > touch + 0.5 * L / c && t < touch + 1.5 * L / c) {
                middle += force * dt;
                middle_time += dt;
            }
        }
        EXPECT_NEAR((first - touch) * 2.0 * v, 0.0, 0.05 * h);
        EXPECT_NEAR(middle / middle_time, rho * c * v, 0.02 * rho * c * v);
        EXPECT_NEAR(last - first, 2.0 * L / c, 0.05 * 2.0 * L / c);
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 0.01 * energy.kinetic_0);
        EXPECT_NEAR(impulse, 2.0 * rho * v * L, 0.05 * 2.0 * rho * v * L);
        EXPECT_GT(energy.contact, 0.0);
    }
}

}  // namespace
