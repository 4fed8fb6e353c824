// SPDX-License-Identifier: BSD-3-Clause
// The matrix of hosts and cases: every library runs every case as the C ABI does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/workplace.hpp"

namespace {

struct Host {
    const char* name;
    const char* options;
    double apart;  // of the largest value of a column
};

void PrintTo(const Host& host, std::ostream* out) { *out << host.name; }

class CliThroughALibrary : public testing::TestWithParam<Host> {};

// Every row of what a test measures, relative to the largest value of its column.
TEST_P(CliThroughALibrary, ComputesTheSame) {
    for (const std::string name : {"umat_oedometer", "umat_triaxial", "umat_undrained",
                                   "umat_cyclic", "umat_water", "umat_cavitation"}) {
        const Workplace here;
        const std::string run =
            "element --no-plot --quiet " GRIT_CASES "/" + name + ".toml --out out";
        ASSERT_EQ(here.grit(run).status, 0);
        const auto own = here.result(name);
        const Answer answer = here.grit(run + GetParam().options);
        ASSERT_EQ(answer.status, 0) << answer.text;
        const auto through = here.result(name);
        for (const char* column : {"stress_11", "stress_22", "stress_12", "strain_11", "strain_22",
                                   "p", "q", "void_ratio", "pore_pressure", "h_11"}) {
            const Values &a = own.at(column), &b = through.at(column);
            ASSERT_EQ(a.size(), b.size());
            ASSERT_GT(a.size(), 10U);
            double largest = 0.0, apart = 0.0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                ASSERT_TRUE(std::isfinite(a[i]) && std::isfinite(b[i])) << name << ", " << column;
                largest = std::max(largest, std::abs(a[i]));
                apart = std::max(apart, std::abs(a[i] - b[i]));
            }
            EXPECT_LE(apart, GetParam().apart * largest) << name << ", " << column;
        }
    }
}

// The VUMAT has no tangent: Newton's method ends elsewhere by 1e-9, and a step may be accepted there that is not
// here: 1e-5 in these cases, and never more than about the tolerance.
INSTANTIATE_TEST_SUITE_P(
    OfAHost, CliThroughALibrary,
    testing::Values(Host{"ClassicUmat", " --umat " GRIT_UMAT, 1e-8},
                    Host{"RadianUmat", " --layout radian --umat " GRIT_UMATR, 1e-8},
                    Host{"AbaqusStandard", " --layout classic --umat " GRIT_STANDARD, 1e-8},
                    Host{"AbaqusExplicit", " --umat " GRIT_EXPLICIT, 3e-4},
                    Host{"AbaqusExplicitRadian", " --layout radian --umat " GRIT_EXPLICITR, 3e-4}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(CliLayout, NeedsALibraryAndANameThatItKnows) {
    const Workplace here;
    const std::string run = "element --no-plot " GRIT_CASES "/umat_oedometer.toml --layout ";
    EXPECT_TRUE(here.grit(run + "radian").says("--umat"));
    EXPECT_TRUE(here.grit(run + "degrees --umat " GRIT_UMAT)
                    .says("--layout: there is no \"degrees\"; known here: classic, radian"));
}

// Rather than to run with another number.
TEST(CliThroughAnyLibrary, RefusesWhatItsPropsHaveNoPlaceFor) {
    const Workplace here;
    const std::string run =
        "element --no-plot " GRIT_CASES "/umat_cavitation.toml --umat " GRIT_UMAT " --set ";
    const Answer tension = here.grit(run + "sand.cavitation_kPa=0");
    EXPECT_NE(tension.status, 0);
    EXPECT_TRUE(tension.says("cavitation_kPa = 0 has no place in the PROPS")) << tension.text;
    const Answer limit = here.grit(run + "numerics.evaluation_limit=500");
    EXPECT_NE(limit.status, 0);
    EXPECT_TRUE(limit.says("evaluation_limit = 500 has no place in the PROPS")) << limit.text;
}

// Radians are out of range for the classic layout, and its degrees for the other: no numbers come out.
TEST(CliLayout, OfTheWrongLibraryGivesNoResult) {
    const Workplace here;
    const std::string run = "element --no-plot " GRIT_CASES "/umat_oedometer.toml --umat ";
    const Answer classic = here.grit(run + GRIT_UMATR);
    EXPECT_NE(classic.status, 0);
    EXPECT_TRUE(classic.says("got 33: degrees?")) << classic.text;
    const Answer radian = here.grit(run + GRIT_UMAT " --layout radian");
    EXPECT_NE(radian.status, 0);
    EXPECT_TRUE(radian.says("radians?")) << radian.text;
}

}  // namespace
