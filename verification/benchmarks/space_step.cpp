// SPDX-License-Identifier: BSD-3-Clause
// What a material point in space costs per step, in the brick of space_brick.hpp, and beside it the bandwidth of a triad
// with as many threads [bytes/ns], for memory is what large numbers of particles share.
#include <adapters/mpm/step/thread_pool.hpp>

#include "measure.hpp"
#include "space_brick.hpp"

namespace {

using namespace benchmarks;

Threads kind_of(int threads) { return threads > 1 ? Threads::several : Threads::one; }

void steps(benchmark::State& state, const BrickPlan& plan) {
    constexpr int count = 3;
    std::unique_ptr<grit::mpm::space::Simulation> simulation;
    const auto prepare = [&] {
        if (simulation) return;
        simulation = brick(plan);
        simulation->step();
    };
    const auto pass = [&] {
        for (int i = 0; i < count; ++i) simulation->step();
    };
    best_of(state, plan.particles() * count, prepare, pass, kind_of(plan.threads));
    state.counters["particles"] = plan.particles();
    state.counters["sand"] = plan.sand ? 1.0 : 0.0;
    state.counters["threads_used"] = plan.threads;
}

// a = b + s c, three arrays of 64 MiB: best_ns is of a byte.
void triad(benchmark::State& state, int threads) {
    constexpr std::size_t size = 1 << 23;
    std::vector<double> a(size), b(size, 1.0), c(size, 2.0);
    grit::mpm::ThreadPool pool(threads);
    const auto pass = [&] {
        pool.run(threads, [&](int i) {
            const std::size_t begin =
                size * static_cast<std::size_t>(i) / static_cast<std::size_t>(threads);
            const std::size_t end =
                size * static_cast<std::size_t>(i + 1) / static_cast<std::size_t>(threads);
            for (std::size_t k = begin; k < end; ++k) a[k] = b[k] + 3.0 * c[k];
            benchmark::DoNotOptimize(a.data());
        });
    };
    best_of(
        state, 3.0 * sizeof(double) * size, [] {}, pass, kind_of(threads));
    state.counters["gigabytes_per_s"] = 1.0 / state.counters["best_ns"];
    state.counters["threads_used"] = threads;
}

void register_all() {
    for (const int threads : {1, 2}) {
        const std::string of = threads == 1 ? "" : ", two threads";
        add_benchmark("triad" + of, [threads](benchmark::State& state) { triad(state, threads); });
        for (const int cells : {23, 50})
            for (const bool sand : {false, true}) {
                const BrickPlan plan{cells, sand, threads};
                add_benchmark((sand ? "space sand/" : "space elastic/") + std::to_string(cells) +
                                  of,
                              [plan](benchmark::State& state) { steps(state, plan); });
            }
    }
}

}  // namespace

int main(int argc, char** argv) { return run_beside_exp(argc, argv, register_all); }
