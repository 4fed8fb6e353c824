// SPDX-License-Identifier: BSD-3-Clause
// What the nodal correction costs on a million nodes, beside the triad a = b + s c of the same run: a
// routine at memory bandwidth needs the time of its bytes (each array once in, velocities once out). On 4096 nodes,
// which stay in the second cache, it is what the arithmetic takes.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <grit/contact.h>

#include "measure.hpp"

namespace {

constexpr std::size_t node_count = 1000000;

using namespace benchmarks;

// 24 bytes per item.
void triad(benchmark::State& state) {
    std::vector<double> a(4 * node_count, 0.0), b(4 * node_count, 1.0), c(4 * node_count, 2.0);
    const auto pass = [&] {
        for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] + 3.0 * c[i];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    };
    best_of(
        state, static_cast<double>(a.size()), [] {}, pass);
    state.counters["bytes"] = 24.0;
}

// One array per quantity, [node][component] or [component][node].
struct Grid {
    std::vector<double> m_a, m_b, s, n, v_a, v_b;
    int components;
    std::size_t node_count;
    bool interleaved;

    Grid(int dimensions, std::size_t nodes, bool structures)
        : components(dimensions), node_count(nodes), interleaved(structures) {
        std::mt19937_64 random(1);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        const auto c = static_cast<std::size_t>(components);
        for (auto* list : {&n, &v_a, &v_b}) list->resize(c * node_count);
        for (std::size_t i = 0; i < node_count; ++i) {
            m_a.push_back(0.1 + uniform(random));
            m_b.push_back(0.1 + uniform(random));
            s.push_back(1.2 * uniform(random) - 0.2);
            double direction[3], length = 0.0;
            for (std::size_t k = 0; k < c; ++k) {
                direction[k] = normal(random);
                length += direction[k] * direction[k];
            }
            for (std::size_t k = 0; k < c; ++k) {
                n[at(i, k)] = direction[k] / std::sqrt(length);
                v_a[at(i, k)] = normal(random);
                v_b[at(i, k)] = normal(random);
            }
        }
    }
    std::size_t at(std::size_t i, std::size_t k) const {
        return interleaved ? i * static_cast<std::size_t>(components) + k : k * node_count + i;
    }
    ptrdiff_t point() const { return interleaved ? components : 1; }
    ptrdiff_t component() const { return interleaved ? 1 : static_cast<ptrdiff_t>(node_count); }

    grit_contact_nodes views() {
        static const double cell = 1.0;
        grit_contact_nodes q{};
        q.struct_size = sizeof q;
        q.mass_a = grit_view_of(m_a.data(), 1, 1);
        q.mass_b = grit_view_of(m_b.data(), 1, 1);
        q.distance = grit_view_of(s.data(), 1, 1);
        q.cell_size = grit_view_of(&cell, 0, 1);
        q.normal = grit_view_of(n.data(), point(), component());
        q.velocity_a = grit_mutable_view_of(v_a.data(), point(), component());
        q.velocity_b = grit_mutable_view_of(v_b.data(), point(), component());
        return q;
    }
};

struct Correction {
    int law, components;
    bool structures = false;
    std::size_t nodes = node_count, per_call = node_count;
};

void correct(benchmark::State& state, const Correction& c) {
    Grid grid(c.components, c.nodes, c.structures);
    const std::vector<double> v_a = grid.v_a, v_b = grid.v_b;
    const grit_contact_nodes all = grid.views();
    grit_contact_options options;
    grit_contact_options_init(&options, sizeof options);
    options.law = c.law;
    options.components = c.components;
    options.friction_coefficient = 0.3;
    const auto prepare = [&] {
        grid.v_a = v_a;
        grid.v_b = v_b;
    };
    const auto pass = [&] {
        grit_contact_nodes q = all;
        for (std::size_t first = 0; first < c.nodes; first += c.per_call) {
            const auto n = static_cast<ptrdiff_t>(std::min(c.per_call, c.nodes - first));
            const auto by = static_cast<ptrdiff_t>(first);
            q.mass_a.base = all.mass_a.base + by;
            q.mass_b.base = all.mass_b.base + by;
            q.distance.base = all.distance.base + by;
            q.normal.base = all.normal.base + by * q.normal.point_stride;
            q.velocity_a.base = all.velocity_a.base + by * q.velocity_a.point_stride;
            q.velocity_b.base = all.velocity_b.base + by * q.velocity_b.point_stride;
            grit_contact_correct(&options, n, &q, nullptr, nullptr, nullptr);
        }
        benchmark::ClobberMemory();
    };
    best_of(state, static_cast<double>(c.nodes), prepare, pass);
    const int numbers = 2 + (c.law == GRIT_CONTACT_GEO ? 1 : 0) + 5 * c.components;
    state.counters["bytes"] = 8.0 * numbers;
}

void add(const std::string& name, const Correction& c) {
    add_benchmark(name, [c](benchmark::State& state) { correct(state, c); });
}

}  // namespace

int main(int argc, char** argv) {
    add_exp("before");
    add_benchmark("triad/before", triad);
    for (const int components : {3, 2}) {
        const std::string d = components == 3 ? "3-D" : "2-D";
        add("Geo-contact, " + d, {GRIT_CONTACT_GEO, components});
        add("frictional, " + d, {GRIT_CONTACT_FRICTIONAL, components});
    }
    add("Geo-contact, 3-D, array of structures", {GRIT_CONTACT_GEO, 3, true});
    add("frictional, 3-D, array of structures", {GRIT_CONTACT_FRICTIONAL, 3, true});
    add("Geo-contact, 3-D, one node per call", {GRIT_CONTACT_GEO, 3, true, node_count, 1});
    add("Geo-contact, 3-D, 4096 nodes", {GRIT_CONTACT_GEO, 3, false, 4096});
    add_benchmark("triad/after", triad);
    add_exp("after");
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
