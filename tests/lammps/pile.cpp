// SPDX-License-Identifier: BSD-3-Clause
// A pile in sand, its self-weight and two blows, in both hosts.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "support/both_hosts.hpp"

namespace {

std::string case_text() {
    std::ostringstream out;
    out << std::ifstream(PILE_BLOWS).rdbuf();
    return out.str();
}

std::string with_double_sums() {
    return replaced(case_text(), "fixed_point = true", "fixed_point = false");
}

constexpr long all = 1000000;

const Told& reference() {
    static const Told told = BothHosts(case_text()).in_driver(all);
    return told;
}

TEST(LammpsPile, HasTheBitsOfTheDriverOnOneProcess) {
    ASSERT_GT(reference().rows.size(), 500u);
    EXPECT_EQ(first_difference(reference(), BothHosts(case_text()).in_lammps(1, 1)), "");
}

TEST(LammpsPile, HasTheBitsOfTheDriverOnTwoProcesses) {
    EXPECT_EQ(first_difference(reference(), BothHosts(case_text()).in_lammps(2, 1)), "");
}

TEST(LammpsPile, HasTheBitsOfTheDriverOnFourProcesses) {
    EXPECT_EQ(first_difference(reference(), BothHosts(case_text()).in_lammps(2, 2)), "");
}

TEST(LammpsPile, WithContactAtSurfacesHasTheBitsOfTheDriverToo) {
    const BothHosts hosts(replaced(case_text(), "law = \"geo\"", "law = \"surface\""));
    const Told driver = hosts.in_driver(all);
    ASSERT_GT(driver.rows.size(), 500u);
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 1)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 1)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 2)), "");
}

TEST(LammpsPile, WithAStiffnessOfSurfacesHasTheBitsOfTheDriverToo) {
    const BothHosts hosts(replaced(case_text(), "law = \"geo\"",
                                   "law = \"surface\"\ncontact_stiffness_multiple = 10\n"
                                   "modulus_kPa = 5e4\nrelaxation_time_s = 1e-3"));
    const Told driver = hosts.in_driver(all);
    ASSERT_GT(driver.rows.size(), 500u);
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 2)), "");
}

TEST(LammpsPile, GoesOnOnFourProcessesFromTheRestartFileOfTwo) {
    const BothHosts hosts(case_text());
    const Told before = hosts.in_lammps(2, 1, "restart 500 blows\n" + hosts.script());
    const Told after = hosts.in_lammps(2, 2, hosts.go_on("blows.500"));
    EXPECT_EQ(first_difference(reference(), before), "");
    Told rest = reference();
    ASSERT_GT(rest.rows.size(), 501u);
    // The first row is that of no step: its forces are means since the row before.
    ASSERT_FALSE(after.rows.empty());
    EXPECT_EQ(after.rows[0][2], rest.rows[500][2]);
    rest.rows.erase(rest.rows.begin(), rest.rows.begin() + 501);
    Told steps = after;
    steps.rows.erase(steps.rows.begin());
    EXPECT_EQ(first_difference(rest, steps), "");
}

// Sums in another order are other sums, by roundoff that grows with the steps.
TEST(LammpsPile, FollowsTheDriverWithDoubleSums) {
    const BothHosts hosts(with_double_sums());
    const Told driver = hosts.in_driver(all), lammps = hosts.in_lammps(2, 2);
    ASSERT_GT(driver.rows.size(), 101u);
    ASSERT_GT(lammps.rows.size(), 101u);
    std::vector<double> size(driver.rows[0].size(), 0.0);
    for (std::size_t i = 0; i <= 100; ++i)
        for (std::size_t c = 0; c < size.size(); ++c)
            if (std::isfinite(driver.rows[i][c]))
                size[c] = std::max(size[c], std::abs(driver.rows[i][c]));
    bool any = false;
    for (std::size_t i = 0; i <= 100; ++i)
        for (std::size_t c = 0; c < size.size(); ++c) {
            if (std::isnan(driver.rows[i][c]) && std::isnan(lammps.rows[i][c])) continue;
            EXPECT_NEAR(lammps.rows[i][c], driver.rows[i][c], 1e-9 * size[c])
                << "row " << i << ", column " << c + 1;
            any = any || lammps.rows[i][c] != driver.rows[i][c];
        }
    EXPECT_TRUE(any) << "four processes have the bits of one: were there four?";
    constexpr std::size_t depth = 4;
    const double wanted = driver.rows.back()[depth];
    EXPECT_GT(wanted, 0.01);
    EXPECT_NEAR(lammps.rows.back()[depth], wanted, 0.01 * wanted);
}

}  // namespace
