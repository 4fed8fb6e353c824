// SPDX-License-Identifier: BSD-3-Clause
// Commands of LAMMPS between runs and around them: what they mean for the fix, or that it refuses them.
#include <gtest/gtest.h>

#include <string>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

class LammpsCommands : public ::testing::Test {
  protected:
    const BothHosts hosts{loaded_block_case("3")};

    // The script with these words in the place of its run; two stages if wanted.
    std::string running(const std::string& words, bool two_stages = false) const {
        std::string fix = hosts.folder.read("both.fix");
        if (two_stages) fix = replaced(fix, "stages 1 flight", "stages 2 flight rest");
        hosts.folder.write("own.fix", fix);
        return replaced(replaced(hosts.folder.read("both.in"), "both.fix", "own.fix"),
                        "run ${most_steps}", words);
    }
    void expect_refused(const std::string& words, const std::string& why, int processes = 1,
                        bool two_stages = false) const {
        expect_error(hosts.lammps(processes, running(words, two_stages)), why);
    }
};

constexpr char print_stage[] = "print \"in stage $(f_mpm[1]) after $(f_mpm[3]:%.3f) s\"\n";

// LAMMPS looks for an end between the parts of such a run.
TEST_F(LammpsCommands, ARunOfSeveralPartsEndsWithItsStage) {
    for (const char* parts : {"every 10 \"print part\"", "every 10 NULL", "pre no every 10 NULL"}) {
        const Answer answer = hosts.lammps(
            2, running(std::string("run 1000000 ") + parts + '\n' + print_stage + "run 10\n" +
                           print_stage +
                           "fix_modify mpm stage rest until_time 0.5\nrun 1000000\nprint \"over "
                           "after $(f_mpm[3]:%.3f) s\"\n",
                       true));
        ASSERT_EQ(answer.status, 0) << answer.text;
        // The second run was left out, and that is said, by one of the processes.
        EXPECT_TRUE(answer.says("in stage 2 after 3.0")) << answer.text;
        EXPECT_FALSE(answer.says("in stage 2 after 3.1") || answer.says("in stage 2 after 3.8"))
            << answer.text;
        const std::string left_out = "runs are left out until fix_modify mpm stage";
        EXPECT_TRUE(answer.says(left_out)) << answer.text;
        EXPECT_EQ(answer.text.find(left_out), answer.text.rfind(left_out)) << answer.text;
        EXPECT_TRUE(answer.says("over after 3.5") || answer.says("over after 3.6")) << answer.text;
    }
}

TEST_F(LammpsCommands, TheLastOfSeveralPartsLeavesTheScriptToGoOn) {
    const Answer answer =
        hosts.lammps(1, running("run 1000000 every 10 NULL\nwrite_restart the.end\nprint done\n"));
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("done"));
    const Answer more = hosts.lammps(1, running("run 20 every 10 NULL\nrun 10\nprint \"$(step) "
                                                "steps\"\n"));
    ASSERT_EQ(more.status, 0) << more.text;
    EXPECT_TRUE(more.says("30 steps")) << more.text;
}

TEST_F(LammpsCommands, WhatOthersEndIsNotTakenUpByAStage) {
    const Answer answer = hosts.lammps(
        2, running("variable late equal step>=5\nfix stop all halt 1 v_late == 1\nrun 1000\n" +
                       std::string(print_stage) +
                       "fix_modify mpm stage rest until_time 0.5\nrun 1000\n" + print_stage +
                       "print \"$(step) steps\"\n",
                   true));
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("WARNING: Fix grit/mpm: stage rest is left out")) << answer.text;
    EXPECT_FALSE(answer.says("in stage 2")) << answer.text;
    EXPECT_TRUE(answer.says("5 steps")) << answer.text;
}

// On any number of processes, also where none of a process's particles leaves it.
TEST_F(LammpsCommands, LoadsFollowTheirGroupFromOneRunToTheNext) {
    const std::string other =
        "run 5\ngroup traction_1 clear\ngroup traction_1 id 1:8\nrun ${most_steps}";
    const Told changed = hosts.in_lammps(1, 1, running(other));
    EXPECT_EQ(first_difference(changed, hosts.in_lammps(2, 1, running(other))), "");
    const std::string no_setup =
        "run 5\ngroup traction_1 clear\ngroup traction_1 id 1:8\nrun ${most_steps} pre no";
    const Told also = hosts.in_lammps(2, 1, running(no_setup));
    EXPECT_EQ(first_difference({{}, changed.points}, {{}, also.points}), "");
    const Told as_it_was = hosts.in_lammps(1, 1, running("run 5\nrun ${most_steps}"));
    EXPECT_NE(first_difference({{}, as_it_was.points}, {{}, changed.points}), "");
    expect_refused("group traction_1 dynamic all every 1\nrun 5",
                   "traction group traction_1 is dynamic");
}

TEST_F(LammpsCommands, AFixDoesNotBeginAnewOnAtomsThatHaveMoved) {
    // Without columns in thermo output, which LAMMPS takes from a fix that has gone.
    const std::string fix = hosts.folder.read("both.fix");
    hosts.folder.write("bare.fix", fix.substr(0, fix.find("# Columns")));
    const std::string again = "thermo_style one\nrun 5\nunfix mpm\n";
    expect_refused(again + "include bare.fix\nrun 5",
                   "the atoms are at step 5, but fix mpm knows of no run before", 2);
    expect_refused(again + "include bare.fix\nrun 5 pre no", "first run cannot be one with pre no");
    ASSERT_EQ(hosts.lammps(2, running("run 3\nwrite_restart some.restart")).status, 0);
    hosts.folder.write("other.fix",
                       replaced(hosts.folder.read("bare.fix"), "fix mpm all", "fix other all"));
    const Answer other = hosts.lammps(
        2, "atom_modify map yes\nread_restart some.restart\ninclude other.fix\nthermo 1\nrun 5\n");
    EXPECT_NE(other.status, 0);
    EXPECT_TRUE(other.says("the atoms are at step 3, but fix other knows of no run before"))
        << other.text;
    const Answer anew =
        hosts.lammps(1, running(again + "reset_timestep 0\ninclude bare.fix\nrun 5\n"));
    EXPECT_EQ(anew.status, 0) << anew.text;
}

TEST_F(LammpsCommands, AStageThatHasDoneNothingIsNotLeftOut) {
    expect_refused("fix_modify mpm stage rest until_time 0.5\nrun 5",
                   "stage rest cannot begin: stage flight has not done a step yet", 2, true);
    expect_refused("run 0\nfix_modify mpm stage rest until_time 0.5\nrun 5",
                   "stage rest cannot begin: stage flight has not done a step yet", 1, true);
}

TEST_F(LammpsCommands, MoveNoAtomAndNoBox) {
    expect_refused("run 2\ndisplace_atoms all move 0.2 0 0 units box\nrun 2",
                   "a command has moved atom ", 2);
    expect_refused("run 2\nset atom 1 x 2.5\nrun 2", "a command has moved atom 1 along x to 2.5 m");
    expect_refused("change_box all x final 0 30 units box\nrun 2",
                   "the box along x is from 0 to 30 m, the grid of the fix from 0 to 24 m", 2);
    expect_refused("run 2\nreset_atom_ids", "Cannot use reset_atom_ids");
}

TEST_F(LammpsCommands, WriteRestartFilesBetweenRunsWithoutSetup) {
    const std::string words = "run 3\nwrite_restart some.restart\nrun 0 pre no\nrun 2 pre no";
    const Answer answer = hosts.lammps(4, running(words + "\nprint \"$(step) steps\"\n"));
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("5 steps")) << answer.text;
}

TEST_F(LammpsCommands, TellTheTimeOfTheRunFromItsFirstRow) {
    ASSERT_EQ(hosts.lammps(1, running("run 3\nwrite_restart some.restart")).status, 0);
    const Answer answer = hosts.lammps(
        1, "atom_modify map yes\nread_restart some.restart\ninclude both.fix\nthermo 1\nrun 0\n"
           "print \"apart by $(time-f_mpm[3])\"\n");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("apart by 0\n")) << answer.text;
}

TEST_F(LammpsCommands, FilesOfPointsHaveAnAtomForEachRow) {
    const std::string points = hosts.folder.read("both_block.points");
    const std::string last = points.substr(points.rfind('\n', points.size() - 2) + 1);
    hosts.folder.write("both_block.points", points + "49" + last.substr(last.find_first_of(" \t")));
    expect_refused("run 2", "has 49 points, but only 48 of them have an atom", 2);
    hosts.folder.write("both_block.points",
                       points + "none" + last.substr(last.find_first_of(" \t")));
    expect_refused("run 2", "an id must be in [1, 2147483647], got none", 2);
}

TEST_F(LammpsCommands, ABodyHasAtoms) {
    const std::string fix = hosts.folder.read("both.fix");
    hosts.folder.write("both.fix", replaced(fix, "driven block",
                                            "body other group nobody elastic 1000 0.3 driven "
                                            "block"));
    const std::string script = replaced(hosts.folder.read("both.in"), "include both.fix",
                                        "group nobody empty\ninclude both.fix");
    const Answer answer = hosts.lammps(2, script);
    EXPECT_NE(answer.status, 0);
    EXPECT_TRUE(answer.says("body other has no atoms")) << answer.text;
}

}  // namespace
