// SPDX-License-Identifier: BSD-3-Clause
// Contact at surfaces in space.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <adapters/mpm/space/kernel/place.hpp>

#include "support/lattice.hpp"
#include "support/loose_cube.hpp"
#include "support/pressed_blocks.hpp"

namespace {

using namespace space_test;

std::vector<NearDomain> domains_of(Particles& particles, const GridView& grid) {
    std::vector<NearDomain> out;
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const auto place = baseline::place_of(grid, particles.view(), p);
        const Vector3* r = place.domain.r;
        out.push_back({place.at, {r[0], r[1], r[2]}});
    }
    return out;
}

// Volume that a mesh encloses and its area; how many edges have not as many facets along them as against them.
struct Measures {
    double volume = 0.0, area = 0.0;
    long open = 0;

    explicit Measures(const TriangleMesh& mesh) {
        std::map<std::pair<std::ptrdiff_t, std::ptrdiff_t>, int> along;
        for (std::ptrdiff_t f = 0; f < mesh.facets(); ++f) {
            const Vector3 a = mesh.corner(f, 0), b = mesh.corner(f, 1), c = mesh.corner(f, 2);
            const Vector3 normal = baseline::cross(b - a, c - a);
            area += 0.5 * norm(normal);
            volume += dot(a, normal) / 6.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto i = 3 * static_cast<std::size_t>(f);
                const std::ptrdiff_t from = mesh.facet[i + k], to = mesh.facet[i + (k + 1) % 3];
                ++along[{from, to}];
                --along[{to, from}];
            }
        }
        open =
            std::count_if(along.begin(), along.end(), [](const auto& e) { return e.second != 0; });
    }
};

TEST(FreeFaces, OfABlockAreItsSidesWhereverItIsAndHoweverSkewed) {
    for (const double skew : {0.0, 0.2, 0.8}) {
        Lattice lattice;
        Particles block;
        const double F[3][3] = {{1.0, skew, 0.0}, {0.0, 1.0, -0.5 * skew}, {0.0, 0.0, 1.0}};
        for (int k = 0; k < 4; ++k)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) {
                    const Vector3 X{0.06 * i, 0.06 * j, 0.05 * k};
                    Vector3 x{0.41, 0.43, 0.47};
                    for (int a = 0; a < 3; ++a)
                        for (int b = 0; b < 3; ++b) x[a] += F[a][b] * X[b];
                    block.add({x, {0.03, 0.03, 0.025}, 1.0});
                    for (int a = 0; a < 3; ++a)
                        for (int b = 0; b < 3; ++b)
                            block.view()[column::F_xx + 3 * a + b][block.size() - 1] = F[a][b];
                }
        FreeFaces faces;
        TriangleMesh mesh;
        for (int again = 0; again < 2; ++again) {
            faces.find(lattice.grid(), domains_of(block, lattice.grid()), mesh);
            EXPECT_EQ(mesh.facets(), 4 * (2 * 9 + 4 * 12));
            EXPECT_EQ(mesh.vertices(), 4 * 4 * 5 - 2 * 2 * 3 + 2 * 9 + 4 * 12);
            const Measures seen(mesh);
            EXPECT_EQ(seen.open, 0);
            EXPECT_NEAR(seen.volume, 0.18 * 0.18 * 0.2, 1e-12);
        }
    }
}

TEST(FreeFaces, ArePassedOverWhereAGapIsNarrowAndFoundWhereItIsWide) {
    Lattice lattice;
    FreeFaces faces;
    TriangleMesh mesh;
    for (const double gap : {0.0, 0.01, 0.02}) {  // of 0.06
        Particles two;
        for (const int i : {0, 1})
            two.add({{0.4 + (0.06 + gap) * i, 0.4, 0.4}, {0.03, 0.03, 0.03}, 1.0});
        faces.find(lattice.grid(), domains_of(two, lattice.grid()), mesh);
        EXPECT_EQ(mesh.facets(), gap < 0.015 ? 40 : 48);
        EXPECT_EQ(Measures(mesh).open, 0);
        EXPECT_EQ(mesh.vertices(), gap < 0.015 ? 12 + 10 : 16 + 12);
    }
}

TEST(FreeFaces, ThatAreCoveredInPartCountIfAQuarterIsOpen) {
    Lattice lattice;
    FreeFaces faces;
    TriangleMesh mesh;
    for (const bool open : {true, false}) {
        Particles three;
        three.add({{0.4, 0.4, 0.4}, {0.03, 0.03, 0.03}, 1.0});
        three.add({{0.46, 0.385, 0.4}, {0.03, 0.015, 0.03}, 1.0});
        const double half = open ? 0.015 : 0.03;  // of the last: three quarters are covered, or all
        three.add({{0.46, 0.415, 0.37 + half}, {0.03, 0.015, half}, 1.0});
        faces.find(lattice.grid(), domains_of(three, lattice.grid()), mesh);
        EXPECT_EQ(mesh.facets(), 4 * (open ? 6 + 5 + 4 : 5 + 4 + 4));
    }
}

// is_near(id): of particles whose places are their ids.
template <class IsNear>
void place(RiddenMesh& mesh, const ParticleView& q, TriangleMesh& out, const IsNear& is_near) {
    std::vector<NearVertex> near;
    mesh.each_near(
        q, [&](int id) { return is_near(id) ? std::ptrdiff_t{id} : std::ptrdiff_t{-1}; },
        [&near](const NearVertex& v) { near.push_back(v); });
    mesh.place(near, out);
}

TEST(RiddenMesh, MovesAsTheParticlesThatItsVerticesWereNearestToAndHasNoLongEdge) {
    Particles particles;
    for (int i = 0; i < 2; ++i) particles.add({{0.5 + i, 0.5, 0.5}, {0.5, 0.5, 0.5}, 1.0});
    TriangleMesh tetrahedron;
    tetrahedron.position = {0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    tetrahedron.facet = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    RiddenMesh mesh(tetrahedron, 0.3);
    const ParticleView q = particles.view();
    grit::mpm::Exchange alone;
    EXPECT_FALSE(mesh.has_riders());
    mesh.find_riders(q, 0, particles.ids(), alone);
    EXPECT_FALSE(mesh.has_riders());
    mesh.find_riders(q, 2, particles.ids(), alone);
    EXPECT_TRUE(mesh.has_riders());
    // F and a way, the same for both.
    const double F[3][3] = {{1.1, 0.2, 0.0}, {-0.1, 0.9, 0.1}, {0.0, 0.1, 1.2}};
    const auto image = [&](const Vector3& x) {
        Vector3 out{3.0, 4.0, 5.0};
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) out[a] += F[a][b] * x[b];
        return out;
    };
    for (std::ptrdiff_t p = 0; p < 2; ++p) {
        const Vector3 x = image(q.position(p));
        for (int a = 0; a < 3; ++a) {
            q[column::x + a][p] = x[a];
            for (int b = 0; b < 3; ++b) q[column::F_xx + 3 * a + b][p] = F[a][b];
        }
    }
    TriangleMesh now;
    place(mesh, q, now, [](int) { return true; });
    const Measures seen(now);
    EXPECT_EQ(seen.open, 0);
    const double J = particles.view().J(0);
    EXPECT_NEAR(seen.volume, J / 3.0, 1e-12);
    EXPECT_GT(now.facets(), 60);
    for (std::ptrdiff_t f = 0; f < now.facets(); ++f)
        for (int k = 0; k < 3; ++k)
            EXPECT_LT(norm(now.corner(f, k) - now.corner(f, (k + 1) % 3)), 0.3 * 1.35);
    const Vector3 tip = image({2.0, 0.0, 0.0});
    double least = 1e30;
    for (std::ptrdiff_t v = 0; v < now.vertices(); ++v)
        least = std::min(least, norm(now.vertex(v) - tip));
    EXPECT_LT(least, 1e-12);
    // What is not near is left out.
    const std::ptrdiff_t all = now.facets();
    place(mesh, q, now, [](int id) { return id == 0; });
    EXPECT_LT(now.facets(), all);
    EXPECT_GT(now.facets(), 0);
}

// Where two edges of a triangle are halved, what is left of it is parted as its mirror image is; sides alike, and not.
// Found by a fuzzer: a file in mm, read as if it were in m, was divided for minutes, into as much memory as there is.
TEST(RiddenMesh, IsRefusedWhereItIsTooLargeForItsCells) {
    TriangleMesh tetrahedron;
    tetrahedron.position = {0.0, 0.0, 0.0, 100.0, 0.0, 0.0, 0.0, 100.0, 0.0, 0.0, 0.0, 50.0};
    tetrahedron.facet = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    EXPECT_NO_THROW(RiddenMesh(tetrahedron, 1.0));
    try {
        RiddenMesh(tetrahedron, 0.05);
        ADD_FAILURE();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(
            std::string(error.what()),
            "the surface of a contact is 100 by 100 by 50 m large: without edges beyond 0.05 m, "
            "the shortest cell, it has more than 262144 triangles; is its unit right?");
    }
}

TEST(RiddenMesh, IsDividedAlikeOnBothSidesOfAMirror) {
    Particles particles;
    particles.add({{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, 1.0});
    struct Shape {
        std::vector<double> position;
        double longest;
    };
    // The last one has two long sides of one length beside a short one.
    const std::vector<double> wide{0.0, 0.0, 0.0, 2.0, 0.3, 0.0, 0.3, 2.0, 0.0, 0.2, 0.2, 1.0};
    const std::vector<double> narrow{0.0, 0.0, 0.0, 2.0, 1.6, 0.0, 1.6, 2.0, 0.0, 0.2, 0.2, 1.0};
    for (const auto& [position, longest] :
         {Shape{wide, 1.9}, Shape{wide, 1.1}, Shape{wide, 0.7}, Shape{wide, 0.35},
          Shape{narrow, 1.5}, Shape{narrow, 0.9}}) {
        TriangleMesh tetrahedron;
        tetrahedron.position = position;
        tetrahedron.facet = {0, 2, 1, 0, 1, 3, 3, 2, 0, 2, 3, 1};
        RiddenMesh mesh(tetrahedron, longest);
        grit::mpm::Exchange alone;
        mesh.find_riders(particles.view(), 1, particles.ids(), alone);
        TriangleMesh now;
        place(mesh, particles.view(), now, [](int) { return true; });
        EXPECT_EQ(Measures(now).open, 0);
        using Corner = std::array<long, 3>;
        std::set<std::set<Corner>> facets, images;
        for (std::ptrdiff_t f = 0; f < now.facets(); ++f) {
            std::set<Corner> own, image;
            for (int k = 0; k < 3; ++k) {
                const Vector3 x = now.corner(f, k);
                const long u = std::lround(1e9 * x[0]), v = std::lround(1e9 * x[1]),
                           w = std::lround(1e9 * x[2]);
                own.insert({u, v, w});
                image.insert({v, u, w});
            }
            facets.insert(own);
            images.insert(image);
        }
        EXPECT_TRUE(facets == images) << longest;
    }
}

TEST(SpaceSurfaceContact, PressesEveryParticleAlikeWhereverTheInterfaceIs) {
    for (const auto& [offset, rows] : {std::pair{0.0, 2}, std::pair{0.3, 3}, std::pair{0.7, 2}}) {
        PressedBlocks blocks;
        blocks.offset = offset;
        blocks.rows = rows;
        const PressedBlocks::Result seen = blocks.run();
        EXPECT_NEAR(seen.lowest, -PressedBlocks::pressure, 2.5e3) << offset << ' ' << rows;
        EXPECT_NEAR(seen.highest, -PressedBlocks::pressure, 2.5e3) << offset << ' ' << rows;
    }
}

TEST(SpaceSurfaceContact, CarriesAConstantStressAcrossAnInterfaceThatIsAskewToTheGrid) {
    for (const auto& [angle, mu] : {std::pair{0.1, 0.4}, std::pair{0.4, 0.0}}) {
        InclinedBars bars;
        bars.angle = angle;
        bars.friction_coefficient = mu;
        EXPECT_LT(bars.run(), 5e-3) << angle << ", " << mu;
    }
}

// Sand that presses a slab, loaded: the slab's surface carries the pressure.
std::unique_ptr<Simulation> pressed(const Settings& settings, double stiffness = 0.0) {
    auto out = std::make_unique<Simulation>(cube_of_cells(1.3, 13), settings);
    Body slab = slab_above();
    for (std::ptrdiff_t p = 0; p < slab.particles.size(); ++p) {
        slab.particles.view()[column::z][p] -= 0.027;
        slab.particles.view()[column::v_z][p] = -3.0;
    }
    out->add_body(std::move(slab));
    out->add_body(loose_cube_of_sand());
    SurfaceLaw law = surface_law(0.3);
    law.options.contact_stiffness = stiffness;
    out->add_contact(law);
    return out;
}

// Of the whole contact, rigid; on a soft layer it comes later.
class SpaceSurfaces : public testing::TestWithParam<double> {};
TEST_P(SpaceSurfaces, KeepMomentumAndCountWhatTheyTake) {
    const auto one = pressed({.cfl = 0.2}, GetParam());
    const auto momentum = [&] {
        Vector3 sum{0.0, 0.0, 0.0};
        for (const std::size_t b : {0u, 1u}) {
            const Particles& q = one->body(b).particles;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p)
                for (int k = 0; k < 3; ++k) sum[k] += q(column::mass, p) * q(column::v_x + k, p);
        }
        return sum;
    };
    const Vector3 before = momentum();
    double impulse = 0.0;
    for (int i = 0; i < 40; ++i) {
        one->step();
        impulse -= one->surface_contact(0).totals().impulse.along[2];  // on the sand
    }
    const Vector3 after = momentum();
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k], 1e-10 * norm(before));
    if (GetParam() == 1e6) {
        EXPECT_LT(impulse, 0.05 * norm(before));
        EXPECT_GT(impulse, 0.0);
    } else {
        EXPECT_GT(impulse, 0.05 * norm(before));
    }
    const grit::mpm::Energy e = one->energy();
    EXPECT_GT(e.contact, 0.0);
    EXPECT_LT(std::fabs(e.residual()), 0.02 * e.kinetic_0);
}

INSTANTIATE_TEST_SUITE_P(Stiffness, SpaceSurfaces, testing::Values(0.0, 1e6, 1e10));

TEST(SpaceSurfaceContact, HasTheSameBitsWithAnyNumberOfThreads) {
    const auto one = pressed({.local_damping = 0.1, .fixed_point = true});
    const auto three = pressed({.local_damping = 0.1, .fixed_point = true, .threads = 3});
    for (int i = 0; i < 15; ++i) {
        one->step();
        three->step();
    }
    EXPECT_LT(one->surface_contact(0).measured().along_z[2], -1.0);
    for (const std::size_t b : {0u, 1u}) {
        const Particles &q = one->body(b).particles, &o = three->body(b).particles;
        for (int id = 0; id < q.size(); ++id)
            for (int c = 0; c < q.column_count(); ++c)
                ASSERT_EQ(q(c, one->find(b, id)), o(c, three->find(b, id)));
    }
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(one->surface_contact(0).totals().impulse.about[k],
                  three->surface_contact(0).totals().impulse.about[k]);
}

TEST(SpaceSurfaceContact, RefusesARigidBodyThatMovesFreely) {
    Simulation simulation(cube_of_cells(1.3, 13), {});
    Body slab = slab_above();
    slab.material.reset();
    RigidCourse course;
    course.free = {true, true, true, true, true, true};
    slab.make_rigid(course);
    simulation.add_body(std::move(slab));
    simulation.add_body(loose_cube_of_sand());
    EXPECT_THROW(simulation.add_contact(surface_law(0.3)), std::invalid_argument);
}

}  // namespace
