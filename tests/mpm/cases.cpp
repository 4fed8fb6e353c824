// SPDX-License-Identifier: BSD-3-Clause
// Plain descriptions that become grids, particles and loads.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <adapters/mpm/case/build_case.hpp>
#include <adapters/mpm/case/fill.hpp>
#include <adapters/mpm/case/initial_state.hpp>
#include <adapters/mpm/kernel/sand.hpp>
#include <grit/sand_catalogue.h>
#include <grit/sand_operators.h>

#include "support/plans.hpp"

namespace {

using namespace mpm_test;

double volume(Particles& particles) {
    double sum = 0.0;
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) sum += particles.view()[column::V0][p];
    return sum;
}

TEST(GradedAxis, FillsItsSegmentsWithCellsThatGrow) {
    const AxisPlan plan{-1.0, {{1.0, cells_for(2.0, 0.1, 1.2), 1.2}, {2.0, 5, 1.0}}};
    const Axis axis = make_axis(plan);
    const int first = plan.segments[0].cells;
    EXPECT_EQ(axis.cells(), first + 5);
    EXPECT_EQ(axis[0], -1.0);
    EXPECT_EQ(axis[first], 1.0);
    EXPECT_EQ(axis[first + 5], 2.0);
    EXPECT_NEAR(axis[1] - axis[0], 0.1, 0.01);
    for (int i = 1; i < first; ++i)
        EXPECT_NEAR((axis[i + 1] - axis[i]) / (axis[i] - axis[i - 1]), 1.2, 1e-9);
    for (int i = first; i < first + 5; ++i) EXPECT_NEAR(axis[i + 1] - axis[i], 0.2, 1e-12);
}

TEST(GradedAxis, TakesTheSmallestCellFromTheEndThatItShrinksTo) {
    const int cells = cells_for(2.0, 0.1, 1.0 / 1.2);
    EXPECT_EQ(cells, cells_for(2.0, 0.1, 1.2));
    const Axis axis = make_axis({0.0, {{2.0, cells, 1.0 / 1.2}}});
    EXPECT_NEAR(axis[cells] - axis[cells - 1], 0.1, 0.01);
}

TEST(Boxes, AreFilledExactlyWhereverTheGridLinesAre) {
    const Axis r = make_axis({0.0, {{1.0, 7, 1.1}}}), z = make_axis({0.0, {{1.0, 9, 0.9}}});
    BodyPlan body = elastic_box("body", 0.13, 0.77, 0.21, 0.86);
    Particles particles = fill(body, r, z, true, 0);
    EXPECT_NEAR(volume(particles), 0.5 * (0.77 * 0.77 - 0.13 * 0.13) * (0.86 - 0.21), 1e-14);
    const ParticleView q = particles.view();
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const int i = r.view().cell_of(q[column::r][p]), j = z.view().cell_of(q[column::z][p]);
        EXPECT_GE(q[column::r][p] - q[column::l_r][p], r[i] - 1e-12);
        EXPECT_LE(q[column::r][p] + q[column::l_r][p], r[i + 1] + 1e-12);
        EXPECT_LE(q[column::z][p] + q[column::l_z][p], z[j + 1] + 1e-12);
    }
}

TEST(Boxes, MayBeFinerThanTheirBody) {
    const Axis r = make_axis({0.0, {{1.0, 5, 1.0}}}), z = make_axis({0.0, {{1.0, 5, 1.0}}});
    BodyPlan body = elastic_box("body", 0.0, 0.4, 0.0, 1.0);
    body.particles_r = body.particles_z = 1;
    body.outlines[0].particles_r = 3;
    body.outlines[0].particles_z = 2;
    body.outlines.push_back(elastic_box("", 0.4, 1.0, 0.0, 1.0).outlines[0]);
    Particles particles = fill(body, r, z, true, 0);
    EXPECT_EQ(particles.size(), 2 * 5 * 3 * 2 + 3 * 5);
    EXPECT_NEAR(volume(particles), 0.5, 1e-14);
}

TEST(Boxes, ThatShareAPlaceFillItOnce) {
    const Axis r = make_axis({0.0, {{1.0, 10, 1.0}}});
    const Axis& z = r;
    BodyPlan body = elastic_box("body", 0.0, 0.6, 0.0, 0.6);
    body.outlines.push_back(elastic_box("", 0.4, 1.0, 0.4, 1.0).outlines[0]);
    Particles particles = fill(body, r, z, false, 0);
    EXPECT_NEAR(volume(particles), 0.36 + 0.36 - 0.04, 1e-12);
}

TEST(Polygons, HaveTheParticlesWhoseCentresAreInside) {
    const Axis r = make_axis({0.0, {{1.0, 50, 1.0}}});
    const Axis& z = r;
    BodyPlan body = elastic_box("body", 0.0, 1.0, 0.0, 1.0);
    body.outlines = {Outline{{{0.1, 0.1}, {0.9, 0.1}, {0.5, 0.8}}}};
    Particles particles = fill(body, r, z, false, 0);
    EXPECT_NEAR(volume(particles), 0.5 * 0.8 * 0.7, 0.01 * 0.28);
    const ParticleView q = particles.view();
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const double x = std::abs(q[column::r][p] - 0.5), y = q[column::z][p];
        EXPECT_TRUE(y > 0.1 && y < 0.8 - x * 0.7 / 0.4);
    }
}

TEST(OutermostEdges, AreThoseThatNoParticleCovers) {
    const Axis r = make_axis({0.0, {{1.0, 10, 1.0}}});
    const Axis& z = r;
    BodyPlan body = elastic_box("step", 0.0, 1.0, 0.0, 0.4);
    body.outlines.push_back(elastic_box("", 0.0, 0.3, 0.4, 0.7).outlines[0]);
    Particles particles = fill(body, r, z, false, 0);
    TractionPlan traction{"step", Edge::top};
    double length = 0.0, high = 0.0;
    for (const int id : outermost(particles, r, z, traction)) {
        const double l = 2.0 * particles(column::l_r, id), y = particles(column::z, id);
        length += l;
        if (y > 0.4) high += l;
        EXPECT_TRUE(y > 0.65 || (y > 0.35 && y < 0.4)) << y;
    }
    EXPECT_NEAR(length, 1.0, 1e-12);
    EXPECT_NEAR(high, 0.3, 1e-12);
    traction.edge = Edge::right;
    traction.z[0] = 0.4;
    double height = 0.0;
    for (const int id : outermost(particles, r, z, traction))
        height += 2.0 * particles(column::l_z, id);
    EXPECT_NEAR(height, 0.3, 1e-12);
    traction.z[0] = 0.9;
    EXPECT_THROW(outermost(particles, r, z, traction), std::invalid_argument);
}

TEST(Bodies, MayTouchButNotShareAPlace) {
    const Axis r = make_axis({0.0, {{1.0, 10, 1.0}}});
    const Axis& z = r;
    Particles soil = fill(elastic_box("soil", 0.0, 1.0, 0.0, 0.5), r, z, true, 0);
    Particles above = fill(elastic_box("pile", 0.0, 0.2, 0.5, 0.9), r, z, true, 0);
    Particles inside = fill(elastic_box("pile", 0.11, 0.14, 0.4, 0.9), r, z, true, 0);
    EXPECT_NO_THROW(check_apart(soil, above, r, z, ""));
    EXPECT_NO_THROW(check_apart(above, soil, r, z, ""));
    EXPECT_THROW(check_apart(inside, soil, r, z, ""), std::invalid_argument);
}

TEST(Boxes, OfTwoBodiesMayTouchButNotReachIntoEachOther) {
    const BodyPlan soil = elastic_box("soil", 0.0, 1.0, 0.0, 0.1 + 0.2);
    EXPECT_NO_THROW(check_boxes_apart(soil, elastic_box("plate", 0.0, 1.0, 0.3, 0.325)));
    EXPECT_NO_THROW(check_boxes_apart(soil, elastic_box("plate", 1.0, 1.1, 0.0, 0.325)));
    for (const BodyPlan& plate :
         {elastic_box("plate", 0.2, 0.5, 0.29, 0.315), elastic_box("plate", 0.999, 1.2, 0.1, 0.2),
          elastic_box("plate", 0.2, 0.5, 0.1, 0.101)})
        EXPECT_THROW(check_boxes_apart(soil, plate), std::invalid_argument);
    BodyPlan cone = elastic_box("cone", 0.0, 0.0, 0.0, 0.0);
    cone.outlines = {Outline{{{0.0, 0.299}, {0.1, 0.4}, {0.0, 0.4}}}};  // by particles
    EXPECT_NO_THROW(check_boxes_apart(soil, cone));

    // Ten of the plate's 25 mm, and no centre of either body within the other.
    Case plan = column_case();
    plan.bodies = {elastic_box("column", 0.0, 0.2, 0.0, 0.98),
                   elastic_box("plate", 0.0, 0.2, 0.97, 0.995)};
    try {
        build_case(plan);
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "bodies column and plate share the place from (0.000000, 0.970000) "
                     "to (0.200000, 0.980000) m");
    }
    plan.bodies[1] = elastic_box("plate", 0.0, 0.2, 0.98, 1.005);
    EXPECT_NO_THROW(build_case(plan));
}

// Each of its numbers, for a restart with others would go on as if nothing were.
TEST(Materials, SayInTheirWordsWhatTheyAreMadeOf) {
    const auto words = [](const MaterialPlan& plan) {
        BodyPlan body = elastic_box("body", 0.0, 1.0, 0.0, 1.0);
        body.material = plan;
        return make_material(body)->words();
    };
    const auto elastic = words(ElasticPlan{1e6, 0.3});
    EXPECT_EQ(elastic, words(ElasticPlan{1e6, 0.3}));
    EXPECT_NE(elastic, words(ElasticPlan{1e6 * (1.0 + 1e-12), 0.3}));
    EXPECT_NE(elastic, words(ElasticPlan{1e6, 0.31}));
    EXPECT_NE(elastic, words(ElasticPlan{1e6, 0.3, true}));
    const SandPlan lausitz = lausitz_plan(0.7);
    const auto sand = words(lausitz);
    EXPECT_EQ(sand, words(lausitz));
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        SandPlan other = lausitz;
        double value = 0.0;
        grit_sand_parameter_get(&other.parameters, i, &value);
        grit_sand_parameter_set(&other.parameters, i, value == 0.0 ? 1.0 : value * (1.0 + 1e-12));
        const std::string name = grit_sand_parameter_describe(i)->name;
        const auto changed = words(other);
        ASSERT_EQ(changed.size(), sand.size());
        for (std::size_t k = 0; k < sand.size(); ++k)
            EXPECT_EQ(changed[k] != sand[k], sand[k].starts_with(name + " ")) << sand[k];
    }
    SandPlan other = lausitz;
    other.options.tolerance = 1e-4;
    EXPECT_NE(sand, words(other));
    other = lausitz;
    other.options.intergranular_off = 1;
    EXPECT_NE(sand, words(other));
}

TEST(TimeTable, IsLinearBetweenItsPointsAndConstantBeyond) {
    const TimeTable table{{1.0, 2.0, 4.0}, {10.0, 20.0, 0.0}};
    EXPECT_EQ(table.at(0.0), 10.0);
    EXPECT_EQ(table.at(1.5), 15.0);
    EXPECT_EQ(table.at(3.0), 10.0);
    EXPECT_EQ(table.at(9.0), 0.0);
}

TEST(PulseTrain, HasItsPeakInEachIntervalAndNothingBetween) {
    PulseTrain train{1000.0, PulseForm::half_sine, 0.1, 0.05, 0.5, 0.2, 2};
    EXPECT_EQ(train.at(0.1), 0.0);
    EXPECT_EQ(train.blow(0.1), 0);
    for (const int blow : {1, 2}) {
        const double begin = 0.2 + 0.5 * (blow - 1);
        EXPECT_EQ(train.blow(begin + 0.01), blow);
        EXPECT_NEAR(train.at(begin + 0.05), 1000.0, 1e-9);
        EXPECT_NEAR(train.at(begin + 0.025), 1000.0 / std::sqrt(2.0), 1e-9);
        EXPECT_EQ(train.at(begin + 0.2), 0.0);
    }
    EXPECT_EQ(train.blow(9.0), 2);
    EXPECT_EQ(train.at(1.25), 0.0);
    train.form = PulseForm::triangle;
    train.peak_time = 0.02;
    EXPECT_NEAR(train.at(0.21), 500.0, 1e-9);
    EXPECT_NEAR(train.at(0.22), 1000.0, 1e-9);
    EXPECT_NEAR(train.at(0.26), 500.0, 1e-9);
}

TEST(Sand, StartsAtRestWithTheVoidRatioOfItsPressure) {
    const Axis r = make_axis({0.0, {{0.5, 5, 1.0}}}), z = make_axis({-2.0, {{0.0, 20, 1.0}}});
    BodyPlan body = elastic_box("sand", 0.0, 0.5, -2.0, 0.0);
    SandPlan sand = lausitz_plan(0.7);
    sand.at_zero_pressure = true;
    sand.intergranular_rho = 1.0;
    body.material = sand;
    body.geostatic = Geostatic{0.5, 2000.0, std::nullopt};
    body.density = 1700.0;
    Particles particles = fill(body, r, z, true, make_material(body)->own_columns());
    set_initial_state(body, 10.0, particles);
    const ParticleView q = particles.view();
    const double K0 = 1.0 - std::sin(sand.parameters.critical_friction_angle);
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const double vertical = 17000.0 * (0.5 - q[column::z][p]) + 2000.0;
        EXPECT_NEAR(q[column::S_zz][p], -vertical, 1e-9 * vertical);
        EXPECT_NEAR(q[column::S_rr][p], -K0 * vertical, 1e-9 * vertical);
        EXPECT_EQ(q[column::S_tt][p], q[column::S_rr][p]);
        EXPECT_EQ(q[column::S_rz][p], 0.0);
        const double sum = (1.0 + 2.0 * K0) * vertical;  // 3 p
        const double e = 0.7 * std::exp(-std::pow(sum / sand.parameters.granulate_hardness,
                                                  sand.parameters.stiffness_exponent));
        EXPECT_NEAR(q[Sand::state + GRIT_SAND_VOID_RATIO][p], e, 1e-9);
        EXPECT_NEAR(q[Sand::state + GRIT_SAND_H22][p], -sand.parameters.elastic_strain_radius,
                    1e-12);
        EXPECT_EQ(q[Sand::state + GRIT_SAND_H11][p], 0.0);
    }
}

TEST(ElasticBodies, StartWithTheStressThatNoLateralStrainGives) {
    const Axis r = make_axis({0.0, {{0.5, 5, 1.0}}}), z = make_axis({-1.0, {{0.0, 10, 1.0}}});
    BodyPlan body = elastic_box("rock", 0.0, 0.5, -1.0, 0.0);
    body.geostatic = Geostatic{0.0, 0.0};
    Particles particles = fill(body, r, z, true, 0);
    set_initial_state(body, 10.0, particles);
    const ParticleView q = particles.view();
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        EXPECT_NEAR(q[column::S_zz][p], 1e4 * q[column::z][p], 1e-9);
        EXPECT_NEAR(q[column::S_rr][p], 1e4 * q[column::z][p] * 0.3 / 0.7, 1e-9);
    }
    body.material = RigidPlan{};
    EXPECT_THROW(set_initial_state(body, 10.0, particles), std::invalid_argument);
}

}  // namespace
