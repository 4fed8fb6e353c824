// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mgis/parameters.hpp"

#include <atomic>
#include <cstdio>
#include <cstring>

namespace grit::mgis {
namespace {

// The interface has no other place for them than the library itself.
std::atomic<double> tolerance{default_tolerance};
std::atomic<int> evaluation_limit{default_evaluation_limit};
std::atomic<double> smallest_reduction{default_smallest_reduction};
std::atomic<double> largest_water_tension{0.0};
std::atomic<int> water_itself{0};

bool is(const char* name, const char* expected) { return name && std::strcmp(name, expected) == 0; }

int refuse_name(const char* name, const char* kind, const char* known) {
    std::fprintf(stderr, "GritSand: there is no %s parameter \"%s\", only %s\n", kind,
                 name ? name : "(null)", known);
    return 0;
}

}  // namespace

Parameters current_parameters() {
    return {tolerance.load(std::memory_order_relaxed),
            evaluation_limit.load(std::memory_order_relaxed),
            smallest_reduction.load(std::memory_order_relaxed),
            largest_water_tension.load(std::memory_order_relaxed),
            water_itself.load(std::memory_order_relaxed)};
}

}  // namespace grit::mgis

extern "C" {

// 1: done, 0: refused, with a line on stderr, for the interface has no room for a message.
__attribute__((visibility("default"))) int GritSand_setParameter(const char* name, double value) {
    using namespace grit::mgis;
    if (is(name, "tolerance")) {
        if (value >= GRIT_SAND_LEAST_TOLERANCE && value <= GRIT_SAND_LARGEST_TOLERANCE) {
            tolerance = value;
            return 1;
        }
        std::fprintf(stderr, "GritSand: tolerance must be in [%g, %g], got %g\n",
                     GRIT_SAND_LEAST_TOLERANCE, GRIT_SAND_LARGEST_TOLERANCE, value);
        return 0;
    }
    if (is(name, "minimal_time_step_scaling_factor")) {
        if (value > 0.0 && value < 1.0) {
            smallest_reduction = value;
            return 1;
        }
        std::fprintf(stderr,
                     "GritSand: minimal_time_step_scaling_factor must be in (0, 1), got %g\n",
                     value);
        return 0;
    }
    if (is(name, "largest_water_tension")) {
        if (value >= 0.0 && value <= highest_water_tension) {
            largest_water_tension = value;
            return 1;
        }
        std::fprintf(stderr, "GritSand: largest_water_tension must be in [0, %g], got %g\n",
                     highest_water_tension, value);
        return 0;
    }
    return refuse_name(name, "real",
                       "tolerance, minimal_time_step_scaling_factor and largest_water_tension");
}

__attribute__((visibility("default"))) int GritSand_setIntegerParameter(const char* name,
                                                                        int value) {
    using namespace grit::mgis;
    if (is(name, "water_itself")) {
        if (value == 0 || value == 1) {
            water_itself = value;
            return 1;
        }
        std::fprintf(stderr, "GritSand: water_itself must be 0 or 1, got %d\n", value);
        return 0;
    }
    if (!is(name, "evaluation_limit"))
        return refuse_name(name, "integer", "evaluation_limit and water_itself");
    if (value >= GRIT_SAND_LEAST_EVALUATION_LIMIT && value <= GRIT_SAND_LARGEST_EVALUATION_LIMIT) {
        evaluation_limit = value;
        return 1;
    }
    std::fprintf(stderr, "GritSand: evaluation_limit must be in [%d, %d], got %d\n",
                 GRIT_SAND_LEAST_EVALUATION_LIMIT, GRIT_SAND_LARGEST_EVALUATION_LIMIT, value);
    return 0;
}
}
