// SPDX-License-Identifier: BSD-3-Clause
// Sums in fixed point in space.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "../larger.hpp"
#include "support/loose_cube.hpp"

namespace {

using namespace space_test;

Body shuffled(Body body, unsigned seed) {
    std::vector<int> order(static_cast<std::size_t>(body.particles.size()));
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 generator(seed);
    std::shuffle(order.begin(), order.end(), generator);
    body.particles.permute(order);
    return body;
}

// A cube and a slab that meet, with a load on the slab, particles in some order.
std::unique_ptr<Simulation> meeting(const Settings& settings, unsigned seed, bool gated = false) {
    auto out = std::make_unique<Simulation>(cube_of_cells(1.3, 13), settings);
    out->set_gravity({1.0, 0.0, -9.81});
    out->add_body(shuffled(loose_cube_of_sand(), seed));
    out->add_body(shuffled(slab_above(), seed));
    for (int id = 5 * 144; id < 6 * 144; ++id)
        out->add_traction({1, id, {2, true}, [](double t) {
                               return Vector3{1e3, 2e2 * std::sin(1e3 * t), -7e3};
                           }});
    ContactLaw law = not_gated();
    law.gated = gated;
    out->add_contact(law);
    for (int step = 0; step < 25; ++step) out->step();
    return out;
}

Settings settings_of(bool fixed_point, bool means, int threads) {
    return {.pic_rate = 20.0,
            .local_damping = 0.1,
            .linear_viscosity = 0.1,
            .cell_mean = means,
            .fixed_point = fixed_point,
            .threads = threads};
}

// Largest difference of a column's numbers, as a share of its largest one.
double difference(const Simulation& a, const Simulation& b) {
    double out = std::fabs(a.time() / b.time() - 1.0);
    for (const std::size_t body : {0u, 1u}) {
        const Particles &q = a.body(body).particles, &o = b.body(body).particles;
        for (int c = 0; c < q.column_count(); ++c) {
            double apart = 0.0, largest = 0.0;
            for (int id = 0; id < q.size(); ++id) {
                const double x = q(c, a.find(body, id)), y = o(c, b.find(body, id));
                apart = larger(apart, std::fabs(x - y));
                largest = std::max(largest, std::fabs(y));
            }
            if (largest > 0.0) out = larger(out, apart / largest);
        }
    }
    return out;
}

TEST(SpaceFixedPoint, NeitherThreadsNorTheOrderOfParticlesChangeABit) {
    for (const bool means : {false, true}) {
        const auto one = meeting(settings_of(true, means, 1), 1);
        const auto& of = one->contact(0);
        EXPECT_GT(std::fabs(of.measured().along_z[2]), 1.0);
        for (const int threads : {1, 2, 3}) {
            const auto other =
                meeting(settings_of(true, means, threads), static_cast<unsigned>(threads) + 1);
            EXPECT_EQ(difference(*one, *other), 0.0) << threads;
            const auto& another = other->contact(0);
            const grit::mpm::Energy a = one->energy(), b = other->energy();
            EXPECT_EQ(a.residual(), b.residual());
            EXPECT_EQ(a.damping, b.damping);
            EXPECT_EQ(a.pic, b.pic);
            EXPECT_EQ(a.viscosity, b.viscosity);
            EXPECT_EQ(a.traction_work, b.traction_work);
            EXPECT_EQ(one->damping_impulse(0), other->damping_impulse(0));
            for (int k = 0; k < 3; ++k) {
                EXPECT_EQ(of.measured().along_z[k], another.measured().along_z[k]);
                EXPECT_EQ(of.measured().sideways[k], another.measured().sideways[k]);
                EXPECT_EQ(one->traction_force(1)[k], other->traction_force(1)[k]);
            }
        }
        // In doubles the order of particles does.
        EXPECT_NE(difference(*meeting(settings_of(false, means, 1), 1),
                             *meeting(settings_of(false, means, 1), 2)),
                  0.0);
    }
}

// Of bodies that do not touch: which particles a node takes for the surface beside it, roundoff may change.
TEST(SpaceFixedPoint, IsWhatDoublesAreToRoundoff) {
    for (const bool means : {false, true}) {
        const auto integers = meeting(settings_of(true, means, 1), 1, true);
        const auto doubles = meeting(settings_of(false, means, 1), 1, true);
        EXPECT_LT(difference(*integers, *doubles), 1e-9);
        EXPECT_GT(difference(*integers, *doubles), 0.0);
        const grit::mpm::Energy a = integers->energy(), b = doubles->energy();
        for (const auto term :
             {&grit::mpm::Energy::kinetic, &grit::mpm::Energy::stored, &grit::mpm::Energy::contact,
              &grit::mpm::Energy::damping, &grit::mpm::Energy::viscosity, &grit::mpm::Energy::pic,
              &grit::mpm::Energy::transfer, &grit::mpm::Energy::external_work})
            EXPECT_NEAR(a.*term, b.*term, 1e-9 * std::fabs(b.*term));
    }
}

TEST(SpaceFixedPoint, OfContributionsOfAnySizeIsThatOfDoubles) {
    for (const double density : {1e-280, 1e-20, 1e100, 1e290}) {
        std::unique_ptr<Simulation> by[2];
        for (const int i : {0, 1}) {
            by[i] = std::make_unique<Simulation>(cube_of_cells(1.2, 12),
                                                 Settings{.fixed_point = i == 1});
            by[i]->add_body(make_brick({{0.3, 0.3, 0.3}, {0.9, 0.9, 0.9}, {6, 6, 6}, density},
                                       std::make_unique<LinearElastic>(1e4 * density, 0.3)));
            int step = 0;
            const double sizes[] = {1e-320, 1e-300, 0.0, 30.0, 1e-150, 30.0};
            by[i]->set_body_force(
                [&](ParticleView q, std::ptrdiff_t begin, std::ptrdiff_t end, double) {
                    for (std::ptrdiff_t p = begin; p < end; ++p)
                        q[column::b_y][p] = (p % 2 == 0 ? 1.0 : -0.5) * sizes[step];
                });
            for (; step < 6; ++step) by[i]->step();
        }
        double apart = 0.0, largest = 0.0;
        for (int id = 0; id < 216; ++id) {
            const double v = by[0]->body(0).particles(column::v_y, by[0]->find(0, id));
            largest = std::max(largest, std::fabs(v));
            apart = larger(
                apart, std::fabs(by[1]->body(0).particles(column::v_y, by[1]->find(0, id)) - v));
        }
        EXPECT_GT(largest, 0.0);
        EXPECT_LT(apart, 1e-11 * largest) << density;
    }
}

TEST(SpaceFixedPoint, RefusesWhatIsNoNumberOrInfiniteAndSaysWhere) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {std::nan(""), infinity, -infinity})
        for (const int column :
             {column::v_x, column::F_zz, column::mass, column::S_xy, column::b_z, column::q}) {
            Simulation simulation(cube_of_cells(1.3, 13), {.fixed_point = true});
            simulation.add_body(loose_cube_of_sand());
            simulation.add_body(slab_above());
            simulation.add_contact(not_gated());
            simulation.step();
            const std::ptrdiff_t p = simulation.find(0, 111);
            simulation.body(0).particles.view()[column][p] = value;
            std::string told = "accepted";
            try {
                simulation.step();
            } catch (const std::runtime_error& error) {
                told = error.what();
            }
            EXPECT_NE(told.find(": a particle's share of"), std::string::npos) << told;
            EXPECT_NE(told.find(std::string("particle 111 has ") + column::names[column] + " = "),
                      std::string::npos)
                << told;
        }
}

}  // namespace
