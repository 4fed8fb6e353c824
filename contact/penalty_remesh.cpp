// SPDX-License-Identifier: BSD-3-Clause
// Merging in one sweep along the line: at a segment that is too short its end goes, else its start,
// if every vertex that has gone between two neighbours stays within the tolerance of the chord that
// replaces them.
#include "contact/penalty_remesh.hpp"

namespace grit::penalty {
namespace {

constexpr double roundoff = 1e-9;  // relative: what is split once fits

double distance_to_chord(Vec a, Vec b, Vec x) {
    const Vec e = b - a;
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
                if (next < last && replaces(kept[count - 1], next + 1)) {
                    --left;
                    ++next;
                } else if (count > 1 && replaces(kept[count - 2], next)) {
                    --left;
                    --count;
                } else {
                    break;
                }
            }
            if (next < n) kept[count++] = next;
        }
        return count;
    }

  private:
    std::ptrdiff_t least() const { return line.closed ? 3 : 2; }
    Vec x(std::ptrdiff_t v) const { return vector_of(line.position, v < line.count ? v : 0); }
    bool is_short(std::ptrdiff_t a, std::ptrdiff_t b) const {
        return norm(x(b) - x(a)) < (1.0 - roundoff) * limits.shortest;
    }
    // Would the chord from a to b do for all vertices between?
    bool replaces(std::ptrdiff_t a, std::ptrdiff_t b) const {
        const Vec start = x(a), end = x(b);
        if (!(norm(end - start) > limits.tolerance)) return false;
        for (std::ptrdiff_t v = a + 1; v < b; ++v)
            if (!(distance_to_chord(start, end, x(v)) <= limits.tolerance)) return false;
        return true;
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
