// SPDX-License-Identifier: BSD-3-Clause
// Splitting and merging of segments.
#include "support/penalty.hpp"

namespace {

using namespace tests;

struct Remesh {
    std::vector<Point> x, history, new_x, new_history;
    std::vector<std::array<std::ptrdiff_t, 2>> parents;
    std::vector<double> weight;
    std::vector<std::ptrdiff_t> workspace;
    grit_penalty_remeshing q{};
    std::ptrdiff_t count = -1;
    grit_error error{};

    explicit Remesh(std::vector<Point> points, bool closed = false, std::ptrdiff_t capacity = 5000)
        : x(std::move(points)), history(x.size()) {
        for (std::size_t i = 0; i < x.size(); ++i) history[i] = {100.0 * i, 10.0 + i};
        resize(capacity);
        q.struct_size = sizeof q;
        q.closed = closed;
        q.longest = 1.0;
        q.shortest = 0.3;
        q.tolerance = 0.03;
    }
    void resize(std::ptrdiff_t capacity) {
        const auto n = static_cast<std::size_t>(capacity);
        new_x.assign(n, {-1.0, -1.0});
        new_history.assign(n, {-1.0, -1.0});
        parents.assign(n, {-1, -1});
        weight.assign(n, -1.0);
        q.capacity = capacity;
    }
    grit_status call() {
        q.count = static_cast<std::ptrdiff_t>(x.size());
        q.position = grit_view_of(x[0].data(), 2, 1);
        q.history = grit_view_of(history[0].data(), 2, 1);
        q.new_position = grit_mutable_view_of(new_x[0].data(), 2, 1);
        q.new_history = grit_mutable_view_of(new_history[0].data(), 2, 1);
        q.parents = parents[0].data();
        q.weight = weight.data();
        workspace.resize(grit_penalty_remesh_workspace_size(q.count) / sizeof(std::ptrdiff_t));
        return grit_penalty_remesh(&q, workspace.data(), workspace.size() * sizeof(std::ptrdiff_t),
                                   &count, &error);
    }
    std::vector<Point> operator()() {
        EXPECT_EQ(call(), GRIT_OK) << error.message;
        return {new_x.begin(), new_x.begin() + count};
    }
};

double length_of(const std::vector<Point>& x, std::size_t j) {
    return norm(x[(j + 1) % x.size()] - x[j]);
}

double distance_to(const std::vector<Point>& line, bool closed, Point p) {
    double least = 1e300;
    for (std::size_t j = 0; j + (closed ? 0 : 1) < line.size(); ++j) {
        const Point a = line[j], e = line[(j + 1) % line.size()] - a;
        const double s = std::clamp(dot(p - a, e) / dot(e, e), 0.0, 1.0);
        least = std::fmin(least, norm(p - a - s * e));
    }
    return least;
}

TEST(PenaltyRemesh, SplitsLongSegmentsIntoEqualPartsAndInterpolatesHistory) {
    Remesh remesh({{0.0, 0.0}, {2.5, 0.0}, {2.5, 0.9}});
    const auto x = remesh();
    ASSERT_EQ(x.size(), 5u);
    for (const std::size_t i : {0, 1, 2, 3}) {
        EXPECT_NEAR(x[i][0], 2.5 * i / 3.0, 1e-15);
        EXPECT_NEAR(remesh.new_history[i][0], 100.0 * i / 3.0, 1e-12);
        EXPECT_NEAR(remesh.new_history[i][1], 10.0 + i / 3.0, 1e-12);
        EXPECT_EQ(remesh.parents[i][0], i == 3 ? 1 : 0);
        EXPECT_EQ(remesh.parents[i][1], i == 0 ? 0 : 1);
    }
    EXPECT_NEAR(remesh.weight[1], 1.0 / 3.0, 1e-15);
    EXPECT_EQ(remesh.weight[3], 0.0);
    EXPECT_EQ(x[4], (Point{2.5, 0.9}));
    EXPECT_EQ(remesh.new_history[4], (Point{200.0, 12.0}));
}

TEST(PenaltyRemesh, SplitsTheClosingSegmentToo) {
    Remesh remesh({{0.0, 0.0}, {0.9, 0.0}, {0.0, 1.8}}, true);
    const auto x = remesh();
    ASSERT_EQ(x.size(), 1u + 3u + 2u);
    EXPECT_NEAR(norm(x[5] - Point{0.0, 0.9}), 0.0, 1e-15);
    EXPECT_EQ(remesh.parents[5], (std::array<std::ptrdiff_t, 2>{2, 0}));
}

TEST(PenaltyRemesh, MergesShortSegmentsOfAStraightLine) {
    Remesh remesh(chain({{0.0, 0.0}, {3.0, 0.0}}, {100}));
    const auto x = remesh();
    EXPECT_LE(x.size(), 11u);
    for (std::size_t j = 0; j + 1 < x.size(); ++j) {
        EXPECT_GE(length_of(x, j), 0.3 - 1e-9);
        EXPECT_LE(length_of(x, j), 1.0);
    }
    for (std::size_t i = 0; i < x.size(); ++i)  // vertices that stay, where and as they were
        EXPECT_EQ(x[i], remesh.x[static_cast<std::size_t>(remesh.parents[i][0])]);
    EXPECT_EQ(x.back(), (Point{3.0, 0.0}));
}

TEST(PenaltyRemesh, KeepsSegmentsThatAreJustLongEnough) {
    Remesh remesh({{0.0, 0.0}, {0.3, 0.0}, {0.61, 0.0}, {0.92, 0.0}, {1.23, 0.0}});
    EXPECT_TRUE(same_bits(remesh(), remesh.x));
    remesh.x[2][0] = 0.598;
    EXPECT_EQ(remesh().size(), 4u);
}

TEST(PenaltyRemesh, ReturnsALineThatFitsAsItIs) {
    std::mt19937_64 random(441);
    for (int i = 0; i < 50; ++i) {
        Remesh remesh(blob(random, {0.0, 0.0}, 12, 0.05).x, true);
        remesh.q.shortest = 0.1;
        EXPECT_TRUE(same_bits(remesh(), remesh.x));
        EXPECT_EQ(remesh.count, 12);
    }
}

// The tip of a pile among crowded vertices: its corners stay to the bit.
// Beyond the end of the chord its end is the nearest.
TEST(PenaltyRemesh, KeepsASpikeThatStandsOutBeyondItsChord) {
    Remesh remesh({{0.0, 0.0}, {0.285, 0.005}, {0.26, 0.0}, {1.0, 0.0}});
    remesh.q.tolerance = 0.02;
    EXPECT_EQ(remesh(), remesh.x);
}

TEST(PenaltyRemesh, KeepsSharpCorners) {
    Remesh remesh(chain({{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}}, {40, 80}));
    const auto x = remesh();
    EXPECT_NE(std::find(x.begin(), x.end(), Point{1.0, 0.0}), x.end());
    EXPECT_LE(x.size(), 12u);
    Remesh notch({{0.0, 0.0}, {2.0, 0.0}, {2.1, 0.2}, {2.2, 0.0}, {4.0, 0.0}});
    EXPECT_EQ(distance_to(notch(), false, {2.1, 0.2}), 0.0);  // short, but 0.2 high
}

TEST(PenaltyRemesh, CutsNoCornerByMoreThanTheTolerance) {
    std::mt19937_64 random(442);
    for (int i = 0; i < 200; ++i) {
        const bool closed = i % 2;
        std::vector<Point> points;
        if (closed) {
            points = blob(random, {0.0, 0.0}, 120, 0.05).x;
        } else {
            points = {{0.0, 0.0}};
            for (int k = 0; k < 100; ++k)
                points.push_back(points.back() +
                                 rotated(uniform(random, -1.0, 1.0),
                                         {std::pow(10.0, uniform(random, -3.0, 0.5)), 0.0}));
        }
        Remesh remesh(points, closed);
        const auto x = remesh();
        for (const Point& p : points) EXPECT_LE(distance_to(x, closed, p), 0.03 * (1.0 + 1e-12));
        for (const Point& p : x) EXPECT_LE(distance_to(points, closed, p), 0.031);
        for (std::size_t j = 0; j + (closed ? 0 : 1) < x.size(); ++j)
            EXPECT_LE(length_of(x, j), 1.0 + 1e-9);
        EXPECT_TRUE(same_bits(remesh(), x));  // deterministic
        for (std::size_t k = 0; k < x.size(); ++k) {
            const auto& [a, b] = remesh.parents[k];
            const double w = remesh.weight[k];
            ASSERT_TRUE(a >= 0 && b >= 0 && w >= 0.0 && w < 1.0);
            const auto A = static_cast<std::size_t>(a), B = static_cast<std::size_t>(b);
            EXPECT_LE(norm(x[k] - ((1.0 - w) * points[A] + w * points[B])), 1e-12);
            EXPECT_NEAR(remesh.new_history[k][0], 100.0 * ((1.0 - w) * a + w * b), 1e-9);
        }
    }
}

// No segment is split and merged again: repeated calls end with a line that fits.
TEST(PenaltyRemesh, SettlesAndLeavesNoSegmentShorterThanTheTolerance) {
    std::mt19937_64 random(443);
    for (int i = 0; i < 100; ++i) {
        std::vector<Point> points{{0.0, 0.0}};
        for (int k = 0; k < 100; ++k)
            points.push_back(points.back() +
                             rotated(uniform(random, -1.0, 1.0),
                                     {std::pow(10.0, uniform(random, -4.0, 0.5)), 0.0}));
        int calls = 0;
        for (;; ++calls) {
            ASSERT_LE(calls, 10);
            Remesh remesh(points);
            const auto x = remesh();
            if (same_bits(x, points)) break;
            EXPECT_TRUE(calls == 0 || x.size() <= points.size());
            points = x;
        }
        for (std::size_t j = 0; j + 1 < points.size(); ++j)
            EXPECT_GE(length_of(points, j), 0.03) << j << " of " << points.size();
    }
}

// The sand's line stretches under the tip, step by step.
TEST(PenaltyRemesh, FollowsALineThatStretches) {
    std::vector<Point> points = chain({{0.0, 0.0}, {5.0, 0.0}}, {8});
    for (int step = 0; step < 200; ++step) {
        for (Point& p : points) p = {1.01 * p[0], 0.2 * std::sin(p[0])};
        Remesh remesh(points);
        points = remesh();
        for (std::size_t j = 0; j + 1 < points.size(); ++j)
            ASSERT_LE(length_of(points, j), 1.0 + 1e-9);
    }
    EXPECT_GE(points.size(), 30u);
}

TEST(PenaltyRemesh, NeverLeavesLessThanALine) {
    Remesh open({{0.0, 0.0}, {0.001, 0.0}});
    EXPECT_EQ(open().size(), 2u);
    Remesh closed({{0.0, 0.0}, {0.01, 0.0}, {0.01, 0.01}, {0.0, 0.01}}, true);
    EXPECT_GE(closed().size(), 3u);
}

TEST(PenaltyRemesh, OfAContactKeepsItsForce) {
    Surface a = punch(-0.5, 0.5, 0.01, 1);
    Contact contact(1e6, 0.5, 0.4);
    const auto force_on = [&](const Surface& line) {
        Surface b = line, punch_again = a;
        for (Point& v : b.v) v = {-1.0, 0.0};
        contact(punch_again, b);
        return punch_again.sum();
    };
    Surface b = ground(-40.0, 40.0, 1);
    const Point before = force_on(b);
    Remesh remesh(b.x);
    const Point after = force_on(Surface(remesh()));
    EXPECT_EQ(remesh.count, 81);
    EXPECT_NEAR(after[0], before[0], 1e-9 * before[1]);
    EXPECT_NEAR(after[1], before[1], 1e-9 * before[1]);
}

struct BadRemesh {
    std::function<void(Remesh&)> spoil;
    const char* part;
    grit_status status = GRIT_BAD_CALL;
    std::ptrdiff_t point = -1;
};

TEST(PenaltyRemesh, RefusesWhatItCannotDoAndWritesNothing) {
    const double nan = std::nan("");
    const BadRemesh all[] = {
        {[](Remesh& r) { r.q.longest = 0.0; }, "longest must be in (0, 1e30] (length), got 0"},
        {[=](Remesh& r) { r.q.longest = nan; }, "longest must be"},
        {[](Remesh& r) { r.q.shortest = 0.6; }, "shortest must be in [0, longest / 2 = 0.5]"},
        {[](Remesh& r) { r.q.tolerance = 0.4; }, "tolerance must be in [0, shortest = 0.3]"},
        {[=](Remesh& r) { r.q.tolerance = nan; }, "tolerance"},
        {[](Remesh& r) { r.q.closed = 2; }, "closed must be 0 or 1, got 2"},
        {[](Remesh& r) { r.q.reserved = 1; }, "reserved"},
        {[](Remesh& r) { r.q.struct_size = 3; }, "struct_size 3"},
        {[](Remesh& r) {
             r.q.longest = 1e-14;
             r.q.shortest = r.q.tolerance = 0.0;
         },
         "at most 2^40"},
        {[](Remesh& r) { r.x.resize(1); },
         "count must be at least 2 vertices for an open line, got 1"},
        {[=](Remesh& r) { r.x[2][1] = nan; }, "line vertex 2: position y", GRIT_BAD_STATE, 2},
        {[](Remesh& r) { r.x[1] = r.x[0]; },
         "line vertex 0: the segment to vertex 1 must be longer", GRIT_BAD_STATE, 0},
        {[](Remesh& r) { r.q.capacity = 5; }, "capacity must be at least 6 vertices, got 5"},
    };
    for (const BadRemesh& bad : all) {
        Remesh remesh({{0.0, 0.0}, {2.5, 0.0}, {2.5, 1.9}});
        bad.spoil(remesh);
        EXPECT_EQ(remesh.call(), bad.status) << bad.part;
        EXPECT_NE(std::string(remesh.error.message).find(bad.part), std::string::npos)
            << remesh.error.message;
        EXPECT_EQ(remesh.error.point, bad.point);
        EXPECT_EQ(remesh.new_x[0][0], -1.0);
        EXPECT_EQ(remesh.weight[0], -1.0);
        EXPECT_EQ(remesh.count, remesh.q.capacity == 5 ? 6 : -1) << bad.part;
    }
    Remesh exact({{0.0, 0.0}, {2.5, 0.0}, {2.5, 1.9}}, false, 6);
    EXPECT_EQ(exact.call(), GRIT_OK);
    EXPECT_EQ(grit_penalty_remesh(&exact.q, exact.workspace.data(), 23, &exact.count, &exact.error),
              GRIT_BAD_CALL);
    EXPECT_STREQ(exact.error.message, "workspace must have at least 24 bytes, got 23");
    EXPECT_EQ(grit_penalty_remesh(&exact.q, nullptr, 24, &exact.count, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_remesh(nullptr, nullptr, 24, &exact.count, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_penalty_remesh_workspace_size(1), 0u);
}

}  // namespace
