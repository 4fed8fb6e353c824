// SPDX-License-Identifier: BSD-3-Clause
#include "cli/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/turns.hpp"

namespace cli {
namespace {

constexpr std::size_t most = 4000;
constexpr double invisible = 1e-3, apart = 0.04;  // parts of the picture

double span(const std::vector<double>& values) {
    double low = INFINITY, high = -INFINITY;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return high > low ? high - low : 1.0;
}

constexpr std::size_t gap = std::numeric_limits<std::size_t>::max();  // here the line is broken

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

// Rows that lie farther than distance from the one kept before, and those of `always`, which rise.
std::vector<std::size_t> far_rows(const Series& all, double distance,
                                  const std::vector<std::size_t>& always) {
    const double dx = span(all.x), dy = span(all.y);
    std::vector<std::size_t> out;
    auto next = always.begin();
    for (std::size_t i = 0; i < all.x.size(); ++i) {
        const bool wanted = next != always.end() && *next == i;
        while (next != always.end() && *next <= i) ++next;
        if (!wanted && !out.empty() &&
            std::hypot((all.x[i] - all.x[out.back()]) / dx, (all.y[i] - all.y[out.back()]) / dy) <
                distance)
            continue;
        out.push_back(i);
    }
    return out;
}

}  // namespace

Series spaced(const Series& points) {
    return points.x.empty() ? points : of_rows(points, far_rows(points, apart, {}));
}

Series thinned(Series line) {
    if (line.x.size() <= most) return line;
    const double noise = invisible * span(line.x);
    line = of_rows(line, far_rows(line, invisible, turning_rows(line.x, noise)));
    if (line.x.size() <= most) return line;
    // A loop is two stretches between turns.
    const std::vector<std::size_t> turns = turning_rows(line.x, noise);
    const std::size_t loops = (turns.size() + 1) / 2;
    const std::size_t step = (line.x.size() + most - 1) / most;
    std::vector<std::size_t> rows;
    for (std::size_t loop = 0; loop < loops; ++loop) {
        if (loop % step != 0 && loop + 1 != loops) continue;
        const std::size_t begin = turns[2 * loop];
        const std::size_t end = 2 * loop + 2 < turns.size() ? turns[2 * loop + 2] : line.x.size();
        if (!rows.empty() && rows.back() + 1 != begin) rows.push_back(gap);
        for (std::size_t i = begin; i < end; ++i) rows.push_back(i);
    }
    line = of_rows(line, rows);
    if (line.x.size() <= 2 * most) return line;
    // Loops of very many points, or none: whatever it costs.
    rows.clear();
    const std::size_t stride = (line.x.size() + most - 1) / most;
    for (std::size_t i = 0; i < line.x.size(); i += stride) rows.push_back(i);
    rows.push_back(line.x.size() - 1);
    return of_rows(line, rows);
}

}  // namespace cli
