// SPDX-License-Identifier: BSD-3-Clause
// What the penalty contact costs per vertex, against the number of vertices: two wavy lines that
// overlap all along (every vertex in contact), two that do not touch, and a pile's outline in a long
// line of which one segment is a million times longer than the others. CPU time per vertex; take the
// best of several repetitions.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <grit/contact_penalty.h>

namespace {

using Point = std::array<double, 2>;

struct Surface {
    std::vector<Point> x, v, history, force;

    explicit Surface(std::vector<Point> points)
        : x(std::move(points)), v(x.size()), history(x.size()), force(x.size()) {}

    grit_penalty_surface view() {
        grit_penalty_surface s{};
        s.struct_size = sizeof s;
        s.count = static_cast<std::ptrdiff_t>(x.size());
        s.position = grit_view_of(x[0].data(), 2, 1);
        s.velocity = grit_view_of(v[0].data(), 2, 1);
        s.history = grit_mutable_view_of(history[0].data(), 2, 1);
        s.force = grit_mutable_view_of(force[0].data(), 2, 1);
        return s;
    }
};

// n segments of length 1, one of them of another length; the upper line travels to the right.
Surface wave(int n, double height, double one_length, bool upper) {
    std::vector<Point> x(static_cast<std::size_t>(n) + 1);
    double along = upper ? 0.0 : 0.37;
    for (int i = 0; i <= n; ++i) {
        const auto at = static_cast<std::size_t>(upper ? i : n - i);
        x[at] = {along, 5.0 * std::sin(0.05 * i) + height};
        along += i == n / 2 ? one_length : 1.0;
    }
    return Surface(x);
}

void forces(benchmark::State& state, double overlap, double one_length) {
    const int n = static_cast<int>(state.range(0)) / 2;
    Surface a = wave(n, -overlap, one_length, true), b = wave(n, 0.0, one_length, false);
    const grit_penalty_surface view_a = a.view(), view_b = b.view();
    grit_penalty_options options;
    grit_penalty_options_init(&options, sizeof options);
    options.normal_stiffness = 1e6;
    options.depth_max = 1.0;
    options.friction_coefficient = 0.3;
    options.time_step = 1e-3;
    grit_penalty_totals totals{};
    totals.struct_size = sizeof totals;
    std::vector<double> workspace(grit_penalty_workspace_size(view_a.count, view_b.count) /
                                  sizeof(double));
    for (auto _ : state)
        if (grit_penalty_forces(&options, &view_a, &view_b, workspace.data(),
                                workspace.size() * sizeof(double), &totals, nullptr) != GRIT_OK)
            std::abort();
    const double vertices = 2.0 * (n + 1.0);
    state.counters["ns_per_vertex"] =
        benchmark::Counter(vertices * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                                benchmark::Counter::kInvert);
    state.counters["tests_per_vertex"] = static_cast<double>(totals.tests) / vertices;
    state.counters["in_contact"] =
        static_cast<double>(totals.contacts_a + totals.contacts_b) / vertices;
}

BENCHMARK_CAPTURE(forces, all_in_contact, 0.1, 1.0)->Arg(1000)->Arg(10000)->Arg(100000);
BENCHMARK_CAPTURE(forces, apart, -3.0, 1.0)->Arg(1000)->Arg(10000)->Arg(100000);
BENCHMARK_CAPTURE(forces, one_segment_long, 0.1, 1e6)->Arg(1000)->Arg(10000)->Arg(100000);

void remesh(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    Surface line = wave(n, 0.0, 1.0, true);
    std::vector<Point> new_x(3 * line.x.size());
    std::vector<std::ptrdiff_t> parents(6 * line.x.size()), workspace(line.x.size());
    std::vector<double> weight(3 * line.x.size());
    grit_penalty_remeshing q{};
    q.struct_size = sizeof q;
    q.longest = 5.0;
    q.shortest = 2.5;
    q.tolerance = 0.25;
    q.count = n + 1;
    q.position = grit_view_of(line.x[0].data(), 2, 1);
    q.capacity = static_cast<std::ptrdiff_t>(new_x.size());
    q.new_position = grit_mutable_view_of(new_x[0].data(), 2, 1);
    q.parents = parents.data();
    q.weight = weight.data();
    std::ptrdiff_t count = 0;
    for (auto _ : state)
        if (grit_penalty_remesh(&q, workspace.data(), workspace.size() * sizeof(std::ptrdiff_t),
                                &count, nullptr) != GRIT_OK)
            std::abort();
    state.counters["ns_per_vertex"] =
        benchmark::Counter((n + 1) * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                               benchmark::Counter::kInvert);
}

BENCHMARK(remesh)->Arg(1000)->Arg(10000)->Arg(100000);

}  // namespace

BENCHMARK_MAIN();
