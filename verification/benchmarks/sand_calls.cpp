// SPDX-License-Identifier: BSD-3-Clause
// What one call costs and what it delivers, from 320 states in memory of their own:
//   sand_calls [--umat LIBRARY LAYOUT.toml]... [--benchmark_...]
// through the C ABI at the default tolerance, at others and with the consistent tangent, and through
// umat_ of any libraries, laid out as their files say (layouts/classic.toml).
#include <exception>
#include <iostream>
#include <set>
#include <stdexcept>

#include "measure.hpp"
#include "sand_points.hpp"
#include "umat_calls.hpp"

namespace {

using namespace benchmarks;

constexpr double increments[] = {1e-6, 1e-4, 1e-3, 1e-2};
constexpr std::size_t copies = 64;  // of 50 kB: past the second cache

std::vector<Outcome> outcomes_of(const std::vector<Call>& calls, const SandPoints& points) {
    std::vector<Outcome> out;
    for (std::size_t i = 0; i < points.size(); ++i)
        out.push_back({points.reports[i].status != GRIT_OK,
                       stress_error(calls[i], &points.stress[6 * i]),
                       static_cast<double>(points.reports[i].evaluations)});
    return out;
}

void call(benchmark::State& state, const SandRequest& request) {
    const auto& calls = calls_of(request.increment);
    const grit_sand sand = lausitz();
    const grit_sand_options options = request.options();
    Copies memory(SandPoints::structures(calls, calls.size(), request.tangent != GRIT_TANGENT_NONE),
                  copies);
    SandPoints* points = nullptr;
    best_of(
        state, static_cast<double>(calls.size()), [&] { points = &memory.next(); },
        [&] { update(sand, options, *points, 0, calls.size(), 1); });
    request.tell(state);
    tell(state, outcomes_of(calls, *points));
}

void call_umat(benchmark::State& state, element::UmatFunction umat, UmatLayout layout,
               const SandRequest& request) {
    const auto& calls = calls_of(request.increment);
    Copies memory(UmatPoints(calls, layout), copies);
    UmatPoints* points = nullptr;
    best_of(
        state, static_cast<double>(calls.size()), [&] { points = &memory.next(); },
        [&] { run_umat(umat, layout, request.tangent != GRIT_TANGENT_NONE, *points); });
    state.counters["increment"] = request.increment;
    state.counters["tangent"] = request.tangent;
    tell(state, outcomes_of(calls, layout, *points));
}

void add_c_abi() {
    const auto add = [](const SandRequest& request) {
        add_benchmark("c_abi" + request.words(),
                      [request](benchmark::State& state) { call(state, request); });
    };
    for (const double increment : increments) {
        add({increment});
        add({.increment = increment, .tangent = GRIT_TANGENT_CONSISTENT});
        for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10})
            add({increment, tolerance});
    }
}

void add_umat(const std::string& library, const std::string& file) {
    const element::UmatFunction umat = open_umat(library);
    const UmatLayout layout = read_umat_layout(file);
    static std::set<std::string> names;
    if (!names.insert(layout.name).second)
        throw std::runtime_error(file + ": another layout has the name \"" + layout.name +
                                 "\" too");
    for (const double increment : increments)
        for (const int tangent : {GRIT_TANGENT_NONE, GRIT_TANGENT_CONSISTENT}) {
            if (tangent == GRIT_TANGENT_NONE && !layout.ddsdde_may_be_null) continue;
            const SandRequest request{.increment = increment, .tangent = tangent};
            add_benchmark(layout.name + request.words(), [=](benchmark::State& state) {
                call_umat(state, umat, layout, request);
            });
        }
}

int run(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    add_exp("before");
    add_c_abi();
    for (int i = 1; i < argc; i += 3) {
        if (std::string(argv[i]) != "--umat" || i + 2 >= argc) {
            std::cerr << "sand_calls: must be --umat LIBRARY LAYOUT.toml, got " << argv[i] << '\n';
            return 2;
        }
        add_umat(argv[i + 1], argv[i + 2]);
    }
    add_exp("after");
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "sand_calls: " << error.what() << '\n';
        return 2;
    }
}
