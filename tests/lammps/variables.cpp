// SPDX-License-Identifier: BSD-3-Clause
// Loads and motions that the script computes while it runs.
#include <gtest/gtest.h>

#include <string>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

// The block with a traction on its left edge, which the first of two processes alone has, or a plate above.
class LammpsVariables : public ::testing::Test {
  protected:
    static std::string case_with(const std::string& from_stage) {
        return block_case("1, 0", "0.4", R"([[traction]]
body = "block"
edge = "left"
)" + from_stage + R"(time_s = [0]
stress_kPa = [1]
[[body]]
name = "plate"
[[body.box]]
r_m = [2, 20]
z_m = [12, 13]
[body.rigid]
)" + from_stage + R"(velocity_r_m_per_s = [0]
velocity_z_m_per_s = [0]
time_s = [0]
[[stage]]
name = "later"
[stage.until]
time_s = 0.4
)");
    }
    // hammer and speed: of variables.
    static Told told(const std::string& hammer, const std::string& speed, int processes,
                     const std::string& script = "", const std::string& more = "",
                     const std::string& from_stage = "") {
        const BothHosts hosts(case_with(from_stage));
        std::string fix = hosts.folder.read("both.fix");
        fix = replaced(fix, "left 1 0 1000", "left 1 0.5 v_hammer");
        fix = replaced(fix, "motion plate 0 0", more + "motion plate 0 v_speed");
        hosts.folder.write("both.fix", "variable hammer equal \"" + hammer +
                                           "\"\nvariable speed equal \"" + speed + "\"\n" + fix);
        return hosts.in_lammps(processes, 1, script.empty() ? hosts.script() : script);
    }
    static constexpr std::size_t t = 2, hammer_force = 8, external_work = 12;
};

TEST_F(LammpsVariables, MayReadWhatTheFixTells) {
    const std::string hammer = "1000*(f_mpm[3]<0.2)-10*f_mpm[6]", speed = "-0.1*(f_mpm[11]>1)";
    const Told one = told(hammer, speed, 1), two = told(hammer, speed, 2);
    EXPECT_GT(one.rows.back()[external_work], 1.0);
    EXPECT_EQ(first_difference(one, two), "");
}

TEST_F(LammpsVariables, LeaveTheMeansOfForcesAsTheyAre) {
    const std::string hammer = "1000*(time<0.3)";
    const BothHosts hosts(case_with(""));
    const std::string script =
        replaced(hosts.folder.read("both.in"), "thermo ${thermo_steps}", "thermo 3");
    const Told quiet = told(hammer, "0", 1, script);
    const Told asking = told(hammer + "+0*f_mpm[9]", "0", 1, script);
    ASSERT_GT(quiet.rows.size(), 3u);
    EXPECT_NE(quiet.rows[2][hammer_force], 0.0);
    EXPECT_EQ(first_difference(quiet, asking), "");
}

TEST_F(LammpsVariables, MoveBodiesOnSeveralThreads) {
    const Told one = told("0", "-time", 1);
    const Told four = told("0", "-time", 1, "", "threads 4 ");
    EXPECT_EQ(first_difference(one, four), "");
}

TEST_F(LammpsVariables, DoNothingBeforeTheirStageAndCountTimeFromIt) {
    const Told lammps = told("1000+0*time", "-1-time", 2, "", "", "from_stage = \"later\"\n");
    double began = 0.0;
    for (const auto& row : lammps.rows) {
        if (row[0] > 1.5) break;
        began = row[t];
        EXPECT_EQ(row[external_work], 0.0) << row[t];
    }
    EXPECT_GT(began, 0.3);
    EXPECT_NE(lammps.rows.back()[external_work], 0.0);
    double lowest = 100.0;
    for (const auto& [id, row] : lammps.points)
        if (id > 48) lowest = std::min(lowest, row[1] - 0.5 * row[10]);
    // 1 m/s and half a metre more, for 0.4 s: z sinks by 0.4 + 0.08.
    const BothHosts hosts(case_with("from_stage = \"later\"\n"));
    double first = 100.0;
    for (const auto& [id, row] : hosts.in_driver(0).points)
        if (id > 48) first = std::min(first, row[1] - 0.5 * row[10]);
    EXPECT_NEAR(first - lowest, 0.48, 0.06);
}

}  // namespace
