// SPDX-License-Identifier: BSD-3-Clause
// Nodal sums of pore water in fixed point: threads and orders change no bit, and what is no number is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

#include <adapters/mpm/io/checkpoint.hpp>
#include <adapters/mpm/run/measures.hpp>

#include "../larger.hpp"
#include "support/pressed_sand.hpp"

namespace {

using namespace mpm_test;

constexpr int steps = 160;

// A block hits sand below its water table.
PressedSand wet(const PoreWater& water, bool fixed_point) {
    PressedSand out;
    out.settings.fixed_point = fixed_point;
    out.water = water;
    return out;
}

// All columns of the sand by id, then energies and forces.
std::vector<double> seen(Simulation& simulation) {
    std::vector<double> out;
    const Particles& q = simulation.body(1).particles;
    for (int id = 0; id < q.size(); ++id)
        for (int c = 0; c < q.column_count(); ++c) out.push_back(q(c, simulation.find(1, id)));
    const Energy e = simulation.energy();
    const Extremes pressures = pore_pressures(simulation);
    const ContactForces forces = contact_forces(simulation, 0);
    for (const double x : {simulation.time(), e.residual(), e.contact, e.pore_water, e.drag,
                           pressures.least, pressures.largest, forces.tip[1], forces.shaft[0]})
        out.push_back(x);
    return out;
}

std::vector<double> run(const PressedSand& problem) {
    const auto simulation = problem.build();
    for (int i = 0; i < steps; ++i) simulation->step();
    return seen(*simulation);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

class WaterInFixedPoint : public testing::TestWithParam<std::tuple<bool, bool>> {
  protected:
    static PoreWater water() {
        return PressedSand::soft_water(std::get<0>(GetParam()), std::get<1>(GetParam()));
    }
};
INSTANTIATE_TEST_SUITE_P(Drainage, WaterInFixedPoint,
                         testing::Combine(testing::Bool(), testing::Bool()), [](const auto& of) {
                             return std::string(std::get<0>(of.param) ? "Flow" : "Undrained") +
                                    (std::get<1>(of.param) ? "Implicit" : "Explicit");
                         });

TEST_P(WaterInFixedPoint, ThreadsChangeNoBit) {
    for (const bool fixed_point : {true, false}) {
        PressedSand problem = wet(water(), fixed_point);
        problem.cells_z = 48;  // strips enough for many threads
        const std::vector<double> alone = run(problem);
        for (const int threads : {2, 3, 4}) {
            problem.settings.threads = threads;
            EXPECT_TRUE(same_bits(alone, run(problem))) << threads << ' ' << fixed_point;
        }
    }
}

TEST_P(WaterInFixedPoint, DiffersFromDoublesByRoundoff) {
    const std::vector<double> integers = run(wet(water(), true));
    const std::vector<double> doubles = run(wet(water(), false));
    EXPECT_FALSE(same_bits(integers, doubles));
    double most[2] = {0.0, 0.0};
    const auto simulation = wet(water(), true).build();
    const auto columns = static_cast<std::size_t>(simulation->body(1).particles.column_count());
    const auto p_w = static_cast<std::size_t>(simulation->body(1).water->first);
    const auto count = static_cast<std::size_t>(simulation->body(1).particles.size());
    for (std::size_t p = 0; p < count; ++p) {
        const std::size_t at = p * columns + p_w;
        most[0] = larger(most[0], std::fabs(doubles[at]));
        most[1] = larger(most[1], std::fabs(integers[at] - doubles[at]));
    }
    EXPECT_GT(most[0], 1e4);
    // A solver that stops at 1e-5 of its load may stop an iteration sooner.
    EXPECT_LT(most[1], (std::get<1>(GetParam()) ? 1e-5 : 1e-7) * most[0]);
}

TEST_P(WaterInFixedPoint, GoesOnFromACheckpointBitForBit) {
    for (const bool fixed_point : {true, false}) {
        const PressedSand problem = wet(water(), fixed_point);
        const auto all = problem.build(), first = problem.build(), second = problem.build();
        const auto saved = [](const Simulation& simulation) {
            std::ostringstream out;
            save(simulation, out);
            return out.str();
        };
        for (int i = 0; i < steps; ++i) all->step();
        for (int i = 0; i < steps / 2; ++i) first->step();
        // What it has done before is forgotten.
        for (int i = 0; i < steps; ++i) second->step();
        std::istringstream in(saved(*first));
        restore(*second, in);
        for (int i = 0; i < steps / 2; ++i) second->step();
        EXPECT_TRUE(saved(*second) == saved(*all)) << fixed_point;
        EXPECT_GT(std::fabs(contact_forces(*second, 0).tip[1]), 1.0);
    }
}

TEST(FlowInFixedPoint, RefusesAVelocityThatIsNoNumberOrInfinite) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {std::nan(""), infinity, -infinity})
        for (const int k : {0, 1}) {
            const auto simulation = wet(PressedSand::soft_water(true, false), true).build();
            for (int i = 0; i < 3; ++i) simulation->step();
            Body& sand = simulation->body(1);
            const int velocity = sand.water->velocity_column() + k;
            sand.particles.view()[velocity][simulation->find(1, 17)] = value;
            std::string told = "accepted";
            try {
                simulation->step();
            } catch (const std::runtime_error& error) {
                told = error.what();
            }
            EXPECT_NE(told.find("body sand: a particle's share of the momentum of pore water"),
                      std::string::npos)
                << told;
            EXPECT_NE(told.find(k == 0 ? "particle 17 has w_r = " : "particle 17 has w_z = "),
                      std::string::npos)
                << told;
        }
}

}  // namespace
