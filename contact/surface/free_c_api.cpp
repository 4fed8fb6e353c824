// SPDX-License-Identifier: BSD-3-Clause
// grit_surface_find_free: the edges of particles' domains beyond which no neighbour is, (V6).
#include <cmath>

#include "contact/surface/ascending.hpp"
#include "contact/surface/box_tree.hpp"
#include "contact/surface/call_checks.hpp"

namespace grit::surface {
namespace {

// Of an edge, from 0 to 1.
struct Interval {
    double begin, end;
    bool operator<(const Interval& o) const { return begin < o.begin; }
};

struct Parallelogram {
    Vector2 x, r1, r2;

    // Counter-clockwise.
    Vector2 corner(int k) const {
        const double e1 = k == 1 || k == 2 ? 1.0 : -1.0, e2 = k < 2 ? -1.0 : 1.0;
        return x + e1 * r1 + e2 * r2;
    }
    double area() const { return 4.0 * (r1[0] * r2[1] - r1[1] * r2[0]); }
    double shortest() const { return 2.0 * std::min(norm(r1), norm(r2)); }
    // What of from + s along, 0 <= s <= 1, lies inside; begin >= end: nothing.
    Interval cut(const Vector2& from, const Vector2& along) const {
        const double half = 0.25 * area() * (1.0 + 1e-9);
        const Vector2 q = from - x;
        Interval inside{0.0, 1.0};
        for (const Vector2* side : {&r2, &r1}) {
            const double at = q[0] * (*side)[1] - q[1] * (*side)[0];
            const double rate = along[0] * (*side)[1] - along[1] * (*side)[0];
            if (rate == 0.0) {
                if (std::fabs(at) > half) return {1.0, 0.0};
                continue;
            }
            const double a = (-half - at) / rate, b = (half - at) / rate;
            inside.begin = std::max(inside.begin, std::min(a, b));
            inside.end = std::min(inside.end, std::max(a, b));
        }
        return inside;
    }
    Box<2> box() const {
        Box<2> box = Box<2>::empty();
        for (int k = 0; k < 4; ++k) box.include(corner(k));
        return box;
    }
};

// A corner of an edge that is free.
struct FreeCorner {
    Vector2 x;
    std::ptrdiff_t domain;
    double near;          // corners within this are the same vertex
    std::ptrdiff_t root;  // the first corner of its vertex
};

class FreeEdges {
  public:
    FreeEdges(Arena& memory, std::ptrdiff_t count, double share)
        : arena(memory), n(count), tolerance(share), domains(arena.take<Parallelogram>(count)),
          boxes(arena.take<Box<2>>(4 * count)), corners(arena.take<FreeCorner>(4 * count)),
          place(arena.take<std::ptrdiff_t>(4 * count)), number_of(arena.take<double>(4 * count)),
          covered(arena.take<Interval>(count)) {}

    // What the constructor and find() take, besides what trees do.
    static std::size_t size(std::ptrdiff_t n) {
        const auto tree = [](std::ptrdiff_t items) {
            return Arena::size_of<std::ptrdiff_t>(items) + Arena::size_of<Box<2>>(2 * items + 8);
        };
        return Arena::size_of<Parallelogram>(n) + Arena::size_of<Box<2>>(4 * n) +
               Arena::size_of<FreeCorner>(4 * n) + Arena::size_of<std::ptrdiff_t>(4 * n) +
               Arena::size_of<double>(4 * n) + Arena::size_of<Interval>(n) + tree(n) + tree(4 * n);
    }

    grit_status read(const grit_surface_domains& d, grit_error* error) {
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const std::ptrdiff_t p = d.index ? d.index[i] : i;
            if (p < 0)
                return failure(error, GRIT_BAD_CALL, i, "entry %td of index must be >= 0, got %td",
                               i, p);
            Parallelogram& q = domains[i];
            for (int c = 0; c < 2; ++c) {
                q.x[c] = component(d.position, p, c);
                q.r1[c] = side(d.side, p, 0, c);
                q.r2[c] = side(d.side, p, 1, c);
            }
            for (const Vector2& v : {q.x, q.r1, q.r2})
                if (!(std::fabs(v[0]) <= largest_number && std::fabs(v[1]) <= largest_number))
                    return failure(error, GRIT_BAD_STATE, p,
                                   "particle %td: position and sides must be within +-1e30 "
                                   "(length), got %g, %g",
                                   p, v[0], v[1]);
            if (!(q.area() > 0.0))
                return failure(
                    error, GRIT_BAD_STATE, p,
                    "particle %td: the area of its domain must be > 0 (length^2), got %g", p,
                    q.area());
        }
        return GRIT_OK;
    }

    void find(double* position, std::ptrdiff_t* facet, std::ptrdiff_t* owner,
              std::ptrdiff_t* vertices, std::ptrdiff_t* facets) {
        for (std::ptrdiff_t i = 0; i < n; ++i) boxes[i] = domains[i].box();
        const BoxTree<2> tree(arena, boxes, n);
        std::ptrdiff_t count = 0, n_facets = 0;
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            for (int k = 0; k < 4; ++k) place[4 * i + k] = -1;
            for (int k = 0; k < 4; ++k) {
                if (!is_free(tree, i, k)) continue;
                for (const int end : {0, 1}) {
                    const int c = (k + end) % 4;
                    if (place[4 * i + c] < 0) {
                        corners[count] = {domains[i].corner(c), i,
                                          tolerance * domains[i].shortest(), count};
                        place[4 * i + c] = count++;
                    }
                    facet[2 * n_facets + end] = place[4 * i + c];
                }
                if (owner) owner[n_facets] = i;
                ++n_facets;
            }
        }
        join(count);
        *facets = n_facets;
        *vertices = number(count, position);
        for (std::ptrdiff_t i = 0; i < 2 * n_facets; ++i) facet[i] = place[facet[i]];
    }

  private:
    static double side(const grit_matrix_view& v, std::ptrdiff_t i, int row, int column) {
        return v.base[i * v.point_stride + row * v.row_stride + column * v.column_stride];
    }
    // Where a piece of it is; then it counts as a whole, for what lies opposite ends where it ends.
    bool is_free(const BoxTree<2>& tree, std::ptrdiff_t i, int k) const {
        const Parallelogram& q = domains[i];
        const Vector2 from = q.corner(k), along = q.corner((k + 1) % 4) - from;
        // Outside along the other sides, as a neighbour that is skewed alike lies.
        const Vector2 off = (k == 0 || k == 3 ? -2.0 : 2.0) * tolerance * (k % 2 ? q.r1 : q.r2);
        Box<2> at = Box<2>::empty();
        at.include(from + off);
        at.include(from + along + off);
        std::ptrdiff_t count = 0;
        const bool is_covered = tree.any(at, [&](std::ptrdiff_t other) {
            if (other == i) return false;
            const Interval shadow = domains[other].cut(from + off, along);
            if (shadow.begin < shadow.end) covered[count++] = shadow;
            // Inside of a body: by one neighbour.
            return shadow.begin <= tolerance && shadow.end >= 1.0 - tolerance;
        });
        if (is_covered) return false;
        sort_ascending(covered, covered + count);
        double open = 0.0, reached = 0.0;  // the longest that is
        for (std::ptrdiff_t c = 0; c < count; ++c) {
            open = std::max(open, covered[c].begin - reached);
            reached = std::max(reached, covered[c].end);
        }
        return std::max(open, 1.0 - reached) > tolerance;
    }
    std::ptrdiff_t root(std::ptrdiff_t c) {
        while (corners[c].root != c) c = corners[c].root = corners[corners[c].root].root;
        return c;
    }
    void join(std::ptrdiff_t count) {
        for (std::ptrdiff_t c = 0; c < count; ++c) {
            boxes[c] = Box<2>::empty();
            boxes[c].include(corners[c].x);
        }
        const BoxTree<2> tree(arena, boxes, count);
        for (std::ptrdiff_t c = 0; c < count; ++c)
            tree.each(boxes[c].grown(corners[c].near), [&](std::ptrdiff_t other) {
                const double near = std::min(corners[c].near, corners[other].near);
                if (corners[other].domain == corners[c].domain ||
                    norm(corners[other].x - corners[c].x) > near)
                    return;
                const std::ptrdiff_t a = root(c), b = root(other);
                corners[std::max(a, b)].root = std::min(a, b);
            });
    }
    // Vertices at the means of their corners, in order of the first of them; place becomes the vertex of a corner.
    std::ptrdiff_t number(std::ptrdiff_t count, double* position) {
        std::ptrdiff_t vertices = 0;
        for (std::ptrdiff_t c = 0; c < count; ++c) {
            const std::ptrdiff_t first = root(c);
            place[c] = first == c ? vertices++ : place[first];
        }
        std::fill_n(number_of, vertices, 0.0);
        std::fill_n(position, 2 * vertices, 0.0);
        for (std::ptrdiff_t c = 0; c < count; ++c) {
            number_of[place[c]] += 1.0;
            for (int k = 0; k < 2; ++k) position[2 * place[c] + k] += corners[c].x[k];
        }
        for (std::ptrdiff_t v = 0; v < vertices; ++v)
            for (int k = 0; k < 2; ++k) position[2 * v + k] /= number_of[v];
        return vertices;
    }

    Arena& arena;
    std::ptrdiff_t n;
    double tolerance;
    Parallelogram* domains;
    Box<2>* boxes;
    FreeCorner* corners;
    std::ptrdiff_t* place;  // of a domain's corner in corners; then of a corner in the vertices
    double* number_of;      // corners of a vertex
    Interval* covered;      // parts of an edge
};

}  // namespace
}  // namespace grit::surface

using namespace grit;
using namespace grit::surface;

extern "C" {

size_t grit_surface_find_free_workspace_size(ptrdiff_t n) {
    return n >= 0 && n <= largest_count ? FreeEdges::size(n) : 0;
}

grit_status grit_surface_find_free(const grit_surface_domains* domains, void* workspace,
                                   size_t workspace_size, double* position, ptrdiff_t* facet,
                                   ptrdiff_t* owner, ptrdiff_t* vertices, ptrdiff_t* facets,
                                   grit_error* error) {
    GRIT_CHECK(check_given(domains, "domains", error));
    grit_surface_domains d{};
    GRIT_CHECK(read_struct(domains, d, "grit_surface_domains", error));
    GRIT_REQUIRE(d.n >= 0 && d.n <= largest_count, "n must be in [0, %td] particles, got %td",
                 largest_count, d.n);
    GRIT_REQUIRE(d.tolerance > 0.0 && d.tolerance <= 0.5, "tolerance must be in (0, 0.5], got %g",
                 d.tolerance);
    GRIT_CHECK(check_given(vertices, "vertices", error));
    GRIT_CHECK(check_given(facets, "facets", error));
    if (d.n > 0) {
        GRIT_CHECK(check_given(position, "position", error));
        GRIT_CHECK(check_given(facet, "facet", error));
        GRIT_CHECK(check_usable(d.position, 2, "domains: position", error));
        GRIT_CHECK(check_usable(d.side, "domains: side", error));
    }
    GRIT_CHECK(check_workspace(workspace, workspace_size,
                               grit_surface_find_free_workspace_size(d.n), error));
    Arena arena(workspace, workspace_size);
    FreeEdges edges(arena, d.n, d.tolerance);
    GRIT_CHECK(edges.read(d, error));
    edges.find(position, facet, owner, vertices, facets);
    return GRIT_OK;
}
}
