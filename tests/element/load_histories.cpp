// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "support/runs.hpp"

namespace {

using namespace tests;
using namespace element;

constexpr double pi = std::numbers::pi;

TEST(CirculatingLoad, FollowsTheSineWithPhaseAndDriftAndComesBack) {
    Circulating kind;
    kind.rows = mixed_control({Control::stress, Control::stress, Control::stress, Control::strain,
                               Control::strain, Control::strain});
    kind.amplitude << 20.0, 0.0, 10.0, 1e-4, 0.0, 0.0;
    kind.phase << 0.0, 0.0, pi / 2.0, pi, 0.0, 0.0;
    kind.drift << 0.0, -5.0, 0.0, 0.0, 0.0, 0.0;
    const Finished out = run_sand({step_of(kind, 64)});
    for (std::size_t i = 0; i <= 64; ++i) {
        const Record& r = out.history.records[i];
        const double x = static_cast<double>(i) / 64.0, angle = 2.0 * pi * x;
        EXPECT_NEAR(r.stress[0], -100.0 + 20.0 * std::sin(angle), 1e-6);
        EXPECT_NEAR(r.stress[1], -100.0 - 5.0 * x, 1e-6);
        EXPECT_NEAR(r.stress[2], -100.0 + 10.0 * (std::cos(angle) - 1.0), 1e-6);
        EXPECT_NEAR(r.strain[3], -1e-4 * std::sin(angle), 1e-12);
    }
}

TEST(CirculatingLoad, TakesTheRateAtMidpointWhereIncrementalDriverIsToBeMatched) {
    Circulating kind;
    kind.rows = mixed_control({});
    kind.amplitude[0] = 1e-3;
    kind.rate_at_midpoint = true;
    constexpr int n = 20;
    const Finished out = run_elastic({step_of(kind, n)});
    double strain = 0.0;
    for (int i = 0; i < n; ++i) {
        strain += 1e-3 * 2.0 * pi / n * std::cos(2.0 * pi * (i + 0.5) / n);
        EXPECT_NEAR(out.history.records[static_cast<std::size_t>(i) + 1].strain[0], strain, 1e-15);
    }
}

TEST(ImportedHistory, TakesItsColumnsTimesTheirFactors) {
    Imported kind;
    kind.rows = mixed_control({Control::strain, Control::stress, Control::stress, Control::strain,
                               Control::strain, Control::strain});
    kind.table = {{10.0, 5.0, 100.0}, {12.0, 5.1, 101.0}, {13.0, 4.9, 105.0}};
    kind.columns[0] = {1, 0.01};
    kind.columns[1] = {2, -2.0};
    kind.time = {0, 60.0};
    const Finished out = run_elastic({step_of(kind, 999)});
    ASSERT_EQ(out.history.records.size(), 3u);
    EXPECT_NEAR(out.history.records[1].strain[0], 0.001, 1e-15);
    EXPECT_NEAR(out.history.records[1].stress[1], -2.0, 1e-9);
    EXPECT_NEAR(out.history.records[1].time, 120.0, 1e-12);
    EXPECT_NEAR(out.sample.strain[0], -0.001, 1e-15);
    EXPECT_NEAR(out.sample.point.stress[1], -10.0, 1e-9);
    EXPECT_NEAR(out.sample.time, 180.0, 1e-12);
}

TEST(Perturbations, ProbeEveryDirectionFromOneStateAndLeaveIt) {
    Perturbations kind;
    kind.rows = mixed_control({Control::stress, Control::stress, Control::stress, Control::stress,
                               Control::stress, Control::stress},
                              Variables::roscoe_isomorph);
    kind.first[0] = kind.second[1] = 0.1;  // a circle of 0.1 kPa in the P-Q plane
    const Finished out = run_sand({triaxial_drained(-0.002), step_of(kind, 36)});
    const Record& origin = out.history.records[100];
    for (std::size_t i = 0; i < 36; ++i) {
        const Record& probe = out.history.records[101 + i];
        EXPECT_NEAR((probe.stress - origin.stress).norm(), 0.1, 1e-6);
        EXPECT_GT((probe.strain - origin.strain).norm(), 0.0);
    }
    EXPECT_EQ(out.sample.point.stress, origin.stress);
    EXPECT_EQ(out.sample.strain, origin.strain);
    EXPECT_EQ(out.sample.point.state, origin.state);
}

TEST(RandomWalk, IsTheSameForOneSeedAndStaysWithinItsSteps) {
    RandomWalk kind;
    kind.rows = mixed_control({});
    kind.amplitude << 1e-4, 1e-4, 1e-4, 2e-4, 0.0, 0.0;
    kind.seed = 7;
    const Finished a = run_sand({step_of(kind, 200)}), b = run_sand({step_of(kind, 200)});
    EXPECT_EQ(a.sample.point.stress, b.sample.point.stress);
    kind.seed = 8;
    EXPECT_NE(run_sand({step_of(kind, 200)}).sample.strain, a.sample.strain);
    double largest = 0.0;
    for (std::size_t i = 1; i < a.history.records.size(); ++i) {
        const Vector6 d = a.history.records[i].strain - a.history.records[i - 1].strain;
        largest = std::max(largest, std::abs(d[0]));
        EXPECT_LE(std::abs(d[3]), 2e-4);
        EXPECT_EQ(d[4], 0.0);
    }
    EXPECT_LE(largest, 1e-4);
    EXPECT_GT(largest, 0.9e-4);
}

}  // namespace
