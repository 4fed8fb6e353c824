// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of triangles: what lies within them, and files of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <adapters/mpm/case/closed_surface.hpp>

namespace {

using grit::Vector3;
using grit::mpm::ClosedSurface;
using grit::mpm::read_stl;
using Triangles = std::vector<ClosedSurface::Triangle>;

constexpr double pi = std::numbers::pi, ring = 0.7, tube = 0.25;

// A torus about the z axis: not convex, and round.
Triangles torus(int along, int around) {
    const auto at = [&](int i, int j) -> Vector3 {
        const double u = 2.0 * pi * (i % along) / along, v = 2.0 * pi * (j % around) / around;
        const double r = ring + tube * std::cos(v);
        return {r * std::cos(u), r * std::sin(u), tube * std::sin(v)};
    };
    Triangles out;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            out.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            out.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return out;
}

Triangles cube() {
    const auto corner = [](int n) -> Vector3 {
        return {n & 1 ? 1.0 : 0.0, n & 2 ? 1.0 : 0.0, n & 4 ? 1.0 : 0.0};
    };
    const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    Triangles out;
    for (const auto& q : quads) {
        out.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
        out.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
    }
    return out;
}

template <class Number> void put(std::ofstream& out, Number x) {
    out.write(reinterpret_cast<const char*>(&x), sizeof x);
}

void write_binary(const std::filesystem::path& file, const Triangles& triangles) {
    std::ofstream out(file, std::ios::binary);
    std::string head = "solid although it is binary";
    head.resize(80, ' ');
    out << head;
    put(out, static_cast<std::uint32_t>(triangles.size()));
    for (const auto& t : triangles) {
        for (int d = 0; d < 3; ++d) put(out, 0.0F);
        for (const Vector3& x : t)
            for (int d = 0; d < 3; ++d) put(out, static_cast<float>(x[d]));
        put(out, std::uint16_t{0});
    }
}

class StlFiles : public testing::Test {
  protected:
    StlFiles() {
        std::string pattern = (std::filesystem::temp_directory_path() / "grit_stl_XXXXXX").string();
        folder = mkdtemp(pattern.data());
    }
    ~StlFiles() override { std::filesystem::remove_all(folder); }
    std::filesystem::path folder;
};

std::string error_of(const std::filesystem::path& file) {
    try {
        read_stl(file, 1.0, {0.0, 0.0, 0.0});
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(ClosedSurface, HasWhatATorusHas) {
    const ClosedSurface surface(torus(160, 80));
    EXPECT_NEAR(surface.volume(), 2.0 * pi * pi * ring * tube * tube, 2e-3);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 x{place(random), place(random), 0.3 * place(random)};
        const double off = std::hypot(std::hypot(x[0], x[1]) - ring, x[2]) - tube;
        if (std::fabs(off) < 2e-3) continue;  // facets
        EXPECT_EQ(surface.has(x), off < 0.0) << x[0] << ' ' << x[1] << ' ' << x[2];
        inside += off < 0.0;
    }
    EXPECT_GT(inside, 4000);
}

// Rays through edges and corners of the surface count them once.
// The ends of a cylinder are fans of slivers, each of them as long as its radius and each in the middle.
TEST(ClosedSurface, OfManySliversTakesNoMoreThanItsShareOfMemory) {
    constexpr int sectors = 6000;
    const auto rim = [](int i, double z) -> Vector3 {
        const double u = 2.0 * pi * (i % sectors) / sectors;
        return {std::cos(u), std::sin(u), z};
    };
    Triangles all;
    for (int i = 0; i < sectors; ++i) {
        all.push_back({Vector3{0.0, 0.0, 1.0}, rim(i, 1.0), rim(i + 1, 1.0)});
        all.push_back({Vector3{0.0, 0.0, 0.0}, rim(i + 1, 0.0), rim(i, 0.0)});
        all.push_back({rim(i, 0.0), rim(i + 1, 0.0), rim(i + 1, 1.0)});
        all.push_back({rim(i, 0.0), rim(i + 1, 1.0), rim(i, 1.0)});
    }
    const ClosedSurface surface(all);
    EXPECT_LE(surface.listed(), 32 * surface.size());
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> place(-1.1, 1.1);
    int within = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 x{place(random), place(random), 0.5 + place(random)};
        const double r = std::hypot(x[0], x[1]);
        if (std::fabs(r - 1.0) < 1e-6) continue;
        const bool expected = r < 1.0 && x[2] > 0.0 && x[2] < 1.0;
        EXPECT_EQ(surface.has(x), expected) << x[0] << ' ' << x[1] << ' ' << x[2];
        within += expected;
    }
    EXPECT_GT(within, 4000);
}

TEST(ClosedSurface, IsCountedOnceWhereTrianglesMeet) {
    const ClosedSurface surface(cube());
    for (int i = 1; i < 8; ++i)
        for (int j = 1; j < 8; ++j)
            for (const double z : {0.125, 0.5, 0.875})
                EXPECT_TRUE(surface.has({i / 8.0, j / 8.0, z}))
                    << i << ' ' << j;  // on diagonals too
    const ClosedSurface round(torus(16, 8));
    for (int i = 0; i < 16; ++i) {  // rays through corners, below and above
        const double u = 2.0 * pi * i / 16;
        const Vector3 x{ring * std::cos(u), ring * std::sin(u), 0.0};
        EXPECT_TRUE(round.has(x)) << i;
        EXPECT_FALSE(round.has({x[0], x[1], 0.26})) << i;
        EXPECT_FALSE(round.has({x[0], x[1], -0.26})) << i;
    }
    EXPECT_FALSE(round.has({0.0, 0.0, 0.0}));
    EXPECT_FALSE(round.has({NAN, 0.0, 0.0}));
}

Triangles moved(Triangles of, double scale, const Vector3& by, bool turned = false) {
    for (auto& t : of) {
        for (Vector3& x : t) x = scale * x + by;
        if (turned) std::swap(t[1], t[2]);
    }
    return of;
}

// Unit cubes and smaller ones: which way they face does not matter, but in a cavity.
TEST(ClosedSurface, OfSeveralShellsHasWhatIsInAnyOfThemButForCavities) {
    for (const bool all_turned : {false, true}) {
        const auto surface_of = [&](const Triangles& second) {
            Triangles all = moved(cube(), 1.0, {0.0, 0.0, 0.0}, all_turned);
            const Triangles other = moved(second, 1.0, {0.0, 0.0, 0.0}, all_turned);
            all.insert(all.end(), other.begin(), other.end());
            return ClosedSurface(all);
        };
        for (const bool turned : {false, true}) {
            const ClosedSurface apart = surface_of(moved(cube(), 0.5, {2.0, 0.1, 0.1}, turned));
            EXPECT_TRUE(apart.has({0.5, 0.5, 0.5}));
            EXPECT_TRUE(apart.has({2.2, 0.3, 0.3}));
            EXPECT_FALSE(apart.has({1.5, 0.3, 0.3}));
            EXPECT_NEAR(apart.volume(), 1.125, 1e-14);
            double volume = 0.0;  // outward, all of them
            for (const auto& t : apart.outward())
                for (int i = 0; i < 3; ++i) {
                    const int j = (i + 1) % 3, k = (i + 2) % 3;
                    volume += t[0][i] * (t[1][j] * t[2][k] - t[1][k] * t[2][j]) / 6.0;
                }
            EXPECT_NEAR(volume, 1.125, 1e-14);
        }
        const ClosedSurface overlapping = surface_of(moved(cube(), 0.5, {0.75, 0.1, 0.1}));
        for (const double x : {0.5, 0.9, 1.1}) EXPECT_TRUE(overlapping.has({x, 0.3, 0.3})) << x;
        EXPECT_FALSE(overlapping.has({1.3, 0.3, 0.3}));
        const ClosedSurface solid_within = surface_of(moved(cube(), 0.5, {0.25, 0.25, 0.25}));
        EXPECT_TRUE(solid_within.has({0.5, 0.5, 0.5}));
        const ClosedSurface hollow = surface_of(moved(cube(), 0.5, {0.25, 0.25, 0.25}, true));
        EXPECT_FALSE(hollow.has({0.5, 0.5, 0.5}));
        EXPECT_TRUE(hollow.has({0.1, 0.5, 0.5}));
        EXPECT_NEAR(hollow.volume(), 0.875, 1e-14);
    }
}

TEST(ClosedSurface, WithAHoleIsRefusedByThePlaceOfIt) {
    Triangles open = cube();
    open.pop_back();
    try {
        const ClosedSurface surface(open);
        ADD_FAILURE() << "it was taken";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("(1, 0, 0) m to (1, 0, 1) m"), std::string::npos)
            << error.what();
    }
    Triangles flat = cube();
    for (auto& t : flat)
        for (Vector3& x : t) x[2] = 0.0;
    EXPECT_THROW(const ClosedSurface surface(flat), std::invalid_argument);
    EXPECT_THROW(const ClosedSurface surface{Triangles{}}, std::invalid_argument);
}

TEST_F(StlFiles, AreReadBinaryAndAsText) {
    const auto binary = folder / "cube.stl", text = folder / "cube_text.stl";
    write_binary(binary, cube());
    std::ofstream(text) << "solid cube\n";
    {
        std::ofstream out(text, std::ios::app);
        for (const auto& t : cube()) {
            out << "facet normal 0 0 0\nouter loop\n";
            for (const Vector3& x : t)
                out << "vertex " << x[0] << ' ' << x[1] << ' ' << x[2] << "e0\n";
            out << "endloop\nendfacet\n";
        }
        out << "endsolid cube\n";
    }
    for (const auto& file : {binary, text}) {
        const ClosedSurface surface = read_stl(file, 0.001, {1.0, 2.0, 3.0});
        EXPECT_EQ(surface.size(), 12U);
        EXPECT_NEAR(surface.volume(), 1e-9, 1e-15);
        EXPECT_TRUE(surface.has({1.0005, 2.0004, 3.0009}));
        EXPECT_FALSE(surface.has({1.0005, 2.0004, 3.0011}));
    }
}

TEST_F(StlFiles, OfASurfaceHaveItsBits) {
    Triangles turned = torus(16, 8);
    for (auto& t : turned) std::swap(t[0], t[1]);  // clockwise
    for (const Triangles& of : {torus(16, 8), turned}) {
        const ClosedSurface surface(of);
        const auto file = folder / "again.stl";
        std::ofstream(file) << stl_text(surface);
        const Triangles &before = surface.outward(), after = read_stl(file, 1.0, {}).outward();
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t t = 0; t < before.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                for (int d = 0; d < 3; ++d) EXPECT_EQ(before[t][k][d], after[t][k][d]);
    }
}

TEST_F(StlFiles, ThatAreWrongAreRefusedByName) {
    const auto file = folder / "wrong.stl";
    EXPECT_NE(error_of(file).find("wrong.stl: cannot be read"), std::string::npos);
    EXPECT_FALSE(error_of(folder).empty());
    write_binary(file, cube());
    std::filesystem::resize_file(file, 84 + 50 * 12 - 7);
    EXPECT_FALSE(error_of(file).empty());
    std::ofstream(file) << "polygon\n";
    EXPECT_NE(error_of(file).find("is no STL file"), std::string::npos);
    std::ofstream(file) << "solid a\nfacet\nvertex 1 2\nendfacet\n";
    EXPECT_NE(error_of(file).find("corner 1 has not three numbers"), std::string::npos);
    std::ofstream(file) << "solid a\nfacet\nvertex 1 2 3\nvertex 1 2 3\nfacet\nvertex 1 2 4\n";
    EXPECT_NE(error_of(file).find("fewer than three corners"), std::string::npos);
}

}  // namespace
