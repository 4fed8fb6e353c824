// SPDX-License-Identifier: BSD-3-Clause
// From the point that a vertex has hit, walk along the master's line as far as it lies opposite the
// halves of the vertex' own segments. What is walked is the area: a side of the vertex that does not
// face the master, and what overhangs an edge of the master, carry nothing. What lies less than half
// as deep as the vertex counts less, and nothing where the bodies do not overlap. Each piece belongs
// to a vertex of the master; if that one is in contact too, both see the same place and share it: each
// has half the stiffness as long as the other sees at least half its depth, and more the less the
// other sees. So no force jumps when a vertex or a view comes in.
#include "contact/penalty/area.hpp"

#include <initializer_list>

namespace grit::penalty {
namespace {

constexpr double least_facing = 1e-3;  // -n.n': segments at right angles do not face, by a margin

double facing(Vector2 n, Vector2 other) { return -dot(n, other); }

// 0 where the depth is 0, 1 where it is at least half the reference.
double ramp(double depth, double reference) {
    return std::min(1.0, 2.0 * std::max(0.0, depth) / reference);
}

struct Half {
    Vector2 x, e, n;  // the vertex, half the vector to its neighbour, normal of that segment
    double r, dr;     // the weight at x and its change along e: the radius, or 1 and 0
    int direction;    // of the walk along the master: against the slave's own
};

// A stretch of a half that lies opposite one piece of the master; u in [0, 1] along e.
struct Stretch {
    double u_0, u_1;
    double depth_0, depth_1;
};

// The integral of ramp(depth) r over u: exact, for both are linear between the ramp's bends.
double weighted_length(const Half& half, const Stretch& s, double reference) {
    const auto bend = [&](double depth) {
        const double part = (depth - s.depth_0) / (s.depth_1 - s.depth_0);
        return part > 0.0 && part < 1.0 ? part : 0.0;  // not a number: constant depth
    };
    const double zero = bend(0.0), full = bend(0.5 * reference);
    const double ends[4] = {0.0, std::min(zero, full), std::max(zero, full), 1.0};
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double middle = 0.5 * (ends[i] + ends[i + 1]);
        const auto integrand = [&](double part) {
            const double u = s.u_0 + part * (s.u_1 - s.u_0);
            const double depth = s.depth_0 + part * (s.depth_1 - s.depth_0);
            return ramp(depth, reference) * (half.r + u * half.dr);
        };
        sum += (ends[i + 1] - ends[i]) / 6.0 *
               (integrand(ends[i]) + 4.0 * integrand(middle) + integrand(ends[i + 1]));
    }
    return sum * (s.u_1 - s.u_0);
}

double area_along(const Line& master, const Half& half, const Hit& hit) {
    const bool ahead = half.direction > 0;
    const double length = norm(half.e), reference = -hit.gap;
    std::ptrdiff_t k = hit.segment;
    double at = hit.xi, u = 0.0, area = 0.0;
    for (std::ptrdiff_t steps = 0; steps < 2 * master.segments + 2; ++steps) {
        const bool near_start = ahead ? at < 0.5 : at <= 0.5;
        double end = ahead ? (near_start ? 0.5 : 1.0) : (near_start ? 0.0 : 0.5);
        const Segment& segment = master.segment[k];
        const double piece = std::fabs(end - at) * segment.length;
        if (piece > 0.0) {
            const double f = facing(half.n, segment.n);
            if (!(f >= least_facing)) break;
            const bool last = piece >= f * (1.0 - u) * length;
            const double u_end = last ? 1.0 : u + piece / (f * length);
            const auto depth = [&](double place) {
                return dot(master.x[k] - half.x - place * half.e, segment.n);
            };
            const Stretch stretch{u, u_end, depth(u), depth(u_end)};
            const std::ptrdiff_t owner = near_start ? k : master.end_of(k);
            const double share = 1.0 - 0.5 * ramp(-master.hit[owner].gap, reference);
            area += f * length * share * weighted_length(half, stretch, reference);
            if (last) break;
            u = u_end;
        }
        if (end == (ahead ? 1.0 : 0.0)) {
            k = ahead ? master.after(k) : master.before(k);
            if (k < 0) break;
            end = ahead ? 0.0 : 1.0;
        }
        at = end;
    }
    return area;
}

}  // namespace

void keep_facing_hits(Line& slave) {
    for (std::ptrdiff_t v = 0; v < slave.vertices; ++v) {
        Hit& hit = slave.hit[v];
        if (hit.gap == 0.0) continue;
        bool faces = false;
        for (const std::ptrdiff_t j : {slave.leaving(v), slave.arriving(v)})
            faces = faces || (j >= 0 && facing(slave.segment[j].n, hit.n) >= least_facing);
        if (!faces) hit = {-1, 0.0, 0.0, {0.0, 0.0}};
    }
}

double contact_area(const Line& slave, std::ptrdiff_t v, const Line& master, bool axisymmetric) {
    const Hit& hit = slave.hit[v];
    double area = 0.0;
    for (const bool next : {true, false}) {
        const std::ptrdiff_t j = next ? slave.leaving(v) : slave.arriving(v);
        if (j < 0 || !(facing(slave.segment[j].n, hit.n) >= least_facing)) continue;
        const Vector2 x = slave.x[v], other = slave.x[next ? slave.end_of(j) : j];
        const double r = axisymmetric ? std::max(x[0], 0.0) : 1.0;
        const double dr = axisymmetric ? 0.5 * (std::max(other[0], 0.0) - r) : 0.0;
        area += area_along(master, {x, 0.5 * (other - x), slave.segment[j].n, r, dr, next ? -1 : 1},
                           hit);
    }
    return area;
}

double half_segment_area(double length, double r_v, double r_other, bool axisymmetric) {
    const double r = 0.25 * (3.0 * std::max(r_v, 0.0) + std::max(r_other, 0.0));
    return 0.5 * length * (axisymmetric ? r : 1.0);
}

}  // namespace grit::penalty
