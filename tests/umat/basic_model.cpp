// SPDX-License-Identifier: BSD-3-Clause
// Switching the intergranular strain off, and increments of nothing.
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

Sand without_memory(const Sand& sand) {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        double value = 0.0;
        grit_sand_parameter_get(&sand.p, i, &value);
        if (grit_sand_parameter_describe(i)->optional != 2) grit_sand_parameter_set(&p, i, value);
    }
    return prepared(sand.name, p);
}

TEST(BasicModel, IntergranularStrainSwitchedOffIsBitwiseAMaterialWithoutIt) {
    for (const Sand& sand : four_sands()) {
        const Sand basic = without_memory(sand);
        Random random(15);
        for (int i = 0; i < 100; ++i) {
            const Point start = point_of(random_state(sand, random));
            const Voigt dE = voigt_strain(random.log_uniform(1e-7, 3e-3) * random.direction());
            const int tangent = i % 3;
            grit_sand_options off = options_with(1e-5, tangent);
            off.intergranular_off = 1;
            Point switched = start, plain = start;
            const Outcome a = update(sand, switched, dE.data(), off);
            const Outcome b = update(basic, plain, dE.data(), options_with(1e-5, tangent));
            ASSERT_EQ(a.status, b.status);
            EXPECT_TRUE(same_bits(switched, plain)) << sand.name;
            EXPECT_EQ(std::memcmp(a.tangent, b.tangent, sizeof a.tangent), 0) << sand.name;
            EXPECT_EQ(std::memcmp(switched.state, start.state, 6 * sizeof(double)), 0)
                << "h is left alone";
            EXPECT_NE(std::memcmp(switched.stress, start.stress, sizeof start.stress), 0);
        }
    }
}

TEST(BasicModel, UnitStiffnessFactorsAreNotTheBasicModel) {
    for (const Sand& sand : four_sands()) {
        grit_sand_parameters p = sand.p;
        p.reversal_stiffness = p.transverse_stiffness = 1.0;
        const Sand unit = prepared(sand.name, p);
        Random random(151);
        State x = random_state(sand, random);
        x.h.setZero();
        const Vec D = random.direction();
        const double elastic = (stiffness_L(unit, x.T, x.e) * D).norm();
        EXPECT_GE((rate(unit, x, D).T - basic_rate(unit, x, D).T).norm(), 0.1 * elastic);
    }
}

TEST(ZeroIncrement, ChangesNoBit) {
    const double nothing[6] = {0.0, -0.0, 0.0, 0.0, 0.0, 0.0};
    for (const Sand& sand : four_sands()) {
        Random random(152);
        for (int i = 0; i < 50; ++i) {
            const Point start = point_of(random_state(sand, random));
            for (const int off : {0, 1})
                for (const int tangent : {0, 1, 2}) {
                    grit_sand_options options = options_with(1e-5, tangent);
                    options.intergranular_off = off;
                    Point point = start;
                    const Outcome out = update(sand, point, nothing, options);
                    EXPECT_EQ(out.status, GRIT_OK);
                    EXPECT_EQ(out.report.evaluations, 0);
                    EXPECT_TRUE(same_bits(point, start)) << sand.name;
                }
        }
    }
}

// [rho^chi m_T + (1 - rho^chi) m_R] L
TEST(ZeroIncrement, HasTheTangentBetweenReversalAndTransverseStiffness) {
    const double nothing[6] = {};
    for (const Sand& sand : four_sands()) {
        Random random(153);
        for (int i = 0; i < 50; ++i) {
            const State x = random_state(sand, random);
            const double rho = x.h.norm() / sand.p.elastic_strain_radius;
            const double w = std::pow(rho, sand.p.stiffness_interpolation_exponent);
            const Mat expected =
                (w * sand.p.transverse_stiffness + (1.0 - w) * sand.p.reversal_stiffness) *
                stiffness_L(sand, x.T, x.e);
            for (const int tangent : {GRIT_TANGENT_CONTINUUM, GRIT_TANGENT_CONSISTENT}) {
                Point point = point_of(x);
                const Outcome out = update(sand, point, nothing, options_with(1e-5, tangent));
                EXPECT_LE((stiffness_from(out.tangent) - expected).norm(), 1e-12 * expected.norm());
            }
        }
    }
}

}  // namespace
