// SPDX-License-Identifier: BSD-3-Clause
#include "support/tables/csv.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

namespace fs = std::filesystem;

class CsvFiles : public testing::Test {
  protected:
    CsvFiles() {
        std::string pattern = (fs::temp_directory_path() / "grit_csv_XXXXXX").string();
        folder = mkdtemp(pattern.data());
    }
    ~CsvFiles() override { fs::remove_all(folder); }

    fs::path file(const std::string& text) const {
        std::ofstream(folder / "x.csv", std::ios::binary) << text;
        return folder / "x.csv";
    }
    std::string complaint(const std::string& text) const {
        try {
            grit::csv::read_numbers(file(text));
        } catch (const grit::csv::Error& error) {
            const std::string what = error.what();
            return what.starts_with(folder.string()) ? what.substr(folder.string().size()) : what;
        }
        return {};
    }
    fs::path folder;
};

// Blanks of every kind make no row, and no cell.
TEST_F(CsvFiles, HaveNoRowOnALineOfOddBlanks) {
    const auto table = grit::csv::read_numbers(file("a,\vb\f\n\v\n \t\f\v\r\n1,2\n"));
    EXPECT_EQ(table.names, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(table.rows.size(), 1u);
}

TEST_F(CsvFiles, HaveNamesUnitsAndRowsBesideComments) {
    const auto table =
        grit::csv::read_numbers(file("\xEF\xBB\xBF# of a machine\r\ntime [s], \"p\" ,f "
                                     "[kN]\r\n\n1, 2.5e-3,nan\n# aside\n-4,5,6\n"));
    EXPECT_EQ(table.names, (std::vector<std::string>{"time", "p", "f"}));
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0][1], 2.5e-3);
    EXPECT_TRUE(std::isnan(table.rows[0][table.at("f")]));
    EXPECT_EQ(table.rows[1], (std::vector<double>{-4.0, 5.0, 6.0}));
    EXPECT_FALSE(table.find("time [s]"));
    EXPECT_THROW(table.at("q"), grit::csv::Error);
}

TEST_F(CsvFiles, SayWhereTheyAreWrong) {
    EXPECT_EQ(complaint("# a\n\na,b\n1,2\n1,2,3\n"), "/x.csv:5: 3 cells where the header has 2");
    EXPECT_EQ(complaint("a,b\n1,\n"), "/x.csv:2: \"\" where a number is needed");
    EXPECT_EQ(complaint("a,b\n1,2 kPa\n"), "/x.csv:2: \"2 kPa\" where a number is needed");
    EXPECT_EQ(complaint("a;b\n1;2\n"),
              "/x.csv:1: cells are separated by commas, not by semicolons");
    EXPECT_EQ(complaint("a,b\n"), "/x.csv: needs a header and at least one row");
    EXPECT_THROW(grit::csv::read(folder), grit::csv::Error);
    EXPECT_THROW(grit::csv::read(folder / "none.csv"), grit::csv::Error);
}

}  // namespace
