// SPDX-License-Identifier: BSD-3-Clause
// When a node may press, and how hard: two square particles, and a node between or beside them.
#include <gtest/gtest.h>

#include <cmath>

#include "support/box.hpp"

namespace {

using namespace mpm_test;

class TwoSquares : public testing::Test {
  protected:
    static constexpr double side = 0.9;  // of a particle; cells are 1 m
    static constexpr int node = 2 * 5 + 2;

    explicit TwoSquares(const ContactLaw& law)
        : pair{law, Settings{.axisymmetric = false}, GridView{axis.view(), axis.view()},
               std::vector<std::uint8_t>(25)} {}

    // What the first one's velocity at the node becomes. below, above: lower left corners; both come along the
    // normal with this speed.
    Vector after(const Vector& below, const Vector& above, const Vector& normal, double speed) {
        const auto square = [](const Vector& x) {
            return make_box({x.r, x.r + side, x.z, x.z + side, 1, 1, 1000.0}, false, nullptr);
        };
        Body first = square(below), second = square(above);
        std::vector<NodeRecord> a(25), b(25);
        std::vector<NodeMotion> v_a(25), v_b(25);
        const auto set = [&](NodeRecord& at, NodeMotion& v, double sign) {
            at[record::m] = 1.0;
            at[record::g_r] = sign * normal.r;
            at[record::g_z] = sign * normal.z;
            at[record::g_scale] = 1.0;
            v[motion::v_r] = sign * speed * normal.r;
            v[motion::v_z] = sign * speed * normal.z;
        };
        set(a[node], v_a[node], 1.0);
        set(b[node], v_b[node], -1.0);
        const GridView grid{axis.view(), axis.view()};
        pair.correct(grid, {a.data(), v_a.data(), first.particles.view(), 1, false},
                     {b.data(), v_b.data(), second.particles.view(), 1, false}, 1e-3, alone);
        return {v_a[node][motion::v_r], v_a[node][motion::v_z]};
    }

    Axis axis = Axis::uniform(0.0, 4.0, 4);
    Exchange alone;
    ContactPair pair;
};

class ReachOfANode : public TwoSquares {
  protected:
    ReachOfANode() : TwoSquares(contact_law(GRIT_CONTACT_GEO, 0.0, 6.0)) {}
};

// A node diagonally beyond a corner has weight as far as the diagonal of a cell, and is held as far.
TEST_F(ReachOfANode, IsTheDiagonalAlongADiagonalNormal) {
    const double n = std::sqrt(0.5), corner = 1.2, reach = std::sqrt(2.0);
    const double s = (2.0 - corner) * reach;  // more than the edge of a cell
    const Vector v =
        after({corner - side, corner - side}, {corner - 0.01, corner - 0.01}, {n, n}, 1.0);
    EXPECT_NEAR(v.r, n * std::pow(s / reach, 6.0), 1e-14);
    EXPECT_NEAR(v.z, n * std::pow(s / reach, 6.0), 1e-14);
}

class GateAtANode : public TwoSquares {
  protected:
    GateAtANode() : TwoSquares(contact_law(GRIT_CONTACT_FRICTIONAL, 0.0)) {}

    // Along z, where the particles are so far apart.
    double after(double gap, double approach) {
        const double left = 2.0 - 0.5 * side;
        return TwoSquares::after({left, 1.0}, {left, 1.0 + side + gap}, {0.0, 1.0}, approach).z;
    }
};

TEST_F(GateAtANode, LetsBodiesComeUntilTheyMeet) {
    EXPECT_EQ(after(0.1, 1.0), 1.0);
    EXPECT_NEAR(after(-0.01, 1.0), 0.0, 1e-15);
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

}  // namespace
