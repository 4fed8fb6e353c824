// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/fill.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "adapters/mpm/case/slabs.hpp"
#include "adapters/mpm/grid/cell_list.hpp"

namespace grit::mpm {
namespace {

struct Bounds {
    double r0 = unlimited, r1 = -unlimited, z0 = unlimited, z1 = -unlimited;
};

Bounds bounds_of(const Outline& outline) {
    Bounds b;
    for (const Vector2& x : outline.corners) {
        b.r0 = std::min(b.r0, x[0]);
        b.r1 = std::max(b.r1, x[0]);
        b.z0 = std::min(b.z0, x[1]);
        b.z1 = std::max(b.z1, x[1]);
    }
    return b;
}

// Sides along r and z.
bool is_box(const Outline& outline) {
    const Bounds b = bounds_of(outline);
    const auto at_corner = [&b](const Vector2& x) {
        return (x[0] == b.r0 || x[0] == b.r1) && (x[1] == b.z0 || x[1] == b.z1);
    };
    const std::vector<Vector2>& x = outline.corners;
    return x.size() == 4 && std::all_of(x.begin(), x.end(), at_corner) &&
           (x[0][0] == x[1][0] || x[0][1] == x[1][1]) && (x[1][0] == x[2][0] || x[1][1] == x[2][1]);
}

// Even-odd rule.
bool inside(const Outline& outline, double r, double z) {
    bool in = false;
    const std::size_t n = outline.corners.size();
    for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
        const Vector2 a = outline.corners[i], b = outline.corners[j];
        if ((a[1] > z) != (b[1] > z) && r < a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1]))
            in = !in;
    }
    return in;
}

}  // namespace

Particles fill(const BodyPlan& body, const Axis& r, const Axis& z, bool axisymmetric,
               int own_columns) {
    Particles out(own_columns);
    double asked = 0.0;
    for (std::size_t k = 0; k < body.outlines.size(); ++k) {
        const Outline& outline = body.outlines[k];
        const auto before = body.outlines.begin();
        const Bounds b = bounds_of(outline);
        const int per_cell_r = outline.particles_r > 0 ? outline.particles_r : body.particles_r;
        const int per_cell_z = outline.particles_z > 0 ? outline.particles_z : body.particles_z;
        const std::vector<Slab> along_r = cut(r, b.r0, b.r1, per_cell_r);
        const std::vector<Slab> along_z = cut(z, b.z0, b.z1, per_cell_z);
        asked += static_cast<double>(along_r.size()) * static_cast<double>(along_z.size());
        check_particles(asked, body.name);
        for (const Slab& j : along_z)
            for (const Slab& i : along_r) {
                const auto here = [&](const Outline& o) { return inside(o, i.centre, j.centre); };
                if (!here(outline)) continue;
                if (std::any_of(before, before + static_cast<std::ptrdiff_t>(k), here)) continue;
                out.add({i.centre, j.centre, i.half, j.half, body.density, body.velocity[0],
                         body.velocity[1]},
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

void check_boxes_apart(const BodyPlan& one, const BodyPlan& other) {
    for (const Outline& mine : one.outlines)
        for (const Outline& theirs : other.outlines) {
            if (!is_box(mine) || !is_box(theirs)) continue;
            const Bounds a = bounds_of(mine), b = bounds_of(theirs);
            const double r0 = std::max(a.r0, b.r0), r1 = std::min(a.r1, b.r1);
            const double z0 = std::max(a.z0, b.z0), z1 = std::min(a.z1, b.z1);
            const double least_r = roundoff * std::min(a.r1 - a.r0, b.r1 - b.r0);
            const double least_z = roundoff * std::min(a.z1 - a.z0, b.z1 - b.z0);
            if (r1 - r0 > least_r && z1 - z0 > least_z)
                throw std::invalid_argument("bodies " + one.name + " and " + other.name +
                                            " share the place from (" + std::to_string(r0) + ", " +
                                            std::to_string(z0) + ") to (" + std::to_string(r1) +
                                            ", " + std::to_string(z1) + ") m");
        }
}

}  // namespace grit::mpm
