// SPDX-License-Identifier: BSD-3-Clause
// Undrained pore water in space (W1): against the plane, the constant-volume path, closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include <adapters/mpm/case/build_case.hpp>
#include <adapters/mpm/case/closed_surface.hpp>
#include <adapters/mpm/case/rules.hpp>
#include <adapters/mpm/run/run.hpp>
#include <adapters/mpm/space/kernel/sand.hpp>

#include "../catalogue.hpp"
#include "support/beside_plane.hpp"
#include "support/loose_cube.hpp"
#include "support/refused.hpp"

namespace {

using namespace space_test;
namespace mpm = grit::mpm;
using mpm::PoreWater;

constexpr double K_w = 2.2e9, n = 0.4, grain_density = 2650.0, rho_w = 1000.0;
constexpr double mixed_density = (1.0 - n) * grain_density + n * rho_w;

PoreWater water_of_elastic(int first) {
    return {.bulk_modulus = K_w, .density = rho_w, .porosity = n, .first = first};
}

// Elastic, its pores full of water without pressure.
Body wet_brick(const Brick& brick, double E, double nu) {
    Body body;
    body.material = std::make_unique<LinearElastic>(E, nu);
    body.water = water_of_elastic(column::own);
    body.particles = Particles(body.water->columns());
    add_brick(body.particles, brick);
    return body;
}

double mean_pore_pressure(Simulation& simulation, std::size_t which) {
    Body& body = simulation.body(which);
    double sum = 0.0, volume = 0.0;
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        const double V = body.particles.view().volume(p);
        sum += V * body.water->pressure(body.particles.view(), p);
        volume += V;
    }
    return sum / volume;
}

void expect_same_energies(BesidePlane& both) {
    const mpm::Energy a = both.plane.energy(), b = both.space.energy();
    EXPECT_NEAR(b.pore_water / both.width, a.pore_water, 1e-9 * a.kinetic_0);
    EXPECT_NEAR(b.contact / both.width, a.contact, 1e-9 * a.kinetic_0);
    EXPECT_NEAR(b.residual() / both.width, a.residual(), 1e-9 * a.kinetic_0);
}

// A saturated block that falls on the corner of a slab: the plane's driver beside it, x = r, one cell across the plane.
TEST(SpaceWater, InPlaneStrainIsThatOfThePlane) {
    namespace pc = grit::mpm::column;
    BesidePlane both({.axisymmetric = false, .local_damping = 0.05});
    both.add<mpm::LinearElastic, LinearElastic>({0.25, 0.05, 10, 8, mixed_density, 1.0, -2.0}, 1e6,
                                                0.3, water_of_elastic(0));
    for (int i = 0; i < 200; ++i) both.step();
    double most = 0.0;
    both.expect_same(
        [&most](const mpm::Particles& a, std::ptrdiff_t p, const Particles& b, std::ptrdiff_t s) {
            EXPECT_NEAR(b(column::S_zz, s), a(pc::S_zz, p), 1e-4);
            EXPECT_NEAR(b(column::own, s), a(pc::own, p), 1e-9 * K_w);
            most = std::fmax(most, std::fabs(a(pc::own, p)));
        });
    EXPECT_GT(most, 1e4);
    expect_same_energies(both);
}

// Two saturated blocks, one of which slides on the other as it falls on it: what water bears does not rub, at nodes of both, as in
// the plane. Bounds of waves, which viscosity and steps go by, are the same in both for the linear law alone; that of
// neo-Hooke has an energy.
class TwoWetBodies : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(SpaceWater, TwoWetBodies, testing::Bool(), [](const auto& of) {
    return std::string(of.param ? "NeoHooke" : "Linear");
});

TEST_P(TwoWetBodies, InPlaneStrainAreThoseOfThePlane) {
    namespace pc = grit::mpm::column;
    const bool neo_hooke = GetParam();
    constexpr double E = 1e6;
    BesidePlane both(
        {.axisymmetric = false, .largest_step = 3e-4, .linear_viscosity = neo_hooke ? 0.0 : 0.1});
    PoreWater water = water_of_elastic(0);
    water.bulk_modulus = E * n;
    for (const BesidePlane::Block& block :
         {BesidePlane::Block{0.05, 0.05, 20, 6, mixed_density},
          BesidePlane::Block{0.45, 0.65, 8, 4, mixed_density, 0.5, -1.0}}) {
        if (neo_hooke) both.add<mpm::NeoHooke, NeoHooke>(block, E, 0.3, water);
        else both.add<mpm::LinearElastic, LinearElastic>(block, E, 0.3, water);
    }
    ContactLaw law = nodal_law(GRIT_CONTACT_FRICTIONAL, 0.3, 0, 1);
    law.gated = false;
    both.plane.add_contact(law);
    both.space.add_contact(law);
    double rubbed = 0.0;
    for (int i = 0; i < 250; ++i) {
        both.step();
        rubbed += both.space.contact(0).totals().dissipation_tangential;
    }
    EXPECT_GT(rubbed, 1.0);
    both.expect_same(
        [](const mpm::Particles& a, std::ptrdiff_t p, const Particles& b, std::ptrdiff_t s) {
            EXPECT_NEAR(b(column::own, s), a(pc::own, p), 1e-9 * E);
        });
    expect_same_energies(both);
    const mpm::Energy energy = both.space.energy();
    EXPECT_NEAR(energy.residual(), 0.0, (neo_hooke ? 1e-3 : 1e-2) * energy.kinetic_0);
}

// A block between rollers that a load presses: K/n of the water and E beside each other carry it (W4), over a whole number of
// periods; the step is that of the wave of both, from the first one on.
TEST(SpaceWater, SharesALoadWithTheSkeleton) {
    constexpr double E = 10e6, load = 1e4, h = 0.1, ramp = 0.02;
    constexpr int cells = 8;
    const Axis side = Axis::uniform(0.0, h, 1);
    Simulation simulation({side, side, Axis::uniform(0.0, 1.0, 10)}, {.cfl = 0.4});
    simulation.add_body(
        wet_brick({{0.0, 0.0, 0.0}, {h, h, cells * h}, {2, 2, 2 * cells}, mixed_density}, E, 0.0));
    for (const int d : {0, 1}) {
        simulation.fix_below(d, 0.0);
        simulation.fix_above(d, h);
    }
    simulation.fix_below(2, 0.0);
    const auto count = static_cast<int>(simulation.body(0).particles.size());
    for (int i = count - 4; i < count; ++i)
        simulation.add_traction({0, i, {2, true}, [](double t) {
                                     return Vector3{0.0, 0.0, -load * std::fmin(t / ramp, 1.0)};
                                 }});
    const double c = std::sqrt((E + K_w / n) / mixed_density);
    double sum = 0.0, steps = 0.0;
    const double period = 4.0 * cells * h / c;
    while (simulation.time() < ramp + 5.0 * period) {
        simulation.step();
        if (simulation.steps() == 1) {
            EXPECT_NEAR(simulation.time(), 0.4 * h / c, 1e-9 * h / c);
            EXPECT_NEAR(simulation.next_step(), 0.4 * h / c, 1e-4 * h / c);
        }
        if (simulation.time() < ramp) continue;
        sum += mean_pore_pressure(simulation, 0);
        steps += 1.0;
    }
    const double expected = load * (K_w / n) / (K_w / n + E);
    EXPECT_NEAR(sum / steps, expected, 0.005 * expected);
    const mpm::Energy energy = simulation.energy();
    EXPECT_NEAR(energy.residual(), 0.0, 1e-3 * energy.external_work);
    EXPECT_GT(energy.pore_water, 0.9 * energy.external_work);
}

mpm::AxisPlan axis(double from, double to, int cells) { return {from, {{to, cells}}}; }

// A column of sand below a water table.
mpm::Case column_of_sand() {
    mpm::Case plan;
    plan.name = "column";
    mpm::SpacePlan& space = plan.space.emplace();
    space.axis[0] = space.axis[1] = axis(0.0, 0.2, 2);
    space.axis[2] = axis(0.0, 1.2, 12);
    for (const int side : {0, 1, 2, 3, 4}) space.boundary[side] = mpm::Boundary::roller;
    mpm::BodyPlan sand{};
    sand.name = "sand";
    mpm::SandPlan material;
    material.parameters = catalogue_parameters("lausitz", 1000.0);
    material.options = options_with_tolerance(1e-3);
    material.void_ratio = 0.65;
    sand.material = material;
    sand.density = grain_density;
    sand.geostatic = mpm::Geostatic{.surface = 1.0, .surcharge = 1000.0};
    sand.water = mpm::WaterPlan{.grain_density = grain_density, .table = 1.0};
    plan.bodies = {sand};
    space.bodies = {{{{mpm::BoxShape{{0.0, 0.0, 0.0}, {0.2, 0.2, 1.0}}}}}};
    mpm::TractionPlan load;
    load.body = "sand";
    load.stress = mpm::TimeTable{{0.0}, {1000.0}};
    plan.tractions = {load};
    space.faces = {{}};
    mpm::StagePlan stage = plan.plain_stage("rest");
    stage.end.time = 0.02;
    plan.stages = {stage};
    plan.history = {"sand", mpm::DepthOf::centre_of_mass, 0.01};
    return plan;
}

TEST(SpaceWater, StartsWithTheBuoyantWeightAndStaysAtRest) {
    mpm::Runner runner(column_of_sand());
    Simulation& simulation = *runner.space();
    Body& body = simulation.body(0);
    const double density = (grain_density + 0.65 * rho_w) / 1.65;
    const auto check = [&](double tolerance) {
        const ParticleView q = body.particles.view();
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            const double depth = 1.0 - q[column::z][p];
            EXPECT_NEAR(q[column::mass][p], density * q[column::V0][p], 1e-9 * q[column::mass][p]);
            EXPECT_NEAR(body.water->pressure(q, p), rho_w * 9.81 * depth, tolerance);
            EXPECT_NEAR(q[column::S_zz][p], -(1000.0 + (density - rho_w) * 9.81 * depth),
                        tolerance);
        }
    };
    check(0.01);
    while (!runner.finished()) runner.step();
    check(10.0);
    EXPECT_GT(runner.row().step, 500);
    EXPECT_LT(runner.row().energy.kinetic, 1e-9);
    EXPECT_NEAR(runner.row().least_pore_pressure, rho_w * 9.81 * 0.025, 10.0);
    EXPECT_NEAR(runner.row().largest_pore_pressure, rho_w * 9.81 * 0.975, 10.0);
}

TEST(SpaceWater, RefusesWhatIsNotThere) {
    const auto refused = [](const auto& spoil, const char* why) {
        mpm::Case plan = column_of_sand();
        spoil(plan);
        expect_refused(plan, why);
    };
    const char* why = "body sand: in space pore water is undrained, and its pressure explicit";
    refused([](mpm::Case& c) { c.bodies[0].water->implicit = true; }, why);
    refused([](mpm::Case& c) { c.bodies[0].water->drainage = mpm::Drainage::flow; }, why);
    refused([](mpm::Case& c) { c.bodies[0].water->bulk_modulus = 5e3; },
            "body sand: the bulk modulus of water");
}

// Triangles that ride do not know whose cell they are in.
TEST(SpaceWater, RefusesAGivenSurfaceOfAWetBody) {
    mpm::Case plan = column_of_sand();
    mpm::ContactPlan contact;
    contact.stiff = "sand";
    contact.soft = "plate";
    const Vector3 corner[] = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    contact.surface_mesh = std::make_shared<mpm::ClosedSurface>(
        std::vector<mpm::ClosedSurface::Triangle>{{corner[0], corner[2], corner[1]},
                                                  {corner[0], corner[1], corner[3]},
                                                  {corner[0], corner[3], corner[2]},
                                                  {corner[1], corner[2], corner[3]}});
    plan.contacts = {contact};
    mpm::BodyPlan plate = plan.bodies[0];
    plate.name = "plate";
    plate.water.reset();
    plan.bodies.push_back(plate);
    const auto same_name = [](std::string_view key) { return std::string(key); };
    const mpm::Objections found = mpm::objection_to_contact(plan, 0, same_name);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->key, "stiff_surface");
    EXPECT_EQ(found->what, ": \"sand\" has pore water");
    plan.bodies[0].water.reset();
    EXPECT_FALSE(mpm::objection_to_contact(plan, 0, same_name));
}

// A cell of saturated sand, whose nodes at 0 are held while those at 1 m have the particle's velocity: it is the gradient.
class WetSand {
  public:
    // p: mean effective pressure, p_w: the column of the pore pressure [Pa].
    WetSand(double p, double e, double p_w) {
        Body cell;
        cell.material =
            std::make_unique<Sand>(catalogue_sand("lausitz", 1000.0), options_with_tolerance(1e-3));
        cell.water = PoreWater{.first = column::own + cell.material->own_columns(),
                               .void_ratio_column = cell.material->separation().void_ratio,
                               .opening_cap = cell.material->separation().cap};
        cell.particles = Particles(cell.material->own_columns() + cell.water->columns());
        add_brick(cell.particles, {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {1, 1, 1}, 2000.0});
        const ParticleView q = cell.particles.view();
        for (int k = 0; k < 3; ++k) q[column::S_xx + k][0] = -p;
        q[cell.water->void_ratio_column][0] = e;
        q[cell.water->first][0] = p_w;
        simulation.add_body(std::move(cell));
        for (const int d : {0, 1, 2}) simulation.fix_below(d, 0.0);
    }
    const PoreWater& water() { return *simulation.body(0).water; }
    double e() { return view()[water().void_ratio_column][0]; }
    double p_w() { return view()[water().first][0]; }
    double bears() { return water().pressure(view(), 0); }
    void strain_by(const Vector3& rates) {
        for (int k = 0; k < 3; ++k) view()[column::v_x + k][0] = rates[k];
        simulation.step();
    }

  private:
    ParticleView view() { return simulation.body(0).particles.view(); }
    Simulation simulation{cube_of_cells(1.0, 1), {.cfl = 0.02}};
};

// Strained in all directions, each its own way, and back: its grains keep their volume.
TEST(SpaceWater, FollowsTheVoidRatioOfItsSand) {
    constexpr double p_w0 = 5e4, e_0 = 0.65;
    WetSand sand(1e5, e_0, p_w0);
    double least = p_w0, most = p_w0;
    for (int i = 0; i < 900; ++i) {
        const double sign = i / 300 == 1 ? -1.0 : 1.0;
        sand.strain_by(sign * Vector3{-0.7, 0.4, 0.28});
        const double expected = p_w0 - K_w * std::log(sand.e() / e_0);
        ASSERT_NEAR(sand.p_w(), expected, 1e-6 * std::fabs(expected) + 1e-3) << i;
        least = std::fmin(least, expected);
        most = std::fmax(most, expected);
    }
    EXPECT_GT(most - least, 1e5);
}

// Pores that have opened as far as they go open no cavity further, and their water bears again where they close from there.
TEST(SpaceWater, KeepsACavityWherePoresAreOpenToTheCap) {
    constexpr double cavity = -1.2e5, tension = -1e5;
    const double cap = mpm::opening_cap(catalogue_sand("lausitz", 1000.0));
    WetSand sand(0.0, cap, cavity);
    for (int i = 0; i < 5; ++i) sand.strain_by({0.1, 0.2, 0.0});
    EXPECT_EQ(sand.p_w(), cavity);
    EXPECT_EQ(sand.bears(), tension);
    for (int i = 0; i < 200 && sand.bears() <= 0.0; ++i) sand.strain_by({-0.05, 0.0, 0.0});
    EXPECT_GT(sand.bears(), 0.0);
    const double expected = cavity - K_w * std::log(sand.e() / cap);
    EXPECT_NEAR(sand.p_w(), expected, 1e-3 * std::fabs(cavity));
}

// What has cavitated bears no more than its tension, and bears again where the pores have closed.
TEST(SpaceWater, CavitatesAndBearsAgain) {
    Simulation simulation(cube_of_cells(1.0, 1), {.cfl = 0.1});
    simulation.add_body(wet_brick({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {1, 1, 1}, 2000.0}, 1e6, 0.2));
    for (const int d : {0, 1, 2}) simulation.fix_below(d, 0.0);
    Body& body = simulation.body(0);
    const auto strain_by = [&](double rate) {
        for (int k = 0; k < 3; ++k) body.particles.view()[column::v_x + k][0] = rate;
        simulation.step();
        return body.water->pressure(body.particles.view(), 0);
    };
    double pressure = 0.0;
    for (int i = 0; i < 50; ++i) pressure = strain_by(1.0);
    EXPECT_EQ(pressure, -1e5);
    double J = 0.0;
    for (int i = 0; i < 60 && pressure < 0.0; ++i) {
        pressure = strain_by(-1.0);
        J = body.particles.view().J(0);
    }
    EXPECT_GE(pressure, 0.0);
    EXPECT_NEAR(J, 1.0, 1e-3);  // of a step
}

enum class Rubs { at_nodes, at_nodes_of_soil, at_surfaces };  // of soil: it is a

// A rigid plate presses on soil and slides on it: K_w = E n, so that water carries half of what presses. The mean force along its
// way once it slides [N].
double rubbing_force(bool wet, Rubs how) {
    constexpr double L = 1.0, h = 0.125, E = 10e6;
    Simulation simulation(
        {Axis::uniform(0.0, L, 8), Axis::uniform(0.0, h, 1), Axis::uniform(0.0, 0.75 * L, 6)}, {});
    const Brick soil{{0.0, 0.0, 0.0}, {L, h, 0.5 * L}, {16, 2, 8}, mixed_density};
    Body body =
        wet ? wet_brick(soil, E, 0.0) : make_brick(soil, std::make_unique<LinearElastic>(E, 0.0));
    if (wet) body.water->bulk_modulus = E * n;
    simulation.add_body(std::move(body));
    Body plate = make_brick({{0.0, 0.0, 0.5 * L}, {L, h, 0.625 * L}, {16, 2, 2}}, nullptr);
    RigidCourse course;
    course.velocity = [down = mpm::TimeTable{{0.0, 0.02, 0.04}, {0.0, -1e-2, 0.0}},
                       along = mpm::TimeTable{{0.0, 0.05, 0.06}, {0.0, 0.0, 0.02}}](double t) {
        return Vector3{along.at(t), 0.0, down.at(t)};
    };
    plate.make_rigid(course);
    simulation.add_body(std::move(plate));
    simulation.fix_below(0, 0.0);
    simulation.fix_above(0, L);
    simulation.fix_below(1, 0.0);
    simulation.fix_above(1, h);
    simulation.fix_below(2, 0.0);
    const bool at_surfaces = how == Rubs::at_surfaces;
    if (at_surfaces) {
        SurfaceLaw law = surface_law(0.3);
        law.a = 1;
        law.b = 0;
        simulation.add_contact(law);
    } else {
        const std::size_t a = how == Rubs::at_nodes ? 1 : 0;
        simulation.add_contact(nodal_law(GRIT_CONTACT_GEO, 0.3, a, 1 - a));
    }
    double force = 0.0, count = 0.0;
    while (simulation.time() < 0.12) {
        simulation.step();
        if (simulation.time() < 0.07) continue;
        const auto of = [](const auto& pair) {
            return pair.measured().sideways[0] + pair.measured().along_z[0];
        };
        force += at_surfaces ? of(simulation.surface_contact(0)) : of(simulation.contact(0));
        count += 1.0;
    }
    return std::fabs(force / count);
}

TEST(SpaceWater, DoesNotRub) {
    for (const Rubs how : {Rubs::at_nodes, Rubs::at_nodes_of_soil, Rubs::at_surfaces}) {
        const double dry = rubbing_force(false, how);
        // Seen from the soil a cell of it moves with the plate.
        const double strained = how == Rubs::at_nodes_of_soil ? 0.5 - 0.125 : 0.5;
        const double expected = 0.3 * 10e6 * 2e-4 / strained * 0.125;
        EXPECT_NEAR(dry, expected, 0.03 * expected);
        EXPECT_NEAR(rubbing_force(true, how), dry, 0.04 * dry) << static_cast<int>(how);
    }
}

// Sand and a slab on it, both wet, particles in some order.
std::unique_ptr<Simulation> wet_meeting(const Settings& settings) {
    auto out = std::make_unique<Simulation>(cube_of_cells(1.3, 13), settings);
    out->set_gravity({1.0, 0.0, -9.81});
    out->add_body(wet(loose_cube_of_sand()));
    out->add_body(wet(slab_above()));
    out->add_contact(not_gated());
    return out;
}

std::string bits_of(const Simulation& simulation) {
    std::string out;
    for (const std::size_t b : {0u, 1u}) {
        const Particles& q = simulation.body(b).particles;
        for (int id = 0; id < q.size(); ++id)
            for (int c = 0; c < q.column_count(); ++c) {
                const double x = q(c, simulation.find(b, id));
                out.append(reinterpret_cast<const char*>(&x), sizeof x);
            }
    }
    return out;
}

TEST(SpaceWater, IsTheSameWhateverTheThreads) {
    for (const bool fixed_point : {false, true})
        for (const bool means : {false, true}) {
            std::string one;
            for (const int threads : {1, 2, 3}) {
                const auto simulation = wet_meeting({.pic_rate = 20.0,
                                                     .local_damping = 0.1,
                                                     .linear_viscosity = 0.1,
                                                     .cell_mean = means,
                                                     .fixed_point = fixed_point,
                                                     .threads = threads});
                for (int i = 0; i < 40; ++i) simulation->step();
                const std::string now = bits_of(*simulation);
                if (threads == 1) one = now;
                EXPECT_TRUE(now == one) << threads << ' ' << fixed_point << means;
            }
        }
}

TEST(SpaceWater, GoesOnFromACheckpointBitForBit) {
    const mpm::Case plan = column_of_sand();
    mpm::Case pushed = plan;
    pushed.tractions[0].stress = mpm::TimeTable{{0.0, 0.01}, {1000.0, 5000.0}};
    mpm::Runner one(pushed), other(pushed);
    const auto saved = [](mpm::Runner& runner) {
        std::ostringstream out;
        runner.subject().save(out);
        return out.str();
    };
    for (int i = 0; i < 100; ++i) one.step();
    std::istringstream in(saved(one));
    other.subject().restore(in, mpm::OtherBits::refused);
    for (int i = 0; i < 100; ++i) {
        one.step();
        other.step();
    }
    EXPECT_TRUE(saved(one) == saved(other));
    mpm::Case drier = pushed;
    drier.bodies[0].water->bulk_modulus = 1e9;
    mpm::Runner third(drier);
    std::istringstream again(saved(one));
    EXPECT_THROW(third.subject().restore(again, mpm::OtherBits::refused), std::runtime_error);
}

}  // namespace
