// SPDX-License-Identifier: BSD-3-Clause
// Sand of the library in material points.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <grit/sand_operators.h>

#include "support/lausitz.hpp"

namespace {

using namespace mpm_test;

// Point i under a random stress, and a random strain and turn of it.
void press_and_strain(const ParticleView& q, Increments& d, int i,
                      std::uniform_real_distribution<double>& any, std::mt19937& generator) {
    for (const int c : {column::S_rr, column::S_zz, column::S_tt})
        q[c][i] = -100e3 * (1.5 + 0.5 * any(generator));
    q[column::S_rz][i] = 2e4 * any(generator);
    q[Sand::state + GRIT_SAND_VOID_RATIO][i] = 0.65;
    for (auto& strain : d.strain) strain[i] = 1e-4 * any(generator);
    const double angle = 1e-2 * any(generator);
    d.rotation[0][i] = d.rotation[4][i] = std::cos(angle);
    d.rotation[1][i] = std::sin(angle);
    d.rotation[3][i] = -std::sin(angle);
    d.rotation[8][i] = 1.0;
}

TEST(SandBody, GivesEachPointWhatTheLibraryGivesIt) {
    Sand material(lausitz(), sand_options());
    Body body = make_box({0.0, 1.0, 0.0, 1.0, 5, 10, 2000.0}, true,
                         std::make_unique<Sand>(lausitz(), sand_options()));
    const ParticleView q = body.particles.view();
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    Increments d{};
    for (int i = 0; i < 50; ++i) {
        press_and_strain(q, d, i, any, generator);
    }
    Particles alone = body.particles;
    material.update({q, 0, 50}, d);
    const ParticleView a = alone.view();
    const grit_sand sand = lausitz();
    const grit_sand_options given = sand_options();
    for (int i = 0; i < 50; ++i) {
        double stress[6] = {a[column::S_rr][i],
                            a[column::S_zz][i],
                            a[column::S_tt][i],
                            a[column::S_rz][i],
                            0.0,
                            0.0};
        double state[8] = {}, Q[9];
        state[GRIT_SAND_VOID_RATIO] = 0.65;
        const double strain[6] = {
            d.strain[0][i], d.strain[1][i], d.strain[2][i], d.strain[3][i], 0.0, 0.0};
        for (int k = 0; k < 9; ++k) Q[k] = d.rotation[k][i];
        grit_sand_points point{};
        point.struct_size = sizeof point;
        point.strain_increment = grit_view_of(strain, 6, 1);
        point.rotation_increment = grit_view_of(Q, 9, 1);
        point.stress = grit_mutable_view_of(stress, 6, 1);
        point.state = grit_mutable_view_of(state, 8, 1);
        ASSERT_EQ(grit_sand_update(&sand, &given, 1, &point, nullptr, nullptr), GRIT_OK);
        for (int k = 0; k < 4; ++k) EXPECT_EQ(q[column::S_rr + k][i], stress[k]);
        for (int k = 0; k < 4; ++k) EXPECT_EQ(q[Sand::state + k][i], state[k]);
        EXPECT_EQ(q[Sand::state + GRIT_SAND_VOID_RATIO][i], state[GRIT_SAND_VOID_RATIO]);
    }
}

// Beyond the axis: mirrored and then strained as strained and then mirrored, with the memory of sand and the water in its pores.
TEST(SandBody, BeyondTheAxisGoesOnAsItsMirrorImage) {
    const PoreWater water{.flows = true};
    Body body = make_box({0.0, 1.0, 0.0, 1.0, 5, 10, 2000.0}, true,
                         std::make_unique<Sand>(lausitz(), sand_options()), water);
    std::mt19937 generator(6);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    Increments d{}, mirrored{};
    ParticleView q = body.particles.view();
    for (int i = 0; i < 50; ++i) {
        press_and_strain(q, d, i, any, generator);
        for (const int h : {GRIT_SAND_H11, GRIT_SAND_H22, GRIT_SAND_H33, GRIT_SAND_H12})
            q[Sand::state + h][i] = 3e-5 * any(generator);
        const int w = body.water->velocity_column();
        for (const int c : std::initializer_list<int>{column::v_r, column::v_z, w, w + 1})
            q[c][i] = any(generator);
    }
    mirrored = d;
    for (int i = 0; i < 50; ++i) {
        mirrored.strain[3][i] = -d.strain[3][i];
        mirrored.rotation[1][i] = d.rotation[3][i];
        mirrored.rotation[3][i] = d.rotation[1][i];
    }
    const auto mirror = [&](Particles& particles) {
        for (std::ptrdiff_t p = 0; p < 50; ++p) {
            reflect(*body.material, particles.view(), p);
            reflect(*body.water, particles.view(), p);
        }
    };
    Particles first = body.particles;
    mirror(first);
    body.material->update({first.view(), 0, 50}, mirrored);
    body.material->update({q, 0, 50}, d);
    for (int i = 0; i < 50; ++i) {
        // Of the water itself, not of its way against the grains.
        const double w_r = q[column::v_r][i] + q[body.water->velocity_column()][i];
        const double w_z = q[column::v_z][i] + q[body.water->velocity_column() + 1][i];
        const ParticleView a = first.view();
        EXPECT_EQ(a[column::v_r][i] + a[body.water->velocity_column()][i], -w_r);
        EXPECT_EQ(a[column::v_z][i] + a[body.water->velocity_column() + 1][i], w_z);
    }
    mirror(body.particles);
    q = body.particles.view();
    for (int c = 0; c < body.particles.column_count(); ++c)
        for (int i = 0; i < 50; ++i)
            EXPECT_NEAR(first.view()[c][i], q[c][i], 1e-13 * std::fabs(q[c][i])) << "column " << c;
}

// Driven down by a rigid plate: void ratio follows the volume, the sand pushes back, energy is kept.
TEST(SandColumn, PressedByAPlateDensifiesAndTakesTheWorkOfThePlate) {
    constexpr double rho = 1700.0, width = 0.25, speed = 0.05;
    Settings settings{.pic_rate = 50.0};
    Simulation simulation(Axis::uniform(0.0, width, 4), Axis::uniform(0.0, 1.0, 16), settings);
    Body plate = make_box({0.0, width, 0.5, 0.75, 8, 8, 1000.0}, true, nullptr);
    plate.prescribed_velocity = [](double) { return grit::Vector2{0.0, -speed}; };
    simulation.add_body(std::move(plate));
    Body body = make_box({0.0, width, 0.0, 0.5, 8, 16, rho}, true,
                         std::make_unique<Sand>(lausitz(), sand_options()));
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        for (const int c : {column::S_rr, column::S_zz, column::S_tt}) q[c][p] = -1000.0;
        q[Sand::state + GRIT_SAND_VOID_RATIO][p] = 0.75;
    }
    simulation.add_body(std::move(body));
    simulation.fix_below(1, 0.0);
    simulation.fix_above(0, width);
    simulation.add_contact(contact_law(GRIT_CONTACT_FRICTIONAL, 0.3));
    while (simulation.time() < 0.1) simulation.step();  // 1 % on average
    const Particles& now = simulation.body(1).particles;
    const ParticleView v = simulation.body(1).particles.view();
    double J_mean = 0.0;
    for (std::ptrdiff_t p = 0; p < now.size(); ++p) {
        EXPECT_NEAR(now(Sand::state + GRIT_SAND_VOID_RATIO, p), 1.75 * v.J(p) - 1.0, 1e-5);
        J_mean += v.J(p) / static_cast<double>(now.size());
    }
    EXPECT_NEAR(J_mean, 0.99, 0.001);
    const Energy energy = simulation.energy();
    EXPECT_GT(energy.rigid_work, 0.0);
    EXPECT_NEAR(energy.residual(), 0.0, 0.02 * energy.rigid_work);
}

}  // namespace
