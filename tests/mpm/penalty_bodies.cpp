// SPDX-License-Identifier: BSD-3-Clause
// Bodies in penalty contact, in the driver.
#include <gtest/gtest.h>

#include <cmath>

#include "support/box.hpp"

namespace {

using namespace mpm_test;

// Two bars, L long, that meet with 2v: as in contact_bodies.cpp.
TEST(PenaltyBars, PressWithTheirImpedanceFromTheTouchOnAndPartAfterTheWave) {
    constexpr double E = 1000.0, rho = 1000.0, L = 1.0, h = 0.05, v = 0.01, width = 2.0 * h;
    const double c = std::sqrt(E / rho);
    for (const double offset : {0.0, 0.4}) {
        Settings settings{.axisymmetric = false, .cfl = 0.1};
        Simulation simulation(Axis::uniform(0.0, width, 2), Axis::uniform(0.0, 3.0, 60), settings);
        const double gap = 0.5 * h, bottom = (8.0 + offset) * h, top = bottom + L + gap;
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
        PenaltyLaw law = penalty_law(0.0, 10.0, E, h);
        law.line_a.points = {{width, bottom + L}, {0.0, bottom + L}};
        law.line_b.points = {{0.0, top}, {width, top}};
        simulation.add_contact(law);
        double first = -1.0, last = -1.0, impulse = 0.0, middle = 0.0, middle_time = 0.0;
        const double touch = gap / (2.0 * v);
        while (simulation.time() < touch + 4.0 * L / c) {
            const double t = simulation.time(), dt = simulation.next_step();
            simulation.step();
            const grit_penalty_totals& totals = simulation.penalty_contact(0).totals();
            const double force = totals.force_on_b[1] / width;
            EXPECT_NEAR(totals.force_on_a[1] / width, -force, 1e-12 * (1.0 + force));
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
        EXPECT_NEAR(last - first, 2.0 * L / c, 0.10 * 2.0 * L / c);
        EXPECT_NEAR(impulse, 2.0 * rho * v * L, 0.05 * 2.0 * rho * v * L);
        const Energy energy = simulation.energy();
        EXPECT_NEAR(energy.residual(), 0.0, 0.01 * energy.kinetic_0);
    }
}

// A block on a rigid floor that slopes at angle theta; its way as a share of g t^2/2 along the floor.
double slide(double angle, double mu) {
    constexpr double g = 9.81, T = 0.5, cell = 0.1;
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
    PenaltyLaw law = penalty_law(mu, 1.0, 1.35e6, cell);
    law.line_a.points = {{3.0, 0.5}, {0.0, 0.5}};
    law.line_b.points = {{0.5, 0.5}, {0.9, 0.5}, {0.9, 0.9}, {0.5, 0.9}};
    law.line_b.closed = true;
    simulation.add_contact(law);
    const Particles& q = simulation.body(1).particles;
    const auto middle = [&] {
        double sum = 0.0;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) sum += q(column::r, p);
        return sum / static_cast<double>(q.size());
    };
    const double start = middle();
    while (simulation.time() < T) simulation.step();
    const Energy energy = simulation.energy();
    EXPECT_NEAR(energy.residual(), 0.0, 0.02 * std::fabs(energy.external_work));
    return (middle() - start) / (0.5 * g * simulation.time() * simulation.time());
}

TEST(PenaltyBlockOnASlope, RestsBelowTheFrictionAngleAndSlidesAboveIt) {
    EXPECT_NEAR(slide(0.3, 0.5), 0.0, 0.01);
    const double expected = std::sin(0.7) - 0.3 * std::cos(0.7);
    EXPECT_NEAR(slide(0.7, 0.3), expected, 0.02 * expected);
}

// A rigid disk pressed into a block: its line is split as it stretches, no vertex leaves its body.
TEST(PenaltyLine, FollowsABodyThatStretches) {
    constexpr double h = 0.1, rate = 2.0;
    Settings settings{.axisymmetric = false, .cfl = 0.2};
    Simulation simulation(Axis::uniform(0.0, 4.0, 40), Axis::uniform(0.0, 1.0, 10), settings);
    Body block =
        make_box({0.5, 1.5, 0.2, 0.6, 20, 8, 1000.0}, false, std::make_unique<NeoHooke>(1e3, 0.0));
    const ParticleView q = block.particles.view();
    for (std::ptrdiff_t p = 0; p < block.particles.size(); ++p)
        q[column::v_r][p] = rate * (q[column::r][p] - 1.0);
    simulation.add_body(std::move(block));
    Body far = make_box({3.5, 3.9, 0.2, 0.6, 8, 8, 1000.0}, false, nullptr);
    far.prescribed_velocity = [](double) { return Vector{0.0, 0.0}; };
    simulation.add_body(std::move(far));
    PenaltyLaw law = penalty_law(0.0, 1.0, 1e3, h);
    law.line_a = {{{0.5, 0.2}, {1.5, 0.2}, {1.5, 0.6}, {0.5, 0.6}}, true};
    law.line_b = {{{3.5, 0.6}, {3.5, 0.2}}, false};
    simulation.add_contact(law);
    while (simulation.time() < 0.3) simulation.step();
    const Particles& now = simulation.body(0).particles;
    double right = 0.0;
    for (std::ptrdiff_t p = 0; p < now.size(); ++p)
        right = std::max(right, now(column::r, p) + now(column::F_rr, p) * now(column::l_r, p));
    const std::vector<double>& x = simulation.penalty_contact(0).vertices(0);
    double longest = 0.0, tip = 0.0;
    for (std::size_t v = 0; v < x.size(); v += 2) {
        const std::size_t next = (v + 2) % x.size();
        longest = std::max(longest, std::hypot(x[next] - x[v], x[next + 1] - x[v + 1]));
        tip = std::max(tip, x[v]);
    }
    EXPECT_GT(right, 1.6);  // it has stretched
    EXPECT_NEAR(tip, right, 0.1 * h);
    EXPECT_LE(longest, h * (1.0 + 1e-12));
}

}  // namespace
