// SPDX-License-Identifier: BSD-3-Clause
// Whole paths at the default tolerance: docs/adr/0009. verification/paths/path_errors runs more of them.
#include "paths/strain_path.hpp"

#include <gtest/gtest.h>

namespace {

constexpr double wanted = 2e-4;  // error of the stress over the largest on the way

void expect_accurate(const paths::StrainPath& path, const paths::Course& exact) {
    EXPECT_LE(paths::error(path, paths::run(path, GRIT_SAND_DEFAULT_TOLERANCE), exact), wanted)
        << path.sand_name << (path.intergranular_off ? ", h off, " : ", ") << path.kind << ", "
        << path.increments.size() << " calls";
}

void expect_accurate(const std::vector<paths::StrainPath>& list) {
    for (const paths::StrainPath& path : list)
        expect_accurate(path, paths::run(path, paths::exact_tolerance));
}

TEST(Paths, OfReferenceCurvesInTheirRowsAreExactToTwoTenThousandths) {
    const auto list = paths::reference_paths(GRIT_DATA "/reference", 0);
    EXPECT_GE(list.size(), 30u);
    expect_accurate(list);
}

TEST(Paths, OfReferenceCurvesInFewAndManyCallsAreExactToTwoTenThousandths) {
    for (const int calls : {30, 67, 100, 300, 1000})
        expect_accurate(paths::reference_paths(GRIT_DATA "/reference", calls));
}

// Dense and loose sand start between the limits of their void ratio.
TEST(Paths, OfLaboratoryTestsStartDenserThanCritical) {
    for (const paths::StrainPath& path : paths::laboratory_paths(30)) {
        double limits[3];  // e_i, e_c, e_d
        ASSERT_EQ(grit_sand_void_ratios(&path.sand, -path.stress[0], limits), GRIT_OK);
        EXPECT_GT(path.state[GRIT_SAND_VOID_RATIO], limits[2]) << path.sand_name;
        EXPECT_LT(path.state[GRIT_SAND_VOID_RATIO], limits[1]) << path.sand_name;
    }
}

TEST(Paths, OfReferenceCurvesComeToTheSameStrainInAnyNumberOfCalls) {
    const auto rows = paths::reference_paths(GRIT_DATA "/reference", 0);
    for (const int calls : {30, 1000}) {
        const auto list = paths::reference_paths(GRIT_DATA "/reference", calls);
        ASSERT_EQ(list.size(), rows.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            EXPECT_EQ(list[i].increments.size(), static_cast<std::size_t>(calls));
            for (std::size_t c = 0; c < 6; ++c) {
                double whole = 0.0, same = 0.0;
                for (const auto& d : rows[i].increments) whole += d[c];
                for (const auto& d : list[i].increments) same += d[c];
                EXPECT_NEAR(same, whole, 1e-12) << list[i].kind;
            }
        }
    }
}

TEST(Paths, OfLaboratoryTestsOfEverySandAreExactToTwoTenThousandths) {
    for (const int calls : {30, 67, 100, 300, 1000})
        expect_accurate(paths::laboratory_paths(calls));
}

// Any void ratio, pressure, memory and size: a tenth of those of path_errors.
TEST(Paths, ThatAreDrawnAreExactToTwoTenThousandths) {
    int compared = 0;
    for (const paths::StrainPath& path : paths::random_paths(300, 1)) {
        const paths::Course exact = paths::run(path, paths::exact_tolerance);
        if (paths::opens(exact)) continue;
        expect_accurate(path, exact);
        ++compared;
    }
    EXPECT_GE(compared, 250);
}

}  // namespace
