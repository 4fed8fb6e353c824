// SPDX-License-Identifier: BSD-3-Clause
// What is wrong is named with vertex, value and unit, and nothing is touched.
#include "support/penalty.hpp"

namespace {

using namespace tests;

struct Call {
    Surface a = punch(-0.5, 0.5, 0.01, 2), b = ground(-2.0, 2.0, 3);
    Contact contact{1e6, 0.5, 0.3};
    grit_penalty_options& o = contact.options;
    grit_penalty_surface view_a, view_b;
    std::vector<double> workspace = std::vector<double>(1000);
    std::size_t workspace_size = 8000;

    Call() {
        for (Surface* body : {&a, &b})
            for (Point& h : body->history) h = {7.0, 8.0};
        view_a = a.view();
        view_b = b.view();
    }
    grit_status run() {
        return grit_penalty_forces(&o, &view_a, &view_b, workspace.data(), workspace_size,
                                   &contact.totals, &contact.error);
    }
};

struct Bad {
    std::function<void(Call&)> spoil;
    const char* part;
    std::ptrdiff_t point = -1;
};

void expect_refused(const std::vector<Bad>& all, grit_status status) {
    for (const Bad& bad : all) {
        Call call;
        call.contact.totals.normal_force = -5.0;
        bad.spoil(call);
        const auto history_a = call.a.history, history_b = call.b.history;
        EXPECT_EQ(call.run(), status) << bad.part;
        EXPECT_NE(std::string(call.contact.error.message).find(bad.part), std::string::npos)
            << call.contact.error.message << " has no: " << bad.part;
        EXPECT_EQ(call.contact.error.point, bad.point) << bad.part;
        EXPECT_EQ(call.a.largest_force(), 0.0) << bad.part;
        EXPECT_EQ(call.b.largest_force(), 0.0) << bad.part;
        EXPECT_TRUE(same_bits(call.a.history, history_a)) << bad.part;
        EXPECT_TRUE(same_bits(call.b.history, history_b)) << bad.part;
        EXPECT_EQ(call.contact.totals.normal_force, -5.0) << bad.part;
    }
}

const double nan = std::nan("");

TEST(PenaltyBadCall, OptionsOutOfRangeAreRefused) {
    EXPECT_EQ(Call().run(), GRIT_OK);
    expect_refused(
        {
            {[](Call& c) { c.o.normal_stiffness = -1.0; },
             "normal_stiffness must be in (0, 1e60] (stress / length), got -1"},
            {[](Call& c) { c.o.normal_stiffness = 0.0; }, "normal_stiffness"},
            {[](Call& c) { c.o.normal_stiffness = nan; }, "normal_stiffness"},
            {[](Call& c) { c.o.tangential_stiffness = -2.0; },
             "tangential_stiffness must be in [0, 1e60] (stress / length), got -2"},
            {[](Call& c) { c.o.tangential_stiffness = nan; }, "tangential_stiffness"},
            {[](Call& c) { c.o.friction_coefficient = -0.1; },
             "friction_coefficient must be in [0, 1e6], got -0.1"},
            {[](Call& c) { c.o.friction_coefficient = nan; }, "friction_coefficient"},
            {[](Call& c) { c.o.depth_max = 0.0; },
             "depth_max must be in (0, 1e30] (length), got 0"},
            {[](Call& c) { c.o.depth_max = nan; }, "depth_max"},
            {[](Call& c) { c.o.time_step = 0.0; },
             "time_step must be in (0, 1e30] (time) with friction, got 0"},
            {[](Call& c) { c.o.time_step = nan; }, "time_step"},
            {[](Call& c) { c.o.axisymmetric = 2; }, "axisymmetric must be 0 or 1, got 2"},
            {[](Call& c) { c.o.validate_only = -1; }, "validate_only must be 0 or 1, got -1"},
            {[](Call& c) { c.o.struct_size = 5; }, "struct_size 5"},
        },
        GRIT_BAD_CALL);
}

TEST(PenaltyBadCall, SurfacesThatCannotBeUsedAreRefused) {
    expect_refused(
        {
            {[](Call& c) { c.view_a.count = 1; },
             "surface a: count must be at least 2 vertices for an open line, got 1"},
            {[](Call& c) { c.view_b.closed = 1, c.view_b.count = 2; },
             "surface b: count must be at least 3 vertices for a closed line, got 2"},
            {[](Call& c) { c.view_b.closed = 3; }, "surface b: closed"},
            {[](Call& c) { c.view_b.reserved = 3; }, "surface b: reserved"},
            {[](Call& c) { c.view_b.struct_size = 1; },
             "surface b: grit_penalty_surface.struct_size"},
            {[](Call& c) { c.view_b.position.base = nullptr; }, "surface b: position"},
            {[](Call& c) { c.view_a.position.component_stride = 0; },
             "surface a: position has 2 components: component_stride must not be 0"},
            {[](Call& c) { c.view_a.velocity.base = nullptr; }, "surface a: velocity"},
            {[](Call& c) { c.view_b.velocity.component_stride = 0; },
             "surface b: velocity has 2 components: component_stride must not be 0"},
            {[](Call& c) { c.view_a.history.base = nullptr; }, "surface a: history"},
            {[](Call& c) { c.view_a.force.base = nullptr; }, "surface a: force"},
            {[](Call& c) { c.view_a.force.point_stride = 0; },
             "surface a: force is written: point"},
            {[](Call& c) { c.view_b.history.component_stride = 0; },
             "surface b: history is written: component_stride"},
            {[](Call& c) { c.view_b.stiffness.point_stride = 0; }, "surface b: stiffness"},
            {[](Call& c) { c.workspace_size = 100; }, "bytes, got 100"},
            {[](Call& c) { c.contact.totals.struct_size = 0; },
             "grit_penalty_totals.struct_size 0"},
        },
        GRIT_BAD_CALL);
}

TEST(PenaltyBadCall, VerticesThatCannotBeAreNamed) {
    expect_refused(
        {
            {[](Call& c) { c.a.x[3][0] = nan; },
             "surface a vertex 3: position x must be within +-1e30 (length), got", 3},
            {[](Call& c) { c.b.x[1][1] = std::numeric_limits<double>::infinity(); },
             "surface b vertex 1: position y must be within +-1e30 (length), got inf", 1},
            {[](Call& c) { c.b.x[2] = c.b.x[1]; },
             "surface b vertex 1: the segment to vertex 2 must be longer than", 1},
            {[](Call& c) { c.b.x[0][0] = -2000.0, c.b.x[2] = c.b.x[1]; },
             "surface b vertex 1: the segment to vertex 2 must be longer than 2e-09 (length), got "
             "0",
             1},
            {[](Call& c) { c.view_a.closed = 1, c.a.x.back() = c.a.x.front(); },
             "surface a vertex 6: the segment to vertex 0 must be longer than", 6},
            {[](Call& c) { c.o.axisymmetric = 1; },
             "surface a vertex 0: position r must be >= 0 (length), got -0.5", 0},
            {[](Call& c) { c.b.v[2][0] = nan; },
             "surface b vertex 2: velocity 0 must be within +-1e30 (length / time)", 2},
            {[](Call& c) { c.b.history[2][0] = nan; },
             "surface b vertex 2: stored tangential traction must be within +-1e90 (stress)", 2},
            {[](Call& c) { c.a.history[4][1] = -1.0; },
             "surface a vertex 4: stored normal traction must be in [0, 1e90] (stress), got -1", 4},
        },
        GRIT_BAD_STATE);
}

TEST(PenaltyBadCall, WithoutArgumentsIsRefused) {
    Call c;
    void* memory = c.workspace.data();
    EXPECT_EQ(grit_penalty_forces(nullptr, &c.view_a, &c.view_b, memory, 8000, nullptr, nullptr),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_forces(&c.o, nullptr, &c.view_b, memory, 8000, nullptr, nullptr),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_forces(&c.o, &c.view_a, nullptr, memory, 8000, nullptr, nullptr),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_forces(&c.o, &c.view_a, &c.view_b, nullptr, 8000, nullptr, nullptr),
              GRIT_BAD_CALL);
    void* odd = reinterpret_cast<char*>(memory) + 1;
    EXPECT_EQ(grit_penalty_forces(&c.o, &c.view_a, &c.view_b, odd, 7999, nullptr, nullptr),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_forces(&c.o, &c.view_a, &c.view_b, memory, 8000, nullptr, nullptr),
              GRIT_OK);
}

TEST(PenaltyWorkspace, IsAsLargeAsItSaysAndLinear) {
    Call c;
    const std::size_t needed = grit_penalty_workspace_size(c.view_a.count, c.view_b.count);
    c.workspace.assign(1000, -3.0);
    c.workspace_size = needed;
    EXPECT_EQ(c.run(), GRIT_OK);
    for (std::size_t i = needed / sizeof(double); i < 1000; ++i) EXPECT_EQ(c.workspace[i], -3.0);
    c.workspace_size = needed - 1;
    EXPECT_EQ(c.run(), GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_workspace_size(1, 2), 0u);
    EXPECT_EQ(grit_penalty_workspace_size(2, -1), 0u);
    EXPECT_EQ(grit_penalty_workspace_size(PTRDIFF_MAX, 2), 0u);
    EXPECT_LE(grit_penalty_workspace_size(100000, 100000), 200u * 200000u);
}

TEST(PenaltyBadCall, StableStepNamesTheNode) {
    const double mass[3] = {1.0, 0.0, 1.0}, stiffness[3] = {1.0, 1.0, nan};
    const grit_view m = grit_view_of(mass, 1, 1), k = grit_view_of(stiffness, 1, 1);
    double step = -1.0;
    grit_error error{};
    EXPECT_EQ(grit_penalty_stable_step(2, &m, &k, 0, nullptr, nullptr, &step, &error),
              GRIT_BAD_STATE);
    EXPECT_STREQ(error.message, "body a node 1: mass must be > 0 and finite (mass) where there is "
                                "stiffness, got 0");
    EXPECT_EQ(error.point, 1);
    const grit_view ones = grit_view_of(mass, 0, 0);
    EXPECT_EQ(grit_penalty_stable_step(0, nullptr, nullptr, 3, &ones, &k, &step, &error),
              GRIT_BAD_STATE);
    EXPECT_NE(std::string(error.message).find("body b node 2: stiffness must be >= 0 and finite"),
              std::string::npos);
    EXPECT_EQ(grit_penalty_stable_step(-1, &m, &k, 0, nullptr, nullptr, &step, &error),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_stable_step(1, nullptr, &k, 0, nullptr, nullptr, &step, &error),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_stable_step(1, &m, nullptr, 0, nullptr, nullptr, &step, &error),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_stable_step(1, &m, &k, 0, nullptr, nullptr, nullptr, &error),
              GRIT_BAD_CALL);
    EXPECT_EQ(step, -1.0);
}

TEST(PenaltyBadCall, FlushStiffnessChecksItsSurface) {
    Call c;
    grit_error error{};
    c.view_a.stiffness.base = nullptr;
    EXPECT_EQ(grit_penalty_flush_stiffness(&c.o, &c.view_a, &error), GRIT_BAD_CALL);
    EXPECT_STREQ(error.message, "surface: stiffness has no base pointer");
    c.b.x[2] = c.b.x[1];
    EXPECT_EQ(grit_penalty_flush_stiffness(&c.o, &c.view_b, &error), GRIT_BAD_STATE);
    EXPECT_EQ(error.point, 1);
    EXPECT_EQ(c.b.stiffness[0], 0.0);
}

// An open line may end where it began; a closed one has a segment there, which needs a length.
TEST(PenaltyBadCall, FlushStiffnessLooksAtTheSegmentThatClosesALine) {
    Call c;
    grit_error error{};
    c.b.x.back() = c.b.x.front();
    c.view_b.closed = 0;
    EXPECT_EQ(grit_penalty_flush_stiffness(&c.o, &c.view_b, &error), GRIT_OK) << error.message;
    c.view_b.closed = 1;
    EXPECT_EQ(grit_penalty_flush_stiffness(&c.o, &c.view_b, &error), GRIT_BAD_STATE);
    EXPECT_EQ(error.point, c.view_b.count - 1);
}

TEST(PenaltyOptions, StartAsDocumented) {
    grit_penalty_options o;
    ASSERT_EQ(grit_penalty_options_init(&o, sizeof o), GRIT_OK);
    EXPECT_EQ(o.struct_size, sizeof o);
    EXPECT_EQ(o.axisymmetric, 0);
    EXPECT_EQ(o.validate_only, 0);
    EXPECT_EQ(o.tangential_stiffness, 0.0);
    EXPECT_EQ(o.friction_coefficient, 0.0);
    EXPECT_EQ(grit_penalty_options_init(nullptr, sizeof o), GRIT_BAD_CALL);
}

}  // namespace
