// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/fill.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "adapters/mpm/cell_list.hpp"

namespace grit::mpm {
namespace {

struct Interval {
    double centre, half;  // [m]
};

// Of the part of an axis between two places.
std::vector<Interval> cut(const Axis& axis, double from, double to, int per_cell) {
    std::vector<Interval> out;
    const double least = 1e-9 * axis.shortest();
    for (int c = 0; c < axis.cells(); ++c) {
        const double cell = axis[c + 1] - axis[c];
        const double begin = std::max(axis[c], from), end = std::min(axis[c + 1], to);
        if (!(end - begin > least)) continue;
        const int n = std::max(1, static_cast<int>(std::lround(per_cell * ((end - begin) / cell))));
        const double half = 0.5 * (end - begin) / n;
        for (int i = 0; i < n; ++i) out.push_back({begin + (2 * i + 1) * half, half});
    }
    return out;
}

struct Bounds {
    double r0 = unlimited, r1 = -unlimited, z0 = unlimited, z1 = -unlimited;
};

Bounds bounds_of(const Outline& outline) {
    Bounds b;
    for (const Vector& x : outline.corners) {
        b.r0 = std::min(b.r0, x.r);
        b.r1 = std::max(b.r1, x.r);
        b.z0 = std::min(b.z0, x.z);
        b.z1 = std::max(b.z1, x.z);
    }
    return b;
}

// Even-odd rule.
bool inside(const Outline& outline, double r, double z) {
    bool in = false;
    const std::size_t n = outline.corners.size();
    for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
        const Vector a = outline.corners[i], b = outline.corners[j];
        if ((a.z > z) != (b.z > z) && r < a.r + (b.r - a.r) * (z - a.z) / (b.z - a.z)) in = !in;
    }
    return in;
}

}  // namespace

Particles fill(const BodyPlan& body, const Axis& r, const Axis& z, bool axisymmetric,
               int own_columns) {
    Particles out(own_columns);
    for (std::size_t k = 0; k < body.outlines.size(); ++k) {
        const Outline& outline = body.outlines[k];
        const auto before = body.outlines.begin();
        const Bounds b = bounds_of(outline);
        const std::vector<Interval> along_r = cut(r, b.r0, b.r1, body.particles_r);
        for (const Interval& j : cut(z, b.z0, b.z1, body.particles_z))
            for (const Interval& i : along_r) {
                const auto here = [&](const Outline& o) { return inside(o, i.centre, j.centre); };
                if (!here(outline)) continue;
                if (std::any_of(before, before + static_cast<std::ptrdiff_t>(k), here)) continue;
                out.add({i.centre, j.centre, i.half, j.half, body.density, body.velocity.r,
                         body.velocity.z},
                        axisymmetric);
            }
    }
    if (out.size() == 0)
        throw std::invalid_argument("body " + body.name + ": no particle has its centre inside");
    return out;
}

std::vector<int> outermost(Particles& particles, const Axis& r, const Axis& z,
                           const TractionPlan& traction) {
    namespace c = column;
    const ParticleView q = particles.view();
    const CellList list(particles, r, z);
    const double to_r = traction.edge == Edge::right  ? 1.0
                        : traction.edge == Edge::left ? -1.0
                                                      : 0.0;
    const double to_z = traction.edge == Edge::top      ? 1.0
                        : traction.edge == Edge::bottom ? -1.0
                                                        : 0.0;
    std::vector<int> out;
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const double x = q[c::r][p], y = q[c::z][p];
        if (!(x >= traction.r[0] && x <= traction.r[1] && y >= traction.z[0] && y <= traction.z[1]))
            continue;
        const double beyond_r = x + 1.001 * to_r * q[c::l_r][p];
        const double beyond_z = y + 1.001 * to_z * q[c::l_z][p];
        if (list.covering(beyond_r, beyond_z, p) < 0) out.push_back(particles.ids()[p]);
    }
    if (out.empty())
        throw std::invalid_argument("traction on body " + traction.body +
                                    ": no outermost edge in its range");
    return out;
}

void check_apart(Particles& one, Particles& other, const Axis& r, const Axis& z,
                 const std::string& names) {
    const CellList list(other, r, z);
    const ParticleView q = one.view();
    for (std::ptrdiff_t p = 0; p < one.size(); ++p) {
        const double x = q[column::r][p], y = q[column::z][p];
        if (list.covering(x, y) >= 0)
            throw std::invalid_argument("bodies " + names + " share the place (" +
                                        std::to_string(x) + ", " + std::to_string(y) + ") m");
    }
}

}  // namespace grit::mpm
