// SPDX-License-Identifier: BSD-3-Clause
// A particle of sand in space against the element test of the same deformation.
#include <gtest/gtest.h>

#include <cmath>

#include <element/grit_law.hpp>
#include <element/simulate.hpp>

#include <adapters/mpm/space/kernel/sand.hpp>

#include "../catalogue.hpp"
#include "support/bricks.hpp"

namespace {

using namespace space_test;

// Sheared along all directions, strained and turned, there and back.
element::Program shaken() {
    element::Program out;
    element::DeformationGradient there, back;
    there.F << 0.99, 0.04, -0.02, 0.01, 1.005, 0.03, 0.015, -0.02, 0.985;
    back.F = there.F.inverse();
    for (element::DeformationGradient* each : {&there, &back}) {
        each->path = element::DeformationGradient::Path::linear;
        each->increments = element::DeformationGradient::Increments::hughes_winget;
        element::Step step;
        step.kind = *each;
        step.increments = 200;
        out.push_back(step);
    }
    return out;
}

TEST(SpaceSand, OfAParticleIsThatOfTheElementTestUnderAnyDeformation) {
    const grit_sand_parameters parameters = catalogue_parameters("lausitz", 1000.0);
    element::GritLawOptions options;
    options.tolerance = 1e-8;
    const element::GritLaw law(parameters, options);
    element::Sample sample;
    element::Vector6 stress;
    stress << -1e5, -0.5e5, -0.7e5, 0.0, 0.0, 0.0;
    sample.point = law.start(stress, 0.65);
    const element::Program program = shaken();
    const element::History test = element::simulate(law, sample, program);
    ASSERT_FALSE(test.failure) << test.failure->message;

    Sand sand(catalogue_sand("lausitz", 1000.0), options_with_tolerance(1e-8));
    Particles particles(sand.own_columns());
    particles.add({{0.1, -0.2, 0.05}, {0.2, 0.25, 0.3}, 1600.0});
    const ParticleView q = particles.view();
    for (int k = 0; k < 3; ++k) q[column::S_xx + k][0] = stress[k];
    q[Sand::state + GRIT_SAND_VOID_RATIO][0] = 0.65;
    const Axis axis = Axis::uniform(-1.5, 1.5, 3);
    const GridView grid{{axis.view(), axis.view(), axis.view()}};
    std::vector<NodeMotion> nodes(64);
    Increments increments;
    GatherSums sums;
    std::size_t record_of = 0;
    double worst = 0.0, turned = 0.0;
    for (const element::Step& step : program) {
        const auto& F = std::get<element::DeformationGradient>(step.kind).F;
        for (int i = 1; i <= step.increments; ++i) {
            const auto at = [&](int k) -> element::Matrix3 {
                const element::Matrix3 one = element::Matrix3::Identity();
                return one + (static_cast<double>(k) / step.increments) * (F - one);
            };
            const element::Matrix3 L = at(i) * at(i - 1).inverse() - element::Matrix3::Identity();
            for (int node = 0; node < 64; ++node) {
                const int place[3] = {node % 4, node / 4 % 4, node / 16};
                for (int a = 0; a < 3; ++a) {
                    nodes[static_cast<std::size_t>(node)][motion::v_x + a] = 0.0;
                    for (int b = 0; b < 3; ++b)
                        nodes[static_cast<std::size_t>(node)][motion::v_x + a] +=
                            L(a, b) * axis[place[b]];
                }
            }
            kernels().gather(Shape::cpdi, {grid, q, 0, 1, nodes.data(), 1.0, 0.0}, increments,
                             sums);
            sand.update({q, 0, 1}, increments);
            turned += std::fabs(increments.rotation[1][0]);
            const element::Record& wanted = test.records[++record_of];
            for (int k = 0; k < 6; ++k)
                worst = std::fmax(worst,
                                  std::fabs(q[column::S_xx + k][0] - wanted.effective_stress[k]));
        }
    }
    EXPECT_LT(worst, 1e-6 * 1e5);
    EXPECT_GT(turned, 0.01);
    EXPECT_GT(std::fabs(q[column::S_xy][0]), 1e3);
    EXPECT_NEAR(q[Sand::state + GRIT_SAND_VOID_RATIO][0], sample.point.state[GRIT_SAND_VOID_RATIO],
                1e-7);
    EXPECT_NEAR(q.J(0), 1.0, 1e-3);
}

}  // namespace
