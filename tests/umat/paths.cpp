// SPDX-License-Identifier: BSD-3-Clause
// Whole paths at the default tolerance: docs/adr/0009. verification/paths/path_errors runs more of them.
#include "paths/strain_path.hpp"

#include <gtest/gtest.h>

namespace {

constexpr double wanted = 2e-4;  // error of the stress over the largest on the way

void expect_accurate(const std::vector<paths::StrainPath>& list) {
    for (const paths::StrainPath& path : list) {
        const paths::Course exact = paths::run(path, paths::exact_tolerance);
        EXPECT_LE(paths::error(path, paths::run(path, GRIT_SAND_DEFAULT_TOLERANCE), exact), wanted)
            << path.sand_name << (path.intergranular_off ? ", h off, " : ", ") << path.kind << ", "
            << path.increments.size() << " calls";
    }
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

TEST(Paths, OfLaboratoryTestsOfEverySandAreExactToTwoTenThousandths) {
    for (const int calls : {30, 67, 100, 300, 1000})
        expect_accurate(paths::laboratory_paths(calls));
}

}  // namespace
