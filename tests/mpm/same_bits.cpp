// SPDX-License-Identifier: BSD-3-Clause
// What must not change a bit: threads and instruction sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>

#include "../larger.hpp"
#include "support/box.hpp"
#include "support/one_particle.hpp"

namespace {

using namespace mpm_test;

// A ball of particles thrown on a floor, two bodies, over many sorts; all columns by id.
std::vector<double> thrown(bool at_surfaces, int threads) {
    Settings settings{.pic_rate = 50.0,
                      .gravity_z = -100.0,
                      .linear_viscosity = 0.1,
                      .cell_mean = true,
                      .threads = threads};
    Simulation simulation(Axis::uniform(0.0, 1.0, 40), Axis::uniform(0.0, 4.0, 160), settings);
    simulation.add_body(make_box({0.0, 1.0, 0.2, 1.03, 124, 160, 2000.0}, true,
                                 std::make_unique<NeoHooke>(1e6, 0.3)));
    Body falling = make_box({0.0, 0.4, 1.06, 2.6, 68, 244, 3000.0}, true,
                            std::make_unique<LinearElastic>(1e6, 0.2));
    for (std::ptrdiff_t p = 0; p < falling.particles.size(); ++p)
        falling.particles.view()[column::v_z][p] = -5.0;
    simulation.add_body(std::move(falling));
    if (at_surfaces) simulation.add_contact(surface_law(0.3));
    else simulation.add_contact(contact_law(GRIT_CONTACT_GEO, 0.3));
    simulation.fix_below(1, 0.2);
    simulation.fix_above(0, 1.0);
    for (int i = 0; i < 60; ++i) simulation.step();
    std::vector<double> out{simulation.time(), simulation.energy().residual(),
                            simulation.energy().contact};
    for (std::size_t b : {0u, 1u}) {
        const Particles& q = simulation.body(b).particles;
        for (int id = 0; id < q.size(); ++id)
            for (int c = 0; c < column::own; ++c) out.push_back(q(c, simulation.find(b, id)));
    }
    return out;
}

TEST(Threads, ChangeNoBitOfTheResult) {
    for (const bool at_surfaces : {false, true}) {
        const std::vector<double> alone = thrown(at_surfaces, 1);
        EXPECT_GT(alone[2], 0.0);  // they have met
        for (const int threads : {2, 3}) {
            const std::vector<double> together = thrown(at_surfaces, threads);
            ASSERT_EQ(alone.size(), together.size());
            EXPECT_EQ(std::memcmp(alone.data(), together.data(), alone.size() * sizeof(double)), 0);
        }
    }
}

// A block in free flight and free vibration, its particles added in another order.
std::vector<double> shuffled(bool fixed_point, Scheme scheme, unsigned seed) {
    Settings settings{.scheme = scheme,
                      .gravity_z = -10.0,
                      .linear_viscosity = 0.1,
                      .cell_mean = true,
                      .fixed_point = fixed_point};
    Simulation simulation(Axis::uniform(0.0, 1.0, 20), Axis::uniform(0.0, 2.0, 40), settings);
    const Body made =
        make_box({0.0, 0.5, 0.6, 1.2, 21, 25, 2000.0}, true, std::make_unique<NeoHooke>(1e6, 0.3));
    Body body;
    std::vector<int> order;
    for (int p = 0; p < made.particles.size(); ++p) order.push_back(p);
    if (seed > 0) std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    for (const int p : order) {
        const auto of = [&](int c) { return made.particles(c, p); };
        const double z = of(column::z);
        body.particles.add({of(column::r), z, of(column::l_r), of(column::l_z), 2000.0,
                            -of(column::r), 3.0 * (z - 0.9) * of(column::r)},
                           true);
    }
    body.material = std::make_unique<NeoHooke>(1e6, 0.3);
    simulation.add_body(std::move(body));
    for (int i = 0; i < 150; ++i) simulation.step();
    std::vector<double> out(order.size() * column::own);
    for (std::size_t id = 0; id < order.size(); ++id)
        for (int c = 0; c < column::own; ++c)
            out[static_cast<std::size_t>(order[id]) * column::own + static_cast<std::size_t>(c)] =
                simulation.body(0).particles(c, simulation.find(0, static_cast<int>(id)));
    return out;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, int c) {
    double difference = 0.0;
    for (std::size_t i = static_cast<std::size_t>(c); i < a.size(); i += column::own)
        difference = larger(difference, std::fabs(a[i] - b[i]));
    return difference;
}

TEST(FixedPointSums, GiveTheSameBitsForAnyOrderOfTheParticles) {
    for (const Scheme scheme : {Scheme::usl, Scheme::musl, Scheme::usf}) {
        const auto sorted = shuffled(true, scheme, 0), other = shuffled(true, scheme, 7);
        EXPECT_EQ(std::memcmp(sorted.data(), other.data(), sorted.size() * sizeof(double)), 0);
        // Sums of doubles do not; the results are the same but for roundoff.
        const auto doubles = shuffled(false, scheme, 0), again = shuffled(false, scheme, 7);
        EXPECT_NE(std::memcmp(doubles.data(), again.data(), doubles.size() * sizeof(double)), 0);
        EXPECT_LT(largest_difference(sorted, doubles, column::z), 1e-10);
        EXPECT_LT(largest_difference(sorted, doubles, column::v_z), 1e-8);
    }
}

// Counts what a step hands to other processes.
class CountingExchange : public Exchange {
  public:
    void sum_nodes(double*, std::ptrdiff_t, int) override { ++sums; }
    void min_nodes(double*, std::ptrdiff_t, int) override { ++minima; }
    void max(double*, int) override { ++maxima; }
    void gather(std::vector<KeyedNumbers>& items) override {
        ++gathers;
        for (const KeyedNumbers& item : items) EXPECT_TRUE(keys.insert(item.key).second);
    }
    int sums = 0, minima = 0, maxima = 0, gathers = 0;
    std::set<std::uint64_t> keys;  // gathered
};

TEST(Exchange, SeesEverySumOfAStep) {
    CountingExchange exchange;
    Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 1.0, 10), {}, &exchange);
    for (const double z : {0.2, 0.5})
        simulation.add_body(make_box({0.0, 0.5, z, z + 0.3, 10, 6, 1000.0}, true,
                                     std::make_unique<LinearElastic>(1e6, 0.3)));
    simulation.add_contact(contact_law(GRIT_CONTACT_GEO, 0.3));
    simulation.step();
    EXPECT_EQ(exchange.sums, 2);    // of each body
    EXPECT_EQ(exchange.minima, 4);  // surfaces, those beside a node, centres, along axes
    // Shortest cell, lightest particles of each body; step at the start and at the end; contact, its gap.
    EXPECT_EQ(exchange.maxima, 1 + 2 + 2 + 2);
}

// Two surfaces that are far apart cost all contacts together a question.
TEST(Exchange, GathersWhatIsNearASurfaceAndNoMore) {
    for (const double distance : {0.0, 1.0}) {
        CountingExchange exchange;
        Simulation simulation(Axis::uniform(0.0, 2.0, 20), Axis::uniform(0.0, 4.0, 40), {},
                              &exchange);
        for (const double z : {0.2, 1.2 + distance})
            simulation.add_body(make_box({0.0, 2.0, z, z + 1.0, 40, 20, 1000.0}, true,
                                         std::make_unique<LinearElastic>(1e6, 0.3)));
        simulation.add_contact(surface_law(0.3));
        const int before = exchange.maxima;
        simulation.step();
        EXPECT_EQ(exchange.maxima, before + 2 + 1);  // step at the start and at the end
        EXPECT_EQ(exchange.gathers, distance == 0.0 ? 1 : 0);
        // Both reach one row of nodes: particles in two rows of cells of each body, nodes of four rows.
        const std::size_t each = 2 * 2 * 40 + 4 * 21;
        EXPECT_EQ(exchange.keys.size(), distance == 0.0 ? 2 * each : 0);
    }
}

TEST(InstructionSets, ChangeNoBitOfTheKernels) {
    std::mt19937 generator(3);
    for (int sample = 0; sample < 100; ++sample)
        for (const bool axisymmetric : {true, false})
            for (const Shape shape :
                 {Shape::cpdi, Shape::cpdi_published, Shape::ugimp, Shape::point}) {
                OneParticle q = OneParticle::random(generator, axisymmetric);
                for (int c = column::S_rr; c < column::own; ++c)
                    q[c] = std::uniform_real_distribution<double>(-1.0, 1.0)(generator);
                const std::size_t n = q.node_count();
                std::vector<NodeMotion> motions(n);
                for (NodeMotion& m : motions)
                    for (double& x : m.value)
                        x = std::uniform_real_distribution<double>(-1.0, 1.0)(generator);
                std::vector<NodeRecord> records[2];
                Particles moved[2] = {q.particles, q.particles};
                const Kernels* sets[2] = {&kernels(), &baseline_kernels};
                for (const std::size_t k : {0u, 1u}) {
                    records[k].assign(n, NodeRecord{});
                    sets[k]->scatter(
                        shape, axisymmetric,
                        {q.grid(), q.particles.view(), 0, 1, records[k].data(), part::all});
                    std::vector<NodeIntegers> integers(n);
                    FixedPoint fixed{integers.data(), {}, {}};
                    std::fill_n(fixed.scale, record::size, 0x1p40);
                    sets[k]->scatter(
                        shape, axisymmetric,
                        {q.grid(), q.particles.view(), 0, 1, nullptr, part::all, &fixed});
                    for (std::size_t i = 0; i < n; ++i)
                        for (int c = 0; c < record::size; ++c)
                            EXPECT_NEAR(static_cast<double>(integers[i].value[c]) * 0x1p-40,
                                        records[k][i][c], 16 * 0x1p-40);
                    Increments increments{};
                    GatherSums sums;
                    sets[k]->gather(
                        shape, axisymmetric,
                        {q.grid(), moved[k].view(), 0, 1, motions.data(), 1e-3, 0.1, task::all},
                        increments, sums);
                }
                EXPECT_EQ(std::memcmp(records[0].data(), records[1].data(), n * sizeof(NodeRecord)),
                          0);
                for (int c = 0; c < column::own; ++c) EXPECT_EQ(moved[0](c, 0), moved[1](c, 0));
            }
}

}  // namespace
