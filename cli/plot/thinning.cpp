// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cli {
namespace {

constexpr std::size_t most = 4000;
// Parts of the picture, which is some 400 pixels high, and lines are two of them wide.
constexpr double apart = 0.04, beside = 5e-4, square_side = 1e-3;
constexpr std::size_t gap = std::numeric_limits<std::size_t>::max();  // here the line is broken

struct Point {
    double x, y;
};

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Of a point from a stretch of a line.
double distance(const Point& p, const Point& a, const Point& b) {
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double along = square > 0.0 ? ((p.x - a.x) * x + (p.y - a.y) * y) / square : 0.0;
    const double t = std::clamp(along, 0.0, 1.0);
    return distance(p, {a.x + t * x, a.y + t * y});
}

bool is_drawn(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

std::vector<double> parts(std::vector<double> values) {
    double low = INFINITY, high = -INFINITY;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    for (double& value : values) value = high > low ? (value - low) / (high - low) : value - low;
    return values;
}

// In parts of the picture.
std::vector<Point> points_of(const Series& series, bool log_x) {
    std::vector<double> x = series.x;
    if (log_x)
        for (double& value : x) value = value > 0.0 ? std::log(value) : NAN;
    x = parts(std::move(x));
    const std::vector<double> y = parts(series.y);
    std::vector<Point> out;
    out.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) out.push_back({x[i], y[i]});
    return out;
}

// The points of these rows.
Series of_rows(const Series& all, const std::vector<std::size_t>& rows) {
    Series out = all;
    out.x.clear();
    out.y.clear();
    for (const std::size_t i : rows) {
        out.x.push_back(i == gap ? NAN : all.x[i]);
        out.y.push_back(i == gap ? NAN : all.y[i]);
    }
    return out;
}

// Rows after `first` up to `last` of a line that passes all others at most `beside` (Ramer 1972, Douglas
// & Peucker 1973).
void straighten(const std::vector<Point>& line, std::size_t first, std::size_t last,
                std::vector<std::size_t>& rows) {
    std::size_t farthest = first;
    double most_off = beside;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double off = distance(line[i], line[first], line[last]);
        if (off <= most_off) continue;
        most_off = off;
        farthest = i;
    }
    if (farthest != first) {
        straighten(line, first, farthest, rows);
        straighten(line, farthest, last, rows);
    } else rows.push_back(last);
}

std::vector<std::size_t> straightened(const std::vector<Point>& line) {
    constexpr std::size_t piece = 256;  // or very many loops cost the square of their points
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < line.size();) {
        if (!is_drawn(line[i])) {
            if (!out.empty() && out.back() != gap) out.push_back(gap);
            ++i;
            continue;
        }
        if (out.empty() || out.back() == gap) out.push_back(i);
        std::size_t last = i;
        while (last + 1 < line.size() && last < i + piece && is_drawn(line[last + 1])) ++last;
        if (last > i) straighten(line, i, last, out);
        i = last + 1 < line.size() && is_drawn(line[last + 1]) ? last : last + 1;
    }
    return out;
}

// Squares of the picture that something is drawn in.
class Ink {
  public:
    // Draws a stretch. Whether it was to be seen beside what is there.
    bool draw(const Point& a, const Point& b) {
        const double steps = std::ceil(2.0 * distance(a, b) / square_side) + 1.0;
        bool seen = false;
        for (double k = 0.0; k <= steps; ++k) {
            const double t = k / steps;
            const std::size_t at =
                square(a.x + t * (b.x - a.x)) * across + square(a.y + t * (b.y - a.y));
            seen = seen || !inked[at];
            inked[at] = true;
        }
        return seen;
    }

  private:
    static constexpr auto across = static_cast<std::size_t>(1.0 / square_side) + 2;
    static std::size_t square(double part) { return static_cast<std::size_t>(part / square_side); }
    std::vector<bool> inked = std::vector<bool>(across * across, false);
};

// Without stretches that lie on others.
std::vector<std::size_t> uncovered(const std::vector<Point>& line,
                                   const std::vector<std::size_t>& rows) {
    Ink ink;
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        const std::size_t from = rows[i], to = rows[i + 1];
        if (from == gap || to == gap || !ink.draw(line[from], line[to])) continue;
        if (out.empty() || out.back() != from) {
            if (!out.empty()) out.push_back(gap);
            out.push_back(from);
        }
        out.push_back(to);
    }
    return out;
}

}  // namespace

Series spaced(const Series& points, bool log_x) {
    const std::vector<Point> drawn = points_of(points, log_x);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (rows.empty() || !(distance(drawn[i], drawn[rows.back()]) < apart)) rows.push_back(i);
    return of_rows(points, rows);
}

Series thinned(const Series& line, bool log_x) {
    if (line.x.size() <= most) return line;
    const std::vector<Point> drawn = points_of(line, log_x);
    std::vector<std::size_t> rows = straightened(drawn);
    if (rows.size() <= most) return of_rows(line, rows);
    const std::vector<std::size_t> fewer = uncovered(drawn, rows);
    return of_rows(line, fewer.size() < rows.size() ? fewer : rows);
}

}  // namespace cli
