// SPDX-License-Identifier: BSD-3-Clause
// How a time is taken: the shortest of many passes on a machine that may be busy with other work, and
// beside it, from the same run, one dependent std::exp. Counters of each benchmark: best_ns, and what it
// was asked for; tables.py makes tables of them.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

namespace benchmarks {

// Of this thread [s].
inline double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// [s]
inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

template <class Pass> double wall_seconds_of(const Pass& pass) {
    const double start = wall_seconds();
    pass();
    return wall_seconds() - start;
}

enum class Threads { one, several };

// The shortest pass [s]. Of those of one thread the ones that nobody disturbed count, where CPU and wall time agree:
// what other processes and other guests of the machine take makes wall time long, and CPU time too short now and
// then. Without any such pass it is the shortest CPU time.
class Best {
  public:
    explicit Best(Threads used) : threads(used) {}
    template <class Pass> double time(const Pass& pass) {
        const double wall_start = wall_seconds(), cpu_start = cpu_seconds();
        pass();
        const double cpu_taken = cpu_seconds() - cpu_start;
        const double wall_taken = wall_seconds() - wall_start;
        if (threads == Threads::several || wall_taken < 1.02 * cpu_taken + 1e-6)
            quiet = std::fmin(quiet, wall_taken);
        cpu = std::fmin(cpu, cpu_taken);
        return wall_taken;
    }
    double seconds() const { return std::isfinite(quiet) ? quiet : cpu; }

  private:
    Threads threads;
    double quiet = std::numeric_limits<double>::infinity(), cpu = quiet;
};

// Passes over so many items, each prepared outside of its time; best_ns is that of the shortest, per item.
template <class Prepare, class Pass>
void best_of(benchmark::State& state, double items, const Prepare& prepare, const Pass& pass,
             Threads threads = Threads::one) {
    Best best(threads);
    for (auto _ : state) {
        prepare();
        state.SetIterationTime(best.time(pass));
    }
    state.counters["best_ns"] = 1e9 * best.seconds() / items;
}

// One that is timed by best_of. Names must differ.
template <class Function> void add_benchmark(const std::string& name, Function function) {
    benchmark::RegisterBenchmark(name.c_str(), function)->UseManualTime();
}

// Copies of what a host has in memory, taken one after the other and written anew when all have been used:
// a call does not find its points in the nearest cache.
template <class Memory> class Copies {
  public:
    Copies(const Memory& start, std::size_t count) : original(start), copies(count, start) {}
    Memory& next() {
        if (++at >= copies.size()) {
            for (Memory& copy : copies) copy = original;
            at = 0;
        }
        return copies[at];
    }

  private:
    Memory original;
    std::vector<Memory> copies;
    std::size_t at = 0;
};

// Once before and once after what is to be told in its units.
inline void add_exp(const std::string& when) {
    add_benchmark("exp/" + when, [](benchmark::State& state) {
        constexpr int count = 10000;
        double x = -0.5;
        best_of(
            state, count, [&x] { x = -0.5; },
            [&x] {
                for (int i = 0; i < count; ++i) x = std::exp(x) - 1.0;  // the next needs the last
                benchmark::DoNotOptimize(x);
            });
    });
}

// The main of a program: its benchmarks with the yardstick before and after them.
inline int run_beside_exp(int argc, char** argv, void (*register_all)()) {
    add_exp("before");
    register_all();
    add_exp("after");
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

}  // namespace benchmarks
