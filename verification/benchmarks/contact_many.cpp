// SPDX-License-Identifier: BSD-3-Clause
// What a node costs where several bodies meet in space, Geo-contact, each with all others, half of the pairs apart: CPU time per
// node; take the best of several repetitions.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include <grit/contact.h>

namespace {

constexpr std::size_t nodes = 1024;

// Arguments: bodies, tenths of the friction coefficient.
void several_bodies(benchmark::State& state) {
    const int bodies = static_cast<int>(state.range(0));
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::normal_distribution<double> normal;
    const auto drawn = [&](std::size_t n, const auto& draw) {
        std::vector<double> list(n);
        for (double& x : list) x = draw();
        return list;
    };
    const auto count = static_cast<std::size_t>(bodies), pair_count = count * (count - 1) / 2;
    std::vector<double> mass = drawn(count * nodes, [&] { return 0.1 + uniform(random); });
    const std::vector<double> velocity = drawn(3 * count * nodes, [&] { return normal(random); });
    std::vector<double> normals = drawn(3 * pair_count * nodes, [&] { return normal(random); });
    for (std::size_t i = 0; i < normals.size(); i += 3) {
        const double length = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
        for (std::size_t c = 0; c < 3; ++c) normals[i + c] /= length;
    }
    const std::vector<double> distance =
        drawn(pair_count * nodes, [&] { return 2.4 * uniform(random) - 0.2; });
    const double cell = 1.0;

    std::vector<double> moved = velocity;
    std::vector<grit_view> masses;
    std::vector<grit_mutable_view> velocities;
    for (std::size_t b = 0; b < count; ++b) {
        masses.push_back(grit_view_of(&mass[b * nodes], 1, 1));
        velocities.push_back(grit_mutable_view_of(&moved[3 * b * nodes], 3, 1));
    }
    grit_contact_options options;
    grit_contact_options_init(&options, sizeof options);
    options.components = 3;
    options.friction_coefficient = 0.1 * static_cast<double>(state.range(1));
    std::vector<grit_contact_pair> pairs;
    for (int a = 0; a < bodies; ++a)
        for (int b = a + 1; b < bodies; ++b) {
            const std::size_t k = pairs.size();
            grit_contact_pair pair{};
            pair.struct_size = sizeof pair;
            pair.a = a;
            pair.b = b;
            pair.options = &options;
            pair.normal = grit_view_of(&normals[3 * k * nodes], 3, 1);
            pair.distance = grit_view_of(&distance[k * nodes], 1, 1);
            pair.cell_size = grit_view_of(&cell, 0, 1);
            pairs.push_back(pair);
        }
    grit_contact_bodies call{};
    call.struct_size = sizeof call;
    call.components = 3;
    call.count = bodies;
    call.mass = masses.data();
    call.velocity = velocities.data();
    for (auto pass : state) {
        state.PauseTiming();
        moved = velocity;
        state.ResumeTiming();
        if (grit_contact_correct_many(&call, static_cast<int>(pairs.size()), pairs.data(), nodes,
                                      nullptr, nullptr, nullptr) != GRIT_OK)
            state.SkipWithError("a node was refused");
    }
    state.counters["per_node"] = benchmark::Counter(
        nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(several_bodies)->ArgsProduct({{2, 3, 4, 8}, {0, 3}});

}  // namespace

BENCHMARK_MAIN();
