// SPDX-License-Identifier: BSD-3-Clause
// What a point of a batch costs: 10^4 points per call and instruction set, in columns as explicit codes keep
// them and in structures, two threads that share them, and 1 to 10^6 points per call. The points are those of the
// 320 states again and again; no reports are asked for.
#include <algorithm>
#include <atomic>
#include <thread>

#include <grit/sand_operators.h>

#include "measure.hpp"
#include "sand_points.hpp"

namespace {

using namespace benchmarks;

constexpr std::size_t cold = 20000;  // points that do not fit into the second cache

struct Batch {
    SandRequest request;
    std::size_t per_call;
    int threads = 1;
    Layout layout = Layout::columns;
};

// Another caller's thread, which spins while it waits: to start or to wake one takes as long as a pass.
template <class Work> class Other {
  public:
    explicit Other(const Work& its_work)
        : work(its_work), thread([this] {
              for (int seen; (seen = turn) != ends;)
                  if (seen == works) {
                      work();
                      turn = waits;
                  }
          }) {}
    ~Other() {
        turn = ends;
        thread.join();
    }
    void start() { turn = works; }
    void finish() const {
        while (turn == works) {
        }
    }

  private:
    static constexpr int waits = 0, works = 1, ends = 2;
    const Work& work;
    std::atomic<int> turn{waits};
    std::thread thread;
};

SandPoints points_of(const Batch& b, std::size_t size) {
    const auto& calls = calls_of(b.request.increment);
    if (b.layout == Layout::columns) return SandPoints::columns(calls, size);
    SandPoints p = SandPoints::structures(calls, size);
    p.reports.clear();
    return p;
}

void batch(benchmark::State& state, const Batch& b) {
    const grit_sand sand = lausitz();
    const grit_sand_options options = b.request.options();
    const std::size_t size = std::max<std::size_t>(b.per_call, 256);
    Copies memory(points_of(b, size), 1 + cold / size);
    SandPoints* points = nullptr;
    const auto part = [&](std::size_t first, std::size_t last) {
        update(sand, options, *points, first, last, b.per_call);
    };
    const auto whole = [&] { part(0, size); };
    const auto prepare = [&] { points = &memory.next(); };
    const auto items = static_cast<double>(size);
    if (b.threads == 2) {
        const auto second_half = [&] { part(size / 2, size); };
        Other other(second_half);
        const auto halves = [&] {
            other.start();
            part(0, size / 2);
            other.finish();
        };
        best_of(state, items, prepare, halves, Threads::several);
    } else {
        best_of(state, items, prepare, whole);
    }
    b.request.tell(state);
    state.counters["per_call"] = static_cast<double>(b.per_call);
    state.counters["threads_used"] = b.threads;
}

void add(const std::string& name, const Batch& b) {
    add_benchmark(name + b.request.words() + "/" + std::to_string(b.per_call),
                  [b](benchmark::State& state) { batch(state, b); });
}

// Points in one call, or one by one.
void wave_moduli(benchmark::State& state, bool together) {
    const auto& calls = calls_of(1e-3);
    const grit_sand sand = lausitz();
    SandPoints points = SandPoints::columns(calls, calls.size());
    std::vector<double> moduli(calls.size());
    const grit_sand_points all = points.views(0);
    const auto pass = [&] {
        if (together)
            grit_sand_wave_moduli(&sand, nullptr, static_cast<std::ptrdiff_t>(calls.size()), &all,
                                  moduli.data(), nullptr);
        else
            for (std::size_t i = 0; i < calls.size(); ++i)
                grit_sand_wave_modulus(&sand, 0, calls[i].stress,
                                       calls[i].state[GRIT_SAND_VOID_RATIO], &moduli[i]);
        benchmark::DoNotOptimize(moduli.data());
    };
    best_of(
        state, static_cast<double>(calls.size()), [] {}, pass);
    state.counters["together"] = together ? 1.0 : 0.0;
}

void register_all() {
    constexpr std::size_t many = 10000;
    for (const double increment : {1e-6, 1e-4, 1e-3, 1e-2}) {
        for (int isa = GRIT_ISA_BASELINE; isa <= grit_instruction_set(); ++isa)
            add("batch", {{.increment = increment, .instruction_set = isa}, many});
        add("threads", {{increment}, many, 2});
        add("structures", {{increment}, many, 1, Layout::structures});
    }
    for (const double increment : {1e-6, 1e-4})
        for (std::size_t n = 1; n <= 1000000; n *= 10) {
            add("growth", {{increment}, n});
            if (n < 1000000) add("growth", {{increment}, 3 * n});
        }
    add_benchmark("wave_moduli/alone", [](benchmark::State& s) { wave_moduli(s, false); });
    add_benchmark("wave_moduli/batch", [](benchmark::State& s) { wave_moduli(s, true); });
}

}  // namespace

int main(int argc, char** argv) { return run_beside_exp(argc, argv, register_all); }
