// SPDX-License-Identifier: BSD-3-Clause
// Grit's own law behind PROPS and STATEV against the UMAT.
#include <gtest/gtest.h>

#include "support/compare.hpp"

namespace {

const std::filesystem::path umat = GRIT_UMAT_LIBRARY;

Table result_of(const Folder& folder, const std::filesystem::path& law = {}) {
    return of_files(folder.path(), "result.out", 1, law);
}

TEST(IncrementalDriverClassicLayout, IsThatOfTheUmatForPoreWaterRotationAndInitialVoidRatio) {
    const Folder folder;
    Folder::fill(folder);
    std::string parameters = lausitz_parameters();
    parameters.replace(parameters.find("0.0\n10.7"), 8, "2e6\n0.72");  // K_w, e_0
    folder.write("parameters.inp", parameters);
    folder.write("initialconditions.inp",
                 "6\n-110\n-130\n-120\n5\n0\n0\n14\n0\n0\n0\n0\n0\n0\n0\n-20\n");
    folder.write("test.inp", "result.out\n*TriaxialE1\n30 10 1\n-0.004\n*DeformationGradient\n"
                             "20 5 1\n1.001\n0.999\n1\n0.1\n-0.09\n0.02\n0\n0\n0.03\n");
    // STRESS = T - p_w I with p_w of 1e4 kPa: T comes back with the roundoff of that, and the steps of
    // the integration amplify it.
    constexpr double pore_water_roundoff = 1e-7;
    const Table rows = result_of(folder);
    EXPECT_LT(difference(rows, result_of(folder, umat)), pore_water_roundoff);
    EXPECT_LT(rows[30][20], 0.72);  // e, compressed by the pressure
    EXPECT_NE(rows[30][21], -20.0);
}

// PROPS(17), PROPS(18), PROPS(19): tolerance, largest tension, and K_w is that of the water itself.
TEST(IncrementalDriverClassicLayout, IsThatOfTheUmatForWaterThatCavitates) {
    const Folder folder;
    Folder::fill(folder);
    std::string parameters = lausitz_parameters();
    parameters.replace(parameters.find("0.0\n10.7"), 8, "2.2e6\n10.55\n0\n50\n1");
    parameters.replace(parameters.find("16"), 2, "19");
    folder.write("parameters.inp", parameters);
    folder.write("initialconditions.inp", isotropic(100.0, 0.55));
    folder.write("test.inp", "result.out\n*TriaxialE1\n200 10 1\n-0.2\n");
    const Table rows = result_of(folder);
    EXPECT_LT(difference(rows, result_of(folder, umat)), 1e-6);
    EXPECT_GT(rows.back()[21], 1000.0);  // -p_w of the cavity
}

TEST(IncrementalDriverClassicLayout, SwitchesTheIntergranularStrainOffAsTheUmatDoes) {
    const Folder folder;
    Folder::fill(folder);
    std::string parameters = lausitz_parameters();
    parameters.replace(parameters.find("5.0\n2.0\n1e-4"), 12, "0.0\n0.0\n0.0");  // m_R, m_T, R
    folder.write("parameters.inp", parameters);
    const Table rows = result_of(folder);
    EXPECT_LT(difference(rows, result_of(folder, umat)), same);
    EXPECT_LT(rows.back()[8], -100.0);
    EXPECT_EQ(rows.back()[14], 0.0);
}

}  // namespace
