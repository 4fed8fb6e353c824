// SPDX-License-Identifier: BSD-3-Clause
// Bodies that move as they are told: their work, and how far they get in a step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <adapters/mpm/case/time_function.hpp>

#include "support/shapes.hpp"

namespace {

using namespace mpm_test;

constexpr double h = 0.1;  // edge of a cell [m]

// A rigid punch above an elastic block on a roller, in plane strain.
struct Punch {
    Scheme scheme = Scheme::usl;
    bool fixed_point = false;
    double stiffness = 50.0;  // of penalty springs, as a multiple of M / h; 0: nodal contact
    double friction = 0.0;
    double gap = 0.3 * h;  // at the start [m]
    double cfl = 0.4;
    std::function<grit::Vector2(double)> velocity = [](double) { return grit::Vector2{0.0, -1.0}; };

    std::unique_ptr<Simulation> build() const {
        constexpr double E = 1e6;
        Settings settings{
            .axisymmetric = false, .scheme = scheme, .cfl = cfl, .fixed_point = fixed_point};
        auto out = std::make_unique<Simulation>(Axis::uniform(0.0, 1.0, 10),
                                                Axis::uniform(0.0, 1.5, 15), settings);
        out->add_body(make_box({0.0, 1.0, 0.0, 0.6, 20, 12, 1000.0}, false,
                               std::make_unique<NeoHooke>(E, 0.2)));
        Body punch = make_box({0.3, 0.7, 0.6 + gap, 0.8 + gap, 8, 4, 1000.0}, false, nullptr);
        punch.name = "punch";
        punch.prescribed_velocity = velocity;
        out->add_body(std::move(punch));
        out->fix_below(1, 0.0);
        out->fix_below(0, 0.0);
        out->fix_above(0, 1.0);
        if (stiffness == 0.0) {
            out->add_contact(contact_law(GRIT_CONTACT_GEO, friction));
            return out;
        }
        PenaltyLaw law = penalty_law(friction, stiffness, 1.1 * E, h);
        law.line_a.points = {{1.0, 0.6}, {0.0, 0.6}};
        law.line_b = {{{0.3, 0.6 + gap}, {0.7, 0.6 + gap}, {0.7, 0.8 + gap}, {0.3, 0.8 + gap}},
                      true};
        out->add_contact(law);
        return out;
    }
};

grit::Vector2 force_on_punch(const Simulation& simulation) {
    if (simulation.contact_count() == 0) {
        const double* F = simulation.penalty_contact(0).totals().force_on_b;
        return {F[0], F[1]};
    }
    const double* F = simulation.contact(0).totals().force_on_b;
    return {F[0], F[1]};
}

// Stiff springs ask for shorter steps as soon as they are touched: work, forces and time know the same step.
TEST(RigidPunch, WorksByItsForcesOverTheStepsThatWereTaken) {
    for (const Scheme scheme : {Scheme::usl, Scheme::musl, Scheme::usf})
        for (const double stiffness : {0.0, 2.0, 50.0}) {
            const auto velocity = [](double t) {
                return grit::Vector2{0.3 * std::sin(40.0 * t), -1.5 * std::cos(15.0 * t)};
            };
            const Punch punch{.scheme = scheme,
                              .fixed_point = stiffness == 2.0,
                              .stiffness = stiffness,
                              .friction = 0.3,
                              .cfl = 0.2,
                              .velocity = velocity};
            const auto simulation = punch.build();
            double work = 0.0, most_work = 0.0, longest = 0.0, shortest = 1.0;
            simulation->energy();
            while (simulation->time() < 0.2) {
                const double start = simulation->time(), planned = simulation->next_step();
                simulation->step();
                ASSERT_EQ(start + planned, simulation->time()) << "step " << simulation->steps();
                const grit::Vector2 F = force_on_punch(*simulation),
                                    v = velocity(simulation->time());
                work -= (F[0] * v[0] + F[1] * v[1]) * planned;
                most_work = std::max(most_work, work);
                longest = std::max(longest, planned);
                shortest = std::min(shortest, planned);
                ASSERT_NEAR(simulation->energy().rigid_work, work, 1e-9 * most_work);
            }
            const Energy energy = simulation->energy();
            EXPECT_GT(most_work, 100.0);
            EXPECT_NEAR(energy.residual(), 0.0, 0.025 * most_work) << stiffness;
            if (stiffness == 50.0) {
                EXPECT_LT(shortest, 0.5 * longest);
            }
        }
}

// By half a cell in a step, what it touches would be on its other side.
TEST(RigidBody, GetsNoFartherInAStepThanTheCourantShareOfACell) {
    std::mt19937 generator(11);
    for (int trial = 0; trial < 40; ++trial) {
        const double top = std::pow(10.0, std::uniform_real_distribution<>(0.0, 4.0)(generator));
        // The way is no longer than 2 m, back and forth.
        TimeTable along_r{{0.0}, {0.0}}, along_z{{0.0}, {0.0}};
        std::uniform_real_distribution<> speed(0.1 * top, top), lasts(0.2 / top, 0.4 / top);
        for (int i = 1; i < 12; ++i) {
            along_z.time.push_back(along_z.time.back() + lasts(generator));
            along_z.value.push_back((i % 2 == 0 ? 1.0 : -1.0) * speed(generator));
        }
        Punch punch{.stiffness = trial % 2 == 0 ? 0.0 : 1.0, .gap = 0.3};
        punch.velocity = [&](double t) { return grit::Vector2{along_r.at(t), along_z.at(t)}; };
        Simulation* simulation = nullptr;
        const auto built = punch.build();
        simulation = built.get();
        for (int i = 0; i < 400; ++i) {
            Particles& q = simulation->body(1).particles;
            const double before = q(column::z, simulation->find(1, 0));
            try {
                simulation->step();
            } catch (const std::runtime_error&) {
                break;  // it has left the grid, or pressed the block flat
            }
            const double way = q(column::z, simulation->find(1, 0)) - before;
            ASSERT_LE(std::fabs(way), 0.4 * h * (1.0 + 1e-9))
                << "trial " << trial << ", up to " << top << " m/s, step " << i;
        }
    }
}

TEST(RigidBody, ThatStartsToMoveWithAStageIsFollowedFromItsFirstStep) {
    bool moves = false;
    Punch punch{.stiffness = 0.0, .gap = 0.5};
    punch.velocity = [&](double) { return grit::Vector2{0.0, moves ? -500.0 : 0.0}; };
    const auto simulation = punch.build();
    for (int i = 0; i < 3; ++i) simulation->step();
    moves = true;
    simulation->set_cfl(0.4);
    const double before = simulation->body(1).particles(column::z, 0);
    simulation->step();
    EXPECT_NEAR(simulation->body(1).particles(column::z, 0) - before, -0.4 * h, 1e-12);
}

TEST(RigidBodies, AloneHaveAStepAsLongAsTheirSpeedAllows) {
    for (const double speed : {40.0, 4e-6}) {
        Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 1.0, 10),
                              {.axisymmetric = false});
        for (const int k : {0, 1}) {
            Body body =
                make_box({0.2, 0.5, 0.1 + 0.5 * k, 0.4 + 0.5 * k, 6, 6, 1.0}, false, nullptr);
            body.prescribed_velocity = [k, speed](double) {
                return grit::Vector2{0.0, k == 0 ? 0.75 * speed : -speed};
            };
            simulation.add_body(std::move(body));
        }
        simulation.add_contact(contact_law(GRIT_CONTACT_GEO, 0.0));
        simulation.energy();
        EXPECT_NEAR(simulation.next_step(), 0.4 * h / speed, 1e-12 * h / speed);
    }
}

TEST(RigidBody, WhoseVelocityIsNoNumberIsRefused) {
    Punch punch{.stiffness = 0.0};
    punch.velocity = [](double t) { return grit::Vector2{0.0, t > 1e-3 ? std::nan("") : 0.0}; };
    const auto simulation = punch.build();
    std::string told;
    try {
        for (int i = 0; i < 100; ++i) simulation->step();
    } catch (const std::runtime_error& error) {
        told = error.what();
    }
    EXPECT_NE(told.find("body punch: its prescribed velocity at t = "), std::string::npos) << told;
}

TEST(RigidBody, SoFastThatNoStepIsShortEnoughIsRefusedByName) {
    for (const double speed : {1e160, 1e200, 1e300}) {
        Punch punch{.stiffness = 0.0};
        punch.velocity = [speed](double) { return grit::Vector2{0.0, -speed}; };
        const auto simulation = punch.build();
        std::string told;
        try {
            simulation->step();
        } catch (const std::runtime_error& error) {
            told = error.what();
        }
        EXPECT_NE(told.find("no time step is short enough: body punch would move at 1e+"),
                  std::string::npos)
            << told;
    }
}

}  // namespace
