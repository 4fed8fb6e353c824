// SPDX-License-Identifier: BSD-3-Clause
// The points of a surface that carry its pressure, (V2): some of its vertices. A stretch is what hangs together and
// turns by less than 30 degrees from facet to facet; in the plane it is parted into equal lengths, as near to the
// spacing as they go, counted in spacings where these change, but for what lies next to its ends, which may be longer;
// in space no point of it is nearer to another than its spacing, its rim comes first but for what waits.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "contact/surface/ascending.hpp"
#include "contact/surface/facets.hpp"

namespace grit::surface {

template <int C> struct PressurePoint {
    Vector<double, C> x;
    Vector<double, C> n;  // in space the mean of the facets' that meet there
    std::ptrdiff_t stretch;
    double spacing;
};

template <int C> class Pressures {
  public:
    // spacing: of facets that are given none; end_spacings: from an end of a stretch to the next point.
    Pressures(Arena& memory, const Skin<C>& of, double spacing, double end_spacings)
        : arena(memory), skin(of), common_spacing(spacing), ends(end_spacings),
          facets(of.given->facets) {
        stretch = arena.take<std::ptrdiff_t>(facets);
        corner = arena.take<Corner>(C * facets);
        boxes = arena.take<Box<C>>(C * facets);
        is_near = arena.take<bool>(C * facets);
        next = arena.take<std::ptrdiff_t>(facets);
        point = arena.take<PressurePoint<C>>(C * facets);
        if (arena.is_overrun()) return;
        find_stretches();
        sort_corners([this](std::ptrdiff_t f) { return stretch[f]; });
        if constexpr (C == 2) part_chains();
        else spread_points();
    }
    // longest: edge of the facets in contact. Every vertex of theirs has a point no farther than its spacing.
    void set_longest(double edge) {
        longest = edge;
        largest_radius = 0.0;
        for (std::ptrdiff_t k = 0; k < count; ++k)
            largest_radius = std::max(largest_radius, radius(k));
    }
    std::ptrdiff_t size() const { return count; }
    const PressurePoint<C>& operator[](std::ptrdiff_t k) const { return point[k]; }

    // For searches: a point's box.
    const Box<C>* point_boxes() {
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            boxes[k] = Box<C>::empty();
            boxes[k].include(point[k].x);
        }
        return boxes;
    }

    // Partition of unity at x on a facet: take(point, share). Weights ((R - d) / (R d))^2 of Franke and
    // Little, 1 at a point itself, R its spacing and an edge more.
    template <class Take>
    void each_share(const BoxTree<C>& tree, std::ptrdiff_t f, const Vector<double, C>& x,
                    std::ptrdiff_t* found, const Take& take) const {
        std::ptrdiff_t n = 0;
        Box<C> around = Box<C>::empty();
        around.include(x);
        tree.each(around.grown(largest_radius), [&](std::ptrdiff_t k) {
            if (point[k].stretch == stretch[f] && norm(point[k].x - x) < radius(k)) found[n++] = k;
        });
        if (n == 0) {
            if (const std::ptrdiff_t k = nearest(f, x); k >= 0) take(k, 1.0);
            return;
        }
        sort_ascending(found, found + n);
        double sum = 0.0;
        for (std::ptrdiff_t i = 0; i < n; ++i) sum += weight(found[i], x);
        for (std::ptrdiff_t i = 0; i < n; ++i) take(found[i], weight(found[i], x) / sum);
    }

  private:
    struct Corner {
        std::ptrdiff_t stretch, vertex, facet;
        bool operator<(const Corner& o) const {
            if (stretch != o.stretch) return stretch < o.stretch;
            return vertex != o.vertex ? vertex < o.vertex : facet < o.facet;
        }
    };

    // Of the stretch of a facet, wherever it is: spacings that jump may leave a place without one within reach.
    std::ptrdiff_t nearest(std::ptrdiff_t f, const Vector<double, C>& x) const {
        std::ptrdiff_t best = -1;
        for (std::ptrdiff_t k = 0; k < count; ++k)
            if (point[k].stretch == stretch[f] &&
                (best < 0 || norm(point[k].x - x) < norm(point[best].x - x)))
                best = k;
        return best;
    }
    double weight(std::ptrdiff_t k, const Vector<double, C>& x) const {
        const double R = radius(k), d = std::max(norm(point[k].x - x), 1e-9 * R);
        const double w = (R - d) / (R * d);
        return w * w;
    }
    double radius(std::ptrdiff_t k) const { return (point[k].spacing + longest) * (1.0 + 1e-9); }
    double spacing(std::ptrdiff_t f) const {
        return skin.given->spacing ? skin.given->spacing[f] : common_spacing;
    }
    double spacings(std::ptrdiff_t f) const { return skin.facet[f].size / spacing(f); }

    std::ptrdiff_t root(std::ptrdiff_t f) {
        while (stretch[f] != f) f = stretch[f] = stretch[stretch[f]];
        return f;
    }
    // Facets that share a vertex and do not turn much are of one stretch.
    void find_stretches() {
        constexpr double least_cosine = 0.8660254037844386;
        std::iota(stretch, stretch + facets, std::ptrdiff_t{0});
        sort_corners([](std::ptrdiff_t) { return std::ptrdiff_t{0}; });
        each_ridge([&](const Corner* first, const Corner* last) {
            for (const Corner* i = first; i < last; ++i)
                for (const Corner* j = first; j < i; ++j) {
                    if (dot(skin.facet[i->facet].n, skin.facet[j->facet].n) < least_cosine)
                        continue;
                    const std::ptrdiff_t a = root(i->facet), b = root(j->facet);
                    stretch[std::max(a, b)] = std::min(a, b);
                }
        });
        for (std::ptrdiff_t f = 0; f < facets; ++f) stretch[f] = root(f);
    }
    template <class Of> void sort_corners(const Of& stretch_of) {
        for (std::ptrdiff_t f = 0; f < facets; ++f)
            for (int i = 0; i < C; ++i) corner[C * f + i] = {stretch_of(f), skin.vertex(f, i), f};
        sort_ascending(corner, corner + C * facets);
    }
    // Corners with the same stretch and vertex, one behind the other.
    template <class Take> void each_ridge(const Take& take) {
        for (std::ptrdiff_t i = 0, end; i < C * facets; i = end) {
            end = i + 1;
            while (end < C * facets && corner[end].stretch == corner[i].stretch &&
                   corner[end].vertex == corner[i].vertex)
                ++end;
            take(corner + i, corner + end);
        }
    }
    // Whether one of the edges at a vertex is of one facet of the stretch alone.
    bool is_rim(const Corner* first, const Corner* last) const {
        for (const Corner* i = first; i < last; ++i)
            for (int a = 0; a < C; ++a) {
                const std::ptrdiff_t across = skin.vertex(i->facet, a);
                if (across == i->vertex) continue;
                int sharing = 0;
                for (const Corner* j = first; j < last; ++j)
                    for (int b = 0; b < C; ++b) sharing += skin.vertex(j->facet, b) == across;
                if (sharing < 2) return true;
            }
        return false;
    }

    // In the plane: along each chain of facets, from end to end or around.
    void part_chains() {
        bool* is_first = is_near;
        for (std::ptrdiff_t f = 0; f < facets; ++f) {
            next[f] = -1;
            is_first[f] = true;
        }
        each_ridge([&](const Corner* first, const Corner* last) {
            if (last - first != 2) return;
            const bool leaves = skin.vertex(first->facet, 0) == first->vertex;
            const std::ptrdiff_t from = leaves ? first[1].facet : first->facet;
            const std::ptrdiff_t to = leaves ? first->facet : first[1].facet;
            if (skin.vertex(from, 1) != first->vertex || skin.vertex(to, 0) != first->vertex)
                return;
            next[from] = to;
            is_first[to] = false;
        });
        for (std::ptrdiff_t f = 0; f < facets; ++f)
            if (is_first[f]) part(f);
        for (std::ptrdiff_t f = 0; f < facets; ++f)
            if (next[f] >= 0) part(f);  // of a ring
    }
    // The chain that starts with a facet; next becomes -2 where it has been.
    void part(std::ptrdiff_t start) {
        double length = 0.0;  // in spacings
        std::ptrdiff_t f = start;
        do length += spacings(f);
        while ((f = next[f]) >= 0 && f != start);
        const bool ring = f == start;
        // What is too short for two ends and something between them has none but ends.
        const bool has_ends = !ring && ends > 1.0 && length > 2.0 * ends + 0.4;
        const double at_end = has_ends ? ends : 0.0;
        const double unit = !ring && !has_ends ? ends : 1.0;
        // Halves, which even surfaces of halved cells have, not by the last bit: always up.
        const double parts = std::floor((length - 2.0 * at_end) / unit + 0.6);
        const double each = (length - 2.0 * at_end) / std::max(parts, 1.0);
        const double last = has_ends ? length - at_end : length - each;
        add_point(start, 0, has_ends ? ends : unit);
        double at = 0.0, wanted = has_ends ? at_end : each;
        for (f = start; f >= 0;) {
            const std::ptrdiff_t after = next[f];
            next[f] = -2;
            at += spacings(f);
            const bool is_last = after < 0 || after == start;
            // The vertex that is nearest to where the point is wanted.
            const double rest = is_last ? 0.0 : 0.5 * spacings(after);
            if (is_last ? !ring && parts > 0.0 : at + rest > wanted && wanted < last + 0.5 * each) {
                add_point(f, 1, has_ends && is_last ? ends : unit);
                wanted += each * std::max(1.0, std::floor((at + rest - wanted) / each) + 1.0);
            }
            f = is_last ? -1 : after;
        }
    }
    void add_point(std::ptrdiff_t f, int end, double spacings_apart) {
        point[count++] = {skin.facet[f].x[end], skin.facet[f].n, stretch[f],
                          spacings_apart * spacing(f)};
    }

    // A vertex of a stretch in space. Those that the grid's symmetries take into each other have the same keys.
    struct Candidate {
        bool is_rim;
        std::ptrdiff_t stretch, vertex;
        double key[1 + C];  // from the middle of the stretch: how far, and along which axes
        double spacing;     // the least of its facets
        Vector<double, C> x, n;

        bool is_like(const Candidate& o) const {
            return is_rim == o.is_rim && stretch == o.stretch &&
                   std::equal(key, key + 1 + C, o.key);
        }
        bool operator<(const Candidate& o) const {
            if (stretch != o.stretch) return stretch < o.stretch;
            if (is_rim != o.is_rim) return is_rim;
            for (int i = 0; i < 1 + C; ++i)
                if (key[i] != o.key[i]) return key[i] > o.key[i];
            return vertex < o.vertex;
        }
    };
    // In space: all vertices that have none near yet, the rims of stretches first, what is far from the middle before what is
    // nearer. Vertices that are like each other and near each other wait until all others have been asked, then the first one is taken.
    void spread_points() {
        auto* candidate = arena.take<Candidate>(C * facets);
        auto* middle = arena.take<Vector<double, C>>(facets);
        auto* area = arena.take<double>(facets);
        if (arena.is_overrun()) return;
        std::fill_n(middle, facets, Vector<double, C>{});
        std::fill_n(area, facets, 0.0);
        for (std::ptrdiff_t f = 0; f < facets; ++f) {
            const Facet<C>& facet = skin.facet[f];
            area[stretch[f]] += facet.size;
            for (int i = 0; i < C; ++i)
                middle[stretch[f]] = middle[stretch[f]] + facet.size / C * facet.x[i];
        }
        std::ptrdiff_t n = 0;
        double least_spacing = std::numeric_limits<double>::infinity();
        each_ridge([&](const Corner* first, const Corner* last) {
            const std::ptrdiff_t of = first->stretch;
            Candidate& c = candidate[n++];
            c = {is_rim(first, last), of, first->vertex, {}, spacing(first->facet), {}, {}};
            c.x = vector_of<C>(skin.given->position, first->vertex);
            for (const Corner* i = first; i < last; ++i) {
                c.spacing = std::min(c.spacing, spacing(i->facet));
                c.n = c.n + skin.facet[i->facet].size * skin.facet[i->facet].n;
            }
            const Vector<double, C> away = c.x - middle[of] / (area[of] > 0.0 ? area[of] : 1.0);
            c.key[0] = norm(away);
            for (int i = 0; i < C; ++i) c.key[1 + i] = std::fabs(away[i]);
            std::sort(c.key + 1, c.key + 1 + C, std::greater<>());
            least_spacing = std::min(least_spacing, c.spacing);
        });
        // By more than roundoff, and no more: what is nearly alike besides, as above and below the middle, would wait for nothing.
        for (std::ptrdiff_t i = 0; i < n; ++i)
            for (double& each : candidate[i].key)
                each = std::floor(1e7 * (each / least_spacing) + 0.3);
        sort_ascending(candidate, candidate + n);
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            is_near[i] = false;
            boxes[i] = Box<C>::empty();
            boxes[i].include(candidate[i].x);
        }
        const BoxTree<C> tree(arena, boxes, n);
        if (arena.is_overrun()) return;
        const auto unit = [](const Vector<double, C>& v) {
            const double length = norm(v);  // 0 where no facet has a size
            return length > 0.0 ? v / length : v;
        };
        const auto each_near = [&](std::ptrdiff_t i, const auto& take) {
            const double least = candidate[i].spacing * (1.0 - 1e-9);
            tree.each(boxes[i].grown(least), [&](std::ptrdiff_t k) {
                if (candidate[k].stretch == candidate[i].stretch &&
                    norm(candidate[k].x - candidate[i].x) < least)
                    take(k);
            });
        };
        // Those that are alike stand side by side.
        const auto has_like_near = [&](std::ptrdiff_t i) {
            const Candidate& c = candidate[i];
            const auto is_one = [&](std::ptrdiff_t k) {
                return norm(candidate[k].x - c.x) < c.spacing * (1.0 - 1e-9);
            };
            for (std::ptrdiff_t k = i; k-- > 0 && candidate[k].is_like(c);)
                if (is_one(k)) return true;
            for (std::ptrdiff_t k = i + 1; k < n && candidate[k].is_like(c); ++k)
                if (is_one(k)) return true;
            return false;
        };
        for (const bool alone : {true, false})
            for (std::ptrdiff_t i = 0; i < n; ++i) {
                if (is_near[i] || (alone && has_like_near(i))) continue;
                const Candidate& c = candidate[i];
                point[count++] = {c.x, unit(c.n), c.stretch, c.spacing};
                is_near[i] = true;
                each_near(i, [&](std::ptrdiff_t k) { is_near[k] = true; });
            }
    }

    Arena& arena;
    const Skin<C>& skin;
    double common_spacing, ends, longest = 0.0, largest_radius = 0.0;
    std::ptrdiff_t facets, count = 0;
    std::ptrdiff_t* stretch = nullptr;  // [facets] the first facet of it
    Corner* corner = nullptr;
    Box<C>* boxes = nullptr;
    bool* is_near = nullptr;         // another one carries the pressure
    std::ptrdiff_t* next = nullptr;  // [facets] in a chain
    PressurePoint<C>* point = nullptr;
};

}  // namespace grit::surface
