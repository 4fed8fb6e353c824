// SPDX-License-Identifier: BSD-3-Clause
// The file that tells where a UMAT has PROPS and STATEV.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "benchmarks/umat_layout.hpp"

namespace {

using namespace benchmarks;

constexpr char least[] = "name = \"x\"\nprops = [33, 1.6e6]\n";

UmatLayout read(const std::string& text) {
    const std::string path = testing::TempDir() +
                             testing::UnitTest::GetInstance()->current_test_info()->name() +
                             ".toml";
    std::ofstream(path) << text;
    UmatLayout out;
    try {
        out = read_umat_layout(path);
    } catch (...) {
        std::remove(path.c_str());
        throw;
    }
    std::remove(path.c_str());
    return out;
}

std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

void expect_refusal(const std::string& keys, const std::string& words) {
    const std::string said = refusal(least + keys);
    EXPECT_NE(said.find(words), std::string::npos) << said;
}

TEST(UmatLayout, CountsPlacesFromOneInTheFileAndFromZeroInside) {
    const UmatLayout x =
        read(std::string(least) + "nstatv = 20\nintergranular_strain = 1\nvoid_ratio = 7\n"
                                  "evaluations = 20\nintergranular_shear = \"tensor\"\n"
                                  "initial_statev = [[8, 2.5]]\n");
    EXPECT_EQ(x.props, (std::vector<double>{33.0, 1.6e6}));
    EXPECT_EQ(x.nstatv, 20);
    EXPECT_EQ(x.intergranular_strain, 0);
    EXPECT_EQ(x.void_ratio, 6);
    EXPECT_EQ(x.evaluations, 19);
    EXPECT_EQ(x.shear, 0.5);
    EXPECT_EQ(x.initial_statev.at(0), std::make_pair(7, 2.5));
    EXPECT_FALSE(x.ddsdde_may_be_null);
}

TEST(UmatLayout, RefusesPlacesThatAreNotInStatev) {
    const std::string size = "nstatv = 14\n";
    expect_refusal(size + "void_ratio = 15\nintergranular_strain = 1\n",
                   "void_ratio must be a place in STATEV, 1 to 14, got 15");
    expect_refusal(size + "void_ratio = 7\nintergranular_strain = 10\n",
                   "intergranular_strain must be a place in STATEV, 1 to 9, got 10");
    expect_refusal(size + "void_ratio = 7\nintergranular_strain = 2\n",
                   "void_ratio must not be one of the six places of intergranular_strain, got 7");
    expect_refusal(size + "void_ratio = 7\nintergranular_strain = 1\ninitial_statev = [[0, 1]]\n",
                   "initial_statev must be a place in STATEV, 1 to 14, got 0");
}

TEST(UmatLayout, RefusesWhatItDoesNotKnowAndWhatIsMissing) {
    const std::string rest = "nstatv = 14\nvoid_ratio = 7\nintergranular_strain = 1\n";
    expect_refusal("nstatv = 6\n", "nstatv must be in [7, 10000]");
    expect_refusal("nstatv = 14\n", "void_ratio is missing");
    expect_refusal(rest + "evaluation = 3\n", "unknown key evaluation");
    expect_refusal(rest + "intergranular_shear = \"half\"\n", "got \"half\"");
    expect_refusal(rest + "ddsdde_may_be_null = 1\n", "must be true or false");
    expect_refusal("nstatv = \"many\"\n", "nstatv must be a whole number");
    EXPECT_NE(
        refusal("name = \"x\"\nprops = [\"a\"]\n" + rest).find("props must have numbers only"),
        std::string::npos);
    EXPECT_NE(refusal("name = \"a/b\"\n" + rest).find("without \"/\""), std::string::npos);
}

}  // namespace
