// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_normals_by_regression at the border: batches, lists, workspace, bad input.
#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include <grit/version.h>

#include "support/clouds.hpp"

namespace {

using namespace tests;

constexpr int nodes = 13;

std::vector<Cloud> clouds(int components) {
    Dice dice(40);
    std::vector<Cloud> all;
    for (int i = 0; i < nodes; ++i)
        all.push_back(parted_cloud(components, 2 + 3 * i, i % 2 ? 0.3 : 0.0, dice));
    return all;
}

bool says(const Clouds& x, const char* part) {
    return std::string(x.error.message).find(part) != std::string::npos;
}

TEST(RegressionCall, GivesANodeTheSameBitsAloneAndInABatchOnEveryInstructionSet) {
    for (const int components : {2, 3})
        for (int isa = GRIT_ISA_BASELINE; isa <= grit_instruction_set(); ++isa) {
            const auto all = clouds(components);
            Clouds batch(components, all);
            grit_contact_clouds q = batch.views();
            q.instruction_set = isa;
            ASSERT_EQ(batch.regress(q), GRIT_OK);
            EXPECT_EQ(batch.counts.defined, nodes);
            for (std::size_t i = 0; i < all.size(); ++i) {
                EXPECT_EQ(batch.normal_at(i), regressed(components, all[i], 0.0, 1.0, 0, isa));
                EXPECT_LT((batch.normal_at(i) - regressed(components, all[i])).norm(), 1e-11);
            }
        }
}

TEST(RegressionCall, GivesTheSameBitsFromAnotherNumberingStrideAndWorkspace) {
    Clouds x(3, clouds(3)), y(3, clouds(3));
    ASSERT_EQ(x.regress(x.views()), GRIT_OK);
    const auto count = static_cast<std::ptrdiff_t>(y.body.size());
    std::vector<std::ptrdiff_t> id(y.body.size());
    std::vector<double> position(3 * id.size()), normal(3 * nodes);
    std::vector<int> body(5 * id.size());
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto p = static_cast<std::size_t>((7 * k + 3) % count);  // 7 does not divide it
        id[static_cast<std::size_t>(k)] = static_cast<std::ptrdiff_t>(p);
        body[5 * p] = y.body[static_cast<std::size_t>(k)];
        for (std::size_t c = 0; c < 3; ++c)
            position[c * id.size() + p] = y.position[3 * static_cast<std::size_t>(k) + c];
    }
    ASSERT_NE(count % 7, 0);
    y.workspace.resize(3 * y.workspace.size() + 5);
    grit_contact_clouds q = y.views();
    q.particle = id.data();
    q.position = grit_view_of(position.data(), 1, count);
    q.body = body.data();
    q.body_stride = 5;
    q.weight.base = nullptr;
    q.fixed = nullptr;
    q.status = nullptr;
    q.normal = grit_mutable_view_of(normal.data(), 1, nodes);
    ASSERT_EQ(grit_contact_normals_by_regression(nodes, &q, y.workspace.data() + 3,
                                                 y.workspace.size() - 3, nullptr, nullptr),
              GRIT_OK);
    for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(normal[c * nodes + i], x.normal[3 * i + c]);
}

TEST(RegressionCall, TakesWeightsUpToTheirLimits) {
    for (const double weight : {1e-100, 1e100}) {
        Clouds x(2, clouds(2)), ones(2, clouds(2));
        std::fill(x.weight.begin(), x.weight.end(), weight);
        std::fill(ones.weight.begin(), ones.weight.end(), 1.0);
        ASSERT_EQ(ones.regress(ones.views()), GRIT_OK);
        ASSERT_EQ(x.regress(x.views()), GRIT_OK);
        for (std::size_t i = 0; i < x.normal.size(); ++i)
            EXPECT_NEAR(x.normal[i], ones.normal[i], 1e-9);
    }
}

TEST(RegressionCall, TakesTheNodesOfAnIndexListAndNoOthers) {
    Clouds all(2, clouds(2)), some(2, clouds(2));
    all.fixed[4] = some.fixed[4] = GRIT_CONTACT_FIXED_1;
    ASSERT_EQ(all.regress(all.views()), GRIT_OK);
    const std::vector<std::ptrdiff_t> index = {11, 4, 7};
    grit_contact_clouds q = some.views();
    q.index = index.data();
    ASSERT_EQ(grit_contact_normals_by_regression(3, &q, some.workspace.data(),
                                                 some.workspace.size(), &some.counts, nullptr),
              GRIT_OK);
    EXPECT_EQ(some.counts.defined, 3);
    for (std::size_t i = 0; i < nodes; ++i) {
        const bool taken = i == 11 || i == 4 || i == 7;
        for (std::size_t c = 0; c < 2; ++c)
            EXPECT_EQ(some.normal[2 * i + c], taken ? all.normal[2 * i + c] : 7.0);
    }
}

TEST(RegressionCall, ThatIsCutInPiecesGivesTheSameBits) {
    Clouds whole(3, clouds(3)), pieces(3, clouds(3));
    ASSERT_EQ(whole.regress(whole.views()), GRIT_OK);
    for (std::ptrdiff_t first = 0; first < nodes; first += 5) {
        grit_contact_clouds q = pieces.views();
        q.offset += first;
        q.fixed += first;
        q.status += first;
        q.normal.base += 3 * first;
        const std::ptrdiff_t n = std::min<std::ptrdiff_t>(5, nodes - first);
        EXPECT_EQ(grit_contact_normals_by_regression(n, &q, pieces.workspace.data(),
                                                     pieces.workspace.size(), nullptr, nullptr),
                  GRIT_OK);
    }
    EXPECT_TRUE(same_bits(whole.normal, pieces.normal));
}

TEST(RegressionCall, RefusesAWorkspaceThatIsTooSmallForANode) {
    for (const int components : {2, 3}) {
        Clouds x(components, clouds(components));
        const auto before = x.normal;
        x.workspace.resize(x.workspace.size() - 1);
        EXPECT_EQ(x.regress(x.views()), GRIT_BAD_CALL);
        EXPECT_EQ(x.error.point, -1);
        EXPECT_STREQ(x.error.message, "workspace holds 32 particles per node, node 11 has 35: see "
                                      "grit_contact_regression_workspace_size");
        EXPECT_TRUE(same_bits(x.normal, before));
        x.workspace.resize(1);
        EXPECT_EQ(x.regress(x.views()), GRIT_BAD_CALL);
        const grit_contact_clouds q = x.views();
        EXPECT_EQ(grit_contact_normals_by_regression(1, &q, nullptr, 1000, nullptr, &x.error),
                  GRIT_BAD_CALL);
        EXPECT_TRUE(says(x, "workspace is null"));
    }
    EXPECT_EQ(grit_contact_regression_workspace_size(-1, 3), 0u);
    EXPECT_EQ(grit_contact_regression_workspace_size(16, 4), 0u);
    EXPECT_EQ(grit_contact_regression_workspace_size(PTRDIFF_MAX, 2), 0u);
    EXPECT_GT(grit_contact_regression_workspace_size(0, 2), 0u);
}

TEST(RegressionCall, LeavesABadNodeAloneAndDoesTheOthers) {
    const auto expect_failure = [](const std::function<void(Clouds&)>& spoil, grit_status status,
                                   const char* message) {
        Clouds good(2, clouds(2)), x(2, clouds(2));
        ASSERT_EQ(good.regress(good.views()), GRIT_OK);
        spoil(x);
        EXPECT_EQ(x.regress(x.views()), status);
        EXPECT_EQ(x.error.status, status);
        EXPECT_EQ(x.error.point, 3);
        EXPECT_STREQ(x.error.message, message);
        EXPECT_EQ(x.counts.failed, 1);
        EXPECT_EQ(x.counts.defined, nodes - 1);
        for (std::size_t i = 0; i < nodes; ++i) {
            EXPECT_EQ(x.status[i], i == 3 ? status : GRIT_OK);
            EXPECT_EQ(x.normal_at(i), i == 3 ? Vec3(7.0, 7.0, 0.0) : good.normal_at(i));
        }
    };
    const double inf = std::numeric_limits<double>::infinity();
    // node 3 has the particles 15 ... 25
    expect_failure([](Clouds& x) { x.position[2 * 17 + 1] = std::nan(""); }, GRIT_BAD_STATE,
                   "node 3: position component 1 of particle 17 must be finite, got nan");
    expect_failure([=](Clouds& x) { x.position[2 * 25] = inf; }, GRIT_BAD_STATE,
                   "node 3: position component 0 of particle 25 must be finite, got inf");
    expect_failure([](Clouds& x) { x.weight[16] = -2.0; }, GRIT_BAD_STATE,
                   "node 3: weight of particle 16 must be 0 or in [1e-100, 1e+100], got -2");
    expect_failure([](Clouds& x) { x.weight[16] = std::nan(""); }, GRIT_BAD_STATE,
                   "node 3: weight of particle 16 must be 0 or in [1e-100, 1e+100], got nan");
    expect_failure([](Clouds& x) { x.position[2 * 18] += 203.0; }, GRIT_BAD_STATE,
                   "node 3: particle 18 is more than 200 lengths of 1 from another: units?");
    expect_failure([](Clouds& x) { x.position[2 * 18] = 1e308; }, GRIT_BAD_STATE,
                   "node 3: particle 18 is more than 200 lengths of 1 from another: units?");
    expect_failure([](Clouds& x) { x.body[20] = 2; }, GRIT_BAD_CALL,
                   "node 3: body of particle 20 must be 0 (A) or 1 (B), got 2");
    expect_failure([](Clouds& x) { x.fixed[3] = 4; }, GRIT_BAD_CALL,
                   "node 3: fixed must be bits of 2 components in [0, 3], got 4");
}

TEST(RegressionCall, ReportsListsThatAreWrongAndLimitsThatAreReached) {
    Clouds x(2, clouds(2));
    std::vector<std::ptrdiff_t> id(x.body.size());
    std::iota(id.begin(), id.end(), 0);
    grit_contact_clouds q = x.views();
    q.particle = id.data();
    const auto count = static_cast<std::ptrdiff_t>(id.size());
    for (const std::ptrdiff_t wrong : {std::ptrdiff_t{-1}, count}) {
        id[16] = wrong;
        EXPECT_EQ(x.regress(q), GRIT_BAD_CALL);
        EXPECT_EQ(std::string(x.error.message), "node 3: particle id must be in [0, " +
                                                    std::to_string(count) + "), got " +
                                                    std::to_string(wrong));
        EXPECT_EQ(x.counts.defined, nodes - 1);
    }
    id[16] = 16;
    std::swap(x.offset[3], x.offset[4]);
    EXPECT_EQ(x.regress(q), GRIT_BAD_CALL);
    EXPECT_EQ(x.error.point, 3);
    EXPECT_STREQ(x.error.message,
                 "node 3: offset must start at >= 0 and not decrease, got 26 and 15");
    std::swap(x.offset[3], x.offset[4]);
    q.iteration_limit = 2;
    x.normal.assign(x.normal.size(), 7.0);
    EXPECT_EQ(x.regress(q), GRIT_NOT_CONVERGED);
    EXPECT_STREQ(x.error.message, "node 0: not converged after 2 evaluations (iteration_limit)");
    EXPECT_EQ(x.counts.failed, nodes);
    EXPECT_EQ(x.normal_at(5), Vec3(7.0, 7.0, 0.0));
}

TEST(RegressionCall, ThatIsWrongAsAWholeTouchesNothing) {
    const auto expect_bad = [](const std::function<void(grit_contact_clouds&)>& spoil,
                               const char* part) {
        Clouds x(2, clouds(2));
        const auto before = x.normal;
        grit_contact_clouds q = x.views();
        spoil(q);
        EXPECT_EQ(x.regress(q), GRIT_BAD_CALL) << part;
        EXPECT_EQ(x.error.point, -1);
        EXPECT_TRUE(says(x, part)) << x.error.message;
        EXPECT_TRUE(same_bits(x.normal, before));
    };
    using Q = grit_contact_clouds;
    expect_bad([](Q& q) { q.struct_size = 1; }, "grit_contact_clouds.struct_size 1");
    expect_bad([](Q& q) { q.components = 1; }, "components must be 2 or 3, got 1");
    expect_bad([](Q& q) { q.reserved = 1; }, "reserved must be 0, got 1");
    expect_bad([](Q& q) { q.instruction_set = 9; }, "instruction_set 9 is not available");
    expect_bad([](Q& q) { q.length = 0.0; }, "length must be finite and > 0 [length], got 0");
    expect_bad([](Q& q) { q.length = std::nan(""); }, "length must be finite");
    expect_bad([](Q& q) { q.ridge = 1e-7; }, "ridge must be in [1e-6, 1000]");
    expect_bad([](Q& q) { q.ridge = std::nan(""); }, "ridge must be in");
    expect_bad([](Q& q) { q.iteration_limit = -1; }, "iteration_limit must be >= 0, got -1");
    expect_bad([](Q& q) { q.particles = -1; }, "particles must be >= 0, got -1");
    expect_bad([](Q& q) { q.offset = nullptr; }, "offset is null");
    expect_bad([](Q& q) { q.body = nullptr; }, "body is null");
    expect_bad([](Q& q) { q.position.component_stride = 0; }, "position needs a base");
    expect_bad([](Q& q) { q.normal.base = nullptr; }, "normal needs a base");
    expect_bad([](Q& q) { q.normal.point_stride = 0; }, "must not be 0 for 13 nodes");
    Clouds x(2, clouds(2));
    const Q q = x.views();
    char none = 0;
    EXPECT_EQ(grit_contact_normals_by_regression(1, nullptr, &none, 1, nullptr, &x.error),
              GRIT_BAD_CALL);
    EXPECT_TRUE(says(x, "clouds is null"));
    EXPECT_EQ(grit_contact_normals_by_regression(-1, &q, &none, 1, nullptr, &x.error),
              GRIT_BAD_CALL);
    EXPECT_TRUE(says(x, "n must be >= 0, got -1"));
    x.counts.struct_size = 0;
    EXPECT_EQ(x.regress(q), GRIT_BAD_CALL);
    EXPECT_TRUE(says(x, "grit_contact_normal_counts.struct_size 0"));
    EXPECT_EQ(grit_contact_normals_by_regression(0, &q, nullptr, 0, nullptr, nullptr), GRIT_OK);
}

}  // namespace
