// SPDX-License-Identifier: BSD-3-Clause
// Weights of particles in space, as their kernels show them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include <adapters/mpm/space/kernel/place.hpp>

#include "support/lattice.hpp"

namespace {

using namespace space_test;

constexpr Shape shapes[] = {Shape::cpdi, Shape::ugimp, Shape::point};

double largest_force(const std::vector<NodeRecord>& nodes, std::size_t i) {
    return std::max({std::fabs(nodes[i][record::f_x]), std::fabs(nodes[i][record::f_y]),
                     std::fabs(nodes[i][record::f_z])});
}

TEST(SpacePatch, OfSkewedDomainsUnderUniformStressIsInBalanceToRoundoff) {
    Lattice lattice;
    const ParticleView q = lattice.particles.view();
    for (std::ptrdiff_t p = 0; p < lattice.particles.size(); ++p)
        for (int k = 0; k < 6; ++k) q[column::S_xx + k][p] = 1000.0 * (k + 1);
    std::vector<NodeRecord> nodes(lattice.nodes());
    kernels().scatter(Shape::cpdi,
                      {lattice.grid(), q, 0, lattice.particles.size(), nodes.data(), nullptr});
    double inside = 0.0, largest = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        largest = std::max(largest, largest_force(nodes, i));
        const Vector3 from = lattice.node(i) - Vector3{0.6, 0.63, 0.67};
        if (norm(from) > 0.25) continue;
        ++count;
        inside = std::max(inside, largest_force(nodes, i));
    }
    EXPECT_GT(count, 40);
    EXPECT_GT(largest, 1.0);
    EXPECT_LT(inside, 1e-13 * largest);
}

TEST(SpacePatch, OfALinearVelocityStrainsSkewedDomainsExactly) {
    constexpr double L[3][3] = {{1e-3, 4e-3, -2e-3}, {-1e-3, 2e-3, 3e-3}, {5e-3, -3e-3, -1e-3}};
    for (const Shape shape : shapes) {
        Lattice lattice;
        const ParticleView q = lattice.particles.view();
        std::vector<Vector3> at;
        for (std::ptrdiff_t p = 0; p < lattice.particles.size(); ++p) at.push_back(q.position(p));
        const double F_xy = q[column::F_xy][0], F_yy = q[column::F_yy][0],
                     F_zy = q[column::F_zy][0];
        std::vector<Increments> increments;
        lattice.gather(kernels(), shape, L, increments);
        int count = 0;
        for (std::ptrdiff_t p = 0; p < lattice.particles.size(); ++p) {
            const Vector3 start = at[static_cast<std::size_t>(p)];
            // Near the sides of the grid the domain of uGIMP ends with it.
            if (norm(start - Vector3{0.6, 0.63, 0.67}) > 0.45) continue;
            ++count;
            for (int a = 0; a < 3; ++a) {
                const double way = L[a][0] * start[0] + L[a][1] * start[1] + L[a][2] * start[2];
                ASSERT_NEAR(q.position(p)[a], start[a] + way, 1e-15);
                const double F = (a == 0   ? F_xy
                                  : a == 1 ? F_yy
                                           : F_zy) +
                                 L[a][0] * F_xy + L[a][1] * F_yy + L[a][2] * F_zy;
                ASSERT_NEAR(q.F(a, 1, p), F, 1e-15);
            }
        }
        EXPECT_GT(count, 500);
    }
}

// Ten turns about an oblique axis in steps of ten degrees, the body's own rotation prescribed at the nodes.
TEST(SpaceRotation, OfAStressedElasticBodyByTenTurnsKeepsItsStressInvariants) {
    const Vector3 axis = Vector3{1.0, 2.0, 3.0} / std::sqrt(14.0);
    const double angle = std::numbers::pi / 18.0, c = std::cos(angle), s = std::sin(angle);
    const double K[3][3] = {
        {0.0, -axis[2], axis[1]}, {axis[2], 0.0, -axis[0]}, {-axis[1], axis[0], 0.0}};
    double L[3][3] = {};  // Q - I, Rodrigues
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            L[i][j] = s * K[i][j];
            for (int k = 0; k < 3; ++k) L[i][j] += (1.0 - c) * K[i][k] * K[k][j];
        }
    Lattice lattice;
    Particles& particles = lattice.particles;
    while (particles.size() > 64) particles.remove(particles.size() - 1);
    const ParticleView q = particles.view();
    const double stress[6] = {-3e5, -1e5, -2e5, 5e4, -4e4, 7e4};
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        // About the middle, near to it: places must stay in the grid.
        for (int k = 0; k < 3; ++k) q[column::x + k][p] = 0.6 + 0.01 * static_cast<double>(p % 7);
        for (int k = 0; k < 6; ++k) q[column::S_xx + k][p] = stress[k];
    }
    LinearElastic material(1e7, 0.3);
    std::vector<NodeMotion> motions(lattice.nodes());
    for (std::size_t i = 0; i < motions.size(); ++i)
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                motions[i][motion::v_x + a] += L[a][b] * (lattice.node(i)[b] - 0.6);
    Increments increments;
    GatherSums sums;
    const Vector3 start = q.position(3);
    for (int step = 0; step < 360; ++step) {
        kernels().gather(Shape::cpdi,
                         {lattice.grid(), q, 0, particles.size(), motions.data(), 1.0, 0.0},
                         increments, sums);
        material.update({q, 0, particles.size()}, increments);
        if (step != 8) continue;  // a quarter turn: it is another stress
        EXPECT_GT(std::fabs(q[column::S_xx][3] - stress[0]), 1e4);
    }
    EXPECT_LT(norm(q.position(3) - start), 1e-12);
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        for (int k = 0; k < 6; ++k)
            ASSERT_NEAR(q[column::S_xx + k][p], stress[k], 1e-10 * 3e5) << k;
        ASSERT_NEAR(q.J(p), q.J(0), 1e-12);
    }
}

TEST(SpaceKernels, GiveTheSameBitsWithEveryInstructionSet) {
    constexpr double L[3][3] = {{1e-2, 4e-2, -2e-2}, {-1e-2, 2e-2, 3e-2}, {5e-2, -3e-2, -1e-2}};
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (const Shape shape : shapes) {
        Lattice one;
        const ParticleView q = one.particles.view();
        for (std::ptrdiff_t p = 0; p < one.particles.size(); ++p)
            for (int k = column::v_x; k < column::own; ++k)
                if ((k < column::F_xx || k > column::V0) || k == column::F_xy || k == column::F_zx)
                    q[k][p] += any(generator);
        Lattice other;
        other.particles = one.particles;
        std::vector<NodeRecord> nodes[2];
        std::vector<NodeSlope> slopes[2], pores[2];
        std::vector<Increments> increments[2];
        const grit::mpm::PoreWater water{.porosity = 0.9};
        std::vector<grit::mpm::CellIntegers> pressures(one.cells());
        for (grit::mpm::CellIntegers& cell : pressures)
            grit::mpm::add_share(cell, 1.0, any(generator));
        std::vector<PorePlace> places[2];
        for (const int i : {0, 1}) {
            Lattice& of = i == 0 ? one : other;
            const Kernels& by = i == 0 ? kernels() : baseline_kernels;
            nodes[i].resize(of.nodes());
            slopes[i].resize(of.nodes());
            places[i].resize(static_cast<std::size_t>(of.particles.size()));
            ScatterCall scattered{of.grid(),           of.particles.view(), 0,
                                  of.particles.size(), nodes[i].data(),     slopes[i].data()};
            scattered.pore_pressures = {pressures.data(), 1e4};
            pores[i].resize(of.nodes());
            scattered.pore_forces = pores[i].data();
            by.scatter(shape, scattered);
            of.gather(by, shape, L, increments[i], {&water, places[i].data()});
        }
        for (std::size_t p = 0; p < places[0].size(); ++p) {
            ASSERT_EQ(places[0][p].V, places[1][p].V);
            ASSERT_EQ(places[0][p].e, places[1][p].e);
            ASSERT_EQ(places[0][p].strain, places[1][p].strain);
            ASSERT_EQ(places[0][p].cell, places[1][p].cell);
        }
        for (std::size_t i = 0; i < nodes[0].size(); ++i) {
            for (int k = 0; k < record::size; ++k) ASSERT_EQ(nodes[0][i][k], nodes[1][i][k]);
            for (int k = 0; k < slope::size; ++k) {
                ASSERT_EQ(slopes[0][i][k], slopes[1][i][k]);
                ASSERT_EQ(pores[0][i][k], pores[1][i][k]);
            }
        }
        for (int k = 0; k < column::own; ++k)
            for (std::ptrdiff_t p = 0; p < one.particles.size(); ++p)
                ASSERT_EQ(one.particles(k, p), other.particles(k, p)) << k;
        for (int k = 0; k < 9; ++k)
            EXPECT_EQ(increments[0][1].rotation[k][5], increments[1][1].rotation[k][5]);
    }
}

// As the 2-D ones: no side that is nine times another, the same volume and the same plane of the long side.
TEST(SpaceDomain, ThatIsDrawnOutIsSeenNoLongerThanNineTimesItsWidth) {
    using namespace grit::mpm::space::baseline;
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    int drawn_out = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Domain d;
        for (Vector3& r : d.r) r = {any(generator), any(generator), any(generator)};
        for (Vector3& r : d.r) r = r + 6.0 * any(generator) * d.r[0];
        if (dot(d.r[0], cross(d.r[1], d.r[2])) < 0.0) std::swap(d.r[1], d.r[2]);
        const double volume = dot(d.r[0], cross(d.r[1], d.r[2]));
        const Domain out = rounded(d);
        EXPECT_NEAR(dot(out.r[0], cross(out.r[1], out.r[2])), volume, 1e-11 * volume);
        double C[3][3], before[3][3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                C[i][j] = dot(out.r[i], out.r[j]);
                before[i][j] = dot(d.r[i], d.r[j]);
            }
        const Principal now(C), was(before);
        const auto [least, most] = std::minmax({now.value[0], now.value[1], now.value[2]});
        EXPECT_LT(most, 81.0 * (1.0 + 1e-9) * least);
        const auto [least_was, most_was] = std::minmax({was.value[0], was.value[1], was.value[2]});
        if (most_was < 80.9 * least_was)
            EXPECT_EQ(norm(out.r[0] - d.r[0]) < 1e-9 * norm(d.r[0]), true);
        else ++drawn_out;
    }
    EXPECT_GT(drawn_out, 50);
}

TEST(SpaceDomain, IsSeenWithinTheNeighbouringCells) {
    using namespace grit::mpm::space::baseline;
    const Domain out =
        limited({{{0.3, 0.0, 0.0}, {0.2, 0.1, 0.0}, {0.0, 0.1, 0.4}}}, {0.25, 1.0, 1.0});
    EXPECT_NEAR(out.r[0][0] + out.r[1][0], 0.25, 1e-15);
    EXPECT_NEAR(out.r[2][2] / out.r[0][0], 4.0 / 3.0, 1e-14);
}

}  // namespace
