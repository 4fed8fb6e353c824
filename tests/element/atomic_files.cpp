// SPDX-License-Identifier: BSD-3-Clause
#include <element/atomic_file.hpp>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace element;

class AtomicFiles : public testing::Test {
  protected:
    AtomicFiles() {
        std::string pattern = (fs::temp_directory_path() / "grit_atomic_XXXXXX").string();
        folder = mkdtemp(pattern.data());
    }
    ~AtomicFiles() override { fs::remove_all(folder); }

    bool is_empty() const { return fs::is_empty(folder); }

    std::set<std::string> files() const {
        std::set<std::string> out;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            out.insert(entry.path().filename().string());
        return out;
    }

    fs::path folder;
};

TEST_F(AtomicFiles, AppearWhenTheyAreComplete) {
    AtomicFile file(folder / "a.csv");
    file.write("1,2\n");
    EXPECT_FALSE(fs::exists(folder / "a.csv"));
    file.complete();
    std::ifstream written(folder / "a.csv");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}), "1,2\n");
    EXPECT_EQ(files(), std::set<std::string>{"a.csv"});
}

TEST_F(AtomicFiles, OfTheSameNameDoNotMix) {
    AtomicFile first(folder / "a.csv"), second(folder / "a.csv");
    for (int i = 0; i < 10000; ++i) {
        first.write("1\n");
        second.write("22\n");
    }
    const auto size = [&] { return fs::file_size(folder / "a.csv"); };
    first.complete();
    EXPECT_EQ(size(), 20000u);
    second.complete();
    EXPECT_EQ(size(), 30000u);
    EXPECT_EQ(files(), std::set<std::string>{"a.csv"});
}

TEST_F(AtomicFiles, LeftByAKilledProgramAreKnownFromOthers) {
    const std::set<std::string> others = {"a.csv.part", "a.csv.0123456789abcdeX.part",
                                          "b.csv.0123456789abcdef.part", "a.csv",
                                          "a.csv.0123456789abcdef"};
    for (const std::string& name : others) std::ofstream(folder / name) << "mine";
    std::ofstream(folder / "a.csv.0123456789abcdef.part") << "half";
    remove_left_behind(folder / "a.csv");
    EXPECT_EQ(files(), others);
}

TEST_F(AtomicFiles, VanishWhenTheyAreNot) {
    {
        AtomicFile file(folder / "a.csv");
        const AtomicPath name(folder / "b.svg");
        std::ofstream(name.path()) << "half";
        EXPECT_FALSE(is_empty());
    }
    EXPECT_TRUE(is_empty());
}

TEST_F(AtomicFiles, VanishOnASignalToo) {
    AtomicFile file(folder / "a.csv");
    remove_incomplete_files();
    EXPECT_TRUE(is_empty());
}

TEST_F(AtomicFiles, LeaveNothingWhereTheirPlaceIsTaken) {
    fs::create_directory(folder / "a.csv");
    {
        AtomicFile file(folder / "a.csv");
        EXPECT_THROW(file.complete(), CannotWrite);
    }
    EXPECT_EQ(files(), std::set<std::string>{"a.csv"});
    EXPECT_THROW(AtomicFile(folder / "no" / "a.csv"), CannotWrite);
}

TEST_F(AtomicFiles, SayWhenTheDiskIsFull) {
    AtomicFile file(folder / "a.csv");
    file.write("1,2\n");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit none{0, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &none);
    EXPECT_THROW(file.complete(), CannotWrite);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
}

}  // namespace
