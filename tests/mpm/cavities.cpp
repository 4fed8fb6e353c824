// SPDX-License-Identifier: BSD-3-Clause
// Cavities in an elastic medium: cylindrical p = 2 G u/a, spherical p = 4 G u/a, both corrected for the outer
// boundary, which is free, by Lame's solution.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/shapes.hpp"

namespace {

using namespace mpm_test;

constexpr double E = 1e7, nu = 0.3, G = 0.5 * E / (1.0 + nu), rho = 1000.0, a = 0.5;

// u/a over p/(2 G) of a cylinder from a to b in plane strain.
double cylinder_factor(double b) { return (b * b + (1.0 - 2.0 * nu) * a * a) / (b * b - a * a); }

// u/a over p/(4 G) of a hollow sphere.
double sphere_factor(double b) {
    const double a3 = a * a * a, b3 = b * b * b;
    return (b3 + 2.0 * (1.0 - 2.0 * nu) / (1.0 + nu) * a3) / (b3 - a3);
}

// Cells of h up to twice the radius, then growing by a tenth each; the last node is at b.
std::vector<double> graded(double from, double to, double h, double fine) {
    std::vector<double> nodes{from};
    for (double length = h; nodes.back() < to; length *= nodes.back() < fine ? 1.0 : 1.1)
        nodes.push_back(nodes.back() + length);
    return nodes;
}

// Particles of half a cell between the given nodes of the radius and of z.
Body make_graded(const std::vector<double>& r, const std::vector<double>& z) {
    Body body;
    for (std::size_t j = 0; j + 1 < z.size(); ++j)
        for (std::size_t i = 0; i + 1 < r.size(); ++i)
            for (const double y : {0.25, 0.75})
                for (const double x : {0.25, 0.75}) {
                    const double l_r = 0.25 * (r[i + 1] - r[i]), l_z = 0.25 * (z[j + 1] - z[j]);
                    body.particles.add({r[i] + 4.0 * x * l_r, z[j] + 4.0 * y * l_z, l_r, l_z, rho},
                                       true);
                }
    body.material = std::make_unique<LinearElastic>(E, nu);
    return body;
}

// The wall is a rigid body that grows until its surface is on a grid line; the pressure is that of the
// contact. Elsewhere between grid lines the error is of first order in the cell size, up to 6 % here: the
// nodes of two lines carry, and what is between them with its hoop stress.
struct Cavity {
    int law = GRIT_CONTACT_GEO;
    double beyond = 0.0;  // the wall's last place, from a grid line outwards [cells]
    int cells = 12;       // in the radius
    double hold = 0.2;    // [s]

    // Of p = 2 G u/a.
    double error() const {
        const double h = a / cells, u = 0.02 * h, rise = 0.02;
        std::vector<double> nodes;
        for (int i = 0; i < cells; ++i) nodes.push_back(i * h);
        for (const double r : graded(a, 20.0 * a, h, 2.0 * a)) nodes.push_back(r);
        const std::vector<double> layer{0.0, h, 2.0 * h};
        Simulation simulation(Axis(nodes), Axis(layer),
                              {.axisymmetric = true, .local_damping = 0.5});
        const double from = a + beyond * h - u;
        Body wall = make_box({from - 2.0 * h, from, 0.0, 2.0 * h, 4, 4, rho}, true, nullptr);
        wall.prescribed_velocity = [=](double t) {
            return grit::Vector2{t < rise ? u / rise : 0.0, 0.0};
        };
        simulation.add_body(std::move(wall));
        std::vector<double> medium = graded(from, nodes[nodes.size() - 2], h, 2.0 * a);
        medium.pop_back();
        medium.back() = nodes[nodes.size() - 2];
        simulation.add_body(make_graded(medium, layer));
        simulation.fix_below(1, 0.0);
        simulation.fix_above(1, 2.0 * h);
        simulation.add_contact(contact_law(law, 0.0));
        while (simulation.time() < rise + hold) simulation.step();
        const double start = simulation.time();
        double impulse = 0.0;
        while (simulation.time() < start + 0.01) {
            const double before = simulation.time();
            simulation.step();
            const double dt = simulation.time() - before;
            impulse += dt * simulation.contact(0).totals().force_on_b[0];
        }
        const Particles& q = simulation.body(0).particles;
        const double last = q(column::r, simulation.find(0, 3)) + q(column::l_r, 0);
        const double pressure = impulse / (simulation.time() - start) / (last * 2.0 * h);
        return pressure / (2.0 * G * (last - from) / from / cylinder_factor(medium.back())) - 1.0;
    }
};

TEST(CylindricalCavity, GrowsAgainstTwiceTheShearModulus) {
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
        Cavity cavity;
        cavity.law = law;
        EXPECT_NEAR(cavity.error(), 0.0, 0.02);
    }
}

// A quarter of the section of a hollow sphere, symmetric to z = 0: rings of particles around its centre.
TEST(SphericalCavity, GrowsAgainstFourTimesTheShearModulus) {
    constexpr double h = a / 10.0, b = 4.0 * a, pressure = 1e4;
    constexpr int rings = 60, sectors = 40;
    const int cells = 42;
    Simulation simulation(Axis::uniform(0.0, cells * h, cells),
                          Axis::uniform(0.0, cells * h, cells),
                          {.axisymmetric = true, .local_damping = 0.5});
    Body body;
    for (int k = 0; k < rings; ++k)
        for (int i = 0; i < sectors; ++i)
            add_sector(body.particles,
                       {a + (b - a) * k / rings, a + (b - a) * (k + 1) / rings,
                        0.5 * std::numbers::pi * i / sectors,
                        0.5 * std::numbers::pi * (i + 1) / sectors},
                       {0.0, 0.0}, rho, true);
    body.material = std::make_unique<LinearElastic>(E, nu);
    simulation.add_body(std::move(body));
    simulation.fix_below(1, 0.0);
    for (int i = 0; i < sectors; ++i) {
        const double angle = 0.5 * std::numbers::pi * (i + 0.5) / sectors;
        // An edge is as long as the middle of its particle.
        const double p = pressure * a / (a + 0.5 * (b - a) / rings);
        const grit::Vector2 stress{p * std::cos(angle), p * std::sin(angle)};
        simulation.add_traction({0, i, Edge::left, [stress](double t) {
                                     const double share = std::min(1.0, t / 0.02);
                                     return grit::Vector2{share * stress[0], share * stress[1]};
                                 }});
    }
    const auto radius = [&](int i) {
        const Particles& q = simulation.body(0).particles;
        const std::ptrdiff_t p = simulation.find(0, i);
        const double r = q(column::r, p) - q(column::F_rr, p) * q(column::l_r, p);
        const double z = q(column::z, p) - q(column::F_zr, p) * q(column::l_r, p);
        return std::hypot(r, z);
    };
    std::vector<double> before;
    for (int i = 0; i < sectors; ++i) before.push_back(radius(i));
    while (simulation.time() < 0.15) simulation.step();
    double mean = 0.0;
    for (int i = 0; i < sectors; ++i)
        mean += (radius(i) - before[static_cast<std::size_t>(i)]) / sectors;
    const double expected = a * pressure / (4.0 * G) * sphere_factor(b);
    EXPECT_NEAR(mean, expected, 0.02 * expected);
}

}  // namespace
