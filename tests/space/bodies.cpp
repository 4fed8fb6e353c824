// SPDX-License-Identifier: BSD-3-Clause
// Bodies that move in space.
#include <gtest/gtest.h>

#include <cmath>

#include "support/beside_plane.hpp"
#include "support/loose_cube.hpp"
#include "support/manufactured.hpp"

namespace {

using namespace space_test;

TEST(SpaceManufacturedSolution, IsMetWithSecondOrder) {
    const double at_8 = Manufactured::run(8, {}), at_16 = Manufactured::run(16, {});
    EXPECT_GT(std::log2(at_8 / at_16), 1.9);
    EXPECT_LT(at_16, 1.3e-3);
}

TEST(SpaceBody, ThatIsFreeKeepsMassMomentumAndItsMoment) {
    for (const Shape shape : {Shape::cpdi, Shape::ugimp, Shape::point}) {
        Simulation simulation(cube_of_cells(1.2, 12), {.shape = shape});
        simulation.add_body(loose_cube(std::make_unique<LinearElastic>(1e6, 0.3)));
        const auto totals = [&] {
            std::array<double, 4> sum{};
            const Particles& q = simulation.body(0).particles;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
                sum[0] += q(column::mass, p);
                for (int k = 0; k < 3; ++k)
                    sum[static_cast<std::size_t>(k) + 1] +=
                        q(column::mass, p) * q(column::v_x + k, p);
            }
            return sum;
        };
        const auto before = totals();
        for (int i = 0; i < 40; ++i) simulation.step();
        const auto after = totals();
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(after[k], before[k], 1e-13 * before[0] * (k == 0 ? 1.0 : 2.0)) << k;
        // Stresses are balanced within the body: nodes have the mass and momentum of the particles.
        double mass = 0.0;
        for (const NodeRecord& n : simulation.records(0)) mass += n[record::m];
        EXPECT_NEAR(mass, before[0], 1e-13 * before[0]);
    }
}

// Roundoff of its velocity is all that strains it.
TEST(SpaceBody, ThatIsFreeFliesOnInUgimpHoweverThinItsParticlesAre) {
    for (const double low : {0.27, 0.3})
        for (const double thickness : {0.07, 0.02, 6e-4, 1e-6}) {
            SCOPED_TRACE(thickness);
            Simulation simulation(cube_of_cells(1.2, 12), {.shape = Shape::ugimp, .cfl = 0.4});
            simulation.add_body(
                make_brick({{0.21, 0.33, low}, {0.71, 0.73, low + thickness}, {10, 8, 1}},
                           std::make_unique<LinearElastic>(1e6, 0.3)));
            const ParticleView q = simulation.body(0).particles.view();
            for (std::ptrdiff_t p = 0; p < simulation.body(0).particles.size(); ++p) {
                q[column::v_x][p] = 0.3;
                q[column::v_z][p] = -0.7;
            }
            for (int i = 0; i < 80; ++i) simulation.step();
            for (std::ptrdiff_t p = 0; p < simulation.body(0).particles.size(); ++p) {
                EXPECT_NEAR(q[column::v_x][p], 0.3, 1e-9);
                EXPECT_NEAR(q[column::v_y][p], 0.0, 1e-9);
                EXPECT_NEAR(q[column::v_z][p], -0.7, 1e-9);
            }
        }
}

TEST(SpaceBody, ThatVibratesKeepsItsEnergyBalance) {
    Simulation simulation(cube_of_cells(1.2, 12),
                          {.cfl = 0.2, .pic_rate = 20.0, .local_damping = 0.1});
    simulation.add_body(loose_cube(std::make_unique<LinearElastic>(1e8, 0.3)));
    simulation.set_gravity({1.0, 0.0, -9.81});
    for (int i = 0; i < 60; ++i) simulation.step();
    const grit::mpm::Energy e = simulation.energy();
    EXPECT_GT(e.kinetic_0, 100.0);
    EXPECT_GT(e.damping, 0.0);
    EXPECT_GT(e.pic, 0.0);
    EXPECT_LT(std::fabs(e.residual()), 2e-3 * e.kinetic_0);
}

// Bulk viscosity works along every axis, where stress has that one component alone too.
TEST(SpaceBody, ThatIsShortenedLosesAsMuchToViscosityAlongEveryAxis) {
    double lost[3];
    for (int d = 0; d < 3; ++d) {
        std::array<int, 3> cells{2, 2, 2};
        Vector3 to{0.2, 0.2, 0.2};
        cells[static_cast<std::size_t>(d)] = 10;
        to[d] = 1.0;
        Simulation s({Axis::uniform(0.0, to[0], cells[0]), Axis::uniform(0.0, to[1], cells[1]),
                      Axis::uniform(0.0, to[2], cells[2])},
                     {.linear_viscosity = 0.1});
        const auto per = [&](int k) {
            return 2 * cells[static_cast<std::size_t>(k)] - (k == d ? 4 : 0);
        };
        Vector3 end = to;
        end[d] = 0.8;
        Body bar = make_brick({{0.0, 0.0, 0.0}, end, {per(0), per(1), per(2)}, 2000.0},
                              std::make_unique<LinearElastic>(1e7, 0.0));
        for (std::ptrdiff_t p = 0; p < bar.particles.size(); ++p)
            bar.particles.view()[column::v_x + d][p] = -1.0;
        s.add_body(std::move(bar));
        for (int k = 0; k < 3; ++k) s.fix_below(k, 0.0);
        for (int k = 0; k < 3; ++k)
            if (k != d) s.fix_above(k, to[k]);
        for (int i = 0; i < 20; ++i) s.step();
        lost[d] = s.energy().viscosity;
    }
    EXPECT_GT(lost[0], 0.1);
    EXPECT_NEAR(lost[1], lost[0], 1e-12 * lost[0]);
    EXPECT_NEAR(lost[2], lost[0], 1e-12 * lost[0]);
}

void expect_same(const Particles& a, const Particles& b) {
    for (std::ptrdiff_t p = 0; p < a.size(); ++p) {
        ASSERT_EQ(a.ids()[p], b.ids()[p]);
        for (int c = 0; c < a.column_count(); ++c) ASSERT_EQ(a(c, p), b(c, p)) << c << ' ' << p;
    }
}

TEST(SpaceThreads, ChangeNoBit) {
    for (const bool means : {false, true}) {
        std::unique_ptr<Simulation> by[2];
        for (const int i : {0, 1}) {
            by[i] = std::make_unique<Simulation>(cube_of_cells(1.3, 13),
                                                 Settings{.local_damping = 0.1,
                                                          .linear_viscosity = 0.1,
                                                          .cell_mean = means,
                                                          .threads = 1 + i});
            by[i]->add_body(loose_cube_of_sand());
            by[i]->add_body(slab_above());
            by[i]->add_contact(not_gated());
            for (int step = 0; step < 25; ++step) by[i]->step();
        }
        for (const std::size_t b : {0u, 1u})
            expect_same(by[0]->body(b).particles, by[1]->body(b).particles);
        EXPECT_EQ(by[0]->energy().residual(), by[1]->energy().residual());
        EXPECT_EQ(by[0]->time(), by[1]->time());
    }
}

// A block that falls on the corner of a slab: the plane's driver beside it, x = r, one cell across the plane.
TEST(SpaceSlab, InPlaneStrainIsThatOfThePlane) {
    namespace mpm = grit::mpm;
    namespace pc = grit::mpm::column;
    BesidePlane both({.axisymmetric = false, .local_damping = 0.05});
    both.add<mpm::LinearElastic, LinearElastic>({0.25, 0.05, 10, 8, 1500.0, 1.0, -2.0}, 1e6, 0.3);
    both.plane.add_traction({0, 79, mpm::Edge::top, [](double t) {
                                 return grit::Vector2{1e4 * t, -2e4};
                             }});
    both.space.add_traction({0, 79, {2, true}, [](double t) {
                                 return Vector3{1e4 * t, 0.0, -2e4};
                             }});
    for (int i = 0; i < 100; ++i) both.step();
    both.expect_same(
        [](const mpm::Particles& a, std::ptrdiff_t p, const Particles& b, std::ptrdiff_t s) {
            EXPECT_NEAR(b(column::S_xx, s), a(pc::S_rr, p), 1e-4);
            EXPECT_NEAR(b(column::S_zz, s), a(pc::S_zz, p), 1e-4);
            EXPECT_NEAR(b(column::S_yy, s), a(pc::S_tt, p), 1e-4);
            EXPECT_NEAR(b(column::S_xz, s), a(pc::S_rz, p), 1e-4);
            EXPECT_GT(std::fabs(a(pc::S_zz, p)), 10.0);
        });
    EXPECT_NEAR(both.space.energy().residual() / both.width, both.plane.energy().residual(), 1e-6);
}

TEST(SpaceSimulation, RefusesWhatIsNotThere) {
    const auto make = [](const Settings& settings) { Simulation(cube_of_cells(1.0, 2), settings); };
    EXPECT_THROW(make({.shape = Shape::cpdi_published}), std::invalid_argument);
    EXPECT_THROW(make({.scheme = grit::mpm::Scheme::musl}), std::invalid_argument);
    EXPECT_THROW(make({.reduced_domains = true}), std::invalid_argument);
    EXPECT_NO_THROW(make({}));
}

TEST(SpaceSimulation, ReportsParticlesThatLeaveTheGrid) {
    Simulation simulation(cube_of_cells(1.0, 4), {});
    Body body = make_brick({{0.5, 0.5, 0.5}, {1.0, 1.0, 1.0}, {2, 2, 2}},
                           std::make_unique<LinearElastic>(1e6, 0.3));
    body.name = "stone";
    for (std::ptrdiff_t p = 0; p < 8; ++p) body.particles.view()[column::v_y][p] = 5.0;
    simulation.add_body(std::move(body));
    try {
        for (int i = 0; i < 1000; ++i) simulation.step();
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("of body stone at ("), std::string::npos)
            << error.what();
    }
}

}  // namespace
