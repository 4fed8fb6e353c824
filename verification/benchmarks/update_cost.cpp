// SPDX-License-Identifier: BSD-3-Clause
// What a call costs: one point at a time, in a batch, with the consistent tangent, beside one dependent
// std::exp measured in the same run. CPU time per point; take the best of several repetitions.
#include <benchmark/benchmark.h>

#include <cmath>

#include <grit/sand_operators.h>

#include "single_calls.hpp"

namespace {

using namespace benchmarks;

const std::vector<Call>& calls_of(double increment) {
    static const auto all = read_calls(GRIT_DATA "/speed_states.csv");
    for (const auto& [size, list] : all)
        if (std::fabs(size / increment - 1.0) < 1e-6) return list;
    std::abort();
}

struct Arrays {
    std::vector<double> strain, stress, state, tangent;
    explicit Arrays(const std::vector<Call>& calls) : tangent(36 * calls.size()) {
        for (const Call& c : calls) {
            strain.insert(strain.end(), c.strain, c.strain + 6);
            stress.insert(stress.end(), c.stress, c.stress + 6);
            state.insert(state.end(), c.state, c.state + 8);
        }
    }
};

grit_sand_points points_of(Arrays& x, std::size_t first) {
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(&x.strain[6 * first], 6, 1);
    q.stress = grit_mutable_view_of(&x.stress[6 * first], 6, 1);
    q.state = grit_mutable_view_of(&x.state[8 * first], 8, 1);
    q.tangent = grit_mutable_matrix_view_of(&x.tangent[36 * first], 36, 6, 1);
    return q;
}

// Arguments: increment as a power of ten, tolerance as a power of ten, tangent, points per call,
// instruction set.
void update(benchmark::State& state) {
    const auto& calls = calls_of(std::pow(10.0, static_cast<double>(state.range(0))));
    const grit_sand sand = lausitz();
    const Arrays start(calls);
    Arrays work = start;
    grit_sand_options options;
    grit_sand_options_init(&options, sizeof options);
    options.tolerance = std::pow(10.0, static_cast<double>(state.range(1)));
    options.tangent = static_cast<int>(state.range(2));
    options.instruction_set = static_cast<int>(state.range(4));
    const auto n = static_cast<std::size_t>(state.range(3));
    for (auto _ : state) {
        work.stress = start.stress;  // 30 kB copied per 320 points
        work.state = start.state;
        for (std::size_t first = 0; first + n <= calls.size(); first += n) {
            const grit_sand_points q = points_of(work, first);
            grit_sand_update(&sand, &options, static_cast<ptrdiff_t>(n), &q, nullptr, nullptr);
        }
        benchmark::DoNotOptimize(work.stress.data());
    }
    const std::size_t points = calls.size() / n * n;
    state.counters["per_point"] = benchmark::Counter(static_cast<double>(points),
                                                     benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

// Wave moduli of points. Argument: 1 in one call, 0 one by one.
void wave_moduli(benchmark::State& state) {
    const auto& calls = calls_of(1e-3);
    const grit_sand sand = lausitz();
    Arrays work(calls);
    std::vector<double> moduli(calls.size());
    const grit_sand_points all = points_of(work, 0);
    for (auto _ : state) {
        if (state.range(0) > 0)
            grit_sand_wave_moduli(&sand, nullptr, static_cast<ptrdiff_t>(calls.size()), &all,
                                  moduli.data(), nullptr);
        else
            for (std::size_t i = 0; i < calls.size(); ++i)
                grit_sand_wave_modulus(&sand, 0, &work.stress[6 * i],
                                       work.state[8 * i + GRIT_SAND_VOID_RATIO], &moduli[i]);
        benchmark::DoNotOptimize(moduli.data());
    }
    state.counters["per_point"] = benchmark::Counter(static_cast<double>(calls.size()),
                                                     benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

void dependent_exp(benchmark::State& state) {
    double x = -0.5;
    for (auto _ : state) {
        for (int i = 0; i < 1000; ++i) x = std::exp(x) - 1.0;  // the next needs the last
        benchmark::DoNotOptimize(x);
        x = -0.5;
    }
    state.counters["per_point"] = benchmark::Counter(
        1000.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void register_all() {
    benchmark::RegisterBenchmark("wave_moduli", wave_moduli)->Arg(0)->Arg(1);
    benchmark::RegisterBenchmark("exp/dependent", dependent_exp);
    for (const int increment : {-6, -4, -3, -2})
        for (const int tolerance : {-3, -5}) {
            const std::string name =
                "increment:1e" + std::to_string(increment) + "/tol:1e" + std::to_string(tolerance);
            const auto add = [&](const std::string& kind, int tangent, int n, int isa) {
                benchmark::RegisterBenchmark((name + "/" + kind).c_str(), update)
                    ->Args({increment, tolerance, tangent, n, isa});
            };
            add("alone", GRIT_TANGENT_NONE, 1, GRIT_ISA_BEST);
            add("alone_consistent", GRIT_TANGENT_CONSISTENT, 1, GRIT_ISA_BEST);
            add("alone_baseline", GRIT_TANGENT_NONE, 1, GRIT_ISA_BASELINE);
            add("batch", GRIT_TANGENT_NONE, 320, GRIT_ISA_BEST);
            add("batch_baseline", GRIT_TANGENT_NONE, 320, GRIT_ISA_BASELINE);
        }
}

}  // namespace

int main(int argc, char** argv) {
    register_all();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
