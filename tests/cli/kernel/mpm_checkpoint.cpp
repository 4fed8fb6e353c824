// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/checkpoint.hpp"

#include <gtest/gtest.h>

#include <random>

#include <element/atomic_file.hpp>

#include "support/no_room.hpp"
#include "support/sand_box.hpp"
#include "support/workplace.hpp"

namespace {

using namespace cli_test;

std::string refusal(const std::filesystem::path& place, grit::mpm::Simulation& simulation) {
    try {
        cli::MpmCheckpoint(place).restore(*grit::mpm::subject_of(simulation));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

class CheckpointFile : public testing::Test {
  protected:
    CheckpointFile() {
        for (int i = 0; i < 5; ++i) simulation->step();
    }
    std::string file() const { return here.text("x.checkpoint"); }

    Workplace here;
    std::filesystem::path place = here.path("x.checkpoint");
    std::unique_ptr<grit::mpm::Simulation> simulation = sand_box();
    std::string runner = std::string("stage 3\0, blow 7", 16);
};

TEST_F(CheckpointFile, HandsBackTheRunnersStateAndTheSimulation) {
    cli::write_mpm_checkpoint(place, *grit::mpm::subject_of(*simulation), runner);
    EXPECT_EQ(here.files(), std::set<std::string>{"x.checkpoint"});
    const auto again = sand_box();
    const cli::MpmCheckpoint checkpoint(place);
    checkpoint.restore(*grit::mpm::subject_of(*again));
    EXPECT_EQ(checkpoint.runner(), runner);
    EXPECT_EQ(again->time(), simulation->time());
    EXPECT_EQ(again->steps(), 5);
}

TEST_F(CheckpointFile, TakesThePlaceOfTheOneBefore) {
    cli::write_mpm_checkpoint(place, *grit::mpm::subject_of(*simulation), "first");
    simulation->step();
    cli::write_mpm_checkpoint(place, *grit::mpm::subject_of(*simulation), "second");
    EXPECT_EQ(cli::MpmCheckpoint(place).runner(), "second");
    EXPECT_EQ(here.files(), std::set<std::string>{"x.checkpoint"});
}

TEST_F(CheckpointFile, ThatIsCutOrChangedIsRefusedByName) {
    cli::write_mpm_checkpoint(place, *grit::mpm::subject_of(*simulation), runner);
    const std::string whole = file();
    for (std::size_t part = 0; part < 64; ++part) {
        here.write("x.checkpoint", whole.substr(0, whole.size() * part / 64));
        const std::string answer = refusal(place, *simulation);
        EXPECT_TRUE(answer.starts_with(place.string() + ": ")) << answer;
        EXPECT_NE(answer.find(part == 0 ? "no checkpoint of grit mpm" : "truncated"),
                  std::string::npos)
            << answer;
    }
    for (std::size_t i = 0; i < 400; i += 7) {
        std::string damaged = whole;
        damaged[i] ^= 16;
        here.write("x.checkpoint", damaged);
        EXPECT_NE(refusal(place, *simulation), "accepted") << i;
    }
}

TEST_F(CheckpointFile, WithMoreBehindItIsRefusedByName) {
    cli::write_mpm_checkpoint(place, *grit::mpm::subject_of(*simulation), runner);
    const std::string whole = file();
    std::mt19937 random(16);
    for (std::size_t length = 1; length < 5000; length = 2 * length + 1) {
        std::string more(length, '\0');
        for (char& c : more) c = static_cast<char>(random());
        for (const std::string& behind : {more, std::string(length, '\0'), whole}) {
            here.write("x.checkpoint", whole + behind);
            EXPECT_EQ(refusal(place, *simulation),
                      place.string() + ": checkpoint: damaged: bytes follow where its state ends");
        }
    }
    here.write("x.checkpoint", whole);
    EXPECT_EQ(refusal(place, *simulation), "accepted");
}

TEST_F(CheckpointFile, ThatIsNotThereIsRefusedByName) {
    EXPECT_NE(refusal(here.path("none"), *simulation).find("none: cannot read this checkpoint: No"),
              std::string::npos);
    EXPECT_NE(refusal(here.path("."), *simulation).find("Is a directory"), std::string::npos);
}

TEST_F(CheckpointFile, ThatFindsNoRoomLeavesTheOneBefore) {
    cli::write_mpm_checkpoint(place, *grit::mpm::subject_of(*simulation), "first");
    const std::string before = file();
    simulation->step();
    for (const rlim_t room : {rlim_t{0}, rlim_t{100}, rlim_t{before.size() / 2}}) {
        const NoRoom full(room);
        try {
            cli::write_mpm_checkpoint(place, *grit::mpm::subject_of(*simulation), "second");
            FAIL() << "no error";
        } catch (const element::CannotWrite& error) {
            EXPECT_EQ(error.what(), place.string() + ": cannot write this file: File too large");
        }
    }
    EXPECT_TRUE(file() == before);
    EXPECT_EQ(here.files(), std::set<std::string>{"x.checkpoint"});
}

TEST_F(CheckpointFile, InAFolderThatIsNotThereSaysSo) {
    EXPECT_THROW(
        cli::write_mpm_checkpoint(here.path("no/x"), *grit::mpm::subject_of(*simulation), ""),
        element::CannotWrite);
}

}  // namespace
