// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/workplace.hpp"

namespace {

// Every row of what a test measures, relative to the largest value of its column.
TEST(Cli, ComputesTheSameThroughAUmat) {
    for (const std::string name : {"umat_oedometer", "umat_triaxial", "umat_undrained"}) {
        const Workplace here;
        const std::string run =
            "element --no-plot --quiet " GRIT_CASES "/" + name + ".toml --out out";
        ASSERT_EQ(here.grit(run).status, 0);
        const auto own = here.result(name);
        ASSERT_EQ(here.grit(run + " --umat " GRIT_UMAT).status, 0);
        const auto through = here.result(name);
        for (const char* column : {"stress_11", "stress_22", "strain_11", "strain_22", "p", "q",
                                   "void_ratio", "pore_pressure", "h_11"}) {
            const Values &a = own.at(column), &b = through.at(column);
            ASSERT_EQ(a.size(), b.size());
            double largest = 0.0, apart = 0.0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                largest = std::max(largest, std::abs(a[i]));
                apart = std::max(apart, std::abs(a[i] - b[i]));
            }
            EXPECT_LE(apart, 1e-8 * largest) << name << ", " << column;
        }
    }
}

}  // namespace
