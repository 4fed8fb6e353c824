// SPDX-License-Identifier: BSD-3-Clause
// Bodies in contact at their true surfaces, in the driver.
#include <gtest/gtest.h>

#include <limits>

#include "support/cavity_in_sand.hpp"
#include "support/cylinders.hpp"
#include "support/inclined_bars.hpp"
#include "support/pressed_blocks.hpp"
#include "support/punch.hpp"

namespace {

using namespace mpm_test;
using grit::Vector2;

TEST(SurfaceContactOfBodies, PressesEveryParticleAlikeWhereverTheInterfaceIs) {
    for (const double offset : {0.0, 0.3, 0.7})
        for (const bool axisymmetric : {false, true}) {
            PressedBlocks blocks;
            blocks.offset = offset;
            blocks.axisymmetric = axisymmetric;
            const PressedBlocks::Result seen = blocks.run();
            EXPECT_NEAR(seen.lowest, -PressedBlocks::pressure, 5e3) << offset;
            EXPECT_NEAR(seen.highest, -PressedBlocks::pressure, 5e3) << offset;
            EXPECT_LT(std::fabs(seen.overlap), 0.01) << offset;
        }
}

// A plate of a part of a cell or more between two blocks that press it: what bears on one side is the load of the other.
struct PlateBetweenBlocks {
    double thickness = 0.5;  // [cells]
    bool contact_of_lower_first = true;

    struct Result {
        double lowest, highest;  // sigma_zz of the plate [Pa]
        double largest_overlap;  // [cells]
    };
    Result run() const {
        constexpr double h = 0.1, E = 50e6, nu = 0.0, rho = 2000.0, width = 0.3;
        const double level[] = {0.0, 0.73, 0.73 + thickness * h, 1.23 + thickness * h};
        Simulation simulation(Axis::uniform(0.0, width, 3), Axis::uniform(0.0, 1.6, 16),
                              {.axisymmetric = false, .local_damping = 0.1});
        for (int k = 0; k < 3; ++k) {
            const int rows =
                k == 1 ? 2 : static_cast<int>(std::lround((level[k + 1] - level[k]) / (0.5 * h)));
            simulation.add_body(make_box({0.0, width, level[k], level[k + 1], 6, rows, rho}, false,
                                         std::make_unique<LinearElastic>(E, nu)));
        }
        simulation.fix_below(0, 0.0);
        simulation.fix_above(0, width);
        simulation.fix_below(1, 0.0);
        const int count = static_cast<int>(simulation.body(2).particles.size());
        for (int i = 0; i < 6; ++i)
            simulation.add_traction({2, count - 6 + i, Edge::top, [](double t) {
                                         const double x = std::min(t / 0.05, 1.0);
                                         return Vector2{0.0, -500e3 * x * x * (3.0 - 2.0 * x)};
                                     }});
        for (const bool lower : {contact_of_lower_first, !contact_of_lower_first}) {
            SurfaceLaw law = surface_law(0.0);
            law.a = lower ? 0 : 1;
            law.b = lower ? 1 : 2;
            simulation.add_contact(law);
        }
        while (simulation.time() < 1.0) simulation.step();
        Result out{0.0, -1e30, 0.0};
        double top[3], bottom[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const Particles& q = simulation.body(k).particles;
            top[k] = -1e30;
            bottom[k] = 1e30;
            for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
                const double side = q(column::F_zz, p) * q(column::l_z, p);
                top[k] = std::max(top[k], q(column::z, p) + side);
                bottom[k] = std::min(bottom[k], q(column::z, p) - side);
                if (k != 1) continue;
                out.lowest = std::min(out.lowest, q(column::S_zz, p));
                out.highest = std::max(out.highest, q(column::S_zz, p));
            }
        }
        out.largest_overlap = std::max(top[0] - bottom[1], top[1] - bottom[2]) / h;
        return out;
    }
};

TEST(SurfaceContactOfBodies, HoldsAPlateBetweenTwoThatPressItHoweverThin) {
    for (const double thickness : {0.25, 0.5, 0.7, 0.9, 1.3, 2.0})
        for (const bool lower_first : {true, false}) {
            const auto seen = PlateBetweenBlocks{thickness, lower_first}.run();
            EXPECT_NEAR(seen.lowest, -500e3, 5e3) << thickness;
            EXPECT_NEAR(seen.highest, -500e3, 5e3) << thickness;
            EXPECT_LT(seen.largest_overlap, 0.01) << thickness;
        }
}

// The patch test: a constant stress crosses an interface of unlike particles that is inclined to the grid.
TEST(SurfaceContactOfBodies, CarriesAConstantStressAcrossAnInclinedInterface) {
    for (const double angle : {0.0, 0.1, 0.3, 0.5, 0.7})
        for (const double mu : {0.0, 0.4}) {
            InclinedBars bars;
            bars.angle = angle;
            bars.friction_coefficient = mu;
            EXPECT_LT(bars.run(), 1e-3) << angle << ", " << mu;
            if (angle != 0.1) continue;  // the worst of them with pressures a cell apart
            bars.kind = ContactKind::surface_1;
            EXPECT_LT(bars.run(), 1e-3) << angle << ", " << mu;
        }
}

TEST(SurfaceContactOfBodies, BeginsWhenTheGapIsClosedWhereverTheSideIs) {
    for (const double radius : {0.2, 0.205, 0.2125, 0.22})
        for (const double offset : {0.0, 0.5}) {
            Cylinders cylinders;
            cylinders.radius = radius;
            cylinders.offset = offset;
            const Cylinders::Result seen = cylinders.run();
            EXPECT_NEAR(seen.first, Cylinders::gap / Cylinders::closing, 1e-3);
            EXPECT_NEAR(seen.momentum, 0.0, 1e-12);
        }
}

// Embedded in an elastic body: 11.10 MN/m by finite elements (contact_study punch); a short cell elsewhere changes
// nothing.
TEST(SurfaceContactOfBodies, PunchesAsStifflyAsFiniteElementsWhateverCellsAreElsewhere) {
    for (const double last_cell : {0.0, 0.2}) {
        Punch punch;
        punch.last_cell = last_cell;
        EXPECT_NEAR(punch.stiffness() / 11.10e6, 1.0, 0.02) << last_cell;
    }
    // A cell apart, but for its edge: 7 % too stiff if they are a cell apart there.
    Punch punch;
    punch.kind = ContactKind::surface_1;
    EXPECT_NEAR(punch.stiffness() / 11.10e6, 1.0, 0.02);
}

// (C9) where the surface is, as docs/contact.md has it: the side's place in its cell decides, with a stiffness as without.
TEST(SurfaceContactOfBodies, PunchesOnAStiffLayerAsItsPlaceInTheGridSays) {
    for (const auto& [cells, error] :
         {std::pair{4.0, 0.0004}, {4.4, -0.0026}, {4.6, -0.050}, {4.8, 0.024}, {8.0, 0.0005}}) {
        Punch punch;
        punch.kind = ContactKind::surface_10;
        punch.cells = cells;
        EXPECT_NEAR(punch.stiffness() / 11.11e6, 1.0 + error, 0.003) << cells;
    }
}

// A particle below the edge that soil beside the punch covers for two thirds bears with the rest: 5 % too soft where it
// does not.
TEST(SurfaceContactOfBodies, PunchesAlikeWhereverParticlesBelowItsEdgeEnd) {
    Punch punch;
    punch.cells = 4.7;
    const double parted = punch.stiffness();
    punch.parted_below = false;
    EXPECT_NEAR(punch.stiffness() / parted, 1.0, 0.02);
}

// The wall of a cavity feels what finite elements that know no contact tell, and so do the particles beside it: those
// that are a cell wide, wherever the wall is in its cell, and means of a cell.
void expand_cavity(CavityByPoints points) {
    points.end = points.turn() + points.ramp + 0.16;
    CavityByElements elements;
    elements.end = points.end;
    const CavityCurve exact = elements.run();
    const CavityByPoints::Result seen = points.run();
    const double largest = exact.pressure_at(points.turn());
    for (std::size_t i = 0; i < seen.curve.time.size(); ++i) {
        const double t = seen.curve.time[i], p = exact.pressure_at(t);
        if (seen.curve.displacement[i] < 0.005) continue;
        EXPECT_NEAR(seen.curve.pressure[i], p, t < points.turn() ? 0.01 * p : 0.02 * largest) << t;
    }
    for (const CavityByPoints::Row& row : seen.rows)
        if (row.r0 < 2.0 * CavityProblem::a) {
            EXPECT_NEAR(row.sigma_rr / exact.stress_at(row.r0), 1.0, 0.05) << row.r0;
        }
}

TEST(SurfaceContactOfBodies, ExpandsACavityInSandWithTheStressOfFiniteElements) {
    CavityByPoints points;
    points.cell_mean = true;
    expand_cavity(points);
}

TEST(SurfaceContactOfBodies, ExpandsACavityOfParticlesOneACellWithTheStressOfFiniteElements) {
    for (const double phase : {0.0, 0.5}) {
        CavityByPoints points;
        points.per_cell = 1;
        points.phase = phase;
        expand_cavity(points);
    }
}

KeyedNumbers domain(std::uint64_t id, double r, double z, const double (&sides)[4]) {
    return {id, {r, z, sides[0], sides[1], sides[2], sides[3]}};
}

// Some of them are as near as others: on the points of a lattice, between them, and twice at one place.
TEST(NearestParticles, AreThoseThatAreFoundOneByOne) {
    std::vector<Vector2> particles;
    std::vector<int> ids;
    for (int i = 0; i < 200; ++i) {
        particles.push_back({static_cast<double>(i * 7 % 13), static_cast<double>(i * 5 % 11)});
        ids.push_back((i * 37 + 11) % 200);
    }
    std::vector<Vector2> places;
    for (int i = 0; i < 300; ++i)
        places.push_back({-2.0 + 0.5 * (i * 11 % 33), -2.0 + 0.25 * (i * 17 % 59)});
    const auto way = [&](std::size_t v, std::ptrdiff_t p) {
        return places[v] - particles[static_cast<std::size_t>(p)];
    };
    for (const std::size_t count : {std::size_t{200}, std::size_t{1}}) {
        std::vector<Rider<2>> riders(places.size());
        Exchange alone;
        find_nearest(
            riders, static_cast<std::ptrdiff_t>(count), ids.data(), alone,
            [&](std::ptrdiff_t p) { return particles[static_cast<std::size_t>(p)][0]; }, way,
            [&](std::size_t v, std::ptrdiff_t p, double* from) {
                from[0] = way(v, p)[0];
                from[1] = way(v, p)[1];
            });
        for (std::size_t v = 0; v < places.size(); ++v) {
            std::size_t nearest = 0;
            for (std::size_t p = 1; p < count; ++p) {
                const double away = norm(places[v] - particles[p]);
                const double least = norm(places[v] - particles[nearest]);
                if (away < least || (away == least && ids[p] < ids[nearest])) nearest = p;
            }
            EXPECT_EQ(riders[v].id, ids[nearest]) << v;
            EXPECT_EQ(riders[v].from[0], places[v][0] - particles[nearest][0]);
            EXPECT_EQ(riders[v].from[1], places[v][1] - particles[nearest][1]);
        }
    }
}

TEST(NearestParticles, AreThoseThatHaveAPlace) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<Vector2> particles(100, {none, 0.0});
    std::vector<int> ids;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (p % 7 == 3) particles[p] = {p % 2 ? far : -far, none};
        ids.push_back(static_cast<int>(p));
    }
    const auto find = [&] {
        std::vector<Rider<2>> riders(3);
        Exchange alone;
        find_nearest(
            riders, static_cast<std::ptrdiff_t>(particles.size()), ids.data(), alone,
            [&](std::ptrdiff_t p) { return particles[static_cast<std::size_t>(p)][0]; },
            [&](std::size_t v, std::ptrdiff_t p) {
                return Vector2{static_cast<double>(v), 0.0} -
                       particles[static_cast<std::size_t>(p)];
            },
            [](std::size_t, std::ptrdiff_t, double*) {});
        return riders[2].id;
    };
    EXPECT_EQ(find(), Rider<2>::none);
    particles[40] = {2.5, 0.5};
    EXPECT_EQ(find(), 40);
}

TEST(RiddenLine, MovesAsTheDomainsThatItsVerticesWereNearestTo) {
    Particles particles(0);
    for (const double r : {0.5, 1.5}) particles.add({r, 0.5, 0.5, 0.5, 1.0}, false);
    Exchange alone;
    RiddenLine line({{{2.0, 1.2}, {0.0, 1.2}}, false}, 1.0);
    EXPECT_FALSE(line.has_riders());
    line.find_riders(particles.view(), 0, particles.ids(), alone);
    EXPECT_FALSE(line.has_riders());
    line.find_riders(particles.view(), particles.size(), particles.ids(), alone);
    EXPECT_TRUE(line.has_riders());
    std::vector<double> x;
    std::vector<std::ptrdiff_t> facet, owner;
    // F = [[1.1, 0.2], [-0.1, 0.9]], moved by (3, 4).
    const auto image = [](double r, double z) {
        return std::pair{3.0 + 1.1 * r + 0.2 * z, 4.0 - 0.1 * r + 0.9 * z};
    };
    std::vector<KeyedNumbers> domains;
    for (const std::ptrdiff_t p : {0, 1}) {
        const auto [r, z] = image(particles(column::r, p), 0.5);
        domains.push_back(
            domain(static_cast<std::uint64_t>(particles.ids()[p]), r, z, {0.55, -0.05, 0.1, 0.45}));
    }
    line.place(domains, x, facet, owner);
    ASSERT_EQ(x.size(), 6u);
    EXPECT_EQ(facet, (std::vector<std::ptrdiff_t>{0, 1, 1, 2}));
    EXPECT_EQ(owner, (std::vector<std::ptrdiff_t>{
                         0, 0}));  // of the middle, which both are near, and the left
    for (std::size_t v = 0; v < 3; ++v) {
        const auto [r, z] = image(2.0 - static_cast<double>(v), 1.2);
        EXPECT_NEAR(x[2 * v], r, 1e-12);
        EXPECT_NEAR(x[2 * v + 1], z, 1e-12);
    }
    domains.pop_back();  // what is not near is left out
    line.place(domains, x, facet, owner);
    EXPECT_EQ(x.size() / 2, facet.size() / 2 + 1);
    EXPECT_LT(x.size(), 6u);
}

TEST(RiddenLine, IsRefusedWhereItIsTooLongForItsCells) {
    EXPECT_NO_THROW(RiddenLine({{{0.0, 0.0}, {0.0, 1e4}}, false}, 0.05));
    for (const double length : {2e4, 1e300})
        EXPECT_THROW(RiddenLine({{{0.0, 0.0}, {0.0, length}}, false}, 0.05), std::invalid_argument);
}

TEST(RiddenLine, OfAClosedLineIsClosed) {
    Particles particles(0);
    particles.add({0.5, 0.5, 0.5, 0.5, 1.0}, false);
    Exchange alone;
    RiddenLine line({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true}, 0.5);
    line.find_riders(particles.view(), particles.size(), particles.ids(), alone);
    std::vector<double> x;
    std::vector<std::ptrdiff_t> facet, owner;
    const KeyedNumbers one =
        domain(static_cast<std::uint64_t>(particles.ids()[0]), 0.5, 0.5, {0.5, 0.0, 0.0, 0.5});
    line.place({&one, 1}, x, facet, owner);
    EXPECT_EQ(x.size(), 16u);
    ASSERT_EQ(facet.size(), 16u);
    EXPECT_EQ(owner, std::vector<std::ptrdiff_t>(8, 0));
    EXPECT_EQ(facet[15], 0);
}

TEST(SurfaceContactOfBodies, RestsOnTheLineOfABodyAndNotOnItsParticles) {
    constexpr double h = 0.1, level = 0.203;
    Simulation simulation(
        Axis::uniform(0.0, 0.4, 4), Axis::uniform(0.0, 0.8, 8),
        {.axisymmetric = false, .cfl = 0.4, .local_damping = 0.5, .gravity_z = -9.81});
    Body floor = make_box({0.0, 0.4, 0.0, 0.2, 8, 4, 2000.0}, false, nullptr);
    floor.prescribed_velocity = [](double) { return grit::Vector2{0.0, 0.0}; };
    simulation.add_body(std::move(floor));
    simulation.add_body(make_box({0.0, 0.4, 0.21, 0.21 + 2 * h, 8, 4, 2000.0}, false,
                                 std::make_unique<LinearElastic>(10e6, 0.2)));
    simulation.fix_below(0, 0.0);
    simulation.fix_above(0, 0.4);
    SurfaceLaw law = surface_law(0.0);
    law.line_a.points = {{0.4, level}, {0.0, level}};
    simulation.add_contact(law);
    while (simulation.time() < 0.5) simulation.step();
    const Particles& q = simulation.body(1).particles;
    double lowest = 1e30;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        lowest = std::min(lowest, q(column::z, p) - q(column::F_zz, p) * q(column::l_z, p));
    EXPECT_NEAR(lowest, level, 1e-4);
}

// A rigid plate presses a damped block onto the floor: how deep it gets into it, and whether energies add up.
struct DampedPress {
    double overlap;   // largest [m]
    double residual;  // of energy by the plate's work [-]
};

DampedPress damped_press(bool after_damping) {
    constexpr double floor = 0.7, top = 1.5, speed = 0.05;
    Simulation simulation(Axis::uniform(0.0, 0.4, 4), Axis::uniform(0.0, 2.0, 20),
                          {.axisymmetric = false, .cfl = 0.4, .local_damping = 0.5});
    Body plate = make_box({0.0, 0.4, top, top + 0.2, 8, 4, 2000.0}, false, nullptr);
    plate.prescribed_velocity = [](double t) {
        return grit::Vector2{0.0, -speed * std::min(1.0, t / 0.02)};
    };
    simulation.add_body(std::move(plate));
    simulation.add_body(make_box({0.0, 0.4, floor, top, 8, 16, 2000.0}, false,
                                 std::make_unique<LinearElastic>(2e6, 0.2)));
    simulation.fix_below(0, 0.0);
    simulation.fix_above(0, 0.4);
    simulation.fix_below(1, floor);
    SurfaceLaw law = surface_law(0.0);
    law.after_damping = after_damping;
    simulation.add_contact(law);
    DampedPress out{0.0, 0.0};
    while (simulation.time() < 0.2) {
        simulation.step();
        double highest = 0.0, lowest = 2.0;
        const Particles &a = simulation.body(0).particles, &b = simulation.body(1).particles;
        for (std::ptrdiff_t p = 0; p < a.size(); ++p)
            lowest = std::min(lowest, a(column::z, p) - a(column::l_z, p));
        for (std::ptrdiff_t p = 0; p < b.size(); ++p)
            highest = std::max(highest, b(column::z, p) + b(column::F_zz, p) * b(column::l_z, p));
        out.overlap = std::max(out.overlap, highest - lowest);
    }
    const Energy energy = simulation.energy();
    out.residual = energy.residual() / energy.rigid_work;
    return out;
}

TEST(SurfaceContactOfBodies, HoldsWhatDampingHasChangedIfAsked) {
    const DampedPress once = damped_press(false), again = damped_press(true);
    EXPECT_GT(once.overlap, 1e-5);
    EXPECT_LT(again.overlap, 1e-8);
    EXPECT_NEAR(again.residual, once.residual, 5e-4);
    EXPECT_NEAR(once.residual, 0.0, 5e-3);
}

// Pressures take sweeps; those that were not given enough of them are counted.
TEST(SurfaceContactOfBodies, TellsHowManySweepsItTookAndWhichDidNotEnd) {
    for (const int limit : {500, 2}) {
        Simulation simulation(Axis::uniform(0.0, 0.8, 8), Axis::uniform(0.0, 1.0, 10),
                              {.axisymmetric = false, .cfl = 0.4});
        simulation.add_body(make_floor({0.0, 0.8, 0.1, 0.2, 16, 2, 2000.0}, false));
        simulation.add_body(make_box({0.0, 0.8, 0.2, 0.4, 16, 4, 2000.0}, false,
                                     std::make_unique<LinearElastic>(2e6, 0.2)));
        for (std::ptrdiff_t p = 0; p < simulation.body(1).particles.size(); ++p)
            simulation.body(1).particles.view()[column::v_z][p] =
                -0.01 * static_cast<double>(p % 5);
        SurfaceLaw law = surface_law(0.3);
        law.options.sweep_limit = limit;
        simulation.add_contact(law);
        constexpr int steps = 10;
        for (int i = 0; i < steps; ++i) simulation.step();
        const Sweeps& sweeps = simulation.surface_contact(0).sweeps();
        EXPECT_EQ(sweeps.calls, steps);
        EXPECT_EQ(sweeps.unfinished, limit == 2 ? steps : 0);
        if (limit == 2) EXPECT_EQ(sweeps.all, 2 * steps);
        else EXPECT_GT(sweeps.all, 2 * steps);
    }
}

}  // namespace
