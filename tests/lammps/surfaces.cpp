// SPDX-License-Identifier: BSD-3-Clause
// A block thrown on the ground, with friction at the surfaces of both, where four sub-domains meet.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/block.hpp"
#include "support/both_hosts.hpp"
#include "support/ground.hpp"

namespace {

class LammpsSurfaces : public ::testing::Test {
  protected:
    // material: of the ground, up to 15.5 m. block: from r, to r.
    static std::string case_with(const std::string& material,
                                 const std::string& block = "9.5, 13") {
        std::string text =
            block_case("2.5, -2", "0.5", ground("r_m = [5.25, 15.5]\nz_m = [8, 12]", material));
        text =
            replaced(text, "r_m = [2, 6]\nz_m = [3, 6]", "r_m = [" + block + "]\nz_m = [12, 15]");
        text = replaced(text, "fixed_point = true", "fixed_point = true\ncfl = 0.1");
        return replaced(text, "kPa = 20", "kPa = 200");
    }
    static std::string on_soft_ground() { return case_with(soft_ground); }
    // All around the ground.
    static std::string on_a_line() {
        return replaced(on_soft_ground(), "law = \"surface\"",
                        "law = \"surface\"\nstiff_line = {r_m = [15.5, 15.5, 5.25, 5.25, 15.5], "
                        "z_m = [8, 12, 12, 8, 8]}");
    }
    // Of the history.
    static constexpr std::size_t tip_force = 6, contact_loss = 16;
};

TEST_F(LammpsSurfaces, HaveTheBitsOfTheDriverHoweverTheGridIsCut) {
    const BothHosts hosts(on_soft_ground());
    const Told driver = hosts.in_driver(1000000);
    ASSERT_GT(driver.rows.size(), 50u);
    EXPECT_GT(driver.rows.back()[contact_loss], 0.0);
    EXPECT_GT(driver.rows.back()[tip_force], 0.0);  // still pressed
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 1)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 1)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 2)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 2)), "");
}

// The last one of three, from 16 m on.
TEST_F(LammpsSurfaces, HaveTheBitsOfTheDriverWhereAProcessHasNoParticle) {
    const BothHosts hosts(on_soft_ground());
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), hosts.in_lammps(3, 1)), "");
}

// The first process has nodes up to 15 m and counts them; that they are near, the second one alone knows.
TEST_F(LammpsSurfaces, HaveTheBitsOfTheDriverWhereTheyBeginBeyondTheNodesOfAProcess) {
    const BothHosts hosts(
        replaced(case_with(soft_ground, "16.25, 19.5"), "[5.25, 15.5]", "[5.25, 20]"));
    const Told driver = hosts.in_driver(1000000);
    EXPECT_GT(driver.rows.back()[contact_loss], 0.0);
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 1)), "");
}

TEST_F(LammpsSurfaces, OfARigidBodyHaveTheBitsOfTheDriver) {
    const BothHosts hosts(case_with("[body.rigid]\nvelocity_r_m_per_s = [-0.5]\n"
                                    "velocity_z_m_per_s = [0.5]"));
    const Told driver = hosts.in_driver(1000000);
    EXPECT_GT(driver.rows.back()[contact_loss], 0.0);
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 2)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 2)), "");
}

// The cut goes from 12 m to where the block's corner is; forces are means since the last row.
TEST_F(LammpsSurfaces, GoOnWhereTheGridIsCutAnew) {
    const BothHosts hosts(on_soft_ground());
    const std::string script = replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                                        "run 17\nbalance 1.0 x 0.4\nrun ${most_steps}");
    EXPECT_EQ(first_difference(hosts.in_driver(1000000), hosts.in_lammps(2, 2, script)), "");
}

TEST_F(LammpsSurfaces, ThatRideOnParticlesOfAllProcessesHaveTheBitsOfTheDriver) {
    const BothHosts hosts(on_a_line());
    const Told driver = hosts.in_driver(1000000);
    EXPECT_GT(driver.rows.back()[contact_loss], 0.0);
    EXPECT_NE(first_difference(driver, BothHosts(on_soft_ground()).in_driver(1000000)), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(1, 1)), "");
    const std::string script = replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                                        "run 17\nbalance 1.0 x 0.4\nrun ${most_steps}");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps(2, 2, script)), "");
    const Told before = hosts.in_lammps(2, 1, "restart 30 line\n" + hosts.script());
    EXPECT_EQ(first_difference(driver, before), "");
    const Told after = hosts.in_lammps(2, 2, hosts.go_on("line.30"));
    ASSERT_FALSE(after.rows.empty());
    EXPECT_EQ(first_difference({{driver.rows.back()}, driver.points},
                               {{after.rows.back()}, after.points}),
              "");
}

TEST_F(LammpsSurfaces, GoOnFromARestartFileOnMoreProcesses) {
    const BothHosts hosts(on_soft_ground());
    const Told before = hosts.in_lammps(2, 1, "restart 30 surfaces\n" + hosts.script());
    const Told after = hosts.in_lammps(2, 2, hosts.go_on("surfaces.30"));
    ASSERT_FALSE(after.rows.empty());
    EXPECT_EQ(first_difference({{before.rows.back()}, before.points},
                               {{after.rows.back()}, after.points}),
              "");
}

}  // namespace
