// SPDX-License-Identifier: BSD-3-Clause
#include <element/output_lock.hpp>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <element/atomic_file.hpp>

namespace {

namespace fs = std::filesystem;
using namespace element;

class OutputLocks : public testing::Test {
  protected:
    OutputLocks() {
        std::string pattern = (fs::temp_directory_path() / "grit_lock_XXXXXX").string();
        folder = mkdtemp(pattern.data());
    }
    ~OutputLocks() override { fs::remove_all(folder); }

    fs::path folder;
};

TEST_F(OutputLocks, RefuseASecondRunByTheNameOfTheFile) {
    const OutputLock first({folder / "a.csv", folder / "b.csv"});
    const OutputLock other({folder / "c.csv", folder / "d.csv"});
    try {
        const OutputLock second({folder / "e.csv", folder / "b.csv"});
        FAIL() << "no error";
    } catch (const CannotWrite& error) {
        EXPECT_EQ(error.what(),
                  (folder / "b.csv").string() +
                      ": another run of grit is writing this file: wait for its end, or write to "
                      "another folder");
    }
    const OutputLock third({folder / "e.csv"});  // the one that was refused holds nothing
}

TEST_F(OutputLocks, LeaveNothingBehind) {
    {
        const OutputLock first({folder / "a.csv"});
        auto second = std::make_unique<OutputLock>(std::vector<fs::path>{folder / "b.csv"});
        EXPECT_FALSE(fs::is_empty(folder));
        second.reset();
        EXPECT_THROW(OutputLock({folder / "a.csv"}), CannotWrite);
    }
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(OutputLocks, VanishOnASignalToo) {
    const OutputLock lock({folder / "a.csv"});
    leave_output_locks();
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(OutputLocks, AreTheSameByWhateverWayAFolderIsNamed) {
    const OutputLock first({folder / "a.csv"});
    EXPECT_THROW(OutputLock({folder / ".." / folder.filename() / "a.csv"}), CannotWrite);
}

TEST_F(OutputLocks, RemoveWhatAKilledRunLeft) {
    std::ofstream(folder / ".grit-lock");
    std::ofstream(folder / "a.csv.0123456789abcdef.part") << "half";
    { const OutputLock next({folder / "a.csv"}); }
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(OutputLocks, HaveOneOwnerAtATimeHoweverTheyComeAndGo) {
    constexpr int names = 3;
    std::array<std::atomic<int>, names> owners{};
    std::atomic<int> taken = 0, two = 0;
    std::vector<std::thread> threads;
    for (unsigned seed = 0; seed < 6; ++seed)
        threads.emplace_back([&, seed] {
            std::mt19937 random(seed);
            for (int i = 0; i < 2000; ++i) {
                const std::size_t which = random() % names;
                try {
                    const OutputLock lock({folder / std::to_string(which)});
                    two += ++owners[which] != 1;
                    ++taken;
                    --owners[which];
                } catch (const CannotWrite&) {
                    continue;
                }
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(two, 0);
    EXPECT_GT(taken, 100);
    EXPECT_TRUE(fs::is_empty(folder));
}

// One that leaves holds all of the lock file while it removes it: no reason to refuse another file.
TEST_F(OutputLocks, OfOtherFilesAreNeverRefusedHoweverTheyComeAndGo) {
    std::atomic<int> refused = 0;
    std::vector<std::thread> runs;
    for (const char* name : {"a.csv", "b.csv", "c.csv"})
        runs.emplace_back([&, file = folder / name] {
            for (int i = 0; i < 3000; ++i) try {
                    const OutputLock mine({file});
                } catch (const CannotWrite&) {
                    ++refused;
                }
        });
    for (std::thread& run : runs) run.join();
    EXPECT_EQ(refused, 0);
}

}  // namespace
