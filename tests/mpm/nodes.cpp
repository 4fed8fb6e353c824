// SPDX-License-Identifier: BSD-3-Clause
// What each call leaves at a node.
#include <gtest/gtest.h>

#include <adapters/mpm/kernel/nodes.hpp>

namespace {

using namespace grit::mpm;

// Whatever contact has done there, and damping before it: neither moves, nor is work found in it.
TEST(FixedNode, IsAtRestAtTheEndOfAStep) {
    for (const std::uint8_t bits : {1, 2, 3}) {  // r, z, both
        NodeRecord record{};
        record[record::m] = 2.0;
        NodeMotion motion{0.3, -0.4, 0.0, 0.0};
        grit::Vector2 internal{};
        NodeCall call{};
        call.records = &record;
        call.motions = &motion;
        call.internal = &internal;
        call.fixed = &bits;
        call.end = 1;
        call.dt = call.dt_before = 1e-3;
        NodeSums sums;
        close_nodes(call, sums);
        const double v_r = bits & fixed::r ? 0.0 : 0.3, v_z = bits & fixed::z ? 0.0 : -0.4;
        EXPECT_EQ(motion[motion::v_r], v_r);
        EXPECT_EQ(motion[motion::v_z], v_z);
        EXPECT_NEAR(sums.change.value(), v_r * v_r + v_z * v_z, 1e-15);
    }
}

}  // namespace
