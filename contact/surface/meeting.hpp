// SPDX-License-Identifier: BSD-3-Clause
// Where two surfaces lie opposite each other, (V1): pieces of A's facets with the nearest facet of B along A's
// normal, and on them points of integration, exact for a pressure and a velocity that are linear there.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/surface/ascending.hpp"
#include "contact/surface/facets.hpp"

namespace grit::surface {

// A point of A and the one of B that lies opposite.
template <int C> struct MeetingPoint {
    std::ptrdiff_t facet_a, facet_b;
    double place_a[C], place_b[C];  // shares of the vertices
    double gap;                     // from A to B along A's normal, negative: overlap
    double size;                    // length or area, times r in axisymmetry
};

constexpr double most_facing =
    -0.1;  // n_a . n_b: facets that turn more from each other do not meet
constexpr double least_piece = 1e-9;  // share of A's facet

template <int C> class Meeting;

template <> class Meeting<2> {
  public:
    Meeting(Arena& arena, const Skin<2>& of_a, const Skin<2>& of_b, const BoxTree<2>&,
            double how_far)
        : a(of_a), b(of_b), reach(how_far), opposite(arena.take<Opposite>(of_b.given->facets)),
          active(arena.take<std::ptrdiff_t>(of_b.given->facets)),
          cuts(arena.take<double>(4 * of_b.given->facets)) {}

    // take(point) for all points of a facet; candidates: of B, in order.
    template <class Take>
    void each_point(std::ptrdiff_t f, const std::ptrdiff_t* candidates, std::ptrdiff_t n,
                    const Take& take) {
        const Facet<2>& facet = a.facet[f];
        if (!(facet.size > 0.0)) return;
        find_opposite(facet, candidates, n);
        sort_ascending(cuts, cuts + n_cuts);
        sort_ascending(opposite, opposite + n_opposite);
        for (std::ptrdiff_t i = 0; i + 1 < n_cuts; ++i) {
            const double from = cuts[i], to = cuts[i + 1];
            if (to - from < least_piece) continue;
            const Opposite* nearest = nearest_at(0.5 * (from + to));
            if (!nearest) continue;
            for (const double side : {-0.5773502691896258, 0.5773502691896258}) {
                const double s = 0.5 * (from + to) + 0.5 * side * (to - from);
                const double t = nearest->place(s);
                take(MeetingPoint<2>{f,
                                     nearest->facet,
                                     {1.0 - s, s},
                                     {1.0 - t, t},
                                     nearest->gap(s),
                                     0.5 * (to - from) * facet.size});
            }
        }
    }

  private:
    // A facet of B above A's: at the ends of B's, the place along A's facet and the height.
    struct Opposite {
        std::ptrdiff_t facet;
        double s[2], height[2];
        double from() const { return std::min(s[0], s[1]); }
        double to() const { return std::max(s[0], s[1]); }
        bool operator<(const Opposite& o) const {
            return from() != o.from() ? from() < o.from() : facet < o.facet;
        }
        double place(double at) const { return (at - s[0]) / (s[1] - s[0]); }
        double gap(double at) const { return height[0] + place(at) * (height[1] - height[0]); }
    };
    void find_opposite(const Facet<2>& facet, const std::ptrdiff_t* candidates, std::ptrdiff_t n) {
        n_opposite = n_cuts = n_begun = n_active = 0;
        const Vector2 along = facet.share[0];
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const Facet<2>& other = b.facet[candidates[i]];
            if (!(other.size > 0.0) || dot(facet.n, other.n) > most_facing) continue;
            Opposite o{candidates[i], {}, {}};
            for (int k = 0; k < 2; ++k) {
                o.s[k] = dot(other.x[k] - facet.x[0], along);
                o.height[k] = dot(other.x[k] - facet.x[0], facet.n);
            }
            const double from = std::max(std::min(o.s[0], o.s[1]), 0.0);
            const double to = std::min(std::max(o.s[0], o.s[1]), 1.0);
            if (to - from < least_piece) continue;
            cuts[n_cuts++] = from;
            cuts[n_cuts++] = to;
            for (const double limit : {-reach, reach}) {  // where it comes within reach
                const double below = limit - o.height[0], above = o.height[1] - limit;
                if (!(below * above > 0.0)) continue;
                const double at = o.s[0] + below / (below + above) * (o.s[1] - o.s[0]);
                if (at > from && at < to) cuts[n_cuts++] = at;
            }
            opposite[n_opposite++] = o;
        }
    }
    // Of those that are nearest the one with the smallest id; for ascending places.
    const Opposite* nearest_at(double s) {
        while (n_begun < n_opposite && opposite[n_begun].from() <= s)
            active[n_active++] = n_begun++;
        const Opposite* best = nullptr;
        std::ptrdiff_t kept = 0;
        for (std::ptrdiff_t i = 0; i < n_active; ++i) {
            const Opposite& o = opposite[active[i]];
            if (o.to() < s) continue;
            active[kept++] = active[i];
            const double gap = o.gap(s);
            if (!(std::fabs(gap) <= reach)) continue;
            const double least = best ? best->gap(s) : gap;
            if (!best || gap < least || (gap == least && o.facet < best->facet)) best = &o;
        }
        n_active = kept;
        return best;
    }

    const Skin<2>&a, &b;
    double reach;
    Opposite* opposite;
    std::ptrdiff_t* active;  // of opposite: begun, and perhaps not ended, where the sweep is
    double* cuts;
    std::ptrdiff_t n_opposite = 0, n_cuts = 0, n_begun = 0, n_active = 0;
};

template <> class Meeting<3> {
  public:
    Meeting(Arena&, const Skin<3>& of_a, const Skin<3>& of_b, const BoxTree<3>& tree_of_b,
            double how_far)
        : a(of_a), b(of_b), tree(tree_of_b), reach(how_far) {}

    template <class Take>
    void each_point(std::ptrdiff_t f, const std::ptrdiff_t* candidates, std::ptrdiff_t n,
                    const Take& take) {
        const Facet<3>& facet = a.facet[f];
        if (!(facet.size > 0.0)) return;
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const Facet<3>& other = b.facet[candidates[i]];
            if (!(other.size > 0.0) || dot(facet.n, other.n) > most_facing) continue;
            Polygon piece = shadow(facet, other);
            if (is_beside(piece)) continue;
            clip(piece);
            for (const double side : {-1.0, 1.0})  // within reach
                cut(piece, [&](const Place& q) { return reach - side * gap_at(facet, other, q); });
            leave_out_needless(piece);
            if (piece.corners >= 3) integrate(f, candidates[i], piece, take);
        }
    }

  private:
    using Place = Vector2;  // shares of the second and the third vertex of A's facet
    // Of a triangle five cuts leave eight corners at most, and a few more by roundoff where it is a sliver.
    struct Polygon {
        static constexpr int most = 12;
        Place at[most];
        int corners;
        void add(const Place& q) {
            if (corners < most) at[corners++] = q;
        }
    };
    // A triangle, or triangles around the middle, no corner before another; three points for each, the middles of its sides, what
    // two of them share once.
    template <class Take>
    void integrate(std::ptrdiff_t f, std::ptrdiff_t other_f, const Polygon& piece,
                   const Take& take) {
        const Facet<3>&facet = a.facet[f], &other = b.facet[other_f];
        const int n = piece.corners;
        Place middle{};
        for (int k = 0; k < n; ++k) middle = middle + piece.at[k] / double(n);
        const auto add = [&](const Place& at, double share) {
            if (!(share > 0.0)) return;
            MeetingPoint<3> out{f,  other_f, {1.0 - at[0] - at[1], at[0], at[1]},
                                {}, 0.0,     share * facet.size / 3.0};
            out.gap = find_place(facet, other, at, out.place_b);
            take(out);
        };
        // Of the triangle that has its base between a corner and the next.
        const auto share_of = [&](const Place& apex, int k) {
            const Place &from = piece.at[k], &to = piece.at[(k + 1) % n];
            const double share = std::fabs(cross(from - apex, to - apex));
            if (!(share * facet.size > least_piece * std::min(facet.size, other.size))) return 0.0;
            const Place centre = (apex + from + to) / 3.0;
            const double gap = gap_at(facet, other, centre);
            return std::fabs(gap) <= reach && !is_hidden(facet, other_f, centre, gap) ? share : 0.0;
        };
        if (n == 3) {
            const double share = share_of(piece.at[2], 0);
            for (int k = 0; k < 3; ++k) add((piece.at[k] + piece.at[(k + 1) % 3]) / 2.0, share);
            return;
        }
        double share[Polygon::most];
        for (int k = 0; k < n; ++k) share[k] = share_of(middle, k);
        for (int k = 0; k < n; ++k) {
            add((piece.at[k] + piece.at[(k + 1) % n]) / 2.0, share[k]);
            add((middle + piece.at[k]) / 2.0, share[(k + n - 1) % n] + share[k]);
        }
    }
    static double cross(const Place& u, const Place& v) { return u[0] * v[1] - u[1] * v[0]; }

    // Shares of a point, along A's normal.
    static Place place_on(const Facet<3>& facet, const Vector3& x) {
        const Vector3 y = x - facet.x[0];
        return {dot(y, facet.share[0]), dot(y, facet.share[1])};
    }
    static Polygon shadow(const Facet<3>& facet, const Facet<3>& other) {
        Polygon p{{}, 3};
        for (int i = 0; i < 3; ++i) p.at[i] = place_on(facet, other.x[i]);
        return p;
    }
    // Beyond one of the facet's sides with all its corners.
    static bool is_beside(const Polygon& p) {
        bool beyond[3] = {true, true, true};
        for (int i = 0; i < p.corners; ++i) {
            const Place& q = p.at[i];
            for (int k = 0; k < 2; ++k) beyond[k] = beyond[k] && q[k] < 0.0;
            beyond[2] = beyond[2] && 1.0 - q[0] - q[1] < 0.0;
        }
        return beyond[0] || beyond[1] || beyond[2];
    }
    // What of it lies on the facet: shares >= 0 (Sutherland and Hodgman).
    static void clip(Polygon& p) {
        for (int side = 0; side < 3; ++side) {
            const auto inside = [side](const Place& q) {
                return side == 2 ? 1.0 - q[0] - q[1] : q[side];
            };
            cut(p, inside);
        }
    }
    // What of it lies where this is >= 0.
    template <class Inside> static void cut(Polygon& p, const Inside& inside) {
        Polygon out{{}, 0};
        for (int i = 0; i < p.corners; ++i) {
            const Place &from = p.at[i], &to = p.at[(i + 1) % p.corners];
            const double d = inside(from), e = inside(to);
            if (d >= 0.0) out.add(from);
            if ((d >= 0.0) != (e >= 0.0)) out.add(from + (d / (d - e)) * (to - from));
        }
        p = out;
    }
    // Corners that bound nothing: what cuts leave, by the last bit, where a corner or a side lies on a side of the facet.
    static void leave_out_needless(Polygon& p) {
        double area = 0.0;
        for (int i = 1; i + 1 < p.corners; ++i)
            area += cross(p.at[i] - p.at[0], p.at[i + 1] - p.at[0]);
        for (int i = 0; i < p.corners && p.corners >= 3;) {
            const Place& before = p.at[(i + p.corners - 1) % p.corners];
            const Place& after = p.at[(i + 1) % p.corners];
            const double bounded = cross(p.at[i] - before, after - before);
            if (std::fabs(bounded) > 1e-9 * std::fabs(area)) {
                ++i;
                continue;
            }
            std::copy(p.at + i + 1, p.at + p.corners, p.at + i);
            --p.corners;
        }
    }
    static Vector3 point_of(const Facet<3>& facet, const Place& at) {
        return facet.x[0] + at[0] * (facet.x[1] - facet.x[0]) + at[1] * (facet.x[2] - facet.x[0]);
    }
    static double gap_at(const Facet<3>& facet, const Facet<3>& other, const Place& at) {
        return dot(other.x[0] - point_of(facet, at), other.n) / dot(facet.n, other.n);
    }
    // Shares of the vertices of B opposite a place of A; returns the gap.
    static double find_place(const Facet<3>& facet, const Facet<3>& other, const Place& at,
                             double* shares) {
        const double gap = gap_at(facet, other, at);
        const Place on = place_on(other, point_of(facet, at) + gap * facet.n);
        shares[0] = 1.0 - on[0] - on[1];
        shares[1] = on[0];
        shares[2] = on[1];
        return gap;
    }
    bool is_hidden(const Facet<3>& facet, std::ptrdiff_t self, const Place& at, double gap) const {
        Box<3> line = Box<3>::empty();
        for (const double side : {-reach, reach})
            line.include(point_of(facet, at) + side * facet.n);
        return tree.any(line.grown(1e-9 * reach), [&](std::ptrdiff_t i) {
            const Facet<3>& other = b.facet[i];
            if (i == self || !(other.size > 0.0) || dot(facet.n, other.n) > most_facing)
                return false;
            double shares[3];
            const double its = find_place(facet, other, at, shares);
            const bool covers = shares[0] >= 0.0 && shares[1] >= 0.0 && shares[2] >= 0.0;
            return covers && std::fabs(its) <= reach && (its < gap || (its == gap && i < self));
        });
    }

    const Skin<3>&a, &b;
    const BoxTree<3>& tree;  // of B's facets
    double reach;
};

}  // namespace grit::surface
