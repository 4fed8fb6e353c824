// SPDX-License-Identifier: BSD-3-Clause
// V4, V6, V7: columns that know their answer.
#include <gtest/gtest.h>

#include <cmath>

#include "support/confined_bar.hpp"

namespace {

using namespace mpm_test;
TEST(ConfinedBar, VibratesInItsFirstMode) {
    const double allowed[3][2] = {{2.2e-2, 1.0e-3}, {6.9e-3, 1.4e-4}, {2.7e-3, 2.0e-5}};
    for (const bool axisymmetric : {false, true})
        for (const int k : {0, 1, 2}) {
            const ModeError error = vibrate(16 << k, axisymmetric);
            EXPECT_LT(error.velocity, allowed[k][0]) << (16 << k) << " cells";
            EXPECT_LT(std::fabs(error.energy), allowed[k][1]);
            EXPECT_LT(std::fabs(error.residual), allowed[k][1]);
        }
}

TEST(ConfinedBar, VibratesAlikeWhetherStressIsUpdatedFirstOrLast) {
    for (const Scheme scheme : {Scheme::usl, Scheme::musl, Scheme::usf}) {
        const ModeError at_16 = vibrate(16, true, scheme), at_32 = vibrate(32, true, scheme);
        EXPECT_LT(at_16.velocity, 2.2e-2);
        EXPECT_LT(at_32.velocity, 6.9e-3);
        EXPECT_LT(std::fabs(at_16.residual), 1e-3);
    }
}

TEST(ConfinedBar, LosesToThePicShareWhatTheBalanceSays) {
    const ModeError error = vibrate(16, true, Scheme::usl, 200.0);
    EXPECT_LT(error.energy, -0.02);
    EXPECT_NEAR(error.residual, 0.0, 0.02 * std::fabs(error.energy));
}

// Self-weight, brought to rest by local damping.
TEST(Column, UnderItsWeightCarriesWhatLiesAboveAndPressesAgainstItsSides) {
    constexpr double E = 1e7, nu = 0.3, rho = 1000.0, g = 9.81, L = 1.0, K0 = nu / (1.0 - nu);
    for (const bool axisymmetric : {false, true}) {
        Settings settings{.axisymmetric = axisymmetric, .local_damping = 0.5, .gravity_z = -g};
        Simulation simulation(Axis::uniform(0.0, 0.0625, 4), Axis::uniform(0.0, 1.0625, 68),
                              settings);
        simulation.add_body(make_box({0.0, 0.0625, 0.0, L, 8, 128, rho}, axisymmetric,
                                     std::make_unique<LinearElastic>(E, nu)));
        simulation.fix_above(0, 0.0625);
        simulation.fix_below(0, 0.0);
        simulation.fix_below(1, 0.0);
        while (simulation.time() < 0.4) simulation.step();
        const Particles& q = simulation.body(0).particles;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            const double vertical = -rho * g * (L - q(column::z, p));
            EXPECT_NEAR(q(column::S_zz, p), vertical, 0.005 * rho * g * L);
            EXPECT_NEAR(q(column::S_rr, p), K0 * vertical, 0.005 * rho * g * L);
            EXPECT_NEAR(q(column::S_tt, p), K0 * vertical, 0.005 * rho * g * L);
            EXPECT_NEAR(q(column::S_rz, p), 0.0, 0.005 * rho * g * L);
        }
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 0.001 * energy.external_work);
        EXPECT_LT(energy.kinetic, 1e-6 * energy.external_work);
    }
}

// A confined bar whose top has felt a pressure from t = 0 on, when the front has passed 0.6 of it.
std::unique_ptr<Simulation> pressed_bar(const Settings& settings,
                                        std::unique_ptr<Material> material, double pressure) {
    constexpr double E = 1e7, rho = 1000.0, L = 1.0;
    constexpr int cells = 100;
    auto out = std::make_unique<Simulation>(Axis::uniform(0.0, 0.04, 4),
                                            Axis::uniform(0.0, 1.1 * L, 110), settings);
    out->add_body(make_box({0.0, 0.04, 0.0, L, 4, 2 * cells, rho}, settings.axisymmetric,
                           std::move(material)));
    for (int i = 0; i < 4; ++i)
        out->add_traction({0, (2 * cells - 1) * 4 + i, Edge::top, [pressure](double) {
                               return grit::Vector2{0.0, -pressure};
                           }});
    out->fix_above(0, 0.04);
    out->fix_below(0, 0.0);
    out->fix_below(1, 0.0);
    while (out->time() < 0.6 * L / std::sqrt(E / rho)) out->step();
    return out;
}

TEST(SteppedBar, MovesWithPressureOverImpedanceBehindAFrontOfTheWaveSpeed) {
    constexpr double E = 1e7, rho = 1000.0, L = 1.0, pressure = 1000.0;
    const double c = std::sqrt(E / rho), v = pressure / (rho * c);
    for (const bool axisymmetric : {false, true}) {
        Settings settings{.axisymmetric = axisymmetric, .cfl = 0.2, .pic_rate = 0.0};
        const auto stepped =
            pressed_bar(settings, std::make_unique<LinearElastic>(E, 0.0), pressure);
        Simulation& simulation = *stepped;
        const Particles& q = simulation.body(0).particles;
        double behind = 0.0, count = 0.0, ahead = 0.0, momentum = 0.0, front = L;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            const double z = q(column::z, p), v_z = q(column::v_z, p);
            momentum += q(column::mass, p) * v_z;
            if (z > 0.5 * L) {
                behind += v_z;
                count += 1.0;
            }
            if (z < 0.3 * L) ahead = std::max(ahead, std::fabs(v_z));
            if (v_z < -0.5 * v) front = std::min(front, z);
        }
        EXPECT_NEAR(behind / count, -v, 0.01 * v);
        EXPECT_LT(ahead, 0.01 * v);
        EXPECT_NEAR(front, L - c * simulation.time(), 0.02 * L);
        const double area = axisymmetric ? 0.5 * 0.04 * 0.04 : 0.04;  // per radian, per metre
        EXPECT_NEAR(momentum, -pressure * area * simulation.time(),
                    1e-6 * pressure * area * simulation.time());
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 0.005 * energy.external_work);
    }
}

// On its support, with the stress of its weight.
TEST(Column, InEquilibriumRestsWhicheverComesFirst) {
    constexpr double E = 1e7, rho = 1000.0, g = 9.81, L = 1.0;
    for (const Scheme scheme : {Scheme::usl, Scheme::musl, Scheme::usf}) {
        Simulation simulation(Axis::uniform(0.0, 0.1, 1), Axis::uniform(0.0, 1.2, 12),
                              {.axisymmetric = true, .scheme = scheme, .gravity_z = -g});
        Body body =
            make_box({0.0, 0.1, 0.0, L, 2, 20, rho}, true, std::make_unique<LinearElastic>(E, 0.0));
        const ParticleView q = body.particles.view();
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
            q[column::S_zz][p] = -rho * g * (L - q[column::z][p]);
        simulation.add_body(std::move(body));
        simulation.fix_above(0, 0.1);
        simulation.fix_below(1, 0.0);
        for (int i = 0; i < 300; ++i) simulation.step();
        EXPECT_LT(simulation.energy().kinetic, 1e-25);
    }
}

TEST(SteppedBar, ClosesItsBalanceWhicheverComesFirst) {
    for (const Scheme scheme : {Scheme::usl, Scheme::musl, Scheme::usf}) {
        const auto simulation = pressed_bar({.axisymmetric = true, .scheme = scheme, .cfl = 0.4},
                                            std::make_unique<NeoHooke>(1e7, 0.0), 3e5);
        const Energy energy = simulation->energy();
        EXPECT_NEAR(energy.residual() / energy.external_work, 0.0, 0.005);
    }
}

// The top of a block crosses grid lines while it is pushed down.
TEST(Traction, GivesAllItsImpulseWhateverTheShapeFunctions) {
    for (const Shape shape : {Shape::cpdi, Shape::ugimp, Shape::point}) {
        Simulation simulation(Axis::uniform(0.0, 0.5, 5), Axis::uniform(0.0, 1.0, 10),
                              {.axisymmetric = false, .shape = shape, .scheme = Scheme::musl});
        simulation.add_body(make_box({0.1, 0.4, 0.53, 0.83, 6, 6, 1000.0}, false,
                                     std::make_unique<LinearElastic>(1e6, 0.2)));
        for (int i = 0; i < 6; ++i)
            simulation.add_traction({0, 30 + i, Edge::top, [](double) {
                                         return grit::Vector2{0.0, -1e3};
                                     }});
        while (simulation.time() < 0.2) simulation.step();
        const Particles& q = simulation.body(0).particles;
        double momentum = 0.0;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p)
            momentum -= q(column::mass, p) * q(column::v_z, p);
        EXPECT_NEAR(momentum, 1e3 * 0.3 * simulation.time(), 0.003 * momentum);
    }
}

TEST(PicShare, IsNeverMoreThanAll) {
    const ModeError error = vibrate(16, true, Scheme::usl, 1e6);
    EXPECT_LE(error.energy, 0.0);
    EXPECT_NEAR(error.residual, 0.0, 0.05);
}

// The same at once on a bar of neo-Hooke material: how much faster than behind the front anything is, and
// what has become of the energy.
struct Shock {
    double overshoot, viscosity, residual;  // [-], [J] as shares of the work of the pressure
};

Shock shock(double linear, double quadratic) {
    constexpr double L = 1.0, pressure = 1e6;
    Settings settings{.axisymmetric = true,
                      .cfl = 0.2,
                      .linear_viscosity = linear,
                      .quadratic_viscosity = quadratic};
    const auto stepped = pressed_bar(settings, std::make_unique<NeoHooke>(1e7, 0.0), pressure);
    Simulation& simulation = *stepped;
    const Particles& q = simulation.body(0).particles;
    double fastest = 0.0, behind = 0.0, count = 0.0;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
        fastest = std::max(fastest, -q(column::v_z, p));
        if (q(column::z, p) < 0.6 * L || q(column::z, p) > 0.8 * L) continue;
        behind -= q(column::v_z, p);
        count += 1.0;
    }
    const Energy energy = simulation.energy();
    return {fastest * count / behind - 1.0, energy.viscosity / energy.external_work,
            energy.residual() / energy.external_work};
}

TEST(BulkViscosity, SmoothsAShockAndAccountsForWhatItTakes) {
    const Shock rough = shock(0.0, 0.0), smooth = shock(0.2, 1.5);
    EXPECT_EQ(rough.viscosity, 0.0);
    EXPECT_GT(rough.overshoot, 2.0 * smooth.overshoot);
    EXPECT_LT(smooth.overshoot, 0.07);
    EXPECT_GT(smooth.viscosity, 0.03);
    EXPECT_NEAR(rough.residual, 0.0, 0.003);
    EXPECT_NEAR(smooth.residual, 0.0, 1e-4);
}

}  // namespace
