// SPDX-License-Identifier: BSD-3-Clause
// What a point of a batch costs: 10^4 points per call and instruction set, in columns as explicit codes keep
// them and in structures, two threads that share them beside one, and 1 to 10^6 points per call. The points are those
// of the 320 states again and again; no reports are asked for.
#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

#include <grit/sand_operators.h>

#include "measure.hpp"
#include "sand_points.hpp"

namespace {

using namespace benchmarks;

constexpr std::size_t cold = 20000;  // points that do not fit into the second cache

struct Batch {
    SandRequest request;
    std::size_t per_call;
    Layout layout = Layout::columns;
};

// Another caller's thread. It and the caller sleep while the other one works alone. To work together it is woken
// before and both spin: to start or to wake a thread takes as long as a pass.
class Other {
  public:
    ~Other() {
        tell(ends);
        thread.join();
    }
    void work_alone(std::function<void()> work) {
        job = std::move(work);
        tell(works);
        turn.wait(works);
    }
    void wake() {
        tell(wakes);
        wait_for(spins);
    }
    void start(std::function<void()> work) {
        job = std::move(work);
        turn = works;
    }
    void finish() const { wait_for(sleeps); }

  private:
    enum Turn { sleeps, wakes, spins, works, ends };
    void tell(Turn next) {
        turn = next;
        turn.notify_one();
    }
    void wait_for(Turn wanted) const {
        while (turn != wanted) {
        }
    }
    void live() {
        while (turn != ends) {
            turn.wait(sleeps);
            if (turn == wakes) turn = spins;
            if (turn == works) {
                job();
                tell(sleeps);
            }
        }
    }
    std::function<void()> job;
    std::atomic<Turn> turn{sleeps};
    std::thread thread{[this] { live(); }};
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
    best_of(
        state, static_cast<double>(size), [&] { points = &memory.next(); },
        [&] { update(sand, options, *points, 0, size, b.per_call); });
    b.request.tell(state);
    state.counters["per_call"] = static_cast<double>(b.per_call);
}

// Items by each of two threads alone, at once, and by both, in turns; together they take pieces of 512 as they come, as
// callers cut a batch. faster_by is how much more both do than one does on average, in the middle one of the turns: other
// guests of the machine slow one of the threads down for seconds. prepare() before each, work(first, last).
template <class Prepare, class Work>
void two_threads(benchmark::State& state, std::size_t size, const Prepare& prepare,
                 const Work& work) {
    constexpr std::size_t piece = 512;
    std::atomic<std::size_t> next{0};
    const auto whole = [&] { work(std::size_t{0}, size); };
    const auto pieces = [&] {
        for (std::size_t at; (at = next.fetch_add(piece)) < size;)
            work(at, std::min(at + piece, size));
    };
    Other other;
    std::vector<double> ratios;
    double best = std::numeric_limits<double>::infinity();
    for (auto _ : state) {
        prepare();
        const double first = wall_seconds_of(whole);
        prepare();
        double second = 0.0;
        other.work_alone([&] { second = wall_seconds_of(whole); });
        prepare();
        next = 0;
        other.wake();
        const double both = wall_seconds_of([&] {
            other.start(pieces);
            pieces();
            other.finish();
        });
        ratios.push_back(2.0 / (1.0 / first + 1.0 / second) / both);
        best = std::fmin(best, both);
        state.SetIterationTime(first + second + both);
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    state.counters["faster_by"] = *middle;
    state.counters["best_ns"] = 1e9 * best / static_cast<double>(size);
}

void two_threads_with_sand(benchmark::State& state, const SandRequest& request, std::size_t size) {
    const grit_sand sand = lausitz();
    const grit_sand_options options = request.options();
    Copies memory(SandPoints::columns(calls_of(request.increment), size), 1 + cold / size);
    SandPoints* points = nullptr;
    two_threads(
        state, size, [&] { points = &memory.next(); },
        [&](std::size_t first, std::size_t last) {
            update(sand, options, *points, first, last, last - first);
        });
    request.tell(state);
}

// What the machine itself gives: without memory, and eight at a time, so that a core has no time to spare.
void two_threads_with_exp(benchmark::State& state) {
    two_threads(
        state, 10000, [] {},
        [](std::size_t first, std::size_t last) {
            std::array<double, 8> x{0.1, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9};
            for (std::size_t i = first; i < last; ++i)
                for (double& each : x) each = std::exp(-each);  // towards 0.567
            benchmark::DoNotOptimize(x);
        });
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
        add("structures", {{increment}, many, Layout::structures});
        const SandRequest request{increment};
        add_benchmark("threads" + request.words(), [=](benchmark::State& state) {
            two_threads_with_sand(state, request, many);
        });
    }
    add_benchmark("threads/exp", two_threads_with_exp);
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
