// SPDX-License-Identifier: BSD-3-Clause
// GRIT_SAND_VOID_CLAMPED: set exactly where e ends outside [e_d, e_i] at the pressure of the end.
#include "support/batch.hpp"
#include "support/sands.hpp"
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

void expect_flag(const Sand& sand, const Point& end, const Outcome& out) {
    ASSERT_EQ(out.status, GRIT_OK) << out.error.message;
    const State x = state_of(end);
    const VoidRatios limits = void_ratios(sand, -x.T.head<3>().sum() / 3.0);
    if (std::fabs(x.e / limits.e_d - 1.0) < 1e-12 || std::fabs(x.e / limits.e_i - 1.0) < 1e-12)
        return;
    EXPECT_EQ((out.report.flags & GRIT_SAND_VOID_CLAMPED) != 0,
              x.e < limits.e_d || x.e > limits.e_i)
        << "e = " << x.e << " of [" << limits.e_d << ", " << limits.e_i << "]";
}

// From states beside the limits, nearer and farther than the pressure moves them.
TEST(VoidLimits, AreReportedExactlyWhereVoidRatiosEndOutsideThem) {
    const Sand sand = sand_named("lausitz");
    Random random(11);
    int clamped = 0, within = 0;
    for (const double size : {1e-7, 1e-5, 1e-3, 1e-2})
        for (const double off : {1e-9, 1e-6, 1e-4, 3e-3, 0.01, 0.018, 0.02, 0.022, 0.05})
            for (const int sign : {-1, 1})
                for (int i = 0; i < 20; ++i) {
                    State x = random_state(sand, random);
                    const VoidRatios limits = void_ratios(sand, -x.T.head<3>().sum() / 3.0);
                    x.e = (i % 2 ? limits.e_d : limits.e_i) * (1.0 + sign * off);
                    Point point = point_of(x);
                    const Outcome out =
                        update(sand, point, voigt_strain(size * random.direction()).data());
                    expect_flag(sand, point, out);
                    ++(out.report.flags & GRIT_SAND_VOID_CLAMPED ? clamped : within);
                }
    EXPECT_GT(clamped, 500);
    EXPECT_GT(within, 500);
}

// Neighbours in a pack differ: some are taken without a logarithm, some with, some by steps.
TEST(VoidLimits, AreReportedForManyPointsAsForEach) {
    const Sand sand = sand_named("lausitz");
    Random random(13);
    Batch batch = random_batch(sand, 203, 12);
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const State x = state_of(batch.points[i]);
        const VoidRatios limits = void_ratios(sand, -x.T.head<3>().sum() / 3.0);
        batch.points[i].state[GRIT_SAND_VOID_RATIO] =
            (i % 3 ? limits.e_d : limits.e_i) * (1.0 + random.uniform(-0.05, 0.05));
    }
    const Batch start = batch;
    ASSERT_EQ(batch.update(sand, options_with()), GRIT_OK) << batch.error.message;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        Point point = start.points[i];
        const Outcome out = update(sand, point, start.strain[i].data());
        EXPECT_EQ(batch.reports[i].flags, out.report.flags) << i;
        expect_flag(sand, point, out);
    }
}

}  // namespace
