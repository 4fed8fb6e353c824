// SPDX-License-Identifier: BSD-3-Clause
// Bodies whose particles follow their surface, and sums over them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/box.hpp"

namespace mpm_test {

// A parallelogram with half-side vectors r1, r2 [m], counter-clockwise.
inline void add_parallelogram(Particles& particles, Vector centre, Vector r1, Vector r2,
                              double density, bool axisymmetric) {
    namespace c = column;
    const double quarter = r1.r * r2.z - r1.z * r2.r, l = std::sqrt(quarter);
    particles.add({centre.r, centre.z, std::min(l, centre.r > 0.0 ? centre.r : l), l, density},
                  axisymmetric);
    const ParticleView q = particles.view();
    const std::ptrdiff_t p = particles.size() - 1;
    q[c::l_r][p] = q[c::l_z][p] = l;
    q[c::F_rr][p] = r1.r / l;
    q[c::F_zr][p] = r1.z / l;
    q[c::F_rz][p] = r2.r / l;
    q[c::F_zz][p] = r2.z / l;
    q[c::V0][p] = 4.0 * quarter * (axisymmetric ? centre.r : 1.0);
    q[c::mass][p] = density * q[c::V0][p];
}

// A sector of a ring around (0, 0) between two radii and two angles against the axis z = 0.
struct Sector {
    double from, to;          // [m]
    double angle_0, angle_1;  // [rad]
};

inline void add_sector(Particles& particles, const Sector& s, Vector middle, double density,
                       bool axisymmetric) {
    const double angle = 0.5 * (s.angle_0 + s.angle_1), half = 0.5 * (s.angle_1 - s.angle_0);
    const double radius = 0.5 * (s.from + s.to), thick = 0.5 * (s.to - s.from);
    const Vector out{std::cos(angle), std::sin(angle)};
    // As wide as the area of the sector wants it.
    const double width = radius * half;
    add_parallelogram(particles, {middle.r + radius * out.r, middle.z + radius * out.z},
                      {thick * out.r, thick * out.z}, {-width * out.z, width * out.r}, density,
                      axisymmetric);
}

// A solid disk of rings of particles about as wide as thick, symmetric to both axes.
inline Body make_disk(Vector middle, double radius, int rings, double density,
                      std::unique_ptr<Material> material) {
    constexpr double pi = std::numbers::pi;
    Body body;
    body.particles = Particles(material->own_columns());
    const double thick = radius / rings;
    const double core = 0.5 * std::sqrt(pi) * thick;
    add_parallelogram(body.particles, middle, {core, 0.0}, {0.0, core}, density, false);
    for (int k = 1; k < rings; ++k) {
        const int sectors = 4 * static_cast<int>(std::lround(0.5 * pi * (k + 0.5)));
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
    body.prescribed_velocity = [](double) { return Vector{0.0, 0.0}; };
    return body;
}

}  // namespace mpm_test
