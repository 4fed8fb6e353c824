// SPDX-License-Identifier: BSD-3-Clause
// A block on a rough plane, the grid across the plane: rest or slide on an incline, stick to slip under a
// growing load. Starts in equilibrium, so that nothing but friction moves it.
#include <cmath>

#include <bars/line.hpp>
#include <gtest/gtest.h>

namespace {

using namespace bars;

constexpr double cell = 0.1, density = 1000.0, stiffness = 1e6, dt = 2e-4;

struct Pair {
    Bar ground, block;
    // Accelerations of the block towards the ground and along it; shear: what friction holds.
    Pair(double base, double pressing, double pushing, double held)
        : ground(make_bar(base - 0.5, base, 10, density)),
          block(make_bar(base, base + 1.0, 20, density)) {
        ground.rigid = true;
        block.modulus = block.shear_modulus = stiffness;
        block.weight = -pressing;
        block.slip_weight = pushing;
        for (Particle& p : block.particles) {
            const double above = density * (base + 1.0 - p.x);
            p.sigma = -above * pressing;
            p.tau = above * held;
        }
    }
};

Contact rough(Contact contact, double mu) {
    contact.options.friction_coefficient = mu;
    return contact;
}

void expect_incline(const Contact& contact, double mu, double base) {
    const double g = 9.81, theta = M_PI / 6.0, t = 1.0;
    const double pressing = g * std::cos(theta), pushing = g * std::sin(theta);
    Pair pair(base, pressing, pushing, std::fmin(pushing, mu * pressing));
    Line line(0.0, cell, 30);
    for (int step = 0; step < std::lround(t / dt); ++step)
        line.step(pair.ground, pair.block, rough(contact, mu), dt);
    const bool rests = std::tan(theta) <= mu;
    const double expected = rests ? 0.0 : 0.5 * t * t * (pushing - mu * pressing);
    const double free = 0.5 * t * t * pushing;
    EXPECT_NEAR(pair.block.mean_slip(), expected, rests ? 1e-3 * free : 0.01 * expected)
        << "mu " << mu << ", base " << base;
    EXPECT_NEAR(pair.block.left(), base, 0.1 * cell);
    EXPECT_EQ(pair.ground.mean_slip_v(), 0.0);
}

TEST(BlockOnAnIncline, RestsOrSlidesAsCoulombSays) {
    for (const double mu : {0.2, 0.5, 0.6, 0.8})  // tan 30 degrees = 0.577
        for (const double base : {0.75, 0.80, 0.83}) {
            expect_incline(frictional_contact(true), mu, base);
            expect_incline(frictional_contact(false), mu, base);
            expect_incline(geo_contact(6.0, true), mu, base);
        }
}

TEST(StickToSlip, BeginsWhenTheLoadReachesCoulombsLimit) {
    // 1000 kg pressed by 1000 N, mu 0.3, pushed by 300 N/s.
    for (const Contact& law : {frictional_contact(true), geo_contact(6.0, true)}) {
        const Contact contact = rough(law, 0.3);
        Pair pair(0.75, 1.0, 0.0, 0.0);
        Line line(0.0, cell, 30);
        double slips_at = -1.0;
        for (int step = 0; step < std::lround(2.0 / dt); ++step) {
            pair.block.slip_weight = 0.3 * step * dt;
            const StepReport r = line.step(pair.ground, pair.block, contact, dt);
            if (slips_at < 0.0 && r.slipping > 0 && r.sticking == 0) slips_at = step * dt;
        }
        EXPECT_NEAR(slips_at, 1.0, 0.01);
        EXPECT_NEAR(pair.block.mean_slip_v(), 0.15, 0.0015);
        EXPECT_NEAR(pair.block.mean_slip(), 0.05, 0.0005);
    }
}

}  // namespace
