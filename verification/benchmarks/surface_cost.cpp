// SPDX-License-Identifier: BSD-3-Clause
// What surface contact costs per vertex, beside penalty contact on the same lines: two wavy lines of n segments each, two
// to a cell of the grid, that touch all along or are apart; and free edges per domain of a block of particles.
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <grit/contact_penalty.h>
#include <grit/contact_surface.h>

#include "measure.hpp"

namespace {

using namespace benchmarks;

constexpr double cell = 2.0, segment = 1.0, dt = 1e-3;  // lengths, and a step
constexpr std::ptrdiff_t rows = 16;                     // of nodes

// n segments, wavy, in a strip of nodes that move down if it is the upper one.
struct Line {
    std::vector<double> position, weight, mass, velocity, start, force;
    std::vector<std::ptrdiff_t> facet, node;
    std::ptrdiff_t nodes;

    Line(int n, double height, bool upper)
        : nodes((static_cast<std::ptrdiff_t>(n * segment / cell) + 2) * rows) {
        for (int i = 0; i <= n; ++i) {
            const double x = segment * (upper ? i : n - i);  // the body is on the left
            add_vertex(x, height + 0.5 * cell * (rows - 1) + 5.0 * std::sin(0.05 * x));
            if (i > 0) facet.insert(facet.end(), {i - 1, i});
        }
        mass.assign(static_cast<std::size_t>(nodes), 1.0);
        for (std::ptrdiff_t i = 0; i < nodes; ++i)
            start.insert(start.end(), {0.0, upper ? -1.0 : 0.0});
        velocity = start;
        force.resize(position.size());
    }
    void add_vertex(double x, double z) {
        position.insert(position.end(), {x, z});
        const double at[2] = {x / cell, z / cell};
        const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(at[0]),
                             j = static_cast<std::ptrdiff_t>(at[1]);
        const double s = at[0] - static_cast<double>(i), t = at[1] - static_cast<double>(j);
        node.insert(node.end(),
                    {i * rows + j, i * rows + j + 1, (i + 1) * rows + j, (i + 1) * rows + j + 1});
        weight.insert(weight.end(), {(1 - s) * (1 - t), (1 - s) * t, s * (1 - t), s * t});
    }
    std::ptrdiff_t vertices() const { return static_cast<std::ptrdiff_t>(position.size() / 2); }
    grit_surface surface() {
        grit_surface s{};
        s.struct_size = sizeof s;
        s.nodes_each = 4;
        s.vertices = vertices();
        s.facets = vertices() - 1;
        s.position = grit_view_of(position.data(), 2, 1);
        s.facet = facet.data();
        s.node = node.data();
        s.weight = weight.data();
        s.nodes = nodes;
        s.mass = grit_view_of(mass.data(), 1, 1);
        s.velocity = grit_mutable_view_of(velocity.data(), 2, 1);
        return s;
    }
    grit_penalty_surface line() {
        grit_penalty_surface s{};
        s.struct_size = sizeof s;
        s.count = vertices();
        s.position = grit_view_of(position.data(), 2, 1);
        s.force = grit_mutable_view_of(force.data(), 2, 1);
        return s;
    }
};

void surface(benchmark::State& state, int n, double gap, double friction) {
    Line a(n, 0.0, false), b(n, gap, true);
    const grit_surface of_a = a.surface(), of_b = b.surface();
    grit_surface_options options;
    grit_surface_options_init(&options, sizeof options);
    options.friction_coefficient = friction;
    options.time_step = dt;
    options.spacing = 2.0 * cell;
    options.reach = cell;
    std::size_t needed = grit_surface_workspace_size(&of_a, &of_b);
    std::vector<double> workspace(needed / sizeof(double) + 1);
    grit_surface_totals totals{};
    totals.struct_size = sizeof totals;
    best_of(
        state, 2.0 * static_cast<double>(a.vertices()),
        [&] {
            a.velocity = a.start;
            b.velocity = b.start;
        },
        [&] {
            if (grit_surface_correct(&options, &of_a, &of_b, workspace.data(),
                                     workspace.size() * sizeof(double), &needed, nullptr, &totals,
                                     nullptr) != GRIT_OK)
                std::abort();
        });
    state.counters["vertices"] = 2.0 * static_cast<double>(a.vertices());
    state.counters["sweeps"] = static_cast<double>(totals.sweeps);
}

void penalty(benchmark::State& state, int n, double gap) {
    Line a(n, 0.0, false), b(n, gap, true);
    const grit_penalty_surface of_a = a.line(), of_b = b.line();
    grit_penalty_options options;
    grit_penalty_options_init(&options, sizeof options);
    options.normal_stiffness = 1e3;
    options.depth_max = cell;
    options.time_step = dt;
    std::vector<double> workspace(
        grit_penalty_workspace_size(a.vertices(), b.vertices()) / sizeof(double) + 1);
    grit_penalty_totals totals{};
    totals.struct_size = sizeof totals;
    best_of(
        state, 2.0 * static_cast<double>(a.vertices()), [] {},
        [&] {
            if (grit_penalty_forces(&options, &of_a, &of_b, workspace.data(),
                                    workspace.size() * sizeof(double), &totals, nullptr) != GRIT_OK)
                std::abort();
        });
    state.counters["vertices"] = 2.0 * static_cast<double>(a.vertices());
}

// A square block of n domains, a little turned.
void free_edges(benchmark::State& state, int n) {
    const int side = static_cast<int>(std::lround(std::sqrt(n)));
    std::vector<double> x, r;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            x.insert(x.end(), {0.96 * i - 0.28 * j, 0.28 * i + 0.96 * j});
            r.insert(r.end(), {0.48, 0.14, -0.14, 0.48});
        }
    const std::size_t count = x.size() / 2;
    grit_surface_domains domains{};
    domains.struct_size = sizeof domains;
    domains.n = static_cast<std::ptrdiff_t>(count);
    domains.position = grit_view_of(x.data(), 2, 1);
    domains.side = grit_matrix_view_of(r.data(), 4, 2, 1);
    domains.tolerance = 0.25;
    std::vector<double> position(8 * count),
        workspace(grit_surface_find_free_workspace_size(domains.n) / sizeof(double) + 1);
    std::vector<std::ptrdiff_t> facet(8 * count);
    std::ptrdiff_t vertices = 0, facets = 0;
    best_of(
        state, static_cast<double>(count), [] {},
        [&] {
            if (grit_surface_find_free(
                    &domains, workspace.data(), workspace.size() * sizeof(double), position.data(),
                    facet.data(), nullptr, &vertices, &facets, nullptr) != GRIT_OK)
                std::abort();
        });
    if (facets != 4 * side) std::abort();
    state.counters["vertices"] = static_cast<double>(count);
}

void register_all() {
    for (const int n : {100, 1000, 10000}) {
        const auto add = [n](const std::string& name, auto function) {
            add_benchmark(name + "/" + std::to_string(n), function);
        };
        add("surface, touching", [n](benchmark::State& state) { surface(state, n, 0.0, 0.0); });
        add("surface, touching, friction",
            [n](benchmark::State& state) { surface(state, n, 0.0, 0.3); });
        add("surface, apart", [n](benchmark::State& state) { surface(state, n, 0.5 * cell, 0.0); });
        add("penalty, touching", [n](benchmark::State& state) { penalty(state, n, -0.1); });
        add("penalty, apart", [n](benchmark::State& state) { penalty(state, n, 0.5 * cell); });
        add("free edges, per domain", [n](benchmark::State& state) { free_edges(state, n); });
    }
}

}  // namespace

int main(int argc, char** argv) { return run_beside_exp(argc, argv, register_all); }
