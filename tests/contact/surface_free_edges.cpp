// SPDX-License-Identifier: BSD-3-Clause
// Which edges of particles' domains are free, and which vertices they share.
#include <cmath>
#include <random>
#include <vector>

#include <grit/contact_surface.h>
#include <gtest/gtest.h>

namespace {

struct Domains {
    std::vector<double> data;  // x, r_1, r_2 of a particle
    std::vector<double> position;
    std::vector<std::ptrdiff_t> facet, owner, index;  // no index: all
    std::ptrdiff_t vertices = -1, facets = -1;
    double tolerance = 0.25;
    grit_error error{};

    void add(double x, double y, double r1x, double r1y, double r2x, double r2y) {
        data.insert(data.end(), {x, y, r1x, r1y, r2x, r2y});
    }
    grit_status find() {
        const std::size_t n = data.size() / 6;
        grit_surface_domains d{};
        d.struct_size = sizeof d;
        d.n = static_cast<std::ptrdiff_t>(n);
        d.position = grit_view_of(data.data(), 6, 1);
        d.side = grit_matrix_view_of(data.data() + 2, 6, 2, 1);
        d.tolerance = tolerance;
        d.index = index.empty() ? nullptr : index.data();
        position.assign(8 * n, 0.0);
        facet.assign(8 * n, -1);
        owner.assign(4 * n, -1);
        std::vector<double> workspace(grit_surface_find_free_workspace_size(d.n) / 8 + 1);
        return grit_surface_find_free(&d, workspace.data(), workspace.size() * 8, position.data(),
                                      facet.data(), owner.data(), &vertices, &facets, &error);
    }
    double length() const {
        double sum = 0.0;
        for (std::size_t f = 0; f < static_cast<std::size_t>(facets); ++f) {
            const auto a = static_cast<std::size_t>(facet[2 * f]);
            const auto b = static_cast<std::size_t>(facet[2 * f + 1]);
            sum += std::hypot(position[2 * b] - position[2 * a],
                              position[2 * b + 1] - position[2 * a + 1]);
        }
        return sum;
    }
    // Enclosed, positive if the body is on the left.
    double area() const {
        double sum = 0.0;
        for (std::size_t f = 0; f < static_cast<std::size_t>(facets); ++f) {
            const auto a = 2 * static_cast<std::size_t>(facet[2 * f]);
            const auto b = 2 * static_cast<std::size_t>(facet[2 * f + 1]);
            sum += 0.5 * (position[a] * position[b + 1] - position[a + 1] * position[b]);
        }
        return sum;
    }
};

// n x m cells of one, deformed by F, with some noise.
Domains block(int n, int m, const double (&F)[4], double noise = 0.0) {
    Domains out;
    std::mt19937_64 random(5);
    const auto dice = [&] {
        return noise * (2.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 1.0);
    };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const double x = i + 0.5, y = j + 0.5;
            out.add(F[0] * x + F[1] * y + dice(), F[2] * x + F[3] * y + dice(),
                    0.5 * (F[0] + dice()), 0.5 * (F[2] + dice()), 0.5 * (F[1] + dice()),
                    0.5 * (F[3] + dice()));
        }
    return out;
}

TEST(FreeEdges, GoAroundABlockHoweverItIsDeformed) {
    const double all[][4] = {
        {1, 0, 0, 1}, {0.6, -0.8, 0.8, 0.6}, {1, 0.9, 0, 1}, {2, 0, 0, 0.5}, {1, 0.5, -0.5, 0.3}};
    for (const auto& F : all) {
        Domains d = block(6, 4, F);
        ASSERT_EQ(d.find(), GRIT_OK) << d.error.message;
        EXPECT_EQ(d.facets, 20);
        EXPECT_EQ(d.vertices, 20);
        EXPECT_NEAR(d.length(), 12.0 * std::hypot(F[0], F[2]) + 8.0 * std::hypot(F[1], F[3]),
                    1e-12);
        EXPECT_NEAR(d.area(), 24.0 * (F[0] * F[3] - F[1] * F[2]), 1e-12);
        for (std::size_t f = 0; f < 20; ++f) {  // an owner at the rim
            const std::ptrdiff_t i = d.owner[f] % 6, j = d.owner[f] / 6;
            EXPECT_TRUE(i == 0 || i == 5 || j == 0 || j == 3);
        }
    }
}

TEST(FreeEdges, BridgeGapsAndOverlapsUpToTheToleranceAndNoWiderOnes) {
    const double upright[4] = {1, 0, 0, 1};
    Domains rough = block(6, 4, upright, 0.05);
    ASSERT_EQ(rough.find(), GRIT_OK);
    EXPECT_EQ(rough.facets, 20);
    EXPECT_EQ(rough.vertices, 20);
    EXPECT_NEAR(rough.area(), 24.0, 1.0);
    for (const double gap : {0.2, 0.3}) {
        Domains d;
        d.add(0.5, 0.5, 0.5, 0.0, 0.0, 0.5);
        d.add(1.5 + gap, 0.5, 0.5, 0.0, 0.0, 0.5);
        ASSERT_EQ(d.find(), GRIT_OK);
        EXPECT_EQ(d.facets, gap < 0.25 ? 6 : 8) << gap;
        EXPECT_EQ(d.vertices, gap < 0.25 ? 6 : 8) << gap;
    }
}

TEST(FreeEdges, OfAHoleAreFound) {
    const double upright[4] = {1, 0, 0, 1};
    Domains d = block(5, 5, upright);
    d.data.erase(d.data.begin() + 6 * 12, d.data.begin() + 6 * 13);
    ASSERT_EQ(d.find(), GRIT_OK);
    EXPECT_EQ(d.facets, 24);
    EXPECT_NEAR(d.area(), 24.0, 1e-12);
}

TEST(FreeEdges, ThatAreCoveredInPartCountIfAPieceAsWideAsTheToleranceIsOpen) {
    Domains d;
    d.add(0.5, 0.5, 0.5, 0.0, 0.0, 0.5);
    d.add(1.5, 0.8, 0.5, 0.0, 0.0, 0.5);  // covers 0.7 of the right edge of the first
    ASSERT_EQ(d.find(), GRIT_OK);
    EXPECT_EQ(d.facets, 8);
    d.data[7] = 0.7;  // 0.8 of it
    ASSERT_EQ(d.find(), GRIT_OK);
    EXPECT_EQ(d.facets, 6);
    d.tolerance = 0.1;
    ASSERT_EQ(d.find(), GRIT_OK);
    EXPECT_EQ(d.facets, 8);
}

TEST(FreeEdges, AreNotThoseOfTwoNarrowGaps) {
    const double upright[4] = {1, 0, 0, 1};
    Domains d = block(1, 1, upright);
    d.add(0.5, 1.5, 0.3, 0.0, 0.0, 0.5);  // above, a fifth is open on each side
    ASSERT_EQ(d.find(), GRIT_OK);
    EXPECT_EQ(d.facets, 6);
    d.data[8] = 0.25;  // a quarter and more, on the left 0.15
    d.data[6] = 0.4;
    ASSERT_EQ(d.find(), GRIT_OK);
    EXPECT_EQ(d.facets, 7);
}

TEST(FreeEdges, OfNothingAreNoneAndOfBadDomainsRefused) {
    Domains d;
    ASSERT_EQ(d.find(), GRIT_OK) << d.error.message;
    EXPECT_EQ(d.facets, 0);
    EXPECT_EQ(d.vertices, 0);
    d.add(0.0, 0.0, 0.5, 0.0, 0.0, -0.5);
    EXPECT_EQ(d.find(), GRIT_BAD_STATE);
    EXPECT_STREQ(d.error.message,
                 "particle 0: the area of its domain must be > 0 (length^2), got -1");
    EXPECT_EQ(d.error.point, 0);
    d.data[1] = std::nan("");
    EXPECT_EQ(d.find(), GRIT_BAD_STATE);
    d.index = {-1};
    EXPECT_EQ(d.find(), GRIT_BAD_CALL);
    EXPECT_STREQ(d.error.message, "entry 0 of index must be >= 0, got -1");
    d.tolerance = 0.6;
    EXPECT_EQ(d.find(), GRIT_BAD_CALL);
    EXPECT_STREQ(d.error.message, "tolerance must be in (0, 0.5], got 0.6");
}

TEST(FreeEdges, OfNoDomainsTakeMemoryToo) {
    EXPECT_GT(grit_surface_find_free_workspace_size(0), 0U);
    EXPECT_EQ(grit_surface_find_free_workspace_size(-1), 0U);
}

}  // namespace
