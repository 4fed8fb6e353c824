// SPDX-License-Identifier: BSD-3-Clause
// Nodal sums in fixed point, for contributions of any size.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <adapters/mpm/step/column_names.hpp>

#include "../larger.hpp"
#include "support/box.hpp"

namespace {

using namespace mpm_test;

std::unique_ptr<Simulation> block(bool fixed_point, bool axisymmetric, double density) {
    Settings settings{.axisymmetric = axisymmetric, .fixed_point = fixed_point};
    auto out = std::make_unique<Simulation>(Axis::uniform(0.0, 1.0, 10),
                                            Axis::uniform(0.0, 1.0, 10), settings);
    Body body = make_box({0.2, 0.6, 0.3, 0.7, 6, 6, density}, axisymmetric,
                         std::make_unique<LinearElastic>(1e4 * density, 0.3));
    body.name = "block";
    out->add_body(std::move(body));
    return out;
}

// Accelerations [m/s2] jump from step to step, masses are those of densities [kg/m3] far from any sand's.
TEST(FixedPointSums, EndForContributionsOfAnySizeAndAreThoseOfDoubles) {
    std::mt19937 generator(5);
    for (const double density : {1e-280, 1e-160, 1e-20, 1000.0, 1e100, 1e290}) {
        std::vector<double> sizes{1e-320, 1e-300, 0.0, 30.0,  1e-310,
                                  1e-150, 30.0,   0.0, 1e-30, 30.0};
        for (int i = 0; i < 20; ++i)
            sizes.push_back(
                std::pow(10.0, std::uniform_real_distribution<>(-323.0, 1.5)(generator)));
        const auto run = [&](bool fixed_point) {
            const auto simulation = block(fixed_point, true, density);
            std::size_t step = 0;
            simulation->set_body_force(
                [&](ParticleView q, std::ptrdiff_t begin, std::ptrdiff_t end, double) {
                    for (std::ptrdiff_t p = begin; p < end; ++p)
                        q[column::b_z][p] = (p % 2 == 0 ? 1.0 : -0.5) * sizes[step];
                });
            std::vector<double> out;
            for (; step < sizes.size(); ++step) {
                simulation->step();
                const Particles& q = simulation->body(0).particles;
                for (int id = 0; id < q.size(); ++id)
                    out.push_back(q(column::v_z, simulation->find(0, id)));
            }
            return out;
        };
        const std::vector<double> integers = run(true), doubles = run(false);
        double difference = 0.0;
        for (std::size_t i = 0; i < doubles.size(); ++i)
            difference = larger(difference, std::fabs(integers[i] - doubles[i]));
        const double largest = *std::max_element(doubles.begin(), doubles.end());
        EXPECT_GT(largest, 0.0) << density;
        EXPECT_LT(difference, 1e-11 * largest) << density;
    }
}

TEST(FixedPointSums, RefuseWhatIsNoNumberOrInfiniteAndSayWhere) {
    namespace c = column;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::mt19937 generator(7);
    const std::vector<std::string> names = column_names(nullptr);
    for (const bool axisymmetric : {true, false})
        for (const double value : {std::nan(""), -std::nan(""), infinity, -infinity})
            for (const int column : {c::z, c::v_r, c::v_z, c::F_rr, c::F_zz, c::mass, c::V0,
                                     c::S_rr, c::S_zz, c::S_rz, c::b_r, c::b_z, c::q}) {
                const auto simulation = block(true, axisymmetric, 1000.0);
                for (int i = 0; i < 3; ++i) simulation->step();
                Particles& q = simulation->body(0).particles;
                const int id = std::uniform_int_distribution<>(0, 35)(generator);
                const std::ptrdiff_t p = simulation->find(0, id);
                q.view()[column][p] = value;
                std::string told = "accepted";
                try {
                    simulation->step();
                } catch (const std::runtime_error& error) {
                    told = error.what();
                }
                const std::string place = "particle " + std::to_string(id) + " has " +
                                          names[static_cast<std::size_t>(column)] + " = ";
                EXPECT_NE(told.find("body block: a particle's share of"), std::string::npos)
                    << place << value << ": " << told;
                EXPECT_NE(told.find(place), std::string::npos) << place << value << ": " << told;
            }
}

}  // namespace
