// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_normals_from_gradients at the border: views, lists, bad input.
#include <functional>
#include <limits>

#include "support/clouds.hpp"

namespace {

using namespace tests;

constexpr std::size_t nodes = 9;

struct Host {
    std::vector<double> a, b, given, scale, normal;
    std::vector<int> fixed;
    std::vector<grit_status> status;
    grit_contact_normal_counts counts{sizeof(grit_contact_normal_counts), 0, 0, 0};
    grit_error error{};

    Host() : scale(nodes, 1.0), normal(3 * nodes, 7.0), fixed(nodes, 0), status(nodes, -1) {
        Dice dice(10);
        for (auto* v : {&a, &b, &given})
            for (std::size_t i = 0; i < 3 * nodes; ++i) v->push_back(dice.uniform(-1.0, 1.0));
    }
    grit_contact_gradients views(int source = GRIT_CONTACT_NORMAL_AVERAGE) {
        grit_contact_gradients q{};
        q.struct_size = sizeof q;
        q.components = 3;
        q.source = source;
        q.gradient_a = grit_view_of(a.data(), 3, 1);
        q.gradient_b = grit_view_of(b.data(), 3, 1);
        q.given = grit_view_of(given.data(), 3, 1);
        q.scale = grit_view_of(scale.data(), 1, 1);
        q.fixed = fixed.data();
        q.status = status.data();
        q.normal = grit_mutable_view_of(normal.data(), 3, 1);
        return q;
    }
    grit_status call(const grit_contact_gradients& q, std::ptrdiff_t n = nodes) {
        return grit_contact_normals_from_gradients(n, &q, &counts, &error);
    }
    bool says(const char* part) const {
        return std::string(error.message).find(part) != std::string::npos;
    }
};

std::vector<double> expected_normals() {
    Host host;
    EXPECT_EQ(host.call(host.views()), GRIT_OK) << host.error.message;
    EXPECT_EQ(host.counts.defined, static_cast<std::ptrdiff_t>(nodes));
    return host.normal;
}

TEST(ContactNormalCall, TakesStructureOfArraysMemoryAndGivesTheSameBits) {
    Host host;
    std::vector<double> a(3 * nodes), b(3 * nodes), n(3 * nodes);
    for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            a[c * nodes + i] = host.a[3 * i + c];
            b[c * nodes + i] = host.b[3 * i + c];
        }
    grit_contact_gradients q = host.views();
    q.gradient_a = grit_view_of(a.data(), 1, nodes);
    q.gradient_b = grit_view_of(b.data(), 1, nodes);
    q.normal = grit_mutable_view_of(n.data(), 1, nodes);
    ASSERT_EQ(host.call(q), GRIT_OK);
    const auto expected = expected_normals();
    for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(n[c * nodes + i], expected[3 * i + c]);
}

TEST(ContactNormalCall, TakesTheNodesOfAnIndexListAndNoOthers) {
    Host host;
    const std::vector<std::ptrdiff_t> index = {8, 2, 5};
    grit_contact_gradients q = host.views();
    q.index = index.data();
    ASSERT_EQ(host.call(q, 3), GRIT_OK);
    const auto expected = expected_normals();
    for (std::size_t i = 0; i < nodes; ++i) {
        const bool taken = i == 8 || i == 2 || i == 5;
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(host.normal[3 * i + c], taken ? expected[3 * i + c] : 7.0);
    }
    EXPECT_EQ(host.status[2], GRIT_OK);
    EXPECT_EQ(host.status[3], -1);
}

TEST(ContactNormalCall, ReadsTheMasksOfTheNodesWithTheirStride) {
    Host host;
    std::vector<int> masks(3 * nodes, 99);
    for (std::size_t i = 0; i < nodes; ++i) masks[3 * i] = i == 4 ? GRIT_CONTACT_FIXED_2 : 0;
    const std::vector<std::ptrdiff_t> index = {4, 3};
    grit_contact_gradients q = host.views();
    q.index = index.data();
    q.fixed = masks.data();
    q.fixed_stride = 3;
    ASSERT_EQ(host.call(q, 2), GRIT_OK) << host.error.message;
    EXPECT_EQ(host.normal[13], 0.0);
    EXPECT_NE(host.normal[10], 0.0);
}

TEST(ContactNormalCall, MayWriteOverAnInput) {
    Host host;
    grit_contact_gradients q = host.views();
    q.normal = grit_mutable_view_of(host.b.data(), 3, 1);
    ASSERT_EQ(host.call(q), GRIT_OK);
    EXPECT_TRUE(same_bits(host.b, expected_normals()));
}

TEST(ContactNormalCall, DoesNotReadWhatTheSourceDoesNotUse) {
    const double nan = std::nan("");
    for (int source = GRIT_CONTACT_NORMAL_OF_A; source <= GRIT_CONTACT_NORMAL_GIVEN; ++source) {
        Host host;
        grit_contact_gradients q = host.views(source);
        q.scale.base = nullptr;
        q.fixed = nullptr;
        q.status = nullptr;
        if (source == GRIT_CONTACT_NORMAL_OF_A || source == GRIT_CONTACT_NORMAL_GIVEN)
            q.gradient_b.base = source == GRIT_CONTACT_NORMAL_OF_A ? &nan : nullptr;
        if (source == GRIT_CONTACT_NORMAL_OF_B || source == GRIT_CONTACT_NORMAL_GIVEN)
            q.gradient_a.base = source == GRIT_CONTACT_NORMAL_OF_B ? &nan : nullptr;
        if (source != GRIT_CONTACT_NORMAL_GIVEN) q.given.base = nullptr;
        EXPECT_EQ(host.call(q), GRIT_OK) << host.error.message;
    }
}

TEST(ContactNormalCall, LeavesABadNodeAloneAndDoesTheOthers) {
    const auto expect_failure = [&](const std::function<void(Host&)>& spoil, int source,
                                    grit_status status, const char* message) {
        Host good, host;
        ASSERT_EQ(good.call(good.views(source)), GRIT_OK);
        spoil(host);
        EXPECT_EQ(host.call(host.views(source)), status);
        EXPECT_EQ(host.error.status, status);
        EXPECT_EQ(host.error.point, 4);
        EXPECT_STREQ(host.error.message, message);
        EXPECT_EQ(host.counts.failed, 1);
        EXPECT_EQ(host.counts.defined, static_cast<std::ptrdiff_t>(nodes) - 1);
        for (std::size_t i = 0; i < nodes; ++i) {
            EXPECT_EQ(host.status[i], i == 4 ? status : GRIT_OK);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_EQ(host.normal[3 * i + c], i == 4 ? 7.0 : good.normal[3 * i + c]);
        }
    };
    const double inf = std::numeric_limits<double>::infinity();
    expect_failure([](Host& x) { x.a[13] = std::nan(""); }, GRIT_CONTACT_NORMAL_OF_A,
                   GRIT_BAD_STATE, "node 4: gradient_a component 1 must be finite, got nan");
    expect_failure([=](Host& x) { x.b[14] = -inf; }, GRIT_CONTACT_NORMAL_OF_B, GRIT_BAD_STATE,
                   "node 4: gradient_b component 2 must be finite, got -inf");
    expect_failure([=](Host& x) { x.b[12] = inf; }, GRIT_CONTACT_NORMAL_AVERAGE, GRIT_BAD_STATE,
                   "node 4: gradient_b component 0 must be finite, got inf");
    expect_failure([](Host& x) { x.given[12] = std::nan(""); }, GRIT_CONTACT_NORMAL_GIVEN,
                   GRIT_BAD_STATE, "node 4: given component 0 must be finite, got nan");
    expect_failure([](Host& x) { x.scale[4] = -1.0; }, GRIT_CONTACT_NORMAL_OF_A, GRIT_BAD_STATE,
                   "node 4: scale must be finite and >= 0, got -1");
    expect_failure([](Host& x) { x.fixed[4] = 8; }, GRIT_CONTACT_NORMAL_OF_A, GRIT_BAD_CALL,
                   "node 4: fixed must be bits of 3 components in [0, 7], got 8");
}

TEST(ContactNormalCall, NamesTheFirstOfSeveralBadNodes) {
    Host host;
    host.a[3 * 6] = std::nan("");
    host.fixed[2] = -1;
    EXPECT_EQ(host.call(host.views()), GRIT_BAD_CALL);
    EXPECT_EQ(host.error.point, 2);
    EXPECT_EQ(host.counts.failed, 2);
    EXPECT_EQ(host.status[6], GRIT_BAD_STATE);
}

TEST(ContactNormalCall, ThatIsWrongAsAWholeTouchesNothing) {
    const auto expect_bad = [](const std::function<void(grit_contact_gradients&)>& spoil,
                               const char* part, int source = GRIT_CONTACT_NORMAL_AVERAGE) {
        Host host;
        const auto before = host.normal;
        grit_contact_gradients q = host.views(source);
        spoil(q);
        EXPECT_EQ(host.call(q), GRIT_BAD_CALL) << part;
        EXPECT_EQ(host.error.point, -1);
        EXPECT_TRUE(host.says(part)) << host.error.message;
        EXPECT_TRUE(same_bits(host.normal, before));
    };
    using Q = grit_contact_gradients;
    expect_bad([](Q& q) { q.struct_size = 1; }, "struct_size 1");
    expect_bad([](Q& q) { q.components = 4; }, "components must be 2 or 3, got 4");
    expect_bad([](Q& q) { q.source = 4; }, "source must be");
    expect_bad([](Q& q) { q.threshold = 1.0; }, "threshold must be in [0, 1), got 1");
    expect_bad([](Q& q) { q.threshold = std::nan(""); }, "threshold");
    expect_bad([](Q& q) { q.gradient_a.base = nullptr; }, "gradient_a needs a base");
    expect_bad([](Q& q) { q.gradient_b.component_stride = 0; }, "gradient_b needs a base");
    expect_bad([](Q& q) { q.given.base = nullptr; }, "given needs", GRIT_CONTACT_NORMAL_GIVEN);
    expect_bad([](Q& q) { q.normal.base = nullptr; }, "normal needs a base");
    expect_bad([](Q& q) { q.normal.point_stride = 0; }, "point_stride must not be 0 for 9 nodes");
    Host host;
    const Q q = host.views();
    EXPECT_EQ(grit_contact_normals_from_gradients(1, nullptr, nullptr, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(host.call(q, -1), GRIT_BAD_CALL);
    EXPECT_TRUE(host.says("n must be >= 0, got -1"));
    host.counts.struct_size = 2;
    EXPECT_EQ(host.call(q), GRIT_BAD_CALL);
    EXPECT_TRUE(host.says("grit_contact_normal_counts.struct_size 2"));
    EXPECT_EQ(grit_contact_normals_from_gradients(0, &q, nullptr, nullptr), GRIT_OK);
}

}  // namespace
