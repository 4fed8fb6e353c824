// SPDX-License-Identifier: BSD-3-Clause
// A column of Lausitz sand (e 0.65) under its weight that has come to rest stays at rest for a second.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <grit/sand_operators.h>

#include "support/lausitz.hpp"

namespace {

using namespace mpm_test;

constexpr double rho = 1600.0, g = 9.81, H = 1.0, e = 0.65;

struct Column {
    bool axisymmetric;
    int points;  // per cell and direction
    int cells = 16;
    double width() const { return 2.0 * H / cells; }
};

Simulation simulation_of(const Column& column, double damping) {
    const Settings settings{
        .axisymmetric = column.axisymmetric, .local_damping = damping, .gravity_z = -g};
    return Simulation(Axis::uniform(0.0, column.width(), 2),
                      Axis::uniform(0.0, H + column.width(), column.cells + 2), settings);
}

void add_between_walls(Simulation& simulation, Body body, const Column& column) {
    simulation.add_body(std::move(body));
    simulation.fix_below(1, 0.0);
    simulation.fix_below(0, 0.0);
    simulation.fix_above(0, column.width());
}

Body make_sand(const Column& column, bool with_stress) {
    const grit_sand sand = lausitz();
    Body body = make_box(
        {0.0, column.width(), 0.0, H, 2 * column.points, column.cells * column.points, rho},
        column.axisymmetric, std::make_unique<Sand>(sand, sand_options()));
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        double stress[6] = {};
        if (with_stress)
            grit_sand_stress_at_rest(&sand, rho * g, H - q[column::z][p], 0.0, -1.0, 1, stress);
        for (int k = 0; k < 4; ++k) q[column::S_rr + k][p] = stress[k];
        q[Sand::state + GRIT_SAND_VOID_RATIO][p] = e;
    }
    return body;
}

// Weight of what lies above the middle of a particle, on the column's area [Pa].
double weight_above(const Particles& q, std::ptrdiff_t p, const Column& column) {
    double mass = 0.0;
    for (std::ptrdiff_t k = 0; k < q.size(); ++k) {
        const double above = q(column::z, k) - q(column::z, p);
        const bool same_row = std::fabs(above) < 1e-4 * H;
        mass += same_row ? 0.5 * q(column::mass, k) : above > 0.0 ? q(column::mass, k) : 0.0;
    }
    const double width = column.width();
    return mass * g / (column.axisymmetric ? 0.5 * width * width : width);
}

// Undamped, for a second.
void stays_at_rest(Simulation& simulation, const Column& column) {
    const Particles& q = simulation.body(0).particles;
    const auto size = static_cast<std::size_t>(q.size());
    std::vector<double> void_ratio(size);
    const auto each = [&](const auto& work) {
        for (std::size_t id = 0; id < size; ++id)
            work(id,
                 q(Sand::state + GRIT_SAND_VOID_RATIO, simulation.find(0, static_cast<int>(id))));
    };
    const double start = simulation.time();
    while (simulation.time() < start + 0.5) simulation.step();
    each([&](std::size_t id, double now) { void_ratio[id] = now; });
    while (simulation.time() < start + 1.0) simulation.step();
    each([&](std::size_t id, double now) { EXPECT_NEAR(now, void_ratio[id], 1e-5); });
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        EXPECT_NEAR(q(column::S_zz, p), -weight_above(q, p, column), 0.01 * rho * g * H);
}

TEST(SandColumn, ThatStartsAtK0StaysAtRestForASecond) {
    for (const Column& column : {Column{true, 2}, Column{false, 2}}) {
        Simulation simulation = simulation_of(column, 0.0);
        add_between_walls(simulation, make_sand(column, true), column);
        stays_at_rest(simulation, column);
    }
}

// It settles by 2 %, a third of a cell at its top. With several points along a cell, those that the cell
// boundaries then cut keep stresses that balance within the cell.
TEST(SandColumn, ThatStartsWithoutStressSettlesAndThenStaysAtRestForASecond) {
    for (const Column& column : {Column{true, 1}, Column{false, 1}}) {
        Simulation settling = simulation_of(column, 0.5);
        add_between_walls(settling, make_sand(column, false), column);
        while (settling.time() < 0.5) settling.step();
        const Particles& q = settling.body(0).particles;
        double lowest = e, top = 0.0;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            lowest = std::min(lowest, q(Sand::state + GRIT_SAND_VOID_RATIO, p));
            top = std::max(top, q(column::z, p));
        }
        EXPECT_LT(lowest, e - 0.03);  // it has densified ...
        EXPECT_LT(top, H - 0.04);     // ... and come down
        Simulation settled = simulation_of(column, 0.0);
        add_between_walls(settled, std::move(settling.body(0)), column);
        stays_at_rest(settled, column);
    }
}

}  // namespace
