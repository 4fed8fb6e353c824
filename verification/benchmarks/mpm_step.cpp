// SPDX-License-Identifier: BSD-3-Clause
// What a material point costs per step: an elastic axisymmetric column, four particles a cell, one
// thread, and where the time goes. Take the best of several repetitions.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include <adapters/mpm/kernel/elastic.hpp>
#include <adapters/mpm/simulation.hpp>

namespace {

using namespace grit::mpm;

// 1 : 4 cells, as a pile's surroundings.
std::unique_ptr<Simulation> column(int cells_r, int threads, Shape shape, Scheme scheme) {
    const int cells_z = 4 * cells_r;
    const double h = 1.0 / cells_r;
    Settings settings{.shape = shape, .scheme = scheme, .gravity_z = -9.81, .threads = threads};
    auto simulation = std::make_unique<Simulation>(
        Axis::uniform(0.0, 1.0, cells_r), Axis::uniform(0.0, 4.2, cells_z + cells_r / 5), settings);
    Body body;
    for (int j = 0; j < 2 * cells_z; ++j)
        for (int i = 0; i < 2 * cells_r; ++i)
            body.particles.add(
                {0.5 * h * (i + 0.5), 0.5 * h * (j + 0.5), 0.25 * h, 0.25 * h, 2000.0}, true);
    body.material = std::make_unique<LinearElastic>(1e7, 0.3);
    simulation->add_body(std::move(body));
    simulation->fix_below(1, 0.0);
    simulation->fix_above(0, 1.0);
    return simulation;
}

void count(benchmark::State& state, double particles) {
    state.counters["ns_per_particle"] =
        benchmark::Counter(particles * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                                 benchmark::Counter::kInvert);
    state.counters["particles"] = particles;
}

void step(benchmark::State& state, Shape shape, Scheme scheme) {
    const auto simulation =
        column(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), shape, scheme);
    simulation->step();
    for (auto _ : state) simulation->step();
    count(state, static_cast<double>(simulation->body(0).particles.size()));
}

}  // namespace

// 20 x 80 cells: 6 400 particles; 79 x 316 cells: 99 856.
BENCHMARK_CAPTURE(step, cpdi_usl, Shape::cpdi, Scheme::usl)
    ->Args({20, 1})
    ->Args({79, 1})
    ->Args({79, 2})
    ->UseRealTime();
BENCHMARK_CAPTURE(step, cpdi_musl, Shape::cpdi, Scheme::musl)->Args({20, 1})->UseRealTime();
BENCHMARK_CAPTURE(step, cpdi_usf, Shape::cpdi, Scheme::usf)->Args({20, 1})->UseRealTime();
BENCHMARK_CAPTURE(step, ugimp_usl, Shape::ugimp, Scheme::usl)->Args({20, 1})->UseRealTime();
BENCHMARK_CAPTURE(step, point_usl, Shape::point, Scheme::usl)->Args({20, 1})->UseRealTime();
BENCHMARK_MAIN();
