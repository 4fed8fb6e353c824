// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace {

using cli::Series;

double span(const std::vector<double>& values) {
    double low = INFINITY, high = -INFINITY;
    for (const double x : values)
        if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    return high - low;
}

double distance(double x, double y, double ax, double ay, double bx, double by) {
    const double dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
    const double t =
        square > 0.0 ? std::clamp(((x - ax) * dx + (y - ay) * dy) / square, 0.0, 1.0) : 0.0;
    return std::hypot(x - ax - t * dx, y - ay - t * dy);
}

// Largest distance of a point of one line from the other, in parts of the picture: every stride-th.
double deviation(const Series& points, const Series& line, double dx, double dy,
                 std::size_t stride) {
    double out = 0.0;
    for (std::size_t i = 0; i < points.x.size(); i += stride) {
        if (!std::isfinite(points.x[i])) continue;
        double nearest = INFINITY;
        for (std::size_t j = 0; j + 1 < line.x.size(); ++j)
            if (std::isfinite(line.x[j]) && std::isfinite(line.x[j + 1]))
                nearest = std::min(nearest, distance(points.x[i] / dx, points.y[i] / dy,
                                                     line.x[j] / dx, line.y[j] / dy,
                                                     line.x[j + 1] / dx, line.y[j + 1] / dy));
        out = std::max(out, nearest);
    }
    return out;
}

// Loops that drift and shrink, as p and q of an undrained cyclic test do, or as strain and stress.
Series cyclic_curve(unsigned seed, std::size_t points) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double cycles = 5.0 + 100.0 * uniform(random), drift = 3.0 * uniform(random);
    const double decay = 2.0 * uniform(random), phase = 6.0 * uniform(random);
    const double second = uniform(random), noise = 1e-3 * uniform(random);
    const double turns = uniform(random) < 0.5 ? 1.0 : 2.0;  // of x in a cycle
    const double scale = std::pow(10.0, 6.0 * uniform(random) - 3.0);
    Series out;
    for (std::size_t i = 0; i < points; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(points - 1);
        const double angle = 2.0 * std::numbers::pi * cycles * t;
        const double size = std::exp(-decay * t);
        out.x.push_back(scale * (100.0 - drift * t + size * std::sin(turns * angle + phase) +
                                 noise * uniform(random)));
        out.y.push_back(size * (std::sin(angle) + second * std::sin(3.0 * angle)) +
                        noise * uniform(random));
    }
    return out;
}

TEST(ThinnedLines, PassEveryPointOfTheFullOnesAndNoOthers) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Series full = cyclic_curve(seed, 4001 + 797 * seed);
        const double dx = span(full.x), dy = span(full.y);
        const Series thin = cli::thinned(full);
        EXPECT_LE(thin.x.size(), full.x.size()) << seed;
        EXPECT_LT(deviation(full, thin, dx, dy, 23), 1.0 / 300.0) << seed;
        EXPECT_LT(deviation(thin, full, dx, dy, 23), 1.0 / 300.0) << seed;
        EXPECT_NEAR(span(thin.x) / dx, 1.0, 2.0 / 300.0) << seed;
        EXPECT_NEAR(span(thin.y) / dy, 1.0, 2.0 / 300.0) << seed;
    }
}

TEST(ThinnedLines, OfManyLoopsOnOneAnotherAreShort) {
    for (unsigned seed = 0; seed < 3; ++seed) {
        Series full;
        for (int i = 0; i < 400000; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 200.0;
            full.x.push_back(std::sin(2.0 * angle) - 0.1 * std::exp(-1e-4 * i));
            full.y.push_back(std::cos(angle + seed));
        }
        EXPECT_LT(cli::thinned(full).x.size(), full.x.size() / 10);
    }
}

TEST(ThinnedLines, KeepTheirBreaks) {
    Series full;
    for (int i = 0; i < 10000; ++i) {
        full.x.push_back(i % 1000 == 0 ? NAN : i);
        full.y.push_back(std::sin(1e-3 * i));
    }
    const Series thin = cli::thinned(full);
    EXPECT_LT(thin.x.size(), 1000u);
    EXPECT_EQ(std::count_if(thin.x.begin(), thin.x.end(), [](double x) { return !(x == x); }), 9);
}

TEST(ThinnedLines, KeepTheirShapeOnALogarithmicAxis) {
    Series full;
    for (int i = 0; i <= 20000; ++i) {
        full.x.push_back(std::pow(10.0, 6.0 * i / 20000.0));
        full.y.push_back(std::sin(12.0 * std::numbers::pi * i / 20000.0));
    }
    Series drawn = full, thin = cli::thinned(full, true);
    for (Series* series : {&drawn, &thin})
        for (double& x : series->x) x = std::log(x);
    EXPECT_LT(thin.x.size(), 1000u);
    EXPECT_LT(deviation(drawn, thin, span(drawn.x), span(drawn.y), 3), 1.0 / 300.0);
}

TEST(ThinnedLines, OfFewPointsAreTheFullOnes) {
    const Series full = cyclic_curve(1, 4000);
    EXPECT_EQ(cli::thinned(full).x, full.x);
}

}  // namespace
