// SPDX-License-Identifier: BSD-3-Clause
// Bodies in penalty contact, in the driver.
#include <random>
#include <string>

#include "../larger.hpp"
#include "support/meeting_bodies.hpp"
#include "support/shapes.hpp"

namespace {

using namespace mpm_test;

TEST(PenaltyBars, PressWithTheirImpedanceFromTheTouchOnAndPartAfterTheWave) {
    for (const double offset : {0.0, 0.4}) {
        const MeetingBars bars{0.5 * MeetingBars::h, offset};
        const auto simulation = bars.build();
        PenaltyLaw law = penalty_law(0.0, 10.0, MeetingBars::E, MeetingBars::h);
        law.line_a.points = {{MeetingBars::width, bars.top_of_lower()}, {0.0, bars.top_of_lower()}};
        law.line_b.points = {{0.0, bars.bottom_of_upper()},
                             {MeetingBars::width, bars.bottom_of_upper()}};
        simulation->add_contact(law);
        const Meeting seen = meet(bars, *simulation, [&] {
            const grit_penalty_totals& totals = simulation->penalty_contact(0).totals();
            return grit::Vector2{totals.force_on_a[1], totals.force_on_b[1]};
        });
        EXPECT_NEAR(seen.gap_at_touch, 0.0, 0.05);
        EXPECT_NEAR(seen.force, 1.0, 0.02);
        EXPECT_NEAR(seen.duration, 1.0, 0.10);  // until springs ten times as stiff as a cell let go
        EXPECT_NEAR(seen.impulse, 1.0, 0.05);
        EXPECT_NEAR(seen.residual, 0.0, 0.01);
    }
}

// The step of the touch is short enough already.
TEST(PenaltyBars, KeepTheirEnergyHoweverStiffTheSprings) {
    for (const double multiple : {1.0, 20.0}) {
        const MeetingBars bars{0.5 * MeetingBars::h, 0.0, 0.4};
        const auto simulation = bars.build();
        PenaltyLaw law = penalty_law(0.0, multiple, MeetingBars::E, MeetingBars::h);
        law.line_a.points = {{MeetingBars::width, bars.top_of_lower()}, {0.0, bars.top_of_lower()}};
        law.line_b.points = {{0.0, bars.bottom_of_upper()},
                             {MeetingBars::width, bars.bottom_of_upper()}};
        simulation->add_contact(law);
        const double most = 1.1 * simulation->energy().kinetic_0;
        while (simulation->time() < 3.0) {
            simulation->step();
            const Energy energy = simulation->energy();
            ASSERT_LT(energy.kinetic + energy.stored, most) << multiple;
            ASSERT_LT(std::fabs(energy.residual()), 0.05 * most) << multiple;
        }
    }
}

TEST(PenaltyBlockOnASlope, RestsBelowTheFrictionAngleAndSlidesAboveIt) {
    const auto slide_with = [](double angle, double mu) {
        const auto simulation = block_on_slope(angle);
        PenaltyLaw law = penalty_law(mu, 1.0, 1.35e6, 0.1);
        law.line_a.points = {{3.0, 0.5}, {0.0, 0.5}};
        law.line_b = {{{0.5, 0.5}, {0.9, 0.5}, {0.9, 0.9}, {0.5, 0.9}}, true};
        simulation->add_contact(law);
        return slide(*simulation);
    };
    const Slide resting = slide_with(0.3, 0.5), sliding = slide_with(0.7, 0.3);
    const double expected = std::sin(0.7) - 0.3 * std::cos(0.7);
    EXPECT_NEAR(resting.way, 0.0, 0.01);
    EXPECT_NEAR(sliding.way, expected, 0.02 * expected);
    EXPECT_NEAR(resting.residual, 0.0, 0.02);
    EXPECT_NEAR(sliding.residual, 0.0, 0.02);
}

// Stresses that are no numbers move a line before any sum tells: it would be cut into no number of segments.
TEST(PenaltyLine, EndsTheStepByNameWhereItsBodyMovesByNoNumber) {
    for (const double stress : {NAN, INFINITY}) {
        const MeetingBars bars{0.5 * MeetingBars::h, 0.0};
        const auto simulation = bars.build();
        PenaltyLaw law = penalty_law(0.0, 1.0, MeetingBars::E, MeetingBars::h);
        law.line_a.points = {{MeetingBars::width, bars.top_of_lower()}, {0.0, bars.top_of_lower()}};
        law.line_b.points = {{0.0, bars.bottom_of_upper()},
                             {MeetingBars::width, bars.bottom_of_upper()}};
        simulation->add_contact(law);
        simulation->step();
        const Particles& lower = simulation->body(0).particles;
        for (std::ptrdiff_t p = 0; p < lower.size(); ++p)
            simulation->body(0).particles.view()[column::S_zz][p] = stress;
        try {
            simulation->step();
            FAIL() << "it went on";
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find("m, off the grid; is cfl too large?"),
                      std::string::npos)
                << error.what();
        }
    }
}

// By which the nodes are found whose mass is asked for.
TEST(PenaltyLine, TellsTheHeightsOfWhatPresses) {
    PenaltyLaw law = penalty_law(0.0, 1.0, 1e6, 0.1);
    law.line_a.points = {{0.5, 0.0}, {0.5, 1.0}};
    law.line_b.points = {{0.499, 1.0}, {0.499, 0.0}};
    PenaltyPair pair(law, false, 1);
    pair.find_forces(0.0);
    std::vector<double> told, heights;
    pair.each_pressed([&](double z) { told.push_back(z); });
    for (const int line : {0, 1})
        for (std::size_t i = 1; i < pair.vertices(line).size(); i += 2)
            heights.push_back(pair.vertices(line)[i]);
    EXPECT_GE(heights.size(), 20u);
    EXPECT_EQ(told, heights);
}

// What a checkpoint keeps of the vertices of both lines: places, velocities, histories, forces, stiffnesses.
struct OfVertices {
    std::vector<std::vector<double>> lists;
    template <class T> void own(const T*, std::size_t) {}
    void list(const std::vector<double>& of) { lists.push_back(of); }
};

// A line is split as its body stretches, and no vertex leaves it; one that is new moves as its body does there.
TEST(PenaltyLine, FollowsABodyThatStretches) {
    constexpr double h = 0.1, rate = 2.0, rise = 0.3;
    Settings settings{.axisymmetric = false, .cfl = 0.2};
    Simulation simulation(Axis::uniform(0.0, 4.0, 40), Axis::uniform(0.0, 1.0, 10), settings);
    Body block =
        make_box({0.5, 1.5, 0.2, 0.6, 20, 8, 1000.0}, false, std::make_unique<NeoHooke>(1e3, 0.0));
    const ParticleView q = block.particles.view();
    for (std::ptrdiff_t p = 0; p < block.particles.size(); ++p) {
        q[column::v_r][p] = rate * (q[column::r][p] - 1.0);
        q[column::v_z][p] = rise;
    }
    simulation.add_body(std::move(block));
    Body far = make_box({3.5, 3.9, 0.2, 0.6, 8, 8, 1000.0}, false, nullptr);
    far.prescribed_velocity = [](double) { return grit::Vector2{0.0, 0.0}; };
    simulation.add_body(std::move(far));
    PenaltyLaw law = penalty_law(0.0, 1.0, 1e3, h);
    law.line_a = {{{0.5, 0.2}, {1.5, 0.2}, {1.5, 0.6}, {0.5, 0.6}}, true};
    law.line_b = {{{3.5, 0.6}, {3.5, 0.2}}, false};
    simulation.add_contact(law);
    while (simulation.time() < 0.3) {
        simulation.step();
        OfVertices of;
        PenaltyPair::visit(simulation.penalty_contact(0), of);
        for (std::size_t v = 1; v < of.lists[1].size(); v += 2)
            ASSERT_NEAR(of.lists[1][v], rise, 1e-9 * rise) << simulation.time();
    }
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

// A line may be drawn, or may have come, where its body has no mass: what the one body gets the other one
// gives, or the step is refused.
TEST(PenaltyLine, LosesNoMomentumWhereverItIs) {
    constexpr double h = 0.1, v = 2.0;
    std::mt19937 generator(17);
    int refused = 0, pressed = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const auto off = [&] {
            return std::uniform_real_distribution<>(-0.5 * h, 4.0 * h)(generator);
        };
        const double lower = trial % 3 == 0 ? 0.0 : off(), upper = trial % 3 == 1 ? 0.0 : off();
        Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 3.0, 30),
                              {.axisymmetric = false, .fixed_point = trial % 2 == 0});
        for (const int k : {0, 1}) {
            Body block = make_box({0.3, 0.7, 1.0 + 0.45 * k, 1.4 + 0.45 * k, 8, 8, 1000.0}, false,
                                  std::make_unique<NeoHooke>(1e5, 0.2));
            block.name = k == 0 ? "lower" : "upper";
            const ParticleView q = block.particles.view();
            for (std::ptrdiff_t p = 0; p < block.particles.size(); ++p)
                q[column::v_z][p] = k == 0 ? v : -v;
            simulation.add_body(std::move(block));
        }
        PenaltyLaw law = penalty_law(0.2, 1.0, 1e5, h);
        law.line_a.points = {{0.7, 1.4 + lower}, {0.3, 1.4 + lower}};
        law.line_b.points = {{0.3, 1.45 - upper}, {0.7, 1.45 - upper}};
        simulation.add_contact(law);
        std::string told;
        double lost = 0.0;
        try {
            while (simulation.time() < 0.1) {
                simulation.step();
                if (simulation.penalty_contact(0).totals().contacts_a > 0) ++pressed;
                const CentreOfMass a = centre_of_mass(simulation.body(0).particles);
                const CentreOfMass b = centre_of_mass(simulation.body(1).particles);
                lost = larger(lost, std::fabs(a.mass * a.v_z + b.mass * b.v_z) / (a.mass * v));
            }
        } catch (const std::runtime_error& error) {
            told = error.what();
        }
        EXPECT_LT(lost, 1e-10) << lower << ' ' << upper;
        if (told.empty()) continue;
        ++refused;
        EXPECT_NE(told.find("penalty contact of lower and upper: vertex "), std::string::npos);
        EXPECT_NE(told.find(" is in a cell where no node has mass of this body"), std::string::npos)
            << told;
    }
    EXPECT_GT(refused, 10);
    EXPECT_GT(pressed, 100);
}

// A body that parts under its line, far from the other one: a vertex over the gap would stay where it is, and press there
// when something comes.
TEST(PenaltyLine, IsRefusedWhereItsBodyLeavesAVertexBehind) {
    constexpr double h = 0.1;
    Simulation simulation(Axis::uniform(0.0, 4.0, 40), Axis::uniform(0.0, 2.0, 20),
                          {.axisymmetric = false, .cfl = 0.2});
    Body dust =
        make_box({1.0, 3.0, 0.2, 0.6, 40, 8, 1000.0}, false, std::make_unique<NeoHooke>(1e-3, 0.0));
    dust.name = "dust";
    const ParticleView q = dust.particles.view();
    for (std::ptrdiff_t p = 0; p < dust.particles.size(); ++p)
        q[column::v_r][p] = q[column::r][p] < 2.0 ? -1.0 : 1.0;
    simulation.add_body(std::move(dust));
    Body far = make_box({1.0, 3.0, 1.5, 1.9, 8, 8, 1000.0}, false, nullptr);
    far.name = "far";
    far.prescribed_velocity = [](double) { return grit::Vector2{0.0, 0.0}; };
    simulation.add_body(std::move(far));
    PenaltyLaw law = penalty_law(0.0, 1.0, 1e3, h);
    law.line_a.points = {{3.0, 0.6}, {2.0, 0.6}, {1.0, 0.6}};
    law.line_b.points = {{1.0, 1.5}, {3.0, 1.5}};
    simulation.add_contact(law);
    std::string told;
    try {
        while (simulation.time() < 0.5) simulation.step();
    } catch (const std::runtime_error& error) {
        told = error.what();
    }
    EXPECT_NE(told.find(" of the line of dust, at ("), std::string::npos) << told;
    EXPECT_NE(told.find(" is in a cell where no node has mass of this body"), std::string::npos);
    EXPECT_EQ(simulation.penalty_contact(0).totals().contacts_a, 0);
}

}  // namespace
