// SPDX-License-Identifier: BSD-3-Clause
// A polyline is its own space-filling order: a binary tree over runs of consecutive segments needs no
// sorting, and long segments among short ones cost nothing. Consecutive vertices of the slave share
// the way down, so that the cost of a vertex hardly depends on how many there are.
#include "contact/penalty/search.hpp"

#include <limits>

namespace grit::penalty {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::ptrdiff_t vertices_per_block = 16;
constexpr double end_tolerance = 1e-6;  // of the end segment's length, beyond an open end

Box empty_box() { return {{infinite, infinite}, {-infinite, -infinite}}; }

void include(Box& box, Vector2 x) {
    box.low = {std::min(box.low[0], x[0]), std::min(box.low[1], x[1])};
    box.high = {std::max(box.high[0], x[0]), std::max(box.high[1], x[1])};
}

Box united(const Box& a, const Box& b) {
    return {{std::min(a.low[0], b.low[0]), std::min(a.low[1], b.low[1])},
            {std::max(a.high[0], b.high[0]), std::max(a.high[1], b.high[1])}};
}

double squared_distance(const Box& box, Vector2 x) {
    const double dx = std::max(std::max(box.low[0] - x[0], x[0] - box.high[0]), 0.0);
    const double dy = std::max(std::max(box.low[1] - x[1], x[1] - box.high[1]), 0.0);
    return dx * dx + dy * dy;
}

bool apart(const Box& a, const Box& b, double distance) {
    return !(a.low[0] - b.high[0] <= distance && b.low[0] - a.high[0] <= distance &&
             a.low[1] - b.high[1] <= distance && b.low[1] - a.high[1] <= distance);
}

struct Nearest {
    double squared;
    std::ptrdiff_t segment;
    double xi;
    Vector2 point;
};

// The nearer point wins, then the lower segment.
void take_nearest(const Line& line, std::ptrdiff_t j, Vector2 x, Nearest& best) {
    const Vector2 a = line.x[j], b = line.x[line.end_of(j)];
    const Vector2 e = b - a;
    const double s = dot(x - a, e) / dot(e, e);
    const double xi = s <= 0.0 ? 0.0 : (s >= 1.0 ? 1.0 : s);
    const Vector2 p = s <= 0.0 ? a : (s >= 1.0 ? b : a + s * e);
    const double squared = dot(x - p, x - p);
    if (squared < best.squared || (squared == best.squared && j < best.segment))
        best = {squared, j, xi, p};
}

class Search {
  public:
    Search(const Line& master_line, double depth) : master(master_line), depth_max(depth) {}

    // The lowest box that holds all segments within depth_max of a block; 0: none are.
    std::ptrdiff_t start_for(const Box& block) {
        std::ptrdiff_t at = 1;
        ++tests;
        if (apart(master.box[1], block, reach())) return 0;
        while (at < master.leaves) {
            tests += 2;
            const bool left = !apart(master.box[2 * at], block, reach());
            const bool right = !apart(master.box[2 * at + 1], block, reach());
            if (left && right) return at;
            if (!left && !right) return 0;
            at = 2 * at + (left ? 0 : 1);
        }
        return at;
    }

    Nearest nearest(std::ptrdiff_t start, Vector2 x) {
        Nearest best{reach() * reach(), std::numeric_limits<std::ptrdiff_t>::max(), 0.0, x};
        struct Waiting {
            std::ptrdiff_t node;
            double squared;
        } stack[64];
        int waiting = 0;
        ++tests;
        stack[waiting++] = {start, squared_distance(master.box[start], x)};
        while (waiting > 0) {
            const Waiting top = stack[--waiting];
            if (!(top.squared <= best.squared)) continue;
            if (top.node >= master.leaves) {
                look_at_leaf(top.node - master.leaves, x, best);
                continue;
            }
            tests += 2;
            const Waiting left = {2 * top.node, squared_distance(master.box[2 * top.node], x)};
            const Waiting right = {left.node + 1, squared_distance(master.box[left.node + 1], x)};
            const bool left_first = left.squared <= right.squared;
            stack[waiting++] = left_first ? right : left;
            stack[waiting++] = left_first ? left : right;
        }
        return best;
    }

    Hit hit(const Nearest& found, Vector2 x) const {
        const Hit none{-1, 0.0, 0.0, {0.0, 0.0}};
        const std::ptrdiff_t j = found.segment;
        if (j >= master.segments) return none;
        const Segment& segment = master.segment[j];
        const Vector2 q = x - found.point;
        Hit hit{j, found.xi, dot(q, segment.n), segment.n};
        if (found.xi == 0.0 || found.xi == 1.0) {
            const std::ptrdiff_t other = found.xi == 0.0 ? master.before(j) : master.after(j);
            if (other < 0) {
                if (!(std::fabs(dot(q, travel(segment.n))) <= end_tolerance * segment.length))
                    return none;
            } else {
                // Nearest to a corner: outside a salient one, inside a re-entrant one.
                if (!(dot(q, segment.n + master.segment[other].n) < 0.0)) return none;
                const double distance = norm(q);
                if (!(distance > 0.0)) return none;
                hit.gap = -distance;
                hit.n = (-1.0 / distance) * q;
            }
        }
        return hit.gap < 0.0 && hit.gap >= -depth_max ? hit : none;  // (S1)
    }

    double reach() const { return depth_max * (1.0 + 1e-9); }

    std::ptrdiff_t tests = 0;

  private:
    void look_at_leaf(std::ptrdiff_t leaf, Vector2 x, Nearest& best) {
        const std::ptrdiff_t first = leaf * segments_per_leaf;
        for (std::ptrdiff_t j = first; j < first + segments_per_leaf && j < master.segments; ++j) {
            ++tests;
            take_nearest(master, j, x, best);
        }
    }

    const Line& master;
    double depth_max;
};

}  // namespace

void build_tree(Line& line) {
    for (std::ptrdiff_t leaf = 0; leaf < line.leaves; ++leaf) {
        Box& box = line.box[line.leaves + leaf];
        box = empty_box();
        const std::ptrdiff_t first = leaf * segments_per_leaf;
        for (std::ptrdiff_t j = first; j < first + segments_per_leaf && j < line.segments; ++j) {
            include(box, line.x[j]);
            include(box, line.x[line.end_of(j)]);
        }
    }
    for (std::ptrdiff_t node = line.leaves - 1; node > 0; --node)
        line.box[node] = united(line.box[2 * node], line.box[2 * node + 1]);
}

std::ptrdiff_t search(Line& slave, const Line& master, double depth_max) {
    Search search(master, depth_max);
    for (std::ptrdiff_t first = 0; first < slave.vertices; first += vertices_per_block) {
        const std::ptrdiff_t room = slave.vertices - first;
        const std::ptrdiff_t end = first + (room < vertices_per_block ? room : vertices_per_block);
        Box block = empty_box();
        for (std::ptrdiff_t v = first; v < end; ++v) include(block, slave.x[v]);
        const std::ptrdiff_t start = search.start_for(block);
        for (std::ptrdiff_t v = first; v < end; ++v)
            slave.hit[v] = start == 0 ? Hit{-1, 0.0, 0.0, {0.0, 0.0}}
                                      : search.hit(search.nearest(start, slave.x[v]), slave.x[v]);
    }
    return search.tests;
}

}  // namespace grit::penalty
