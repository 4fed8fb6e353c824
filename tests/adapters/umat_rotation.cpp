// SPDX-License-Identifier: BSD-3-Clause
// DROT turns what Abaqus does not turn: h, but not STRESS.
#include <grit/sand_operators.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/umat_call.hpp"

namespace {

// Fortran's DROT(i, j) for a turn by angle about axis 3, anticlockwise.
void turn_about_3(UmatCall& call, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double columns[9] = {c, s, 0, -s, c, 0, 0, 0, 1};
    for (int i = 0; i < 9; ++i) call.drot[i] = columns[i];
}

TEST(UmatRotation, TurnsIntergranularStrainAndNotStress) {
    UmatCall call = UmatCall::hochstetten();
    call.stress[0] = -150.0;
    call.stress[3] = 10.0;
    call.statev[6] = 0.7;
    call.statev[0] = -5e-5;
    const UmatCall before = call;
    const double angle = 0.5;
    turn_about_3(call, angle);
    call.run();
    EXPECT_EQ(call.stress, before.stress);
    const double c = std::cos(angle), s = std::sin(angle);
    EXPECT_NEAR(call.statev[0], -5e-5 * c * c, 1e-18);
    EXPECT_NEAR(call.statev[1], -5e-5 * s * s, 1e-18);
    EXPECT_NEAR(call.statev[3], 2.0 * -5e-5 * c * s, 1e-18) << "engineering shear";
}

TEST(UmatRotation, IsObjective) {
    UmatCall still = UmatCall::hochstetten();
    still.set_dstran(-1e-4, 4e-5, 1e-5, 5e-5);
    still.run();
    // The same point turned by a host: stress and strain increment by the host, h by DROT.
    const double angle = 0.7;
    const double c = std::cos(angle), s = std::sin(angle);
    const double Q[9] = {c, -s, 0, s, c, 0, 0, 0, 1};
    UmatCall turned = still;
    still.set_dstran(-2e-4, 1e-5, 3e-5, -4e-5);
    still.run();
    ASSERT_EQ(grit_sand_rotate(Q, turned.stress.data(), nullptr), GRIT_OK);
    double strain[6] = {-2e-4, 1e-5, 3e-5, -2e-5, 0, 0};  // tensor shear, as a stress
    ASSERT_EQ(grit_sand_rotate(Q, strain, nullptr), GRIT_OK);
    turned.set_dstran(strain[0], strain[1], strain[2], 2 * strain[3], 2 * strain[4], 2 * strain[5]);
    turn_about_3(turned, angle);
    turned.run();
    ASSERT_EQ(turned.pnewdt, 1.0);
    ASSERT_EQ(grit_sand_rotate(Q, still.stress.data(), still.statev.data()), GRIT_OK);
    for (int i = 0; i < 6; ++i) {
        EXPECT_NEAR(turned.stress[i], still.stress[i], 1e-9 * 100.0) << i;
        EXPECT_NEAR(turned.statev[i], still.statev[i], 1e-9 * 1e-4) << i;
    }
}

// Rodrigues: a turn by angle about a unit axis, row-major.
void turn_about(const double axis[3], double angle, double Q[9]) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double skew[9] = {0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            Q[3 * i + j] = (i == j ? c : 0.0) + s * skew[3 * i + j] + (1.0 - c) * axis[i] * axis[j];
}

// A host whose rotations are truncated series hands over a stretch with them.
TEST(UmatRotation, TakesTheRotationThatIsNearestToDrotWhereItIsNearly) {
    const double axis[3] = {1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0};
    double Q[9];
    turn_about(axis, 0.4, Q);
    const auto turned_by = [](const double R[9]) {
        UmatCall call = UmatCall::hochstetten();
        call.set_dstran(-1e-4, 4e-5, 1e-5, 5e-5);
        const double h[6] = {-5e-5, 2e-5, -3e-5, 4e-5, -1e-5, 2e-5};
        for (int c = 0; c < 6; ++c) call.statev[c] = h[c];
        for (int i = 0; i < 9; ++i) call.drot[i % 3 * 3 + i / 3] = R[i];  // column-major
        return call;
    };
    UmatCall exact = turned_by(Q);
    exact.run();
    ASSERT_EQ(exact.pnewdt, 1.0);
    const double stretch[9] = {0.8, -0.3, 0.2, -0.3, -0.5, 0.4, 0.2, 0.4, 0.1};
    for (const double off : {1e-9, 1e-7, 1e-5, 3e-4, 3e-3}) {
        double R[9];  // Q (1 + off S)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                R[3 * i + j] = Q[3 * i + j];
                for (int k = 0; k < 3; ++k) R[3 * i + j] += off * Q[3 * i + k] * stretch[3 * k + j];
            }
        UmatCall call = turned_by(R);
        call.run();
        EXPECT_EQ(call.pnewdt, 1.0) << off;
        for (int c = 0; c < 6; ++c) {
            EXPECT_NEAR(call.statev[c], exact.statev[c], 1e-12 * 1e-4) << off;
            EXPECT_NEAR(call.stress[c], exact.stress[c], 1e-10) << off;
        }
    }
    for (double& entry : Q) entry *= 1.02;
    UmatCall far = turned_by(Q);
    EXPECT_NE(far.complaint().find("proper orthogonal"), std::string::npos);
}

TEST(UmatRotation, IsRefusedWithoutStrainTooWhereDrotResemblesOneButIsOff) {
    const double axis[3] = {1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0};
    for (const double scale : {0.8, 0.98, 1.02, 1.2}) {
        double Q[9];
        turn_about(axis, 0.4, Q);
        UmatCall call = UmatCall::hochstetten();
        const double h[6] = {-5e-5, 2e-5, -3e-5, 4e-5, -1e-5, 2e-5};
        for (int c = 0; c < 6; ++c) call.statev[c] = h[c];
        for (int i = 0; i < 9; ++i) call.drot[i % 3 * 3 + i / 3] = scale * Q[i];
        EXPECT_NE(call.complaint().find("proper orthogonal"), std::string::npos) << scale;
        EXPECT_LT(call.pnewdt, 1.0);
        for (int c = 0; c < 6; ++c) EXPECT_EQ(call.statev[c], h[c]);
    }
}

TEST(UmatRotation, TurnsByNinetyDegreesInTenIncrementsAboutAnyAxis) {
    const double quarter = 1.5707963267948966, third = 1.0 / 3.0, half = std::sqrt(0.5);
    const double axes[][3] = {
        {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {third, -2 * third, 2 * third}, {half, 0, -half}};
    for (const auto& axis : axes) {
        UmatCall call = UmatCall::hochstetten();
        const double stress[6] = {-150, -90, -110, 12, -7, 21};
        const double h[6] = {-5e-5, 2e-5, -3e-5, 4e-5, -1e-5, 6e-5};
        for (int c = 0; c < 6; ++c) {
            call.stress[c] = stress[c];
            call.statev[c] = h[c];
        }
        double step[9], whole[9], expected[GRIT_SAND_STATE_SIZE] = {}, turned[6];
        turn_about(axis, quarter / 10.0, step);
        turn_about(axis, quarter, whole);
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) call.drot[r + 3 * c] = step[3 * r + c];
        for (int i = 0; i < 10; ++i) {  // the host turns STRESS before each call
            ASSERT_EQ(grit_sand_rotate(step, call.stress.data(), nullptr), GRIT_OK);
            call.run();
            ASSERT_EQ(call.pnewdt, 1.0);
        }
        for (int c = 0; c < 6; ++c) {
            expected[c] = h[c];
            turned[c] = stress[c];
        }
        ASSERT_EQ(grit_sand_rotate(whole, turned, expected), GRIT_OK);
        for (int c = 0; c < 6; ++c) {
            EXPECT_NEAR(call.statev[c], expected[c], 1e-12 * 1e-4) << c;
            EXPECT_NEAR(call.stress[c], turned[c], 1e-12 * 200.0) << c;
        }
        EXPECT_GT(std::abs(call.statev[0] - h[0]) + std::abs(call.statev[3] - h[3]), 1e-5);
    }
}

TEST(UmatRotation, TakesAZeroMatrixAsNone) {
    UmatCall with = UmatCall::hochstetten();
    with.set_dstran(-1e-4, 4e-5, 1e-5, 5e-5);
    UmatCall without = with;
    for (double& entry : without.drot) entry = 0.0;
    with.run();
    without.run();
    EXPECT_TRUE(without.same_results(with));
}

TEST(UmatRotation, TakesAZeroMatrixAsNoneInThePlaneToo) {
    UmatCall with = UmatCall::hochstetten();
    with.use_components(4);
    with.set_dstran(-1e-4, 4e-5, 1e-5, 5e-5);
    UmatCall without = with;
    for (double& entry : without.drot)
        entry = std::nan("");  // what is not of the plane is not read
    for (const int in_plane : {0, 1, 3, 4}) without.drot[in_plane] = 0.0;
    with.run();
    without.run();
    EXPECT_EQ(without.pnewdt, 1.0);
    EXPECT_TRUE(without.same_results(with));
}

// A host that has not set DROT yet hands over what its memory held.
TEST(UmatRotation, TakesDenormalsAsZeros) {
    for (const int components : {6, 4}) {
        UmatCall with = UmatCall::hochstetten();
        with.use_components(components);
        with.set_dstran(-1e-4, 4e-5, 1e-5, 5e-5);
        UmatCall without = with;
        for (std::size_t i = 0; i < 9; ++i) without.drot[i] = i % 2 ? 6.9e-310 : -5e-324;
        with.run();
        without.run();
        EXPECT_EQ(without.pnewdt, 1.0);
        EXPECT_TRUE(without.same_results(with));
    }
}

TEST(UmatRotation, IsNotLookedForWithoutStrainWhereDrotIsNone) {
    const double nan = std::nan(""), infinite = HUGE_VAL;
    for (const int components : {6, 4, 3})
        for (const double entry : {6.9e-310, 1e-300, 1e-5, -0.7, 3.0, 1e300, infinite, nan}) {
            UmatCall with = UmatCall::hochstetten();
            with.use_components(components);
            with.statev[0] = -5e-5;
            UmatCall without = with;
            for (const std::size_t i : {0U, 1U, 4U, 8U}) without.drot[i] = entry;
            with.run();
            without.run();
            EXPECT_EQ(without.pnewdt, 1.0) << entry;
            EXPECT_TRUE(without.same_results(with)) << entry;
            EXPECT_GT(without.ddsdde[0], 0.0) << entry;
        }
}

TEST(UmatRotation, StaysInThePlaneWithFourComponents) {
    UmatCall full = UmatCall::hochstetten();
    full.statev[0] = -5e-5;
    UmatCall plane = full;
    plane.use_components(4);
    for (UmatCall* call : {&full, &plane}) {
        turn_about_3(*call, 0.3);
        call->set_dstran(-1e-4, 4e-5, 1e-5, 5e-5);
        call->run();
        ASSERT_EQ(call->pnewdt, 1.0);
    }
    EXPECT_EQ(plane.statev, full.statev);
    for (int c = 0; c < 4; ++c) EXPECT_EQ(plane.stress[c], full.stress[c]);
    EXPECT_EQ(plane.statev[4], 0.0);
    EXPECT_EQ(plane.statev[5], 0.0);
}

TEST(UmatRotation, RefusesAMatrixThatDoesNotRotate) {
    UmatCall call = UmatCall::hochstetten();
    call.set_dstran(-1e-4, 4e-5, 1e-5, 5e-5);
    call.drot[0] = 1.1;
    const UmatCall before = call;
    EXPECT_NE(call.complaint().find("rotation_increment"), std::string::npos);
    EXPECT_LT(call.pnewdt, 1.0);
    EXPECT_TRUE(call.same_results(before));
}

}  // namespace
