// SPDX-License-Identifier: BSD-3-Clause
// From the point that a vertex has hit, walk along the master's line as far as it lies opposite the
// halves of the vertex' own segments. What is walked is the area: a side of the vertex that does not
// face the master, and what overhangs an edge of the master, carry nothing. Each piece belongs to a
// vertex of the master; if that one is in contact too, both see the same place and share it:
//   depths d and d': weight 1 - min(1, d'/d)/2, so that both tractions add up to eps_n max(d, d')
// and a vertex that comes into contact changes no force by a jump.
#include "contact/penalty_area.hpp"

#include <initializer_list>

namespace grit::penalty {
namespace {

constexpr double least_facing = 1e-3;  // -n.n': segments at right angles do not face, by a margin

double facing(Vec n, Vec other) { return -dot(n, other); }

struct Half {
    Vec n;          // of the slave's segment
    double length;  // half of it
    double r_v, r_end;
    int direction;  // of the walk along the master: against the slave's own
};

struct Walk {
    const Line& master;
    double depth;
    bool axisymmetric;
};

double share(const Walk& walk, std::ptrdiff_t owner) {
    const double other = -walk.master.hit[owner].gap;
    return 1.0 - 0.5 * std::min(1.0, other / walk.depth);
}

double area_along(const Walk& walk, const Half& half, const Hit& hit) {
    const Line& master = walk.master;
    const bool ahead = half.direction > 0;
    std::ptrdiff_t k = hit.segment;
    double at = hit.xi, done = 0.0, area = 0.0;
    for (std::ptrdiff_t steps = 0; steps < 2 * master.segments + 2; ++steps) {
        const bool near_start = ahead ? at < 0.5 : at <= 0.5;
        const double end = ahead ? (near_start ? 0.5 : 1.0) : (near_start ? 0.0 : 0.5);
        const double piece = std::fabs(end - at) * master.segment[k].length;
        if (piece > 0.0) {
            const double f = facing(half.n, master.segment[k].n);
            if (!(f >= least_facing)) break;
            const double left = half.length - done;
            const bool last = piece >= f * left;
            const double step = last ? left : piece / f;
            const double middle = (done + 0.5 * step) / half.length;
            const double r = walk.axisymmetric ? half.r_v + middle * (half.r_end - half.r_v) : 1.0;
            area += f * step * r * share(walk, near_start ? k : master.end_of(k));
            done += step;
            if (last) break;
        }
        at = end;
        if (end == (ahead ? 1.0 : 0.0)) {
            k = ahead ? master.after(k) : master.before(k);
            if (k < 0) break;
            at = ahead ? 0.0 : 1.0;
        }
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
    const Walk walk{master, -hit.gap, axisymmetric};
    double area = 0.0;
    for (const bool next : {true, false}) {
        const std::ptrdiff_t j = next ? slave.leaving(v) : slave.arriving(v);
        if (j < 0 || !(facing(slave.segment[j].n, hit.n) >= least_facing)) continue;
        const double r_v = std::max(slave.x[v].x, 0.0);
        const double r_other = std::max(slave.x[next ? slave.end_of(j) : j].x, 0.0);
        const Half half{slave.segment[j].n, 0.5 * slave.segment[j].length, r_v,
                        0.5 * (r_v + r_other), next ? -1 : 1};
        area += area_along(walk, half, hit);
    }
    return area;
}

double half_segment_area(double length, double r_v, double r_other, bool axisymmetric) {
    const double r = 0.25 * (3.0 * std::max(r_v, 0.0) + std::max(r_other, 0.0));
    return 0.5 * length * (axisymmetric ? r : 1.0);
}

}  // namespace grit::penalty
