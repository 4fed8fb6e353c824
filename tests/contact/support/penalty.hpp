// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with their own memory, and a call of the penalty contact on two of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <grit/contact_penalty.h>
#include <gtest/gtest.h>

namespace tests {

using Point = std::array<double, 2>;

inline Point operator+(Point a, Point b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Point operator-(Point a, Point b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Point operator*(double s, Point a) { return {s * a[0], s * a[1]}; }
inline double dot(Point a, Point b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(Point a, Point b) { return a[0] * b[1] - a[1] * b[0]; }
inline double norm(Point a) { return std::sqrt(dot(a, a)); }
inline Point rotated(double angle, Point a) {
    return {std::cos(angle) * a[0] - std::sin(angle) * a[1],
            std::sin(angle) * a[0] + std::cos(angle) * a[1]};
}

inline double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

// A chain of points with n equal parts between each two.
inline std::vector<Point> chain(const std::vector<Point>& corners, const std::vector<int>& parts) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (int i = 0; i < parts[k]; ++i)
            points.push_back(corners[k] + (static_cast<double>(i) / parts[k]) *
                                              (corners[(k + 1) % corners.size()] - corners[k]));
    if (parts.size() + 1 == corners.size()) points.push_back(corners.back());
    return points;
}

struct Surface {
    std::vector<Point> x, v, history, force;
    std::vector<double> stiffness;
    std::vector<grit_penalty_report> reports;
    bool closed;

    explicit Surface(std::vector<Point> points, bool is_closed = false)
        : x(std::move(points)), v(x.size()), history(x.size()), force(x.size()),
          stiffness(x.size()), reports(x.size()), closed(is_closed) {}

    grit_penalty_surface view() {
        grit_penalty_surface s{};
        s.struct_size = sizeof s;
        s.closed = closed;
        s.count = static_cast<std::ptrdiff_t>(x.size());
        s.position = grit_view_of(x[0].data(), 2, 1);
        s.velocity = grit_view_of(v[0].data(), 2, 1);
        s.history = grit_mutable_view_of(history[0].data(), 2, 1);
        s.force = grit_mutable_view_of(force[0].data(), 2, 1);
        s.stiffness = grit_mutable_view_of(stiffness.data(), 1, 1);
        s.reports = reports.data();
        return s;
    }
    void clear() {
        for (Point& f : force) f = {0.0, 0.0};
        for (double& k : stiffness) k = 0.0;
    }
    Point sum() const {
        Point total{0.0, 0.0};
        for (const Point& f : force) total = total + f;
        return total;
    }
    double largest_force() const {
        double largest = 0.0;
        for (const Point& f : force) largest = std::fmax(largest, norm(f));
        return largest;
    }
    double moment() const {
        double total = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) total += cross(x[i], force[i]);
        return total;
    }
    int contacts() const {
        int count = 0;
        for (const auto& report : reports) count += report.state != GRIT_PENALTY_OPEN;
        return count;
    }
    void move(Point u) {
        for (Point& p : x) p = p + u;
    }
    void turn(double angle) {
        for (Point& p : x) p = rotated(angle, p);
    }
};

struct Contact {
    grit_penalty_options options;
    grit_penalty_totals totals{};
    grit_error error{};
    std::vector<double> workspace;

    explicit Contact(double eps_n = 1e6, double depth_max = 0.5, double mu = 0.0) {
        grit_penalty_options_init(&options, sizeof options);
        options.normal_stiffness = eps_n;
        options.depth_max = depth_max;
        options.friction_coefficient = mu;
        options.time_step = 1e-3;
        totals.struct_size = sizeof totals;
    }
    grit_status call(const grit_penalty_surface& a, const grit_penalty_surface& b) {
        workspace.resize(grit_penalty_workspace_size(a.count, b.count) / sizeof(double));
        return grit_penalty_forces(&options, &a, &b, workspace.data(),
                                   workspace.size() * sizeof(double), &totals, &error);
    }
    // Forces from zero.
    void operator()(Surface& a, Surface& b) {
        a.clear();
        b.clear();
        ASSERT_EQ(call(a.view(), b.view()), GRIT_OK) << error.message;
    }
};

// The ground: a body below z = 0 between two abscissae, its line in n parts.
inline Surface ground(double left, double right, int n) {
    return Surface(chain({{right, 0.0}, {left, 0.0}}, {n}));
}

// A flat punch above, its base at z = -depth in n parts; with left = 0 the half of it.
inline Surface punch(double left, double right, double depth, int n) {
    if (left == 0.0) return Surface(chain({{0.0, -depth}, {right, -depth}, {right, 3.0}}, {n, 2}));
    return Surface(chain({{left, 3.0}, {left, -depth}, {right, -depth}, {right, 3.0}}, {2, n, 2}));
}

// A closed body with bumps and dents.
inline Surface blob(std::mt19937_64& random, Point centre, int n, double roughness = 0.15) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * (i + uniform(random, -0.3, 0.3)) / n;
        const double radius = 1.0 + uniform(random, -roughness, roughness);
        points.push_back(centre + radius * Point{std::cos(angle), std::sin(angle)});
    }
    return Surface(points, true);
}

inline void stir(std::mt19937_64& random, Surface& body, double speed) {
    for (Point& v : body.v) v = {uniform(random, -speed, speed), uniform(random, -speed, speed)};
}

inline bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0;
}

}  // namespace tests
