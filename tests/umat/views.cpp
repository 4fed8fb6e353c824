// SPDX-License-Identifier: BSD-3-Clause
// Hosts pass their own memory: strides, index lists, four components.
#include "support/batch.hpp"

namespace {

using namespace tests;

constexpr std::size_t n = 29;  // no multiple of any pack

const Sand& sand = four_sands()[0];

Batch expected_batch(int tangent) {
    Batch batch = random_batch(sand, n, 40);
    EXPECT_EQ(batch.update(sand, options_with(1e-5, tangent)), GRIT_OK) << batch.error.message;
    return batch;
}

TEST(Views, APointHasTheSameBitsAloneAndInABatch) {
    for (const int tangent : {GRIT_TANGENT_NONE, GRIT_TANGENT_CONSISTENT}) {
        const Batch expected = expected_batch(tangent);
        const Batch start = random_batch(sand, n, 40);
        for (std::size_t i = 0; i < n; ++i) {
            Point point = start.points[i];
            update(sand, point, start.strain[i].data(), options_with(1e-5, tangent));
            EXPECT_TRUE(same_bits(point, expected.points[i])) << i;
        }
    }
}

TEST(Views, StructureOfArraysGivesTheSameBitsAsArrayOfStructures) {
    const Batch expected = expected_batch(GRIT_TANGENT_CONTINUUM);
    const Batch start = random_batch(sand, n, 40);
    std::vector<double> strain(6 * n), stress(6 * n), state(8 * n), tangent(36 * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < 6; ++c) strain[c * n + i] = start.strain[i][c];
        for (std::size_t c = 0; c < 6; ++c) stress[c * n + i] = start.points[i].stress[c];
        for (std::size_t c = 0; c < 8; ++c) state[c * n + i] = start.points[i].state[c];
    }
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(strain.data(), 1, n);
    q.stress = grit_mutable_view_of(stress.data(), 1, n);
    q.state = grit_mutable_view_of(state.data(), 1, n);
    // column-major matrices, one component of all points after the other
    q.tangent = grit_mutable_matrix_view_of(tangent.data(), 1, n, 6 * n);
    const grit_sand_options options = options_with(1e-5, GRIT_TANGENT_CONTINUUM);
    ASSERT_EQ(grit_sand_update(sand, &options, n, &q, nullptr, nullptr), GRIT_OK);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < 6; ++c)
            EXPECT_EQ(stress[c * n + i], expected.points[i].stress[c]);
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_EQ(state[c * n + i], expected.points[i].state[c]);
        for (std::size_t r = 0; r < 6; ++r)
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_EQ(tangent[(6 * c + r) * n + i], expected.tangents[i][6 * r + c]);
    }
}

TEST(Views, AnIndexListTakesItsPointsAndNoOthers) {
    const Batch start = random_batch(sand, n, 40);
    const Batch expected = expected_batch(GRIT_TANGENT_NONE);
    const std::vector<std::ptrdiff_t> index = {28, 3, 0, 17, 11, 4};
    Batch batch = start;
    grit_sand_points q = batch.views();
    q.index = index.data();
    const grit_sand_options options = options_with();
    ASSERT_EQ(grit_sand_update(sand, &options, 6, &q, batch.reports.data(), nullptr), GRIT_OK);
    for (std::size_t i = 0; i < n; ++i) {
        const bool taken =
            std::find(index.begin(), index.end(), static_cast<std::ptrdiff_t>(i)) != index.end();
        EXPECT_TRUE(same_bits(batch.points[i], taken ? expected.points[i] : start.points[i])) << i;
    }
    for (std::size_t k = 0; k < index.size(); ++k)
        EXPECT_EQ(batch.reports[k].evaluations,
                  expected.reports[static_cast<std::size_t>(index[k])].evaluations);
}

TEST(Views, OneStrainIncrementCanServeAllPoints) {
    Batch shared = random_batch(sand, n, 41);
    Batch copied = shared;
    grit_sand_points q = shared.views();
    q.strain_increment.point_stride = 0;
    for (Voigt& strain : copied.strain) strain = shared.strain[0];
    ASSERT_EQ(shared.update(sand, options_with(), q), GRIT_OK);
    ASSERT_EQ(copied.update(sand, options_with()), GRIT_OK);
    EXPECT_TRUE(same_bits(shared, copied));
}

TEST(Views, FourComponentsAreThePlanePartOfSix) {
    for (const Sand& each : four_sands()) {
        Batch six = random_batch(each, n, 42, true);
        const Batch start = six;
        ASSERT_EQ(six.update(each, options_with(1e-5, GRIT_TANGENT_CONSISTENT)), GRIT_OK);
        for (std::size_t i = 0; i < n; ++i) {
            double strain[4], stress[4], state[8], tangent[16];
            std::copy_n(start.strain[i].begin(), 4, strain);
            std::copy_n(start.points[i].stress, 4, stress);
            std::copy_n(start.points[i].state, 8, state);
            grit_sand_points q{};
            q.struct_size = sizeof q;
            q.components = 4;
            q.strain_increment = grit_view_of(strain, 4, 1);
            q.stress = grit_mutable_view_of(stress, 4, 1);
            q.state = grit_mutable_view_of(state, 8, 1);
            q.tangent = grit_mutable_matrix_view_of(tangent, 16, 4, 1);
            const grit_sand_options options = options_with(1e-5, GRIT_TANGENT_CONSISTENT);
            ASSERT_EQ(grit_sand_update(each, &options, 1, &q, nullptr, nullptr), GRIT_OK);
            EXPECT_EQ(std::memcmp(stress, six.points[i].stress, sizeof stress), 0);
            EXPECT_EQ(std::memcmp(state, six.points[i].state, sizeof state), 0);
            for (std::size_t r = 0; r < 4; ++r)
                for (std::size_t c = 0; c < 4; ++c)
                    EXPECT_EQ(tangent[4 * r + c], six.tangents[i][6 * r + c]);
        }
    }
}

TEST(Views, OfFourComponentsAreRefusedWhereAMemoryLeavesThePlane) {
    for (const int h : {GRIT_SAND_H13, GRIT_SAND_H23}) {
        Batch batch = random_batch(sand, n, 43, true);
        batch.points[2].state[h] = 1e-6;
        const Batch start = batch;
        grit_sand_points q = batch.views();
        q.components = 4;
        EXPECT_EQ(batch.update(sand, options_with(), q), GRIT_BAD_STATE);
        EXPECT_TRUE(same_bits(batch.points[2], start.points[2]));
        EXPECT_EQ(batch.error.point, 2);
        const std::string said = h == GRIT_SAND_H13 ? "got 1e-06 and 0" : "got 0 and 1e-06";
        EXPECT_EQ(batch.error.message, "point 2: h13 and h23 must be 0 with 4 components, " + said);
    }
}

}  // namespace
