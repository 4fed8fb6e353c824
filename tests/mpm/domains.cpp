// SPDX-License-Identifier: BSD-3-Clause
// Domains at their limits: stretched, at the axis, turning, leaving.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <adapters/mpm/kernel/place.hpp>

#include "support/box.hpp"
#include "support/one_particle.hpp"

namespace {

using namespace mpm_test;

TEST(Domain, ReachesTheNeighbouringCellsAtMostHoweverItIsStretched) {
    std::mt19937 generator(4);
    for (int sample = 0; sample < 100; ++sample)
        for (const bool axisymmetric : {true, false}) {
            OneParticle q = OneParticle::random(generator, axisymmetric);
            for (const int c : {column::F_rr, column::F_rz, column::F_zr, column::F_zz})
                q[c] *= 20.0;
            q.scatter(Shape::cpdi, axisymmetric);
            const int i_p = q.grid().r.cell_of(q[column::r]);
            const int j_p = q.grid().z.cell_of(q[column::z]);
            double mass = 0.0;
            for (int j = 0, k = 0; j < q.z.nodes(); ++j)
                for (int i = 0; i < q.r.nodes(); ++i, ++k) {
                    const double m = q.nodes[static_cast<std::size_t>(k)][record::m];
                    mass += m;
                    const bool near_r = i >= i_p - 1 && i <= i_p + 2;
                    const bool near_z = j >= j_p - 1 && j <= j_p + 2;
                    EXPECT_TRUE(m == 0.0 || (near_r && near_z));
                    EXPECT_GE(m, 0.0);
                }
            EXPECT_NEAR(mass, q[column::mass], 1e-13 * q[column::mass]);
        }
}

// Singular values of [r1 r2], the larger one first, and the direction of that one.
struct Stretches {
    double s1, s2, angle;
};
Stretches stretches(const baseline::Domain& d) {
    const double rr = d.r1r * d.r1r + d.r2r * d.r2r, zz = d.r1z * d.r1z + d.r2z * d.r2z;
    const double rz = d.r1r * d.r1z + d.r2r * d.r2z;
    const double mean = 0.5 * (rr + zz), radius = std::hypot(0.5 * (rr - zz), rz);
    const double s1 = std::sqrt(mean + radius);
    return {s1, 0.25 * d.area() / s1, 0.5 * std::atan2(2.0 * rz, rr - zz)};
}

TEST(Domain, OfASpentParticleKeepsItsAreaAndDirectionsButNotItsLength) {
    std::mt19937 generator(8);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    int changed = 0;
    for (int sample = 0; sample < 1000; ++sample) {
        const double shear = 30.0 * any(generator), turn = std::numbers::pi * any(generator);
        const double a = 0.01 * (1.5 + any(generator)), b = 0.01 * (1.5 + any(generator));
        const double c = std::cos(turn), s = std::sin(turn);
        const baseline::Domain d{a * c, a * s, b * (shear * c - s), b * (shear * s + c)};
        const baseline::Domain r = baseline::rounded(d);
        const Stretches before = stretches(d), after = stretches(r);
        EXPECT_NEAR(r.area(), d.area(), 1e-12 * d.area() * (1.0 + shear * shear));
        if (before.s1 <= 8.999 * before.s2) {
            EXPECT_EQ(r.r1r, d.r1r);
            continue;
        }
        ++changed;
        EXPECT_NEAR(after.s1 / after.s2, 9.0, 1e-6);
        EXPECT_NEAR(std::sin(after.angle - before.angle), 0.0, 1e-6);
        // Nor is it turned over: its corners stay where they were, seen along the long side.
        EXPECT_GE(r.r2r * d.r2r + r.r2z * d.r2z, 0.0);
    }
    EXPECT_GT(changed, 300);
}

TEST(Domain, DoesNotReachAcrossTheAxis) {
    OneParticle q;
    q.particles.add({0.02, 0.05, 0.02, 0.02, 1000.0}, true);
    q[column::F_rr] = 2.0;
    q.scatter(Shape::cpdi, true);
    double moment = 0.0;
    for (int j = 0, k = 0; j < q.z.nodes(); ++j)
        for (int i = 0; i < q.r.nodes(); ++i, ++k) {
            const double m = q.nodes[static_cast<std::size_t>(k)][record::m];
            EXPECT_GE(m, 0.0);
            moment += m * q.r[i];
        }
    // Weighted mean radius of a domain from the axis to 2 r_p: r_p + r_p / 3.
    EXPECT_NEAR(moment / q[column::mass], 0.02 * 4.0 / 3.0, 1e-12);
}

// Velocity field at all nodes.
std::vector<NodeMotion> motions(const OneParticle& q, double v_r, double v_z, double spin) {
    std::vector<NodeMotion> out;
    const double r = q.particles(column::r, 0), z = q.particles(column::z, 0);
    for (int j = 0; j < q.z.nodes(); ++j)
        for (int i = 0; i < q.r.nodes(); ++i) {
            const double a = v_r - spin * (q.z[j] - z), b = v_z + spin * (q.r[i] - r);
            out.push_back({{a, b, a, b}});
        }
    return out;
}

GatherSums move(OneParticle& q, const std::vector<NodeMotion>& field, bool axisymmetric, double dt,
                Material& material) {
    Increments increments{};
    GatherSums sums;
    const ParticleView view = q.particles.view();
    kernels().gather(Shape::cpdi, axisymmetric,
                     {q.grid(), view, 0, 1, field.data(), dt, 0.0, task::all}, increments, sums);
    material.update({view, 0, 1}, increments);
    return sums;
}

TEST(Particle, CarriesItsStressAlongWhenItTurns) {
    std::mt19937 generator(6);
    OneParticle q = OneParticle::random(generator, false);
    q[column::F_rr] = q[column::F_zz] = 1.0;
    q[column::F_rz] = q[column::F_zr] = 0.0;
    q[column::S_rr] = 3e5;
    q[column::S_zz] = 1e5;
    LinearElastic soft(1e-3, 0.0);
    constexpr int steps = 1000;
    constexpr double angle = std::numbers::pi / 6.0;  // anticlockwise
    for (int i = 0; i < steps; ++i) move(q, motions(q, 0.0, 0.0, angle), false, 1.0 / steps, soft);
    EXPECT_NEAR(q[column::S_rr], 2.5e5, 10.0);
    EXPECT_NEAR(q[column::S_zz], 1.5e5, 10.0);
    EXPECT_NEAR(q[column::S_rz], 1e5 * std::sin(2.0 * angle), 10.0);
    EXPECT_NEAR(q[column::F_zr], std::sin(angle), 1e-3);
    EXPECT_NEAR(q[column::F_rz], -std::sin(angle), 1e-3);
}

TEST(Particle, IsNotStrainedByARigidTurnHoweverLarge) {
    std::mt19937 generator(9);
    OneParticle q = OneParticle::random(generator, false);
    const double r = q[column::r], z = q[column::z], turn = 0.5;
    std::vector<NodeMotion> field;
    for (int j = 0; j < q.z.nodes(); ++j)
        for (int i = 0; i < q.r.nodes(); ++i) {
            const double x = q.r[i] - r, y = q.z[j] - z;
            const double u = (std::cos(turn) - 1.0) * x - std::sin(turn) * y;
            const double w = std::sin(turn) * x + (std::cos(turn) - 1.0) * y;
            field.push_back({{u, w, u, w}});
        }
    Increments increments{};
    GatherSums sums;
    kernels().gather(Shape::cpdi, false,
                     {q.grid(), q.particles.view(), 0, 1, field.data(), 1.0, 0.0, task::all},
                     increments, sums);
    for (const auto& strain : increments.strain) EXPECT_NEAR(strain[0], 0.0, 1e-13);
    EXPECT_NEAR(increments.rotation[0][0], std::cos(turn), 1e-13);
    EXPECT_NEAR(increments.rotation[3][0], std::sin(turn), 1e-13);
}

TEST(Particle, ThatCrossesTheAxisComesBackAsItsMirrorImage) {
    OneParticle q;
    q.particles.add({0.02, 0.05, 0.01, 0.01, 1000.0}, true);
    q[column::v_r] = -1.0;
    q[column::v_z] = 0.5;
    q[column::F_rz] = 0.2;
    q[column::F_zr] = -0.1;
    q[column::S_rz] = 7.0;
    q[column::b_r] = 3.0;
    LinearElastic material(1e-3, 0.0);
    std::vector<NodeMotion> field = motions(q, -1.0, 0.5, 0.0);
    for (NodeMotion& m : field) m[motion::other_r] = m[motion::v_r];
    const GatherSums sums = move(q, field, true, 0.05, material);
    EXPECT_EQ(sums.reflected, 1);
    EXPECT_EQ(sums.outside, 0);
    reflect(material, q.particles.view(), 0);
    EXPECT_NEAR(q[column::r], 0.03, 1e-14);
    EXPECT_NEAR(q[column::v_r], 1.0, 1e-14);
    EXPECT_NEAR(q[column::v_z], 0.5, 1e-14);
    EXPECT_GT(q[column::F_rr], 0.0);
    EXPECT_LT(q[column::F_rz], 0.0);
    EXPECT_GT(q[column::F_zr], 0.0);
    EXPECT_LT(q[column::S_rz], 0.0);
    EXPECT_EQ(q[column::b_r], -3.0);
}

TEST(Particle, ThatLeavesTheGridOrIsNotANumberStopsTheRun) {
    for (const double v : {1.0, std::nan("")}) {
        Settings settings{.axisymmetric = false, .largest_step = 0.1};
        Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 1.0, 10), settings);
        Body body = make_box({0.4, 0.6, 0.4, 0.6, 2, 2, 1000.0}, false,
                             std::make_unique<LinearElastic>(1e3, 0.3));
        for (std::ptrdiff_t p = 0; p < 4; ++p) body.particles.view()[column::v_z][p] = v;
        simulation.add_body(std::move(body));
        const auto run = [&] {
            while (simulation.time() < 1.0) simulation.step();
        };
        EXPECT_THROW(run(), std::runtime_error);
    }
}

TEST(Axis, KeepsItsNodesAtRestAcrossIt) {
    Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 1.0, 10), {});
    Body body = make_box({0.0, 0.4, 0.2, 0.6, 8, 8, 1000.0}, true,
                         std::make_unique<LinearElastic>(1e5, 0.3));
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
        body.particles.view()[column::v_r][p] = 1.0;
    simulation.add_body(std::move(body));
    for (int i = 0; i < 10; ++i) simulation.step();
    for (std::size_t j = 0; j < 11; ++j) {
        EXPECT_EQ(simulation.motions(0)[11 * j][motion::v_r], 0.0);
        EXPECT_EQ(simulation.motions(0)[11 * j][motion::other_r], 0.0);
    }
}

TEST(Axis, FindsTheCellOfEveryPointOnAGradedGrid) {
    std::vector<double> nodes{-1.0};
    for (int i = 0; i < 40; ++i) nodes.push_back(nodes.back() + 0.01 * std::pow(1.15, i));
    const Axis axis(nodes);
    const AxisView view = axis.view();
    std::mt19937 generator(8);
    for (int sample = 0; sample < 10000; ++sample) {
        const double x =
            std::uniform_real_distribution<double>(nodes.front(), nodes.back())(generator);
        const int cell = view.cell_of(x);
        EXPECT_GE(x, axis[cell]);
        EXPECT_LT(x, axis[cell + 1]);
    }
    for (int i = 0; i + 1 < axis.nodes(); ++i) EXPECT_EQ(view.cell_of(axis[i]), i);
    EXPECT_THROW(Axis({0.0, 1.0, 1.0}), std::invalid_argument);
}

// In cells that are larger than the particle.
EdgeForces load_of(Particles& particles, int i, Edge edge, grit::Vector2 stress,
                   bool axisymmetric) {
    const Axis axis = Axis::uniform(0.0, 4.0, 4);
    return edge_forces({axis.view(), axis.view()}, particles.view(), i, edge, stress,
                       {.axisymmetric = axisymmetric});
}

// Four quarters make the whole: an edge's load is that of the ring it sweeps.
TEST(EdgeLoad, OfARingIsPressureTimesItsAreaAndActsAtItsCentroid) {
    Particles particles;
    particles.add({0.3, 0.5, 0.1, 0.2, 1000.0}, true);
    const EdgeForces top = load_of(particles, 0, Edge::top, {0.0, -1000.0}, true);
    const double force = top.f_z[0] + top.f_z[1];
    EXPECT_NEAR(force, -1000.0 * 0.5 * (0.16 - 0.04), 1e-10);  // per radian
    const double moment = top.f_z[0] * top.r[0] + top.f_z[1] * top.r[1];
    EXPECT_NEAR(moment, -1000.0 * (0.064 - 0.008) / 3.0, 1e-10);
    EXPECT_EQ(top.z[0], 0.7);
    const EdgeForces plane = load_of(particles, 0, Edge::left, {5.0, 0.0}, false);
    EXPECT_NEAR(plane.f_r[0], 1.0, 1e-14);
    EXPECT_NEAR(plane.f_r[1], 1.0, 1e-14);
}

TEST(EdgeLoad, OfTheHammerOnThePileIsThatOfThePaper) {
    Particles pile;
    constexpr int n = 5;
    for (int i = 0; i < n; ++i) pile.add({0.03 * (i + 0.5), 1.0, 0.015, 0.1, 8000.0}, true);
    double force = 0.0;
    for (int i = 0; i < n; ++i) {
        const EdgeForces top = load_of(pile, i, Edge::top, {0.0, -1e6}, true);
        force += top.f_z[0] + top.f_z[1];
    }
    EXPECT_NEAR(-2.0 * std::numbers::pi * force, 70.69e3, 10.0);
}

}  // namespace
