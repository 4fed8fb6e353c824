// SPDX-License-Identifier: BSD-3-Clause
// Bodies that meet, slide and rest on each other, in the driver.
#include "support/cylinders.hpp"
#include "support/meeting_bodies.hpp"
#include "support/pressed_blocks.hpp"
#include "support/punch.hpp"

namespace {

using namespace mpm_test;

TEST(BlockOnASlope, RestsBelowTheFrictionAngleAndSlidesAboveIt) {
    const auto slide_with = [](double angle, double mu, int law) {
        const auto simulation = block_on_slope(angle);
        simulation->add_contact(contact_law(law, mu));
        return slide(*simulation);
    };
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL}) {
        EXPECT_NEAR(slide_with(0.3, 0.5, law).way, 0.0, 0.01);
        const Slide sliding = slide_with(0.7, 0.3, law);
        const double expected = std::sin(0.7) - 0.3 * std::cos(0.7);
        EXPECT_NEAR(sliding.way, expected, 0.02 * expected);
        EXPECT_NEAR(sliding.residual, 0.0, 0.01);
    }
}

TEST(TwoBars, TouchWhenTheGapIsClosedPressWithTheirImpedanceAndPartAfterTheWave) {
    for (const double offset : {0.0, 0.4}) {
        const MeetingBars bars{2.5 * MeetingBars::h, offset};
        const auto simulation = bars.build();
        simulation->add_contact(contact_law(GRIT_CONTACT_GEO, 0.0));
        const Meeting seen = meet(bars, *simulation, [&] {
            const grit_contact_totals& totals = simulation->contact(0).totals();
            return grit::Vector2{totals.force_on_a[1], totals.force_on_b[1]};
        });
        EXPECT_NEAR(seen.gap_at_touch, 0.0, 0.05);
        EXPECT_NEAR(seen.force, 1.0, 0.02);
        EXPECT_NEAR(seen.duration, 1.0, 0.05);
        EXPECT_NEAR(seen.impulse, 1.0, 0.05);
        EXPECT_NEAR(seen.residual, 0.0, 0.01);
        EXPECT_GT(simulation->energy().contact, 0.0);
    }
}

// (C9): published, they creep into each other, in each step by as much.
TEST(BlocksOnSprings, RestWhateverTheStep) {
    PressedBlocks blocks;
    blocks.kind = ContactKind::geo_spring;
    blocks.offset = 0.3;
    const double overlap = blocks.run().overlap;
    EXPECT_GT(overlap, 0.001);
    blocks.end = 2.0;
    EXPECT_NEAR(blocks.run().overlap, overlap, 1e-3 * overlap);
    blocks.end = 1.0;
    blocks.cfl = 0.1;
    EXPECT_NEAR(blocks.run().overlap, overlap, 0.03 * overlap);
}

// A node beyond a body that is thinner than a cell has both on one side, and sees no surface between them: springs there
// threw them apart.
TEST(BlocksOnSprings, ThinnerThanACellStayWhereTheyTouch) {
    constexpr double h = 0.1, E = 1e6;
    for (const int normal :
         {GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B, GRIT_CONTACT_NORMAL_AVERAGE}) {
        Simulation simulation(Axis::uniform(0.0, 0.8, 8), Axis::uniform(0.0, 0.8, 8),
                              {.axisymmetric = false});
        simulation.add_body(make_box({0.25, 0.55, 0.31, 0.36, 6, 2, 1000.0}, false,
                                     std::make_unique<LinearElastic>(E, 0.0)));
        simulation.add_body(make_box({0.25, 0.55, 0.36, 0.42, 6, 2, 1000.0}, false,
                                     std::make_unique<LinearElastic>(E, 0.0)));
        ContactLaw law = contact_law(GRIT_CONTACT_GEO, 0.0);
        law.gated = true;
        law.normal = normal;
        law.options.contact_stiffness = contact_stiffness(1.0, E, h);
        simulation.add_contact(law);
        for (int i = 0; i < 40; ++i) simulation.step();
        EXPECT_LT(simulation.energy().kinetic, 1e-20 * E * h * h) << normal;
    }
}

// Around the punch's edge the soil is hollow: the gap along the diagonal there is no overlap to push against, which
// made the punch 1.9 times as stiff. 11.10 MN/m by finite elements: contact_study punch.
TEST(PunchOnSprings, IsNearerToTheElasticOneTheStifferTheyAre) {
    const auto error = [](ContactKind kind) {
        Punch punch;
        punch.kind = kind;
        return punch.stiffness() / 11.10e6 - 1.0;
    };
    const double published = error(ContactKind::geo), spring = error(ContactKind::geo_spring);
    const double stiffer = error(ContactKind::geo_spring_10);
    EXPECT_LT(published, spring);
    EXPECT_LT(spring, stiffer);
    EXPECT_LT(stiffer, 0.0);
}

// Beside the edge normals are diagonal: the gap is closed no earlier there.
TEST(TwoCylinders, TouchWhenTheirGapIsClosedWhereverTheirSideIs) {
    for (const ContactKind kind : {ContactKind::geo, ContactKind::frictional})
        for (const double radius : {0.2, 0.205, 0.2125, 0.22})
            for (const double offset : {0.0, 0.3, 0.5, 0.8}) {
                Cylinders cylinders;
                cylinders.kind = kind;
                cylinders.radius = radius;
                cylinders.offset = offset;
                const Cylinders::Result seen = cylinders.run();
                EXPECT_NEAR(seen.first, Cylinders::gap / Cylinders::closing, 1e-3)
                    << name_of(kind) << ", radius " << radius << ", offset " << offset;
                EXPECT_NEAR(seen.momentum, 0.0, 1e-12);
            }
}

// A wall reaches into the cells of a strip that is one cell wide: at the nodes of the roller behind it the wall can press
// on nothing, and the ends of the strip are no surface that it meets.
TEST(Wall, DoesNotHoldWhatSlidesBetweenItAndARoller) {
    constexpr double h = 0.1, wide = 0.999 * h, speed = 0.1;
    for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL})
        for (const bool gated : {false, true}) {
            Simulation simulation(Axis::uniform(0.0, 3.0 * h, 3), Axis::uniform(0.0, 1.0, 10),
                                  {.axisymmetric = false, .cfl = 0.4});
            Body wall = make_box({wide, 2.5 * h, 0.0, 1.0, 2, 10, 1000.0}, false, nullptr);
            wall.prescribed_velocity = [](double) { return grit::Vector2{0.0, 0.0}; };
            simulation.add_body(std::move(wall));
            simulation.add_body(make_box({0.0, wide, 0.3, 0.7, 1, 4, 1000.0}, false,
                                         std::make_unique<LinearElastic>(1e6, 0.0)));
            simulation.fix_below(0, 0.0);
            ContactLaw contact = contact_law(law, 0.0);
            contact.gated = gated;
            simulation.add_contact(contact);
            const ParticleView q = simulation.body(1).particles.view();
            for (std::ptrdiff_t p = 0; p < 4; ++p) q[column::v_z][p] = speed;
            while (simulation.time() < 0.1) simulation.step();
            double sum = 0.0;
            for (std::ptrdiff_t p = 0; p < 4; ++p)
                sum += simulation.body(1).particles.view()[column::v_z][p];
            EXPECT_NEAR(sum / 4.0, speed, 1e-9) << law << ", " << gated;
        }
}

}  // namespace
