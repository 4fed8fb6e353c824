// SPDX-License-Identifier: BSD-3-Clause
// What contact at surfaces knows of two bodies where they are near.
#include <gtest/gtest.h>

#include <adapters/mpm/kernel/nodes.hpp>
#include <adapters/mpm/step/contact_zone.hpp>

namespace {

using namespace grit::mpm;

// A grid of 12 x 12 cells of 1 m. Body a has mass at the nodes up to row 5, body b from there on.
class ContactZoneOfTwo : public testing::Test {
  protected:
    ContactZoneOfTwo() {
        for (std::ptrdiff_t node = 0; node < nodes; ++node) {
            a_records[at(node)].value[record::m] = node / 13 <= 5 ? 1.0 + double(node) : 0.0;
            b_records[at(node)].value[record::m] = node / 13 >= 5 ? 2.0 + double(node) : 0.0;
            b_motions[at(node)] = {double(node), -double(node), 0.25, 0.5};
            if (node % 13 == 0) fixed_nodes[at(node)] = fixed::r;
            if (node / 13 == 7) fixed_nodes[at(node)] |= fixed::z;
        }
    }
    static std::size_t at(std::ptrdiff_t node) { return static_cast<std::size_t>(node); }
    SurfaceBody body(std::vector<NodeRecord>& records, std::vector<NodeMotion>& motions) {
        return {records.data(), motions.data(), none.view(), none.ids(), 0, 0.0, false, {}};
    }
    static constexpr std::ptrdiff_t nodes = 13 * 13;
    Axis axis = Axis::uniform(0.0, 12.0, 12);
    GridView grid{axis.view(), axis.view()};
    std::vector<std::uint8_t> fixed_nodes = std::vector<std::uint8_t>(nodes);
    std::vector<NodeRecord> a_records = std::vector<NodeRecord>(nodes), b_records = a_records;
    std::vector<NodeMotion> a_motions = std::vector<NodeMotion>(nodes), b_motions = a_motions;
    Particles none{0};
    SurfaceBody a = body(a_records, a_motions), b = body(b_records, b_motions);
    ContactZone zone{grid, nullptr, false, fixed_nodes};
    Exchange alone;
};

// Of particles near them, which are in the two rows of cells on both sides, and whose corners are in the next one.
TEST_F(ContactZoneOfTwo, HasTheNodesUpToThreeFromThoseThatBothReach) {
    ASSERT_TRUE(zone.find(a, b));
    zone.gather(a, b, alone);
    EXPECT_EQ(zone.nodes(0).size(), 4u * 13);  // rows 2 to 5
    EXPECT_EQ(zone.nodes(1).size(), 4u * 13);  // rows 5 to 8
    EXPECT_EQ(zone.place_of(0, 2 * 13), 0);
    EXPECT_EQ(zone.place_of(1, 8 * 13 + 12), 51);
    EXPECT_EQ(zone.place_of(0, 2 * 13 - 1), -1);
    EXPECT_EQ(zone.place_of(0, 6 * 13), -1);  // no mass
    EXPECT_EQ(zone.place_of(1, 9 * 13), -1);
}

TEST_F(ContactZoneOfTwo, KnowsOfEachNodeWhatMovesAndWhatHoldsIt) {
    ASSERT_TRUE(zone.find(a, b));
    zone.gather(a, b, alone);
    for (std::size_t i = 0; i < zone.nodes(1).size(); ++i) {
        const auto node = static_cast<std::ptrdiff_t>(5 * 13 + i);
        ASSERT_EQ(zone.place_of(1, node), static_cast<std::ptrdiff_t>(i));
        const double* value = zone.nodes(1)[i].value;
        EXPECT_EQ(value[near_node::m], 2.0 + double(node));
        EXPECT_EQ(value[near_node::v_r], double(node));
        EXPECT_EQ(value[near_node::v_z], -double(node));
        EXPECT_EQ(value[near_node::other_r], 0.25);
        EXPECT_EQ(value[near_node::other_z], 0.5);
        EXPECT_EQ(zone.fixed(1)[i], (node % 13 == 0 ? 1 : 0) + (node / 13 == 7 ? 2 : 0));
    }
}

TEST_F(ContactZoneOfTwo, WritesVelocitiesToItsNodesAlone) {
    ASSERT_TRUE(zone.find(a, b));
    zone.gather(a, b, alone);
    for (KeyedNumbers& node : zone.nodes(1)) node.value[near_node::v_r] += 1000.0;
    zone.write(1, b);
    for (std::ptrdiff_t node = 0; node < nodes; ++node) {
        const bool is_in = node / 13 >= 5 && node / 13 <= 8;
        EXPECT_EQ(b_motions[at(node)][motion::v_r], double(node) + (is_in ? 1000.0 : 0.0));
        EXPECT_EQ(b_motions[at(node)][motion::v_z], -double(node));
        EXPECT_EQ(b_motions[at(node)][motion::other_r], 0.25);
    }
}

TEST_F(ContactZoneOfTwo, IsEmptyWhereTheyShareNoNode) {
    for (std::size_t i = 0; i < 13; ++i) a_records[5 * 13 + i].value[record::m] = 0.0;
    EXPECT_FALSE(zone.find(a, b));
    zone.gather(a, b, alone);
    EXPECT_TRUE(zone.nodes(0).empty() && zone.nodes(1).empty());
}

}  // namespace
