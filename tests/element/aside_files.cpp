// SPDX-License-Identifier: BSD-3-Clause
#include <element/aside_file.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;
using namespace element;

class AsideFiles : public testing::Test {
  protected:
    AsideFiles() {
        std::string pattern = (fs::temp_directory_path() / "grit_aside_XXXXXX").string();
        folder = mkdtemp(pattern.data());
    }
    ~AsideFiles() override { fs::remove_all(folder); }

    bool is_empty() const { return fs::is_empty(folder); }

    fs::path folder;
};

TEST_F(AsideFiles, AppearWhenTheyAreComplete) {
    AsideFile file(folder / "a.csv");
    file.write("1,2\n");
    EXPECT_FALSE(fs::exists(folder / "a.csv"));
    file.complete();
    std::ifstream written(folder / "a.csv");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}), "1,2\n");
    EXPECT_FALSE(fs::exists(folder / "a.csv.part"));
}

TEST_F(AsideFiles, VanishWhenTheyAreNot) {
    {
        AsideFile file(folder / "a.csv");
        const AsidePath name(folder / "b.svg");
        std::ofstream(name.path()) << "half";
        EXPECT_FALSE(is_empty());
    }
    EXPECT_TRUE(is_empty());
}

TEST_F(AsideFiles, VanishOnASignalToo) {
    AsideFile file(folder / "a.csv");
    remove_aside_files();
    EXPECT_TRUE(is_empty());
}

TEST_F(AsideFiles, LeaveNothingWhereTheirPlaceIsTaken) {
    fs::create_directory(folder / "a.csv");
    {
        AsideFile file(folder / "a.csv");
        EXPECT_THROW(file.complete(), CannotWrite);
    }
    EXPECT_FALSE(fs::exists(folder / "a.csv.part"));
    EXPECT_THROW(AsideFile(folder / "no" / "a.csv"), CannotWrite);
}

TEST_F(AsideFiles, SayWhenTheDiskIsFull) {
    if (!fs::exists("/dev/full")) return;
    fs::create_symlink("/dev/full", folder / "a.csv.part");
    AsideFile file(folder / "a.csv");
    file.write("1,2\n");
    EXPECT_THROW(file.complete(), CannotWrite);
}

}  // namespace
