// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/rolling_disk.hpp"

namespace {

using namespace mpm_test;

// Fine grids: verification/mpm/convergence.cpp.
TEST(DiskOnASlope, RollsAsARigidOneWithAnErrorThatFallsWithTheCellSize) {
    const RollingDisk disk;
    const RollingDisk::Result at_4 = disk.run(4), at_8 = disk.run(8), at_16 = disk.run(16);
    EXPECT_NEAR(at_16.way, 1.0, 0.02);
    EXPECT_GT(std::log2((1.0 - at_4.way) / (1.0 - at_8.way)), 1.3);
    EXPECT_GT(std::log2((1.0 - at_8.way) / (1.0 - at_16.way)), 1.3);
    EXPECT_NEAR(at_16.residual, 0.0, 0.01);
}

TEST(DiskOnASlope, RollsAsARigidOneBySurfaceContactOnAFineGrid) {
    RollingDisk disk;
    disk.kind = ContactKind::surface;
    EXPECT_NEAR(disk.run(8).way, 1.0, 0.04);
    const RollingDisk::Result at_16 = disk.run(16);
    EXPECT_NEAR(at_16.way, 1.0, 0.01);
    EXPECT_NEAR(at_16.residual, 0.0, 0.01);
}

// Pressures two cells apart: 2.8 %.
TEST(DiskOnASlope, RollsBetterWithPressuresACellApart) {
    RollingDisk disk;
    disk.kind = ContactKind::surface_1;
    EXPECT_NEAR(disk.run(8).way, 1.0, 0.022);
}

// Springs: -4.6, +0.3 and +1.0 %; contacts at nodes: -9.4, -2.4 and -0.9 %.
TEST(DiskOnASlope, RollsNoWorseThanBySpringsWhereItsSurfaceGivesBack) {
    RollingDisk disk;
    disk.kind = ContactKind::surface_1_10;
    EXPECT_NEAR(disk.run(4).way, 1.0, 0.045);
    EXPECT_NEAR(disk.run(8).way, 1.0, 0.0028);
    EXPECT_NEAR(disk.run(16).way, 1.0, 0.0087);
}

}  // namespace
