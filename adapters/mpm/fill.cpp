// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/fill.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
    const AxisView a_r = r.view(), a_z = z.view();
    std::vector<std::vector<std::ptrdiff_t>> by_cell(static_cast<std::size_t>(r.cells()) *
                                                     static_cast<std::size_t>(z.cells()));
    const auto cell = [&](double x, double y) -> std::vector<std::ptrdiff_t>& {
        const auto row = static_cast<std::size_t>(a_z.cell_of(y));
        return by_cell[row * static_cast<std::size_t>(a_r.cells) +
                       static_cast<std::size_t>(a_r.cell_of(x))];
    };
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) cell(q[c::r][p], q[c::z][p]).push_back(p);
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
        const std::vector<std::ptrdiff_t>& near = cell(beyond_r, beyond_z);
        const bool covered = std::any_of(near.begin(), near.end(), [&](std::ptrdiff_t o) {
            return o != p && std::abs(q[c::r][o] - beyond_r) <= q[c::l_r][o] &&
                   std::abs(q[c::z][o] - beyond_z) <= q[c::l_z][o];
        });
        if (!covered) out.push_back(particles.ids()[p]);
    }
    if (out.empty())
        throw std::invalid_argument("traction on body " + traction.body +
                                    ": no outermost edge in its range");
    return out;
}

}  // namespace grit::mpm
