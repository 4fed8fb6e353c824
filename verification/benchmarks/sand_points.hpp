// SPDX-License-Identifier: BSD-3-Clause
// Points of a host, and what is asked of the library with them.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <vector>

#include "single_calls.hpp"

namespace benchmarks {

// How a host keeps its points: all components of one together, or one component of all together.
enum class Layout { structures, columns };

struct SandPoints {
    Layout layout = Layout::structures;
    std::vector<double> strain, stress, state, tangent;
    std::vector<grit_sand_report> reports;  // none: not asked for

    // The calls again and again, up to count points.
    static SandPoints structures(const std::vector<Call>& calls, std::size_t count,
                                 bool with_tangent = false);
    static SandPoints columns(const std::vector<Call>& calls, std::size_t count);
    std::size_t size() const { return strain.size() / 6; }
    // From first on; tangents if there is memory for them.
    grit_sand_points views(std::size_t first);
};

struct SandRequest {
    double increment;
    double tolerance = 0.0;  // 0: the default
    int tangent = GRIT_TANGENT_NONE;
    int instruction_set = GRIT_ISA_BEST;

    grit_sand_options options() const;
    std::string words() const;                 // for a name
    void tell(benchmark::State& state) const;  // as counters
};

// Points first ... last - 1 in calls of so many.
void update(const grit_sand& sand, const grit_sand_options& options, SandPoints& points,
            std::size_t first, std::size_t last, std::size_t per_call);

// Failures and percentiles of evaluations and error, as counters.
void tell(benchmark::State& state, const std::vector<Outcome>& outcomes);

}  // namespace benchmarks
