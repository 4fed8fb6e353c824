// SPDX-License-Identifier: BSD-3-Clause
// Bodies that slide, by Coulomb's law.
#include <gtest/gtest.h>

#include "support/rolling_disk.hpp"
#include "support/sliding_blocks.hpp"

namespace {

using namespace mpm_test;

constexpr ContactKind all[] = {ContactKind::geo, ContactKind::frictional, ContactKind::surface};

TEST(SlidingCube, FollowsThePathOfCoulombsLaw) {
    for (const ContactKind kind : all) {
        const SlidingCube::Result seen = SlidingCube{kind}.run();
        EXPECT_LT(seen.way, 0.02) << name_of(kind);
        EXPECT_LT(seen.height, 1e-4) << name_of(kind);
    }
}

TEST(LoadedBlock, SticksUntilTheLoadExceedsFrictionAndThenSlips) {
    for (const ContactKind kind : all) {
        const LoadedBlock::Result seen = LoadedBlock{kind}.run();
        EXPECT_NEAR(seen.crept, 0.0, 1e-4) << name_of(kind);
        EXPECT_NEAR(seen.creep_velocity, 0.0, 3e-4) << name_of(kind);
        EXPECT_NEAR(seen.slips_at, 1.0, 0.02) << name_of(kind);
        EXPECT_NEAR(seen.velocity, 1.0, 0.02) << name_of(kind);
        EXPECT_NEAR(seen.way, 1.0, 0.02) << name_of(kind);
    }
}

TEST(DiskOnASlope, SlidesWhereFrictionIsTooLittleToRollIt) {
    for (const ContactKind kind : all) {
        RollingDisk disk;
        disk.friction = 0.1;
        disk.kind = kind;
        EXPECT_NEAR(disk.run(8).way, 1.0, 0.02) << name_of(kind);
    }
}

}  // namespace
