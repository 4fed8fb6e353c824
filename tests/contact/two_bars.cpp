// SPDX-License-Identifier: BSD-3-Clause
// Two bars collide (verification/bars): when contact starts, how hard and how long they press, what is
// left of their energy, at ten places of the bars against the grid.
#include <bars/impact.hpp>
#include <gtest/gtest.h>

namespace {

using namespace bars;

constexpr int offsets = 10;

void expect_wave_theory(const Contact& contact, const char* name) {
    for (int i = 0; i < offsets; ++i) {
        const Impact r = impact(contact, 0.1 * i);
        EXPECT_NEAR(r.start_gap, 0.0, 0.05) << name << ", offset " << i;
        EXPECT_NEAR(r.force, 1.0, 0.02) << name << ", offset " << i;
        EXPECT_NEAR(r.duration, 1.0, 0.05) << name << ", offset " << i;
        EXPECT_LE(r.most_energy, 1.0 + 1e-12) << name << ", offset " << i;
        EXPECT_GE(r.energy, 0.88) << name << ", offset " << i;  // one cell meets inelastically
    }
}

TEST(TwoBars, PressAsTheWaveTheorySaysInGatedGeoContact) {
    for (const double k : {2.0, 4.0, 6.0, 10.0}) expect_wave_theory(geo_contact(k, true), "GCA");
}

TEST(TwoBars, PressAsTheWaveTheorySaysInGatedFrictionalContact) {
    expect_wave_theory(frictional_contact(true), "FCA");
}

TEST(TwoBars, PressAsTheWaveTheorySaysInPenaltyContact) {
    expect_wave_theory(penalty_contact(impact_penalty_stiffness(1.0)), "PCA");
}

TEST(TwoBars, TouchACellTooEarlyAndTooSoftlyWithoutTheGate) {
    for (int i = 0; i < offsets; ++i) {
        const Impact r = impact(frictional_contact(false), 0.1 * i);
        EXPECT_GE(r.start_gap, 1.0) << i;
        EXPECT_LE(r.force, 0.8) << i;
        EXPECT_GE(r.duration, 1.6) << i;
        EXPECT_LE(r.most_energy, 1.0 + 1e-12) << i;
    }
}

TEST(TwoBars, LoseNeverEnergyToNothing) {
    // What the bars have less is what contact took: the leapfrog value closes the balance.
    Bar a = make_bar(0.25, 1.25, 40, 1000.0), b = make_bar(1.3, 2.3, 40, 1000.0);
    a.modulus = b.modulus = 1000.0;
    for (Particle& p : a.particles) p.v = 0.01;
    for (Particle& p : b.particles) p.v = -0.01;
    Line line(0.0, 0.05, 60);
    const double before = a.energy() + b.energy(), dt = 0.001;
    double taken = 0.0;
    const double momentum = a.momentum() + b.momentum();
    for (int step = 0; step < 6000; ++step) {
        taken += line.step(a, b, frictional_contact(true), dt).dissipation;
        ASSERT_NEAR(a.momentum() + b.momentum(), momentum, 1e-11);
    }
    const double lost = before - a.energy() - b.energy();
    EXPECT_GT(lost, 0.01 * before);
    EXPECT_NEAR(taken, lost, 0.1 * lost);  // the rest stays in FLIP's fluctuations
}

}  // namespace
