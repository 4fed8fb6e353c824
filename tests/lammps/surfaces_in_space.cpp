// SPDX-License-Identifier: BSD-3-Clause
// A block thrown on the ground in space, with friction at the surfaces of both, where eight sub-domains meet.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/both_hosts.hpp"
#include "support/box_stl.hpp"
#include "support/brick.hpp"
#include "support/ground.hpp"

namespace {

constexpr long all = 1000000;

class LammpsSpaceSurfaces : public ::testing::Test {
  protected:
    // material: of the ground. block: from x, to x. more: of the contact.
    static std::string case_with(const std::string& material, const std::string& block = "10, 13",
                                 const std::string& more = "") {
        std::string text =
            brick_case("2.5, 1.5, -2", "0.4",
                       ground("x_m = [5, 15.5]\ny_m = [4.5, 14]\nz_m = [6, 9]", material, more));
        text = replaced(text, "x_m = [2, 6]\ny_m = [2, 5]\nz_m = [3, 6]",
                        "x_m = [" + block + "]\ny_m = [7, 10.5]\nz_m = [9, 11]");
        text = replaced(text, "fixed_point = true", "fixed_point = true\ncfl = 0.1");
        return replaced(text, "kPa = 20", "kPa = 200");
    }
    static void expect_contact(const Told& driver) {
        constexpr std::size_t tip_force = 6, contact_loss = 16;
        ASSERT_GT(driver.rows.size(), 30u);
        EXPECT_GT(driver.rows.back()[contact_loss], 0.0);
        EXPECT_GT(driver.rows.back()[tip_force], 0.0);  // still pressed
    }
    // Of the ground: triangles that ride on its particles. material: of the ground.
    static BothHosts hosts_with_mesh(const std::string& material) {
        return BothHosts(case_with(material, "10, 13", "stiff_surface = {file = \"ground.stl\"}\n"),
                         {{"ground.stl", stl_of_box({5.0, 4.5, 6.0}, {15.5, 14.0, 9.0})}});
    }
};

TEST_F(LammpsSpaceSurfaces, HaveTheBitsOfTheDriverHoweverTheGridIsCut) {
    const BothHosts hosts(case_with(soft_ground));
    const Told driver = hosts.in_driver(all);
    expect_contact(driver);
    for (const auto& bricks : {std::array{1, 1, 1}, std::array{2, 1, 1}, std::array{1, 2, 1},
                               std::array{1, 1, 2}, std::array{2, 2, 2}})
        EXPECT_EQ(first_difference(driver, hosts.in_lammps(bricks)), "")
            << bricks[0] << ' ' << bricks[1] << ' ' << bricks[2];
}

// Ground whose water presses beside it, and does not rub.
TEST_F(LammpsSpaceSurfaces, HaveTheBitsOfTheDriverOnWetGroundToo) {
    const BothHosts hosts(replaced(case_with(soft_ground), "name = \"ground\"\ndensity_kg_per_m3",
                                   "name = \"ground\"\nwater = {porosity = 0.4, bulk_modulus_kPa = "
                                   "200}\ngrain_density_kg_per_m3"));
    const Told driver = hosts.in_driver(all);
    expect_contact(driver);
    for (const auto& bricks : {std::array{1, 1, 1}, std::array{2, 1, 1}, std::array{2, 2, 2}})
        EXPECT_EQ(first_difference(driver, hosts.in_lammps(bricks)), "")
            << bricks[0] << ' ' << bricks[1] << ' ' << bricks[2];
}

// Triangles that ride do not know whose cell they are in.
TEST_F(LammpsSpaceSurfaces, AreNotGivenOfWetGround) {
    const BothHosts hosts = hosts_with_mesh(soft_ground);
    hosts.folder.write("wet.fix", replaced(hosts.folder.read("both.fix"), "driven ",
                                           "water ground undrained porosity 0.4 driven "));
    const Answer answer =
        hosts.lammps(1, replaced(hosts.folder.read("both.in"), "both.fix", "wet.fix"));
    EXPECT_NE(answer.status, 0);
    EXPECT_TRUE(answer.says("stiff_surface: \"ground\" has pore water")) << answer.text;
}

// The last one of three, from 16 m on; and where the first one counts nodes of which the second alone knows that they are near.
TEST_F(LammpsSpaceSurfaces, HaveTheBitsOfTheDriverWhereAProcessHasNoneOfThem) {
    const BothHosts hosts(case_with(soft_ground));
    EXPECT_EQ(first_difference(hosts.in_driver(all), hosts.in_lammps({3, 1, 1})), "");
    const BothHosts beyond(replaced(case_with(soft_ground, "16.25, 19.5"), "[5, 15.5]", "[5, 20]"));
    const Told driver = beyond.in_driver(all);
    expect_contact(driver);
    EXPECT_EQ(first_difference(driver, beyond.in_lammps({2, 1, 1})), "");
}

TEST_F(LammpsSpaceSurfaces, OfARigidBodyAndWithAStiffnessHaveTheBitsOfTheDriver) {
    const BothHosts hosts(case_with("[body.rigid]\nvelocity_x_m_per_s = [-0.5]\n"
                                    "velocity_z_m_per_s = [0.5]\n"
                                    "angular_velocity_z_rad_per_s = [0.1]\n"
                                    "centre_m = [10, 9, 7]",
                                    "10, 13",
                                    "pressure_spacing_cells = 1\nsweep_tolerance = 1e-9\n"
                                    "contact_stiffness_multiple = 10\nmodulus_kPa = 400\n"
                                    "relaxation_time_s = 0.01\n"));
    const Told driver = hosts.in_driver(all);
    expect_contact(driver);
    EXPECT_EQ(first_difference(driver, hosts.in_lammps({1, 2, 1})), "");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps({2, 2, 2})), "");
}

TEST_F(LammpsSpaceSurfaces, GoOnWhereTheGridIsCutAnew) {
    const BothHosts hosts(case_with(soft_ground));
    const std::string script = replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                                        "run 11\nbalance 1.0 x 0.4 y 0.6\nrun ${most_steps}");
    EXPECT_EQ(first_difference(hosts.in_driver(all), hosts.in_lammps({2, 2, 1}, script)), "");
}

TEST_F(LammpsSpaceSurfaces, GoOnFromARestartFileOnMoreProcesses) {
    const BothHosts hosts(case_with(soft_ground));
    const Told before = hosts.in_lammps({2, 1, 1}, "restart 20 surfaces\n" + hosts.script());
    const Told after = hosts.in_lammps({2, 2, 2}, hosts.go_on("surfaces.20"));
    ASSERT_FALSE(after.rows.empty());
    EXPECT_EQ(first_difference({{before.rows.back()}, before.points},
                               {{after.rows.back()}, after.points}),
              "");
}

TEST_F(LammpsSpaceSurfaces, ThatRideOnParticlesOfAllProcessesHaveTheBitsOfTheDriver) {
    const BothHosts hosts = hosts_with_mesh(soft_ground);
    const Told driver = hosts.in_driver(all);
    expect_contact(driver);
    const BothHosts without(case_with(soft_ground));
    EXPECT_NE(first_difference(driver, without.in_driver(all)), "");
    for (const auto& bricks : {std::array{1, 1, 1}, std::array{2, 1, 1}, std::array{2, 2, 2}})
        EXPECT_EQ(first_difference(driver, hosts.in_lammps(bricks)), "")
            << bricks[0] << ' ' << bricks[1] << ' ' << bricks[2];
    // Cut anew where particles have moved, vertices ride on those that they rode on before.
    const std::string script = replaced(hosts.folder.read(hosts.name + ".in"), "run ${most_steps}",
                                        "run 11\nbalance 1.0 x 0.4 y 0.6\nrun ${most_steps}");
    EXPECT_EQ(first_difference(driver, hosts.in_lammps({2, 2, 1}, script)), "");
}

TEST_F(LammpsSpaceSurfaces, ThatRideOnARigidBodyGoOnFromARestartFile) {
    const BothHosts hosts = hosts_with_mesh("[body.rigid]\nvelocity_x_m_per_s = [-0.5]\n"
                                            "velocity_z_m_per_s = [0.5]\n"
                                            "angular_velocity_z_rad_per_s = [0.5]\n"
                                            "centre_m = [10, 9, 7]");
    const Told driver = hosts.in_driver(all);
    expect_contact(driver);
    const Told before = hosts.in_lammps({2, 1, 1}, "restart 20 mesh\n" + hosts.script());
    EXPECT_EQ(first_difference(driver, before), "");
    const Told after = hosts.in_lammps({2, 2, 2}, hosts.go_on("mesh.20"));
    ASSERT_FALSE(after.rows.empty());
    EXPECT_EQ(first_difference({{driver.rows.back()}, driver.points},
                               {{after.rows.back()}, after.points}),
              "");
    // A file may be elsewhere; another surface is another run.
    const std::string name = "both_ground_block.stl";
    const auto go_on_with = [&](const std::string& file, const std::string& text) {
        if (!text.empty()) hosts.folder.write(file, text);
        hosts.folder.write("other.fix", replaced(hosts.folder.read("both.fix"), name, file));
        return hosts.lammps(2, replaced(hosts.go_on("mesh.20"), "both.fix", "other.fix"));
    };
    const Answer moved = go_on_with("elsewhere.stl", hosts.folder.read(name));
    EXPECT_EQ(moved.status, 0) << moved.text;
    const Answer other = go_on_with("other.stl", stl_of_box({5.0, 4.5, 6.0}, {15.5, 14.0, 8.999}));
    EXPECT_TRUE(other.status != 0 && other.says("with other words")) << other.text;
    const Answer missing = go_on_with("nowhere.stl", "");
    EXPECT_TRUE(missing.status != 0 && missing.says("nowhere.stl: cannot be read")) << missing.text;
}

}  // namespace
