// SPDX-License-Identifier: BSD-3-Clause
#include "support/batch.hpp"

namespace {

using namespace tests;

const Sand& sand = four_sands()[0];

std::array<double, 9> row_major(const Full& Q) {
    std::array<double, 9> q{};
    for (std::size_t i = 0; i < 9; ++i) q[i] = Q(static_cast<int>(i / 3), static_cast<int>(i % 3));
    return q;
}

// A quarter turn about axis 3 takes 11 to 22 and changes the sign of 12.
TEST(Rotation, OfAQuarterTurnExchangesAxes) {
    const double Q[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
    double stress[6] = {1, 2, 3, 4, 5, 6};
    double state[8] = {1, 2, 3, 4, 5, 6, 0.7, 0.2};
    ASSERT_EQ(grit_sand_rotate(Q, stress, state), GRIT_OK);
    const double expected[6] = {2, 1, 3, -4, -6, 5};
    for (int c = 0; c < 6; ++c) {
        EXPECT_NEAR(stress[c], expected[c], 1e-14);
        EXPECT_NEAR(state[c], expected[c], 1e-14);
    }
    EXPECT_EQ(state[GRIT_SAND_VOID_RATIO], 0.7);
    EXPECT_EQ(state[GRIT_SAND_SEPARATION], 0.2);
    EXPECT_EQ(grit_sand_rotate(Q, nullptr, nullptr), GRIT_OK);
}

TEST(Rotation, MustBeProperAndOrthogonal) {
    double stress[6] = {1, 2, 3, 4, 5, 6};
    const double mirror[9] = {-1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double stretched[9] = {1.1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double undefined[9] = {std::nan(""), 0, 0, 0, 1, 0, 0, 0, 1};
    for (const double* Q : {mirror, stretched, undefined}) {
        EXPECT_EQ(grit_sand_rotate(Q, stress, nullptr), GRIT_BAD_CALL);
        EXPECT_EQ(stress[0], 1.0);
        Batch batch = random_batch(sand, 1, 60);
        const Batch start = batch;
        grit_sand_points q = batch.views();
        q.rotation_increment = grit_view_of(Q, 0, 1);
        EXPECT_EQ(batch.update(sand, options_with(), q), GRIT_BAD_CALL);
        EXPECT_NE(std::string(batch.error.message).find("proper orthogonal"), std::string::npos);
        EXPECT_TRUE(same_bits(batch, start));
    }
}

// An increment with Q is a rotation of stress and h, then the increment in the end configuration.
TEST(Rotation, ComesBeforeTheStrainIncrement) {
    Random random(61);
    for (int i = 0; i < 20; ++i) {
        const auto Q = row_major(random.rotation());
        Batch together = random_batch(sand, 1, 62 + static_cast<std::uint64_t>(i));
        Batch apart = together, host_turns_stress = together;
        grit_sand_points q = together.views();
        q.rotation_increment = grit_view_of(Q.data(), 9, 1);
        ASSERT_EQ(together.update(sand, options_with(), q), GRIT_OK);

        Point& point = apart.points[0];
        ASSERT_EQ(grit_sand_rotate(Q.data(), point.stress, point.state), GRIT_OK);
        ASSERT_EQ(apart.update(sand, options_with()), GRIT_OK);
        const State a = state_of(together.points[0]), b = state_of(apart.points[0]);
        EXPECT_LE((a.T - b.T).norm(), 1e-11 * b.T.norm());
        EXPECT_LE((a.h - b.h).norm(), 1e-11 * sand.p.elastic_strain_radius);

        grit_sand_options options = options_with();
        options.stress_is_rotated = 1;
        q = host_turns_stress.views();
        q.rotation_increment = grit_view_of(Q.data(), 9, 1);
        ASSERT_EQ(grit_sand_rotate(Q.data(), host_turns_stress.points[0].stress, nullptr), GRIT_OK);
        ASSERT_EQ(host_turns_stress.update(sand, options, q), GRIT_OK);
        const State c = state_of(host_turns_stress.points[0]);
        EXPECT_LE((c.T - b.T).norm(), 1e-11 * b.T.norm());
        EXPECT_LE((c.h - b.h).norm(), 1e-11 * sand.p.elastic_strain_radius);
    }
}

TEST(Rotation, ByNothingChangesNoBit) {
    for (const Sand& each : four_sands()) {
        Random random(52);
        for (int i = 0; i < 50; ++i) {
            const Point start = point_of(random_state(each, random));
            Point point = start;
            const double identity_matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
            const double none[6] = {};
            grit_sand_points q{};
            q.struct_size = sizeof q;
            q.strain_increment = grit_view_of(none, 6, 1);
            q.rotation_increment = grit_view_of(identity_matrix, 9, 1);
            q.stress = grit_mutable_view_of(point.stress, 6, 1);
            q.state = grit_mutable_view_of(point.state, GRIT_SAND_STATE_SIZE, 1);
            ASSERT_EQ(grit_sand_update(each, nullptr, 1, &q, nullptr, nullptr), GRIT_OK);
            EXPECT_TRUE(same_bits(point, start));
        }
    }
}

TEST(Rotation, ByNothingChangesNoBitOfAStrainedBatchEither) {
    const double identity_matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (const Sand& each : four_sands()) {
        Batch turned = random_batch(each, 64, 53), still = turned;
        grit_sand_points q = turned.views();
        q.rotation_increment = grit_view_of(identity_matrix, 0, 1);
        ASSERT_EQ(turned.update(each, options_with(), q), still.update(each, options_with()));
        for (std::size_t i = 0; i < 64; ++i)
            EXPECT_TRUE(same_bits(turned.points[i], still.points[i])) << i;
    }
}

TEST(Rotation, WithoutStrainTurnsStressAndMemoryOnly) {
    Random random(63);
    const Full Q = random.rotation();
    const auto q9 = row_major(Q);
    Batch batch = random_batch(sand, 1, 64);
    batch.strain[0].fill(0.0);
    const State start = state_of(batch.points[0]);
    grit_sand_points q = batch.views();
    q.rotation_increment = grit_view_of(q9.data(), 9, 1);
    ASSERT_EQ(batch.update(sand, options_with(), q), GRIT_OK);
    const State end = state_of(batch.points[0]);
    EXPECT_LE((end.T - rotated(Q, start.T)).norm(), 1e-13 * start.T.norm());
    EXPECT_LE((end.h - rotated(Q, start.h)).norm(), 1e-13 * sand.p.elastic_strain_radius);
    EXPECT_EQ(end.e, start.e);
}

// Rigid rotation of the whole experiment, step by step, leaves the material answer alone.
TEST(Rotation, OfTheWholePathIsNotSeenByTheMaterial) {
    Random random(65);
    const Full Q = Eigen::AngleAxisd(0.05, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).matrix();
    const auto q9 = row_major(Q);
    Batch turning = random_batch(sand, 1, 66), still = turning;
    const Vec dE = 2e-4 * (deviator(random.direction()) - 0.2 * identity()).normalized();
    Full total = Full::Identity();
    for (int i = 0; i < 30; ++i) {
        total = Q * total;
        turning.strain[0] = voigt_strain(rotated(total, dE));
        still.strain[0] = voigt_strain(dE);
        grit_sand_points q = turning.views();
        q.rotation_increment = grit_view_of(q9.data(), 9, 1);
        ASSERT_EQ(turning.update(sand, options_with(1e-9), q), GRIT_OK);
        ASSERT_EQ(still.update(sand, options_with(1e-9)), GRIT_OK);
    }
    const State a = state_of(turning.points[0]), b = state_of(still.points[0]);
    EXPECT_LE((a.T - rotated(total, b.T)).norm(), 1e-7 * b.T.norm());
    EXPECT_LE((a.h - rotated(total, b.h)).norm(), 1e-7 * sand.p.elastic_strain_radius);
}

}  // namespace
