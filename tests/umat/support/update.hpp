// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_update on one point.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "support/operators.hpp"

namespace tests {

struct Point {
    double stress[6];
    double state[GRIT_SAND_STATE_SIZE];
};

inline Point point_of(const State& x) {
    Point point;
    const auto stress = voigt_stress(x.T);
    const auto state = state_array(x);
    std::copy(stress.begin(), stress.end(), point.stress);
    std::copy(state.begin(), state.end(), point.state);
    return point;
}
inline State state_of(const Point& x) {
    return {stress_from(x.stress), strain_from(x.state), x.state[GRIT_SAND_VOID_RATIO]};
}
inline bool same_bits(const Point& a, const Point& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Defaults, but for the instruction set: GRIT_TEST_INSTRUCTION_SET lets the suite run with another.
inline grit_sand_options options_with(double tolerance = 1e-5, int tangent = GRIT_TANGENT_NONE) {
    grit_sand_options o;
    grit_sand_options_init(&o, sizeof o);
    o.tolerance = tolerance;
    o.tangent = tangent;
    if (const char* forced = std::getenv("GRIT_TEST_INSTRUCTION_SET"))
        o.instruction_set = std::atoi(forced);
    return o;
}

struct Outcome {
    grit_status status;
    grit_sand_report report;
    grit_error error;
    double tangent[36];  // row-major Voigt
};

inline Outcome update(const Sand& sand, Point& point, const double strain[6],
                      const grit_sand_options& options = options_with()) {
    Outcome out{};
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(strain, 6, 1);
    q.stress = grit_mutable_view_of(point.stress, 6, 1);
    q.state = grit_mutable_view_of(point.state, GRIT_SAND_STATE_SIZE, 1);
    q.tangent = grit_mutable_matrix_view_of(out.tangent, 36, 6, 1);
    out.status = grit_sand_update(sand, &options, 1, &q, &out.report, &out.error);
    return out;
}

// The state after the strain increment dE; a failure fails the test.
inline State updated(const Sand& sand, const State& x, const Vec& dE,
                     const grit_sand_options& options = options_with()) {
    Point point = point_of(x);
    const Outcome out = update(sand, point, voigt_strain(dE).data(), options);
    EXPECT_EQ(out.status, GRIT_OK) << out.error.message;
    return state_of(point);
}

}  // namespace tests
