// SPDX-License-Identifier: BSD-3-Clause
// Merging in one sweep along the line: of the two ends of a segment that is too short the one goes
// that the line misses less, if every vertex that has gone between two neighbours stays within the
// tolerance of the chord that replaces them. So a corner goes only if both ends are corners.
#include "contact/penalty/remesh.hpp"

#include <limits>

namespace grit::penalty {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::ptrdiff_t longest_run = 64;  // looked at for a chord: keeps the sweep O(n)
constexpr double roundoff = 1e-9;           // relative: what is split once fits

double distance_to_chord(Vector2 a, Vector2 b, Vector2 x) {
    const Vector2 e = b - a;
    const double s = dot(x - a, e) / dot(e, e);
    return norm(x - a - std::min(std::max(s, 0.0), 1.0) * e);
}

class Merging {
  public:
    Merging(const Geometry& old_line, const Limits& given, std::ptrdiff_t* vertices)
        : line(old_line), limits(given), kept(vertices) {}

    std::ptrdiff_t run() {
        const std::ptrdiff_t n = line.count;
        const std::ptrdiff_t last = line.closed ? n : n - 1;  // n is vertex 0 once more
        std::ptrdiff_t left = n;
        count = 0;
        kept[count++] = 0;
        for (std::ptrdiff_t next = 1; next <= last; ++next) {
            while (is_short(kept[count - 1], next) && left > least()) {
                const double end = next < last ? miss(kept[count - 1], next + 1) : infinite;
                const double start = count > 1 ? miss(kept[count - 2], next) : infinite;
                if (!(std::min(end, start) <= limits.tolerance)) break;
                --left;
                if (end <= start) ++next;
                else --count;
            }
            if (next < n) kept[count++] = next;
        }
        return count;
    }

  private:
    std::ptrdiff_t least() const { return line.closed ? 3 : 2; }
    Vector2 x(std::ptrdiff_t v) const { return vector_of(line.position, v < line.count ? v : 0); }
    bool is_short(std::ptrdiff_t a, std::ptrdiff_t b) const {
        return norm(x(b) - x(a)) < (1.0 - roundoff) * limits.shortest;
    }
    // How far the chord from a to b is from the vertices between.
    double miss(std::ptrdiff_t a, std::ptrdiff_t b) const {
        const Vector2 start = x(a), end = x(b);
        if (b - a > longest_run || !(norm(end - start) > limits.tolerance)) return infinite;
        double largest = 0.0;
        for (std::ptrdiff_t v = a + 1; v < b; ++v)
            largest = std::max(largest, distance_to_chord(start, end, x(v)));
        return largest;
    }

    const Geometry& line;
    const Limits& limits;
    std::ptrdiff_t* kept;
    std::ptrdiff_t count = 0;
};

}  // namespace

std::ptrdiff_t merge_short(const Geometry& line, const Limits& limits, std::ptrdiff_t* kept) {
    return Merging(line, limits, kept).run();
}

double parts_of(double length, double longest) {
    const double ratio = length / longest - roundoff;
    if (ratio > static_cast<double>(largest_count)) return ratio;
    const auto whole = static_cast<double>(static_cast<std::ptrdiff_t>(ratio));
    return whole >= ratio ? std::max(whole, 1.0) : whole + 1.0;
}

}  // namespace grit::penalty
