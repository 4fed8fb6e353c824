// SPDX-License-Identifier: BSD-3-Clause
// When a node may press, and how hard: two square particles, and a node between or beside them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/box.hpp"

namespace {

using namespace mpm_test;

void correct(ContactPair& pair, const GridView& grid, const ContactBody& a, const ContactBody& b,
             double dt, Exchange& alone) {
    if (pair.find(grid, a, b, alone)) pair.correct(a, b, dt, alone);
}

class GateAtANode : public testing::Test {
  protected:
    static constexpr double half = 0.45;  // of a particle's side; cells are 1 m
    static constexpr int node = 2 * 5 + 2;

    // What the velocities along z, equal and opposite, become where the particles are so far apart.
    double after(double gap, double approach) {
        Body below =
            make_box({2.0 - half, 2.0 + half, 1.0, 1.0 + 2.0 * half, 1, 1, 1000.0}, false, nullptr);
        Body above = make_box(
            {2.0 - half, 2.0 + half, 1.0 + 2.0 * half + gap, 1.0 + 4.0 * half + gap, 1, 1, 1000.0},
            false, nullptr);
        std::vector<NodeRecord> a(25), b(25);
        std::vector<NodeMotion> v_a(25), v_b(25);
        a[node][record::m] = b[node][record::m] = 1.0;
        a[node][record::g_z] = a[node][record::g_scale] = 1.0;
        b[node][record::g_z] = -1.0;
        b[node][record::g_scale] = 1.0;
        v_a[node][motion::v_z] = approach;
        v_b[node][motion::v_z] = -approach;
        const GridView grid{axis.view(), axis.view()};
        correct(pair, grid, {a.data(), v_a.data(), below.particles.view(), 1, false},
                {b.data(), v_b.data(), above.particles.view(), 1, false}, 1e-3, alone);
        return v_a[node][motion::v_z];
    }

    Axis axis = Axis::uniform(0.0, 4.0, 4);
    Exchange alone;
    ContactPair pair{contact_law(GRIT_CONTACT_FRICTIONAL, 0.0), Settings{.axisymmetric = false},
                     GridView{axis.view(), axis.view()}, std::vector<std::uint8_t>(25)};
};

// A node diagonally beyond a corner has weight as far as the diagonal of a cell, and is held as far.
TEST(ReachOfANode, IsTheDiagonalAlongADiagonalNormal) {
    constexpr int node = 2 * 5 + 2;
    const double n = std::sqrt(0.5), corner = 1.2, reach = std::sqrt(2.0);
    Axis axis = Axis::uniform(0.0, 4.0, 4);
    Exchange alone;
    const GridView grid{axis.view(), axis.view()};
    ContactPair pair{contact_law(GRIT_CONTACT_GEO, 0.0, 6.0), Settings{.axisymmetric = false}, grid,
                     std::vector<std::uint8_t>(25)};
    Body below =
        make_box({corner - 0.9, corner, corner - 0.9, corner, 1, 1, 1000.0}, false, nullptr);
    Body above = make_box(
        {corner - 0.01, corner + 0.89, corner - 0.01, corner + 0.89, 1, 1, 1000.0}, false, nullptr);
    std::vector<NodeRecord> a(25), b(25);
    std::vector<NodeMotion> v_a(25), v_b(25);
    a[node][record::m] = b[node][record::m] = 1.0;
    a[node][record::g_r] = a[node][record::g_z] = 1.0;
    b[node][record::g_r] = b[node][record::g_z] = -1.0;
    a[node][record::g_scale] = b[node][record::g_scale] = 2.0;
    v_a[node][motion::v_r] = v_a[node][motion::v_z] = n;
    v_b[node][motion::v_r] = v_b[node][motion::v_z] = -n;
    correct(pair, grid, {a.data(), v_a.data(), below.particles.view(), 1, false},
            {b.data(), v_b.data(), above.particles.view(), 1, false}, 1e-3, alone);
    const double s = (2.0 - corner) * reach;  // more than the edge of a cell
    EXPECT_NEAR(v_a[node][motion::v_r], n * std::pow(s / reach, 6.0), 1e-14);
    EXPECT_NEAR(v_a[node][motion::v_z], n * std::pow(s / reach, 6.0), 1e-14);
}

TEST_F(GateAtANode, LetsBodiesComeUntilTheyMeet) {
    EXPECT_EQ(after(0.1, 1.0), 1.0);
    EXPECT_NEAR(after(-0.01, 1.0), 0.0, 1e-15);
}

TEST_F(GateAtANode, MeasuresTheGapWhereBothBodiesHaveANode) {
    EXPECT_TRUE(std::isnan(pair.faces().largest_gap));
    after(0.1, 1.0);
    EXPECT_NEAR(pair.faces().largest_gap, 0.1, 1e-14);
}

TEST_F(GateAtANode, StaysClosedThroughAJumpOfTheGapWhilePressed) {
    after(-0.01, 1.0);
    EXPECT_NEAR(after(0.4, 1.0), 0.0, 1e-15);
    EXPECT_NEAR(after(0.4, 1.0), 0.0, 1e-15);
}

TEST_F(GateAtANode, OpensByVelocityOrByHalfACell) {
    after(-0.01, 1.0);
    EXPECT_EQ(after(0.6, 1.0), 1.0);
    EXPECT_EQ(after(0.1, 1.0), 1.0);
    after(-0.01, 1.0);
    EXPECT_EQ(after(-0.01, -1.0), -1.0);
    EXPECT_EQ(after(0.1, 1.0), 1.0);
}

// The lower right corner of a body above, a node beyond it, and what lies around.
class CornerAtANode : public testing::Test {
  protected:
    // What the velocities along the diagonal, equal and opposite, become.
    double after(const std::vector<Box>& around, double g_r, double g_z) {
        constexpr int node = 1 * 5 + 2;
        Axis axis = Axis::uniform(0.0, 4.0, 4);
        Exchange alone;
        const GridView grid{axis.view(), axis.view()};
        ContactPair pair{contact_law(GRIT_CONTACT_FRICTIONAL, 0.0), Settings{.axisymmetric = false},
                         grid, std::vector<std::uint8_t>(25)};
        Body above = make_box({0.9, 1.8, 1.2, 2.1, 1, 1, 1000.0}, false, nullptr);
        Body other = make_box(around[0], false, nullptr);
        for (std::size_t i = 1; i < around.size(); ++i)
            other.particles.add(static_cast<int>(i),
                                row_of(make_box(around[i], false, nullptr).particles).data());
        std::vector<NodeRecord> a(25), b(25);
        std::vector<NodeMotion> v_a(25), v_b(25);
        a[node][record::m] = b[node][record::m] = 1.0;
        a[node][record::g_r] = 1.0;
        a[node][record::g_z] = -1.0;
        b[node][record::g_r] = g_r;
        b[node][record::g_z] = g_z;
        a[node][record::g_scale] = b[node][record::g_scale] = 2.0;
        const double n = std::sqrt(0.5);
        v_a[node][motion::v_r] = v_b[node][motion::v_z] = n;
        v_a[node][motion::v_z] = v_b[node][motion::v_r] = -n;
        correct(pair, grid, {a.data(), v_a.data(), above.particles.view(), 1, false},
                {b.data(), v_b.data(), other.particles.view(), other.particles.size(), false}, 1e-3,
                alone);
        return v_a[node][motion::v_r] / n;
    }

    static std::vector<double> row_of(const Particles& q) {
        std::vector<double> row;
        for (int c = 0; c < q.column_count(); ++c) row.push_back(q(c, 0));
        return row;
    }
};

// Along the diagonal the other body reaches behind the corner.
TEST_F(CornerAtANode, IsOpenAboveAFaceThatItDoesNotTouch) {
    for (const double gap : {0.1, 0.01})
        EXPECT_EQ(after({{0.9, 1.8, 0.3 - gap, 1.2 - gap, 1, 1, 1000.0},
                         {1.8, 2.7, 0.3 - gap, 1.2 - gap, 1, 1, 1000.0}},
                        0.0, 1.0),
                  1.0);
}

TEST_F(CornerAtANode, IsOpenBesideAWallThatItDoesNotTouch) {
    EXPECT_EQ(
        after({{1.9, 2.8, 0.3, 1.2, 1, 1, 1000.0}, {1.9, 2.8, 1.2, 2.1, 1, 1, 1000.0}}, -1.0, 0.0),
        1.0);
}

TEST_F(CornerAtANode, IsClosedWhereItTouchesAFaceOrACorner) {
    EXPECT_NEAR(
        after({{0.9, 1.8, 0.3, 1.2, 1, 1, 1000.0}, {1.8, 2.7, 0.3, 1.2, 1, 1, 1000.0}}, 0.0, 1.0),
        0.0, 1e-15);
    EXPECT_NEAR(after({{1.79, 2.69, 0.31, 1.21, 1, 1, 1000.0}}, -1.0, 1.0), 0.0, 1e-15);
}

// A pile in sand: what holds it is below it and beside it, and no direction parts them.
TEST_F(CornerAtANode, IsClosedInACornerThatHoldsIt) {
    EXPECT_NEAR(after({{0.9, 1.8, 0.3, 1.2, 1, 1, 1000.0},
                       {1.8, 2.7, 0.3, 1.2, 1, 1, 1000.0},
                       {1.8, 2.7, 1.2, 2.1, 1, 1, 1000.0}},
                      -1.0, 1.0),
                0.0, 1e-15);
}

}  // namespace
