// SPDX-License-Identifier: BSD-3-Clause
// *ImportFile: a history from a table.
#include <gtest/gtest.h>

#include <element/incremental_driver/run.hpp>

#include "support/folder.hpp"

namespace {

const std::string components = "*Cartesian\n0 2 * -0.01\n0 0\n0 0\n0 0\n0 0\n0 3\n";

element::Step read(const Folder& folder, const std::string& step) {
    folder.write("test.inp", "out\n" + step);
    return incremental_driver::read_test(folder.path("test.inp"), {}).program.at(0);
}

TEST(IncrementalDriverImport, FollowsColumnsTimesFactors) {
    const Folder folder;
    folder.write("table.txt", "time compression shear\n(s) (%) -\n0 0 0 remark\n1 0.5 1e-3\n\n"
                              "3, 1.5, 2d-3\n4 1 0\n");
    const element::Step step =
        read(folder, "*ImportFile table.txt|3\n100 5 0\n" + components + "1 * 2\n");
    const auto load = std::get<element::Imported>(step.kind);
    EXPECT_EQ(step.increments, 3);
    const std::vector<std::vector<double>> table{
        {0, 0, 0}, {1, 0.5, 1e-3}, {3, 1.5, 2e-3}, {4, 1, 0}};
    EXPECT_EQ(load.table, table);
    EXPECT_EQ(load.columns[0].index, 1);
    EXPECT_EQ(load.columns[0].factor, -0.01);
    EXPECT_EQ(load.columns[1].index, -1);
    EXPECT_EQ(load.columns[5].index, 2);
    EXPECT_EQ(load.time.index, 0);
    EXPECT_EQ(load.time.factor, 2.0);
}

TEST(IncrementalDriverImport, TakesNoMoreThanNincIncrementsAndDtimeForEach) {
    const Folder folder;
    folder.write("table.txt", "0 0 0\n1 1 0\n2 2 0\n3 3 0\n");
    const element::Step step = read(folder, "*ImportFile table.txt | 3\n2 5 10\n" + components);
    EXPECT_EQ(step.increments, 2);
    EXPECT_EQ(step.duration, 20.0);
}

TEST(IncrementalDriverImport, ReachesTheStrainAndTimeOfEveryRow) {
    const Folder folder;
    Folder::fill(folder);
    folder.write("table.txt", "t e1 g23\n0 2 0\n1 2.1 1e-3\n3 2.3 2e-3\n4 2.2 0\n");
    folder.write("test.inp",
                 "result.out\n*ImportFile table.txt|3\n100 5 -1\n" + components + "1 * 2\n");
    incremental_driver::run({folder.path(), {}, {}});
    const Table rows = read_table(folder.path("result.out"));
    ASSERT_EQ(rows.size(), 4u);
    const double strain[] = {0, -1e-3, -3e-3, -2e-3}, shear[] = {0, 1e-3, 2e-3, 0};
    const double time[] = {0, 2, 6, 8};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(rows[i][1], time[i], 1e-12);
        EXPECT_NEAR(rows[i][2], strain[i], 1e-12);
        EXPECT_NEAR(rows[i][7], shear[i], 1e-12);
    }
}

}  // namespace
