// SPDX-License-Identifier: BSD-3-Clause
// What normals and distances cost: CPU time per node (distances: per particle at 16 nodes); take the best of several
// repetitions. The clouds have 16 particles a node, on both sides of a plane of any direction.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <grit/grit.h>

namespace {

constexpr std::ptrdiff_t nodes = 1024;
constexpr std::ptrdiff_t particles_each = 16;

void per_item(benchmark::State& state, std::ptrdiff_t items) {
    state.counters["per_item"] = benchmark::Counter(static_cast<double>(items),
                                                    benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
}

std::vector<double> direction(int components, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<double> n(static_cast<std::size_t>(components));
    double square = 0.0;
    for (double& x : n) {
        x = normal(random);
        square += x * x;
    }
    for (double& x : n) x /= std::sqrt(square);
    return n;
}

struct Clouds {
    std::vector<double> position, normal;
    std::vector<int> body;
    std::vector<std::ptrdiff_t> offset{0};

    Clouds(int components, bool overlapping) {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
        for (std::ptrdiff_t i = 0; i < nodes; ++i) {
            const auto n = direction(components, random);
            for (std::ptrdiff_t p = 0; p < particles_each; ++p) {
                double along = 0.1;
                for (const double component : n) {
                    position.push_back(coordinate(random));
                    along += position.back() * component;
                }
                if (overlapping) along += 0.3 * coordinate(random);
                body.push_back(along > 0.0 ? GRIT_CONTACT_BODY_B : GRIT_CONTACT_BODY_A);
            }
            offset.push_back(static_cast<std::ptrdiff_t>(body.size()));
        }
        normal.resize(static_cast<std::size_t>(components * nodes));
    }
};

// Arguments: components, overlapping, instruction set.
void regression(benchmark::State& state) {
    const int components = static_cast<int>(state.range(0));
    Clouds x(components, state.range(1) != 0);
    grit_contact_clouds clouds{};
    clouds.struct_size = sizeof clouds;
    clouds.components = components;
    clouds.instruction_set = static_cast<int>(state.range(2));
    clouds.offset = x.offset.data();
    clouds.particles = nodes * particles_each;
    clouds.position = grit_view_of(x.position.data(), components, 1);
    clouds.body = x.body.data();
    clouds.length = 1.0;
    clouds.normal = grit_mutable_view_of(x.normal.data(), components, 1);
    std::vector<char> workspace(grit_contact_regression_workspace_size(particles_each, components));
    for (auto _ : state) {
        grit_error error;
        if (grit_contact_normals_by_regression(nodes, &clouds, workspace.data(), workspace.size(),
                                               nullptr, &error) != GRIT_OK)
            state.SkipWithError(error.message);
        benchmark::DoNotOptimize(x.normal.data());
    }
    per_item(state, nodes);
}

// Argument: components.
void gradients(benchmark::State& state) {
    const int components = static_cast<int>(state.range(0));
    Clouds x(components, false);
    grit_contact_gradients q{};
    q.struct_size = sizeof q;
    q.components = components;
    q.source = GRIT_CONTACT_NORMAL_AVERAGE;
    q.gradient_a = grit_view_of(x.position.data(), components, 1);
    q.gradient_b = grit_view_of(x.position.data() + components * nodes, components, 1);
    q.normal = grit_mutable_view_of(x.normal.data(), components, 1);
    for (auto _ : state) {
        grit_contact_normals_from_gradients(nodes, &q, nullptr, nullptr);
        benchmark::DoNotOptimize(x.normal.data());
    }
    per_item(state, nodes);
}

// Argument: particles per call. 16 nodes each, as in the plane with CPDI.
void distances(benchmark::State& state) {
    constexpr std::ptrdiff_t particles = 1024, grid_nodes = 289;
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> coordinate(0.0, 16.0);
    std::vector<double> node_position, normal, position, side, surface(2 * grid_nodes);
    std::vector<std::ptrdiff_t> node;
    for (std::ptrdiff_t i = 0; i < grid_nodes; ++i) {
        const std::ptrdiff_t row = i / 17;
        node_position.push_back(static_cast<double>(i - 17 * row));
        node_position.push_back(static_cast<double>(row));
        const auto n = direction(2, random);
        normal.insert(normal.end(), n.begin(), n.end());
    }
    for (std::ptrdiff_t p = 0; p < particles; ++p) {
        position.insert(position.end(), {coordinate(random), coordinate(random)});
        side.insert(side.end(), {0.25, 0.05, -0.02, 0.2});
        const auto first = static_cast<std::ptrdiff_t>(13.0 * coordinate(random) / 16.0);
        for (std::ptrdiff_t k = 0; k < 16; ++k) node.push_back(18 * first + k % 4 + 17 * (k / 4));
    }
    grit_contact_surfaces s{};
    s.struct_size = sizeof s;
    s.components = 2;
    s.nodes = grid_nodes;
    s.position = grit_view_of(node_position.data(), 2, 1);
    s.normal = grit_view_of(normal.data(), 2, 1);
    s.surface = grit_mutable_view_of(surface.data(), 2, 1);
    grit_contact_surfaces_reset(&s, nullptr);
    const std::ptrdiff_t n = state.range(0);
    grit_contact_domains d{};
    d.struct_size = sizeof d;
    d.sides = 2;
    d.nodes_each = 16;
    for (auto _ : state) {
        for (std::ptrdiff_t p = 0; p < particles; p += n) {
            d.node = node.data() + 16 * p;
            d.position = grit_view_of(position.data() + 2 * p, 2, 1);
            d.side = grit_matrix_view_of(side.data() + 4 * p, 4, 2, 1);
            grit_error error;
            if (grit_contact_surfaces_add(&s, n, &d, &error) != GRIT_OK)
                state.SkipWithError(error.message);
        }
        benchmark::DoNotOptimize(surface.data());
    }
    per_item(state, particles);
}

void register_all() {
    for (const int n : {1, 1024})
        benchmark::RegisterBenchmark("distances/2d/per_call", distances)->Arg(n);
    for (const int components : {2, 3}) {
        const std::string dimension = std::to_string(components) + "d/";
        for (const int overlapping : {0, 1})
            for (int isa = GRIT_ISA_BASELINE; isa <= grit_instruction_set(); ++isa) {
                const std::string name = "regression/" + dimension +
                                         (overlapping ? "overlapping" : "separable") +
                                         "/isa:" + std::to_string(isa);
                benchmark::RegisterBenchmark(name.c_str(), regression)
                    ->Args({components, overlapping, isa});
            }
        benchmark::RegisterBenchmark(("gradients/" + dimension + "average").c_str(), gradients)
            ->Arg(components);
    }
}

}  // namespace

int main(int argc, char** argv) {
    register_all();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
