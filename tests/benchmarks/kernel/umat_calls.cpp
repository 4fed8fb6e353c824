// SPDX-License-Identifier: BSD-3-Clause
// The comparison of UMATs: whatever the layout, the same sand; and what counts as failed.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "benchmarks/sand_points.hpp"
#include "benchmarks/umat_calls.hpp"

namespace {

using namespace benchmarks;

const std::vector<Call>& some_calls() { return calls_of(1e-3); }

UmatPoints run(const char* library, const char* file, bool tangent) {
    UmatLayout layout = read_umat_layout(std::string(GRIT_LAYOUTS) + file);
    UmatPoints points(some_calls(), layout);
    run_umat(open_umat(library), layout, tangent, points);
    for (const Outcome& o : outcomes_of(some_calls(), layout, points)) {
        EXPECT_FALSE(o.failed);
        EXPECT_LT(o.error, SandRequest{1e-3}.options().tolerance);
        EXPECT_GT(o.evaluations, 1.0);
    }
    return points;
}

SandPoints through_c_abi() {
    SandPoints points = SandPoints::structures(some_calls(), some_calls().size());
    update(lausitz(), SandRequest{1e-3}.options(), points, 0, points.size(), 1);
    return points;
}

TEST(ComparedUmat, OfTheClassicLayoutHasTheStressOfTheCAbi) {
    const SandPoints expected = through_c_abi();
    for (const bool tangent : {false, true}) {
        const UmatPoints points = run(GRIT_UMAT_CLASSIC, "/classic.toml", tangent);
        for (std::size_t i = 0; i < points.stress.size(); ++i)
            EXPECT_NEAR(points.stress[i], expected.stress[i], 1e-9) << i;
        EXPECT_EQ(std::count(points.ddsdde.begin(), points.ddsdde.end(), 0.0) == 0, tangent);
    }
}

TEST(ComparedUmat, OfTheSecondLayoutHasTheStressOfTheFirst) {
    const UmatPoints first = run(GRIT_UMAT_CLASSIC, "/classic.toml", false);
    const UmatPoints second = run(GRIT_UMAT_RADIAN, "/radian.toml", false);
    for (std::size_t i = 0; i < first.stress.size(); ++i)
        EXPECT_NEAR(second.stress[i], first.stress[i], 1e-9) << i;
}

TEST(ComparedUmat, HasFailedWhereStressIsOldOrNotFiniteOrASmallerIncrementIsWanted) {
    const std::vector<Call> calls(some_calls().begin(), some_calls().begin() + 4);
    const UmatLayout layout = read_umat_layout(std::string(GRIT_LAYOUTS) + "/classic.toml");
    UmatPoints points(calls, layout);
    points.stress[6 * 1] = std::numeric_limits<double>::quiet_NaN();
    std::copy(calls[2].stress_end, calls[2].stress_end + 6, &points.stress[6 * 2]);
    points.pnewdt[2] = 0.5;
    std::copy(calls[3].stress_end, calls[3].stress_end + 6, &points.stress[6 * 3]);
    const std::vector<Outcome> outcomes = outcomes_of(calls, layout, points);
    EXPECT_TRUE(outcomes[0].failed);
    EXPECT_TRUE(outcomes[1].failed);
    EXPECT_TRUE(outcomes[2].failed);
    EXPECT_FALSE(outcomes[3].failed);
    EXPECT_EQ(outcomes[3].error, 0.0);
}

TEST(ComparedUmat, ThatIsNotThereIsNamed) {
    EXPECT_THROW(open_umat("no_such_library.so"), std::runtime_error);
}

}  // namespace
