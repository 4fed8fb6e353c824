// SPDX-License-Identifier: BSD-3-Clause
// What the history tells of local damping.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <adapters/mpm/run/run.hpp>

#include "support/plans.hpp"

namespace {

using namespace mpm_test;

TEST(Run, TellsTheForceOfLocalDamping) {
    Case plan = pressed_column_case();
    plan.stages[0] = {.name = "press", .local_damping = 0.3, .end = {.time = 0.3}};
    plan.history.interval = 0.01;
    Runner runner(plan);
    const double mass = 1000.0 * std::numbers::pi * 0.04, weight = 9.81 * mass;
    HistoryRow before = runner.row();
    double largest = 0.0;
    while (!runner.finished()) {
        runner.step();
        if (!runner.row_is_due()) continue;
        const HistoryRow row = runner.row();
        const double inertia = mass * (row.velocity - before.velocity) / (row.t - before.t);
        EXPECT_NEAR(row.damping_force, row.hammer_force + weight - row.base_force - inertia,
                    1e-9 * weight)
            << "t = " << row.t;
        largest = std::max(largest, std::abs(row.damping_force));
        before = row;
    }
    EXPECT_GT(largest, 0.01 * weight);
}

}  // namespace
