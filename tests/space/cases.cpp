// SPDX-License-Identifier: BSD-3-Clause
// Cases in space: shapes, sides, loads, stages, checkpoints.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include <adapters/mpm/case/build_case.hpp>
#include <adapters/mpm/run/run.hpp>
#include <adapters/mpm/space/case/solids.hpp>
#include <adapters/mpm/space/kernel/sand.hpp>

#include "../catalogue.hpp"
#include "support/bricks.hpp"
#include "support/refused.hpp"

namespace {

using namespace space_test;
namespace mpm = grit::mpm;

mpm::AxisPlan axis(double from, double to, int cells) { return {from, {{to, cells}}}; }

double volume(const Particles& q) {
    double sum = 0.0;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p) sum += q(column::V0, p);
    return sum;
}

double volume_of(const mpm::Shape3& shape) {
    const Axes axes{Axis::uniform(0.0, 2.0, 20), Axis::uniform(0.0, 2.0, 20),
                    Axis::uniform(0.0, 2.0, 20)};
    mpm::SpacePlan plan;
    plan.bodies = {{{{shape}}}};
    plan.boundary[0] = plan.boundary[2] = mpm::Boundary::roller;
    return volume(fill(plan, 0, "body", 1000.0, axes, 0));
}

TEST(SpaceShapes, HaveTheirVolumeABoxExactly) {
    constexpr double pi = std::numbers::pi;
    EXPECT_NEAR(volume_of(mpm::BoxShape{{0.13, 0.0, 0.2}, {1.27, 0.71, 1.99}}), 1.14 * 0.71 * 1.79,
                1e-12);
    EXPECT_NEAR(volume_of(mpm::SphereShape{{1.0, 1.0, 1.0}, 0.8}), 4.0 / 3.0 * pi * 0.512, 2e-3);
    EXPECT_NEAR(volume_of(mpm::ConeShape{{1.0, 1.0}, {0.5, 1.5}, {0.6, 0.6}}), pi * 0.36, 1e-3);
    EXPECT_NEAR(volume_of(mpm::ConeShape{{1.0, 1.0}, {0.5, 1.5}, {0.0, 0.9}}), pi * 0.27, 1e-3);
    // A quarter, the rest of it beyond the grid.
    EXPECT_NEAR(volume_of(mpm::ConeShape{{0.0, 0.0}, {0.5, 1.5}, {0.6, 0.6}}), pi * 0.09, 3e-4);
    // Around a side that rolls, but nowhere else.
    for (const double x : {-0.1, 0.1, 2.0})
        EXPECT_THROW(volume_of(mpm::SphereShape{{x, 1.0, 1.0}, 0.8}), std::invalid_argument) << x;
    EXPECT_THROW(volume_of(mpm::BoxShape{{0.0, 0.0, 0.0}, {1.0, 2.1, 1.0}}), std::invalid_argument);
}

// A pile and the sand around it, at any place in its cells: together they are the box, and what the pile's surface cuts
// off has the moments of the cylinder.
TEST(SpaceShapes, ThatAreCutHaveTheirVolumeAndMomentsAndLeaveNothingOut) {
    const Axes axes{Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 1.0, 10),
                    Axis::uniform(0.0, 0.4, 4)};
    for (const double off : {0.0, 0.013, 0.05, 0.071}) {
        mpm::SpacePlan plan;
        const double R = 0.23, centre = 0.5 + off;
        plan.bodies = {{{{mpm::ConeShape{{centre, centre}, {0.0, 0.4}, {R, R}}}}},
                       {{{mpm::BoxShape{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.4}}}}, {0}}};
        const Particles pile = fill(plan, 0, "pile", 1.0, axes, 0);
        const Particles sand = fill(plan, 1, "sand", 1.0, axes, 0);
        const double exact = std::numbers::pi * R * R * 0.4;
        EXPECT_NEAR(volume(pile), exact, 1e-3 * exact) << off;
        EXPECT_NEAR(volume(pile) + volume(sand), 0.4, 1e-3 * exact) << off;
        // Upright sides are whole: what is cut fills its layer, and a load on the top has the area of the circle.
        for (std::ptrdiff_t p = 0; p < pile.size(); ++p)
            EXPECT_DOUBLE_EQ(pile(column::l_z, p), 0.025);
        double first = 0.0, second = 0.0;  // about the axis; with the particles' own
        for (std::ptrdiff_t p = 0; p < pile.size(); ++p) {
            const double x = pile(column::x, p) - centre, y = pile(column::y, p) - centre;
            const double l_x = pile(column::l_x, p), l_y = pile(column::l_y, p);
            first += pile(column::V0, p) * x;
            second += pile(column::V0, p) * (x * x + y * y + (l_x * l_x + l_y * l_y) / 3.0);
        }
        EXPECT_NEAR(first, 0.0, 1e-3 * exact * R) << off;
        EXPECT_NEAR(second, 0.5 * exact * R * R, 3e-3 * exact * R * R) << off;
    }
}

// A quarter of a pile has as much on each side of the diagonal, and so has the sand around it.
TEST(SpaceShapes, ThatAreCutAreTheSameOnBothSidesOfADiagonal) {
    const Axes axes{Axis::uniform(0.0, 0.6, 6), Axis::uniform(0.0, 0.6, 6),
                    Axis::uniform(0.0, 0.2, 2)};
    mpm::SpacePlan plan;
    plan.boundary[0] = plan.boundary[2] = mpm::Boundary::roller;
    plan.bodies = {{{{mpm::ConeShape{{0.0, 0.0}, {0.0, 0.2}, {0.23, 0.23}}}}},
                   {{{mpm::BoxShape{{0.0, 0.0, 0.0}, {0.6, 0.6, 0.2}}}}, {0}}};
    for (const std::size_t body : {0, 1}) {
        const Particles q = fill(plan, body, "body", 1.0, axes, 0);
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            double nearest = 1.0;  // of what the mirror image differs by
            for (std::ptrdiff_t other = 0; other < q.size(); ++other) {
                double off = std::fabs(q(column::V0, p) - q(column::V0, other));
                for (const auto& [x, y] : {std::pair<int, int>{column::x, column::y},
                                           {column::y, column::x},
                                           {column::z, column::z},
                                           {column::l_x, column::l_y},
                                           {column::l_y, column::l_x}})
                    off = std::max(off, std::fabs(q(x, p) - q(y, other)));
                nearest = std::min(nearest, off);
            }
            ASSERT_LT(nearest, 1e-14) << body << ' ' << p;
        }
    }
}

TEST(SpaceShapes, OfTwoBodiesAreApart) {
    const Axes axes{Axis::uniform(0.0, 1.0, 5), Axis::uniform(0.0, 1.0, 5),
                    Axis::uniform(0.0, 1.0, 5)};
    const auto box = [&](double from, double to) {
        mpm::SpacePlan plan;
        plan.bodies = {{{{mpm::BoxShape{{from, 0.0, 0.0}, {to, 1.0, 1.0}}}}}};
        return fill(plan, 0, "box", 1.0, axes, 0);
    };
    Particles one = box(0.0, 0.5), beside = box(0.5, 1.0), within = box(0.4, 1.0);
    EXPECT_NO_THROW(check_apart(one, beside, axes, "one and beside"));
    EXPECT_THROW(check_apart(one, within, axes, "one and within"), std::invalid_argument);
}

// What a shape shows along a direction is loaded, whatever cells cut it; a flat side has the areas of its bricks.
TEST(SpaceTraction, LoadsTheAreaThatAShapeShowsAlongItsDirection) {
    constexpr double pi = std::numbers::pi, R = 0.31;
    const auto area = [&](const mpm::Shape3& shape, int across, bool upper, int cells) {
        const Axis along = Axis::uniform(0.0, 1.0, cells);
        const Axes axes{along, along, along};
        mpm::SpacePlan plan;
        plan.bodies = {{{{shape}}}};
        const Particles q = fill(plan, 0, "body", 1000.0, axes, 0);
        double sum = 0.0;
        for (const OuterFace& of : outermost(plan, 0, axes, {across, upper}, "body")) {
            const int a = column::l_x + (across + 1) % 3, b = column::l_x + (across + 2) % 3;
            sum += of.share * 4.0 * q(a, of.particle) * q(b, of.particle);
            EXPECT_EQ(q.ids()[of.particle], of.particle);
        }
        return sum;
    };
    const mpm::SphereShape ball{{0.5, 0.51, 0.48}, R};
    const mpm::ConeShape pile{{0.5, 0.51}, {0.2, 0.83}, {R, R}},
        tip{{0.5, 0.51}, {0.2, 0.83}, {0.0, R}};
    for (const bool upper : {false, true}) {
        for (const int across : {0, 1, 2})
            EXPECT_NEAR(area(ball, across, upper, 10), pi * R * R, 0.005 * pi * R * R);
        EXPECT_NEAR(area(pile, 0, upper, 10), 2.0 * R * 0.63, 0.005);
        EXPECT_NEAR(area(pile, 2, upper, 10), pi * R * R, 0.005 * pi * R * R);
        EXPECT_NEAR(area(tip, 2, upper, 10), pi * R * R, 0.02 * pi * R * R);
        EXPECT_NEAR(area(tip, 2, upper, 20), pi * R * R, 0.005 * pi * R * R);
    }
    const mpm::BoxShape box{{0.13, 0.2, 0.31}, {0.77, 0.5, 0.9}};
    EXPECT_NEAR(area(box, 2, true, 7), 0.64 * 0.3, 1e-12);
    EXPECT_NEAR(area(box, 0, false, 7), 0.3 * 0.59, 1e-12);
}

// A shape upon another one of the same body covers its share of the faces below.
TEST(SpaceTraction, LeavesOutWhatAnotherShapeOfTheBodyCovers) {
    const Axis along = Axis::uniform(0.0, 1.0, 10);
    const Axes axes{along, along, along};
    mpm::SpacePlan plan;
    plan.bodies = {{{{mpm::BoxShape{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.5}}},
                     {mpm::BoxShape{{0.0, 0.0, 0.5}, {0.475, 1.0, 0.8}}}}}};
    const Particles q = fill(plan, 0, "step", 1000.0, axes, 0);
    double lower = 0.0, upper = 0.0;
    for (const OuterFace& of : outermost(plan, 0, axes, {2, true}, "step"))
        (q(column::z, of.particle) < 0.5 ? lower : upper) +=
            of.share * 4.0 * q(column::l_x, of.particle) * q(column::l_y, of.particle);
    EXPECT_NEAR(upper, 0.475, 1e-12);
    EXPECT_NEAR(lower, 0.525, 0.001);
}

// A stamp on sand at rest, with a load beside it.
mpm::Case stamp() {
    mpm::Case plan;
    plan.name = "stamp";
    plan.settings.cell_mean = true;
    plan.settings.local_damping = 0.1;
    mpm::SpacePlan& space = plan.space.emplace();
    space.axis[0] = space.axis[1] = axis(0.0, 0.6, 6);
    space.axis[2] = axis(-0.4, 0.3, 7);
    for (const int side : {0, 1, 2, 3, 4}) space.boundary[side] = mpm::Boundary::roller;
    mpm::BodyPlan sand{};
    sand.name = "sand";
    sand.density = 1600.0;
    mpm::SandPlan material{};
    material.parameters = catalogue_parameters("lausitz", 1000.0);
    material.options = options_with_tolerance(1e-3);
    material.void_ratio = 0.65;
    material.intergranular_rho = 1.0;
    material.intergranular_direction[1] = 0.0;
    material.intergranular_direction[2] = -1.0;
    sand.material = material;
    sand.geostatic = mpm::Geostatic{0.0, 2000.0, {}};
    mpm::BodyPlan rigid{};
    rigid.name = "stamp";
    rigid.density = 1000.0;
    rigid.material = mpm::RigidPlan{{{0.0}, {0.0}}, {{0.0, 0.01}, {0.0, -0.5}}};
    plan.bodies = {sand, rigid};
    space.bodies = {{{{mpm::BoxShape{{0.0, 0.0, -0.4}, {0.6, 0.6, 0.0}}}}},
                    {{{mpm::ConeShape{{0.0, 0.0}, {0.0, 0.1}, {0.2, 0.2}}}}}};
    mpm::TractionPlan load;
    load.body = "sand";
    load.stress = mpm::TimeTable{{0.0}, {2000.0}};
    plan.tractions = {load};
    space.faces = {{.range = {{0.2, 1.0}, {0.0, 1.0}, {-0.1, 0.1}}}};
    mpm::ContactPlan contact;
    contact.stiff = "stamp";
    contact.soft = "sand";
    contact.law = GRIT_CONTACT_GEO;
    contact.friction_coefficient = 0.3;
    plan.contacts = {contact};
    mpm::StagePlan stage = plan.plain_stage("press");
    stage.end.time = 0.006;
    plan.stages = {stage};
    plan.history = {"sand", mpm::DepthOf::centre_of_mass, 0.001};
    return plan;
}

std::string saved(mpm::Runner& runner) {
    std::ostringstream out;
    runner.subject().save(out);
    return out.str();
}

TEST(SpaceRun, OfAStampKeepsItsBalanceAndTellsItsForces) {
    mpm::Runner runner(stamp());
    EXPECT_EQ(runner.particles(), 12 * 12 * 8 + 2 * 15);
    const double weight = 0.6 * 0.6 * 0.4 * 1600.0 * 9.81;
    while (!runner.finished()) runner.step();
    EXPECT_EQ(runner.ended(), mpm::Ended::by_time);
    const mpm::HistoryRow row = runner.row();
    EXPECT_LT(row.tip_force, -10.0);
    EXPECT_NEAR(row.hammer_force, 2000.0 * 0.4 * 0.6, 1.0);
    EXPECT_NEAR(row.base_force, weight + 2000.0 * 0.36, 0.3 * weight);
    EXPECT_LT(std::fabs(row.residual_share), 0.02);
    EXPECT_GT(row.energy.rigid_work, 0.0);
}

// ... on a quarter about the axis x = y = 0: along z what its tip and its shaft tell, sideways the same along x and y, and no
// moment about that axis; the other moments are as far from it as pressures below a quarter of a stamp are.
TEST(SpaceRun, TellsForcesAndMomentsOfContactsInSpace) {
    mpm::Case plan = stamp();
    plan.tractions.clear();
    plan.space->faces.clear();
    plan.history.body = "stamp";
    mpm::Runner runner(plan);
    while (!runner.finished()) runner.step();
    const mpm::HistoryRow row = runner.row();
    const double F = row.tip_force + row.shaft_force;
    EXPECT_GT(F, 10.0);
    EXPECT_NEAR(row.contact[2], F, 1e-9 * F);
    EXPECT_NEAR(row.contact[0], row.contact[1], 1e-9 * F);
    EXPECT_NEAR(row.contact[3], -row.contact[4], 1e-9 * F);
    EXPECT_NEAR(row.contact[5], 0.0, 1e-9 * F);
    EXPECT_GT(row.contact[3],
              0.3 * 0.2 * F);  // y F; 4/(3 pi) of the radius where pressure is uniform
    EXPECT_LT(row.contact[3], 0.6 * 0.2 * F);
    // Of the sand they are the opposite.
    plan.history.body = "sand";
    mpm::Runner other(plan);
    while (!other.finished()) other.step();
    const mpm::HistoryRow on_sand = other.row();
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(on_sand.contact[k], -row.contact[k], 1e-9 * F) << k;
}

// A free block above the ground: what a case of rigid bodies that move freely tells.
mpm::Case falling_block() {
    mpm::Case plan;
    plan.name = "fall";
    mpm::SpacePlan& space = plan.space.emplace();
    for (mpm::AxisPlan& of : space.axis) of = axis(0.0, 1.0, 5);
    for (const int side : {0, 1, 2, 3, 4}) space.boundary[side] = mpm::Boundary::roller;
    mpm::BodyPlan soil{};
    soil.name = "soil";
    soil.density = 2000.0;
    soil.material = mpm::ElasticPlan{5e6, 0.3};
    soil.geostatic = mpm::Geostatic{0.4, 0.0, {}};
    mpm::BodyPlan block{};
    block.name = "block";
    block.density = 2000.0;
    mpm::RigidPlan motion{{{0.0}, {0.0}}, {{0.0}, {0.0}}};
    motion.free[2] = true;
    block.material = motion;
    plan.bodies = {soil, block};
    space.bodies = {{{{mpm::BoxShape{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.4}}}}},
                    {{{mpm::BoxShape{{0.3, 0.3, 0.65}, {0.7, 0.7, 0.85}}}}}};
    mpm::ContactPlan contact;
    contact.stiff = "block";
    contact.soft = "soil";
    contact.law = GRIT_CONTACT_GEO;
    plan.contacts = {contact};
    mpm::StagePlan stage = plan.plain_stage("fall");
    stage.end.time = 0.05;
    plan.stages = {stage};
    plan.history = {"block", mpm::DepthOf::centre_of_mass, 0.01};
    return plan;
}
mpm::RigidPlan& motion_of_block(mpm::Case& plan) {
    return std::get<mpm::RigidPlan>(plan.bodies[1].material);
}

TEST(SpaceRun, IsNotAtRestWhileAFreeBodyFalls) {
    mpm::Case plan = falling_block();
    plan.stages[0].end.unbalanced_share = 1e-3;
    mpm::Runner runner(plan);
    while (!runner.finished()) {
        runner.step();
        EXPECT_NEAR(runner.row().unbalanced_share, 1.0, 1e-9);
    }
    EXPECT_EQ(runner.ended(), mpm::Ended::by_time);
    EXPECT_NEAR(runner.row().depth, 0.5 * 9.81 * 0.05 * 0.05, 1e-3);
}

// At rest until then, and then with the velocity that it starts with.
TEST(SpaceRun, HoldsWhatIsFreeUntilItsStageBegins) {
    mpm::Case plan = falling_block();
    motion_of_block(plan).from_stage = "fall";
    plan.space->bodies[1].velocity = {0.0, 0.0, 0.2};
    mpm::StagePlan before = plan.plain_stage("before");
    before.end.time = 0.03;
    plan.stages.insert(plan.stages.begin(), before);
    mpm::Runner runner(plan);
    while (!runner.finished()) {
        runner.step();
        const mpm::HistoryRow row = runner.row();
        if (row.stage == 1) {
            ASSERT_EQ(row.depth, 0.0) << row.t;
        }
    }
    const double t = runner.row().t - 0.03;
    EXPECT_NEAR(runner.row().depth, 0.5 * 9.81 * t * t - 0.2 * t, 1e-3);
}

// What moves a body as it is told works against its loads.
TEST(SpaceRun, KeepsItsBalanceWhereALoadActsAlongWhatIsTold) {
    for (const bool any_free : {true, false}) {
        mpm::Case plan = falling_block();
        motion_of_block(plan).free[2] = any_free;
        motion_of_block(plan).velocity_r = {{0.0}, {0.4}};
        mpm::TractionPlan load;
        load.body = "block";
        load.stress = mpm::TimeTable{{0.0}, {2e4}};
        plan.tractions = {load};
        plan.space->faces = {{.across = 0, .upper = true, .direction = {-1.0, 0.0, 0.0}}};
        mpm::Runner runner(plan);
        while (!runner.finished()) runner.step();
        const mpm::HistoryRow row = runner.row();
        const double work = -2e4 * 0.4 * 0.2 * 0.4 * row.t;
        EXPECT_NEAR(row.energy.traction_work, work, 1e-3 * std::fabs(work));
        EXPECT_NEAR(row.energy.rigid_work, -work, 1e-3 * std::fabs(work));
        EXPECT_LT(std::fabs(row.energy.residual()), 1e-6 * std::fabs(work));
    }
}

TEST(SpaceRun, RefusesRigidBodiesThatAreToldTwiceOrHalvedAndFree) {
    const auto refused = [](const auto& spoil, const char* why) {
        mpm::Case plan = falling_block();
        spoil(plan);
        expect_refused(plan, why);
    };
    refused(
        [](mpm::Case& c) {
            motion_of_block(c).velocity_z = {{0.0}, {-1.0}};
        },
        "body block: the velocity along z is free, and a table tells it");
    refused(
        [](mpm::Case& c) {
            motion_of_block(c).free[4] = true;
            motion_of_block(c).spin[1] = {{0.0}, {-1.0}};
        },
        "body block: the rotation about y is free, and a table tells it");
    refused(
        [](mpm::Case& c) {
            c.space->bodies[1].velocity = {0.0, 0.5, 0.0};
        },
        "body block: the velocity along y at the start is 0.5 m/s");
    const auto at_left = [](mpm::Case& c) {
        c.space->bodies[1] = {{{mpm::BoxShape{{0.0, 0.3, 0.65}, {0.4, 0.7, 0.85}}}}};
    };
    for (const std::size_t degree : {0, 4, 5})
        refused(
            [&](mpm::Case& c) {
                at_left(c);
                motion_of_block(c).free[degree] = true;
            },
            "body block lies at the left side, which is held");
    mpm::Case slides = falling_block();
    at_left(slides);
    motion_of_block(slides).free = {false, true, true, true, false, false};
    EXPECT_NO_THROW(mpm::build_case(slides));
}

TEST(ProfilePlan, SharesWhatActsBetweenTwoHeightsBetweenItsParts) {
    const mpm::ProfilePlan profile{-1.0, 1.0, 4};
    const auto parts_of = [&](double low, double high) {
        std::vector<double> impulses(profile.numbers());
        profile.add(low, high, {0.0, 8.0, 1.0}, impulses);
        std::vector<double> along_y;
        for (std::size_t part = 0; part < 4; ++part) {
            EXPECT_EQ(impulses[3 * part], 0.0);
            EXPECT_EQ(8.0 * impulses[3 * part + 2], impulses[3 * part + 1]);
            along_y.push_back(impulses[3 * part + 1]);
        }
        return along_y;
    };
    using Parts = std::vector<double>;
    EXPECT_EQ(parts_of(-0.25, 0.75), (Parts{0.0, 2.0, 4.0, 2.0}));
    EXPECT_EQ(parts_of(-1.5, -0.5), (Parts{4.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(parts_of(-3.0, 5.0), Parts(4, 0.5));
    EXPECT_EQ(parts_of(0.5, 0.5), (Parts{0.0, 0.0, 0.0, 8.0}));
    EXPECT_EQ(parts_of(1.0, 2.0), Parts(4));
    const mpm::ProfilePlan thin{0.0, 1e-300, 1000};
    std::vector<double> impulses(thin.numbers());
    thin.add(-1.0, 1.0, {1.0, 0.0, 0.0}, impulses);
    for (const double each : impulses) EXPECT_LT(each, 1e-300);
    EXPECT_EQ(parts_of(-2.0, -1.0), Parts(4));
}

// A stamp as above, pressed down: all of it about its lower face, at nodes from a cell below it on, and as much as contacts
// tell.
TEST(SpaceRun, TellsForcesOfContactsByHeight) {
    for (const bool at_surfaces : {false, true}) {
        mpm::Case plan = stamp();
        plan.contacts[0].at_surfaces = at_surfaces;
        plan.history.body = "stamp";
        plan.history.profile = {-0.3, 0.3, 6};
        mpm::Runner all(plan), first(plan), second(plan);
        while (!all.finished()) all.step();
        const mpm::HistoryRow row = all.row();
        ASSERT_EQ(row.profile.size(), 18U);
        for (std::size_t k = 0; k < 3; ++k) {
            double sum = 0.0;
            for (std::size_t part = 0; part < 6; ++part) sum += row.profile[3 * part + k];
            EXPECT_NEAR(sum, row.contact[k], 1e-9 * row.contact[2]) << k;
        }
        EXPECT_NEAR((at_surfaces ? 0.0 : row.profile[5]) + row.profile[8] + row.profile[11],
                    row.contact[2], 1e-9 * row.contact[2]);
        EXPECT_EQ(row.profile[17], 0.0);
        EXPECT_EQ(all.state().profile, std::vector<double>(18));  // since that row
        // What has not been told goes on.
        for (int i = 0; i < 6; ++i) first.step();
        std::istringstream in(saved(first));
        second.resume(first.state());
        second.subject().restore(in, mpm::OtherBits::refused);
        while (!second.finished()) second.step();
        EXPECT_EQ(second.row().profile, row.profile);
    }
}

TEST(SpaceRun, GoesOnFromACheckpointWithTheBitsOfOneThatNeverStopped) {
    for (const int kind : {0, 1, 2}) {
        mpm::Case plan = stamp();
        plan.settings.fixed_point = kind > 0;
        plan.contacts[0].at_surfaces = kind == 2;
        mpm::Runner all(plan), first(plan), second(plan);
        for (int i = 0; i < 12; ++i) all.step();
        for (int i = 0; i < 6; ++i) first.step();
        std::istringstream in(saved(first));
        second.resume(first.state());
        second.subject().restore(in, mpm::OtherBits::refused);
        for (int i = 0; i < 6; ++i) second.step();
        EXPECT_TRUE(saved(second) == saved(all));
        EXPECT_EQ(second.row().tip_force, all.row().tip_force);
    }
}

TEST(SpaceRun, SweepsPressuresAsFarAsTheCaseSays) {
    long sweeps[2];
    for (const bool fine : {false, true}) {
        mpm::Case plan = stamp();
        plan.contacts[0].at_surfaces = true;
        plan.contacts[0].sweep_tolerance = fine ? 1e-13 : 1e-2;
        mpm::Runner run(plan);
        for (int i = 0; i < 5; ++i) run.step();
        sweeps[fine] = run.space()->surface_contact(0).sweeps().all;
    }
    EXPECT_GT(sweeps[0], 0);
    EXPECT_GT(sweeps[1], 2 * sweeps[0]);
}

TEST(SpaceRun, RefusesTheCheckpointOfAnotherCase) {
    struct Pair {
        mpm::Case of, other;
        const char* what;
    };
    mpm::Case rough = stamp(), freed = stamp(), surface = stamp(), finer = stamp();
    for (mpm::Case* plan : {&surface, &finer}) plan->contacts[0].at_surfaces = true;
    finer.contacts[0].sweep_tolerance = 1e-9;
    rough.contacts[0].friction_coefficient = 0.4;
    mpm::RigidPlan& motion = std::get<mpm::RigidPlan>(freed.bodies[1].material);
    motion.free[2] = true;
    motion.velocity_z = {{0.0}, {0.0}};
    for (const auto& [of, other, what] :
         {Pair{stamp(), rough, "friction coefficient"}, Pair{stamp(), freed, "free"},
          Pair{surface, finer, "sweeps to"}}) {
        mpm::Runner one(of), another(other);
        std::istringstream in(saved(one));
        try {
            another.subject().restore(in, mpm::OtherBits::refused);
            ADD_FAILURE() << what;
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
        }
    }
}

}  // namespace
