// SPDX-License-Identifier: BSD-3-Clause
// What is wrong ends LAMMPS with an error that says why, as its own fixes do.
#include <gtest/gtest.h>

#include <string>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

class LammpsRefuses : public ::testing::Test {
  protected:
    // ... the script, or its fix, with other words in the place of these, by LAMMPS's own kind of error.
    void expect(const std::string& words, const std::string& other, const std::string& why,
                int processes = 1) {
        std::string script = hosts.folder.read("both.in"), fix = hosts.folder.read("both.fix");
        std::string& text = fix.find(words) == std::string::npos ? script : fix;
        text = replaced(text, words, other);
        script = replaced(script, "both.fix", "changed.fix");
        hosts.folder.write("changed.fix", fix);
        expect_error(hosts.lammps(processes, script), why);
    }
    const BothHosts hosts{loaded_block_case("0.1")};
};

TEST_F(LammpsRefuses, NothingInTheCaseAsItIs) {
    const Answer answer = hosts.lammps(2, hosts.script());
    EXPECT_EQ(answer.status, 0) << answer.text;
}

TEST_F(LammpsRefuses, NoThreadsButSaysWhichAreNotUsed) {
    const std::string word = " used: there are no more cores";
    EXPECT_FALSE(hosts.lammps(1, hosts.script()).says(word));
    const Answer answer = hosts.lammps(
        2,
        replaced(hosts.folder.read("both.in"), "include both.fix",
                 replaced(hosts.folder.read("both.fix"), "cell_mean", "threads 1000 cell_mean")));
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("WARNING: Fix grit/mpm: 1000 threads wanted, ") && answer.says(word))
        << answer.text;
}

TEST_F(LammpsRefuses, AGroupThatIsNotThere) {
    expect("fix mpm all", "fix mpm nobody", "Could not find fix group ID");
    expect("traction block traction_1", "traction block nobody",
           "Could not find fix grit/mpm traction group ID nobody");
    expect("body block type 1", "body block group nobody",
           "Could not find fix grit/mpm body group ID nobody");
}

TEST_F(LammpsRefuses, AnAtomTypeThatIsNotThere) {
    expect("body block type 1", "body block type 7", "there is no atom type 7");
}

TEST_F(LammpsRefuses, AKeywordThatIsNone) {
    expect("cell_mean", "cel_mean", "unknown keyword \"cel_mean\"");
    expect("stage flight gravity", "stage flight gravty", "unknown keyword \"gravty\" of a stage");
}

TEST_F(LammpsRefuses, ANumberThatIsNone) {
    expect("cfl 0.4", "cfl big0.4", "cfl must be a number, got \"big0.4");
}

TEST_F(LammpsRefuses, ACommandThatEndsTooEarly) {
    expect("driven block lowest_point", "driven block", "the command ends where");
}

TEST_F(LammpsRefuses, AStageThatIsNotTheNext) {
    expect("stage flight gravity", "stage landing gravity", "no stage is called \"landing\"");
}

TEST_F(LammpsRefuses, AGridThatIsNotTheBox) {
    expect("grid r 24", "grid r 23", "grid r ends at 23");
}

TEST_F(LammpsRefuses, AFileOfPointsThatIsNotThere) {
    expect("both_block.points", "nowhere.points", "cannot open file nowhere.points");
}

TEST_F(LammpsRefuses, PeriodicSides) {
    expect("boundary f f p", "boundary p f p", "boundary f f p");
}

TEST_F(LammpsRefuses, AtomsWithoutMap) { expect("atom_modify map yes", "", "atom_modify map yes"); }

TEST_F(LammpsRefuses, TiledSubdomains) {
    expect("include both.fix", "comm_style tiled\nbalance 1.0 rcb\ninclude both.fix",
           "brick sub-domains", 2);
    expect("run ${most_steps}", "comm_style tiled\nbalance 1.0 rcb\nrun ${most_steps}",
           "brick sub-domains", 2);
    expect("run ${most_steps}",
           "comm_style tiled\nfix cuts all balance 10 1.0 rcb\nrun ${most_steps}",
           "brick sub-domains", 2);
}

TEST_F(LammpsRefuses, APoissonsRatioAtItsLimits) {
    expect("20000 0.29999999999999999", "20000 0.5", "Poisson's ratio must be in (-1, 0.5)");
    expect("20000 0.29999999999999999", "20000 -1", "Poisson's ratio must be in (-1, 0.5)", 2);
}

TEST_F(LammpsRefuses, OtherIntegrators) {
    expect("run ${most_steps}", "run_style respa 2 2\nrun 20", "requires run_style verlet");
    expect("run ${most_steps}", "minimize 0 0 10 10", "cannot be used with minimize");
}

TEST_F(LammpsRefuses, ATractionOnAtomsOfNoBody) {
    expect("group traction_1 id", "group none empty\ngroup others id",
           "Could not find fix grit/mpm traction group ID traction_1");
    expect("include both.fix", "group traction_1 clear\ninclude both.fix",
           "traction group traction_1 has no atoms of body block");
}

TEST_F(LammpsRefuses, ContactOfABodyWithItself) {
    expect("driven block lowest_point",
           "contact block block frictional 0.3 driven block lowest_point",
           "contact block block: the softer body must be another body than the stiffer one");
}

TEST_F(LammpsRefuses, LoadsAndContactsOfRigidBodies) {
    expect("elastic 20000 0.29999999999999999", "rigid", "\"block\" is rigid, no load moves it");
    expect("driven block lowest_point",
           "body a type 1 rigid body b type 1 rigid contact a b geo 0.3 driven block "
           "lowest_point",
           "both bodies are rigid");
}

TEST_F(LammpsRefuses, SubdomainsThinnerThanTheHalo) {
    expect("units si", "processors 6 1 1\nunits si", "is too thin for the cells there", 6);
}

TEST_F(LammpsRefuses, AnotherFixThatMovesTheAtoms) {
    expect("run ${most_steps}", "fix other all nve\nrun ${most_steps}",
           "another fix that moves them");
}

TEST_F(LammpsRefuses, AtomsThatHaveNoPoint) {
    expect("run ${most_steps}", "create_atoms 1 single 12 12 0\nrun ${most_steps}",
           "49 atoms in its group, but 48 material points", 2);
}

TEST_F(LammpsRefuses, AVariableThatIsNotThere) {
    expect("-1 1000", "-1 v_nothing", "there is no equal-style variable \"nothing\"", 2);
}

TEST_F(LammpsRefuses, ParticlesThatLeaveTheGrid) {
    const BothHosts fast{block_case("40, 0.5", "1")};
    const Answer answer = fast.lammps(2, fast.script());
    EXPECT_NE(answer.status, 0);
    EXPECT_TRUE(answer.says("ERROR") && answer.says("particles left the grid")) << answer.text;
}

TEST_F(LammpsRefuses, ToGoOnWithoutSetupWhenTheGridIsCutAnew) {
    expect("run ${most_steps}", "run 1\nbalance 1.0 x 0.6\nrun 1 pre no",
           "cannot be one with pre no", 2);
}

// As LAMMPS leaves out runs once its time is over; where nothing has ended in this run, it is an error.
TEST_F(LammpsRefuses, ToGoOnWhenAllStagesHaveEnded) {
    const std::string more = "write_restart the.end\nprint \"at $(step)\"\nrun 10\nprint \"at "
                             "$(step)\"\nrun 10 pre no\nprint \"at $(step)\"\n";
    const Answer answer = hosts.lammps(1, hosts.script() + more);
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(answer.says("Grit: all stages have ended, further runs are left out"))
        << answer.text;
    const std::string end = hosts.folder.read("said.log");
    const std::string at =
        end.substr(end.rfind("\nat "), end.find('\n', end.rfind("\nat ") + 1) - end.rfind("\nat "));
    EXPECT_NE(end.find(at), end.rfind(at)) << "there were more steps";
    const Answer again = hosts.lammps(2, hosts.go_on("the.end"));
    EXPECT_NE(again.status, 0);
    EXPECT_TRUE(again.says("ERROR: Fix grit/mpm: all stages have ended")) << again.text;
}

}  // namespace
