// SPDX-License-Identifier: BSD-3-Clause
// The 320 states x 5 increments of speed_states.csv, integrated to 1e-13 by another program.
#include <map>

#include "../larger.hpp"
#include "support/tables/csv.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

struct Call {
    Point start, end;
    double strain[6];
};

std::map<double, std::vector<Call>> read_calls() {
    std::map<double, std::vector<Call>> calls;
    for (const auto& row : grit::csv::read_numbers(GRIT_DATA "/speed_states.csv").rows) {
        Call c{};
        const double* v = row.data() + 1;
        std::copy(v, v + 6, c.start.stress);
        std::copy(v + 6, v + 13, c.start.state);
        std::copy(v + 13, v + 19, c.strain);
        std::copy(v + 19, v + 25, c.end.stress);
        std::copy(v + 25, v + 32, c.end.state);
        calls[row[0]].push_back(c);
    }
    return calls;
}

TEST(SingleCalls, DeliverTheErrorAskedForAtEveryIncrementAndTolerance) {
    const Sand sand = sand_named("lausitz");
    const auto calls = read_calls();
    ASSERT_EQ(calls.size(), 5u);
    for (const auto& [increment, list] : calls) {
        ASSERT_EQ(list.size(), 320u);
        for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
            int within = 0;
            double worst = 0.0;
            for (const Call& c : list) {
                const Vec exact = stress_from(c.end.stress);
                const State x = updated(sand, state_of(c.start), strain_from(c.strain),
                                        options_with(tolerance));
                const double error = (x.T - exact).norm() / exact.norm() / tolerance;
                within += error <= 1.0;
                worst = larger(worst, error);
                const double error_h = (x.h - strain_from(c.end.state)).norm() / 1e-4;
                EXPECT_LE(error_h, std::fmax(100.0 * tolerance, 1e-7));
                EXPECT_NEAR(x.e, c.end.state[GRIT_SAND_VOID_RATIO], 1e-12);
            }
            EXPECT_GE(within, 317) << increment << " at " << tolerance;  // 99 % of 320
            EXPECT_LE(worst, 10.0) << increment << " at " << tolerance;
        }
    }
}

}  // namespace
