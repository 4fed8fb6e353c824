// SPDX-License-Identifier: BSD-3-Clause
// Volumetric strain as the mean of a cell, and sand that opens no further than it may.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include <grit/sand_operators.h>

#include "../larger.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace mpm_test;

constexpr int cells = 6;

// Strains of one step of a block whose particles fly about, by id: the trace of F - I, and its deviator.
struct Strains {
    std::vector<double> volumetric, shear;
    std::vector<int> cell;
    std::vector<double> volume;
};

Strains one_step(bool cell_mean, bool axisymmetric, Scheme scheme) {
    Settings settings{.axisymmetric = axisymmetric, .scheme = scheme, .cell_mean = cell_mean};
    Simulation simulation(Axis::uniform(0.0, 1.0, cells), Axis::uniform(0.0, 1.0, cells), settings);
    Body body = make_box({0.0, 1.0, 0.0, 1.0, 3 * cells, 2 * cells, 1000.0}, axisymmetric,
                         std::make_unique<LinearElastic>(1e6, 0.49));
    const ParticleView q = body.particles.view();
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    Strains out;
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        q[column::v_r][p] = any(generator);
        q[column::v_z][p] = any(generator);
        out.cell.push_back(static_cast<int>(q[column::z][p] * cells) * cells +
                           static_cast<int>(q[column::r][p] * cells));
        out.volume.push_back(q[column::V0][p]);
    }
    simulation.add_body(std::move(body));
    simulation.step();
    const Particles& now = simulation.body(0).particles;
    for (int id = 0; id < now.size(); ++id) {
        const std::ptrdiff_t p = simulation.find(0, id);
        out.volumetric.push_back(now(column::F_rr, p) + now(column::F_zz, p) +
                                 now(column::F_tt, p) - 3.0);
        out.shear.push_back(now(column::F_rz, p) + now(column::F_zr, p));
    }
    return out;
}

TEST(CellMean, GivesAllParticlesOfACellTheirMeanVolumetricStrainAndLeavesShearAlone) {
    for (const bool axisymmetric : {true, false})
        for (const Scheme scheme : {Scheme::usl, Scheme::musl, Scheme::usf}) {
            const Strains mean = one_step(true, axisymmetric, scheme);
            const Strains own = one_step(false, axisymmetric, scheme);
            std::map<int, double> sum, volume, largest, smallest;
            for (std::size_t p = 0; p < own.cell.size(); ++p) {
                sum[own.cell[p]] += own.volume[p] * own.volumetric[p];
                volume[own.cell[p]] += own.volume[p];
            }
            double scatter = 0.0;
            for (std::size_t p = 0; p < own.cell.size(); ++p) {
                const double expected = sum[own.cell[p]] / volume[own.cell[p]];
                EXPECT_NEAR(mean.volumetric[p], expected, 1e-12);
                if (scheme != Scheme::usf) {  // there stress acts in the same step
                    EXPECT_NEAR(mean.shear[p], own.shear[p], 1e-14);
                }
                scatter = larger(scatter, std::fabs(own.volumetric[p] - expected));
            }
            EXPECT_GT(scatter, 1e-4);  // there was something to average
        }
}

// A block in free vibration whose particles are stressed each differently: the residual of its energy as a
// share of that of the motion at the start.
double residual_of_vibration(bool cell_mean, bool axisymmetric) {
    Settings settings{
        .axisymmetric = axisymmetric, .cfl = 0.1, .linear_viscosity = 0.05, .cell_mean = cell_mean};
    Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 1.0, 10), settings);
    Body body = make_box({0.0, 0.53, 0.21, 0.74, 11, 11, 1000.0}, axisymmetric,
                         std::make_unique<LinearElastic>(1e6, 0.3));
    const ParticleView q = body.particles.view();
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> any(-1e4, 1e4);
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        for (const int c : {column::S_rr, column::S_zz, column::S_tt}) q[c][p] = any(generator);
        q[column::v_r][p] = -q[column::r][p];
        q[column::v_z][p] = std::sin(6.0 * q[column::z][p]) * q[column::r][p];
    }
    simulation.add_body(std::move(body));
    for (int i = 0; i < 200; ++i) simulation.step();
    return simulation.energy().residual() / simulation.energy().kinetic_0;
}

TEST(CellMean, LetsNodalForcesDoTheWorkThatTheStressesTake) {
    for (const bool axisymmetric : {true, false}) {
        const double own = residual_of_vibration(false, axisymmetric);
        EXPECT_NEAR(residual_of_vibration(true, axisymmetric), own, 3e-4);
    }
}

// A thick cylinder that hardly changes its volume, eight cells across its wall: displacement of the inner
// face as a share of Lame's, and the largest error of the radial stress as a share of the pressure.
struct Cylinder {
    double displacement, stress_error;
};

Cylinder inflate(bool cell_mean) {
    constexpr double a = 0.5, b = 1.0, E = 1e7, nu = 0.499, pressure = 1000.0, h = 0.0625;
    Settings settings{.axisymmetric = true, .local_damping = 0.5, .cell_mean = cell_mean};
    Simulation simulation(Axis::uniform(0.0, b + 2.0 * h, 18), Axis::uniform(0.0, 2.0 * h, 2),
                          settings);
    simulation.add_body(make_box({a, b, 0.0, 2.0 * h, 16, 4, 1000.0}, true,
                                 std::make_unique<LinearElastic>(E, nu)));
    simulation.fix_below(1, 0.0);
    simulation.fix_above(1, 2.0 * h);
    for (int j = 0; j < 4; ++j)
        simulation.add_traction({0, 16 * j, Edge::left, [](double) {
                                     return grit::Vector2{pressure, 0.0};
                                 }});
    while (simulation.time() < 0.2) simulation.step();
    const Particles& q = simulation.body(0).particles;
    const std::ptrdiff_t inner = simulation.find(0, 0);
    const double u_a = q(column::r, inner) - q(column::F_rr, inner) * q(column::l_r, inner) - a;
    const double share = pressure * a * a / (b * b - a * a);
    const double exact = share * (1.0 + nu) / (E * a) * ((1.0 - 2.0 * nu) * a * a + b * b);
    Cylinder out{u_a / exact, 0.0};
    for (int i = 0; i < 16; ++i) {
        const std::ptrdiff_t p = simulation.find(0, i);
        const double radial = share * (1.0 - b * b / std::pow(q(column::r, p), 2));
        out.stress_error =
            larger(out.stress_error, std::fabs(q(column::S_rr, p) - radial) / pressure);
    }
    return out;
}

TEST(CellMean, UnlocksACylinderThatKeepsItsVolume) {
    const Cylinder locked = inflate(false), free = inflate(true);
    EXPECT_LT(locked.displacement, 0.9);
    EXPECT_NEAR(free.displacement, 1.0, 0.002);
    EXPECT_GT(locked.stress_error, 5.0);
    EXPECT_LT(free.stress_error, 0.06);
}

TEST(SeparatedSand, OpensToItsCapAndBearsAgainOnlyOnceItHasClosed) {
    const grit_sand sand = lausitz();
    Settings settings{.axisymmetric = false, .cfl = 0.1, .largest_step = 1e-3};
    Simulation simulation(Axis::uniform(0.0, 0.2, 2), Axis::uniform(0.0, 2.0, 20), settings);
    Body body = make_box({0.0, 0.2, 0.0, 0.5, 4, 10, 1700.0}, false,
                         std::make_unique<Sand>(sand, sand_options()));
    ParticleView q = body.particles.view();
    double void_ratios[3];
    grit_sand_void_ratios(&sand, 0.0, void_ratios);
    const double cap = 1.2 * void_ratios[0];
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        for (const int c : {column::S_rr, column::S_zz, column::S_tt}) q[c][p] = -5000.0;
        q[Sand::state + GRIT_SAND_VOID_RATIO][p] = 0.8;
        q[column::v_z][p] = 4.0 * q[column::z][p];  // drawn out, up to 140 %
    }
    simulation.add_body(std::move(body));
    simulation.fix_below(1, 0.0);
    simulation.fix_below(0, 0.0);
    simulation.fix_above(0, 0.2);
    while (simulation.time() < 0.35) simulation.step();
    q = simulation.body(0).particles.view();
    int capped = 0;
    for (std::ptrdiff_t p = 0; p < 40; ++p) {
        const double e = q[Sand::state + GRIT_SAND_VOID_RATIO][p];
        EXPECT_LE(e, cap * 1.01);                      // one step beyond at most
        EXPECT_NEAR(1.8 * q.J(p), 1.0 + e, 1e-2 * e);  // its domain as well
        if (e >= cap) ++capped;
    }
    EXPECT_GT(capped, 20);
    // And back together.
    for (std::ptrdiff_t p = 0; p < 40; ++p) q[column::v_z][p] = -4.0 * q[column::z][p];
    bool bears = false;
    for (int i = 0; i < 4000 && !bears; ++i) {
        simulation.step();
        q = simulation.body(0).particles.view();
        for (std::ptrdiff_t p = 0; p < 40; ++p) {
            const bool loaded = q[column::S_zz][p] < 0.0;
            EXPECT_TRUE(!loaded || q[Sand::state + GRIT_SAND_SEPARATION][p] == 0.0);
            bears = bears || q[column::S_zz][p] < -1000.0;
        }
    }
    EXPECT_TRUE(bears);
}

}  // namespace
