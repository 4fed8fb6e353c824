// SPDX-License-Identifier: BSD-3-Clause
// Bodies whose particles follow their surface, and sums over them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/box.hpp"

namespace mpm_test {

// A parallelogram with half-side vectors r1, r2 [m], counter-clockwise.
inline void add_parallelogram(Particles& particles, grit::Vector2 centre, grit::Vector2 r1,
                              grit::Vector2 r2, double density, bool axisymmetric) {
    namespace c = column;
    const double quarter = r1[0] * r2[1] - r1[1] * r2[0], l = std::sqrt(quarter);
    particles.add({centre[0], centre[1], std::min(l, centre[0] > 0.0 ? centre[0] : l), l, density},
                  axisymmetric);
    const ParticleView q = particles.view();
    const std::ptrdiff_t p = particles.size() - 1;
    q[c::l_r][p] = q[c::l_z][p] = l;
    q[c::F_rr][p] = r1[0] / l;
    q[c::F_zr][p] = r1[1] / l;
    q[c::F_rz][p] = r2[0] / l;
    q[c::F_zz][p] = r2[1] / l;
    q[c::V0][p] = 4.0 * quarter * (axisymmetric ? centre[0] : 1.0);
    q[c::mass][p] = density * q[c::V0][p];
}

// A sector of a ring around (0, 0) between two radii and two angles against the axis z = 0.
struct Sector {
    double from, to;          // [m]
    double angle_0, angle_1;  // [rad]
};

inline void add_sector(Particles& particles, const Sector& s, grit::Vector2 middle, double density,
                       bool axisymmetric) {
    const double angle = 0.5 * (s.angle_0 + s.angle_1), half = 0.5 * (s.angle_1 - s.angle_0);
    const double radius = 0.5 * (s.from + s.to), thick = 0.5 * (s.to - s.from);
    const grit::Vector2 out{std::cos(angle), std::sin(angle)};
    // As wide as the area of the sector wants it.
    const double width = radius * half;
    add_parallelogram(particles, {middle[0] + radius * out[0], middle[1] + radius * out[1]},
                      {thick * out[0], thick * out[1]}, {-width * out[1], width * out[0]}, density,
                      axisymmetric);
}

// Of ring k of a disk, so that its particles are about as wide as thick.
inline int sectors_of_ring(int k) {
    return 4 * static_cast<int>(std::lround(0.5 * std::numbers::pi * (k + 0.5)));
}

// The polygon of the outermost edges of a disk's particles.
inline BoundaryLine rim_of_disk(grit::Vector2 middle, double radius, int rings) {
    BoundaryLine line{{}, true};
    const int sides = sectors_of_ring(rings - 1);
    const double corner = radius / std::cos(std::numbers::pi / sides);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        line.points.push_back(
            {middle[0] + corner * std::cos(angle), middle[1] + corner * std::sin(angle)});
    }
    return line;
}

// A solid disk of rings of particles about as wide as thick, symmetric to both axes.
inline Body make_disk(grit::Vector2 middle, double radius, int rings, double density,
                      std::unique_ptr<Material> material) {
    constexpr double pi = std::numbers::pi;
    Body body;
    body.particles = Particles(material->own_columns());
    const double thick = radius / rings;
    const double core = 0.5 * std::sqrt(pi) * thick;
    add_parallelogram(body.particles, middle, {core, 0.0}, {0.0, core}, density, false);
    for (int k = 1; k < rings; ++k) {
        const int sectors = sectors_of_ring(k);
        for (int i = 0; i < sectors; ++i)
            add_sector(
                body.particles,
                {k * thick, (k + 1) * thick, 2.0 * pi * i / sectors, 2.0 * pi * (i + 1) / sectors},
                middle, density, false);
    }
    body.material = std::move(material);
    return body;
}

// Mass, its centre and its mean velocity.
struct CentreOfMass {
    double mass = 0.0, r = 0.0, z = 0.0, v_r = 0.0, v_z = 0.0;
};

inline CentreOfMass centre_of_mass(const Particles& q) {
    CentreOfMass sum;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
        const double m = q(column::mass, p);
        sum.mass += m;
        sum.r += m * q(column::r, p);
        sum.z += m * q(column::z, p);
        sum.v_r += m * q(column::v_r, p);
        sum.v_z += m * q(column::v_z, p);
    }
    for (double* x : {&sum.r, &sum.z, &sum.v_r, &sum.v_z}) *x /= sum.mass;
    return sum;
}

// What does not move, and nothing moves into.
inline Body make_floor(const Box& box, bool axisymmetric) {
    Body body = make_box(box, axisymmetric, nullptr);
    body.prescribed_velocity = [](double) { return grit::Vector2{0.0, 0.0}; };
    return body;
}

}  // namespace mpm_test
