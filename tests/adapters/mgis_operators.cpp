// SPDX-License-Identifier: BSD-3-Clause
// What K[0] asks for is what comes back: operators, predictions, the speed of sound.
#include <grit/grit.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../catalogue.hpp"
#include "support/mgis_point.hpp"

namespace {

using namespace mgis_host;

double factor(int c) { return c < 3 ? 1.0 : sqrt_2; }

// The library's own answer, with as many components as the hypothesis has.
struct LibraryPoint {
    double stress[6] = {-100, -100, -100, 0, 0, 0};
    double state[GRIT_SAND_STATE_SIZE] = {0, 0, 0, 0, 0, 0, 0.6, 0};
    double tangent[36] = {};

    LibraryPoint(int components, int kind, double share = 1.0) {
        double d[6] = {};
        for (int c = 0; c < components; ++c) d[c] = share * general_strain[c] * factor(c);
        grit_sand_options options;
        grit_sand_options_init(&options, sizeof options);
        options.tangent = kind;
        grit_sand_points q{};
        q.struct_size = sizeof q;
        q.strain_increment = grit_view_of(d, 6, 1);
        q.stress = grit_mutable_view_of(stress, 6, 1);
        q.state = grit_mutable_view_of(state, GRIT_SAND_STATE_SIZE, 1);
        q.tangent = grit_mutable_matrix_view_of(tangent, 36, 6, 1);
        const grit_sand sand = catalogue_sand("lausitz", 1.0);
        EXPECT_EQ(grit_sand_update(&sand, &options, 1, &q, nullptr, nullptr), GRIT_OK);
    }
};

void expect_operator(const Point& p, const double C[36]) {
    const int n = p.components();
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c)
            EXPECT_NEAR(p.K[r * n + c], C[6 * r + c] * factor(r) * factor(c), 1e-7)
                << p.behaviour.hypothesis << " " << r << " " << c;
    EXPECT_TRUE(p.in_bounds());
}

void expect_end(const Point& p, const LibraryPoint& library) {
    for (int c = 0; c < p.components(); ++c) {
        EXPECT_NEAR(p.stress1[c], library.stress[c] * factor(c), 1e-10) << c;
        EXPECT_NEAR(p.state1[c], library.state[c] / factor(c), 1e-16) << c;
    }
    EXPECT_NEAR(p.state1[p.components()], library.state[GRIT_SAND_VOID_RATIO], 1e-15);
}

TEST(MgisOperator, ConsistentTangentIsTheLibrarysInMandelComponents) {
    for (const char* hypothesis : hypotheses) {
        Point p = strained(hypothesis);
        ASSERT_EQ(p.run(consistent_tangent), 1) << p.said();
        const LibraryPoint library(p.components(), GRIT_TANGENT_CONSISTENT);
        expect_end(p, library);
        expect_operator(p, library.tangent);
    }
}

// Without a look at the library's conventions: perturb what the host passes, see what it gets.
TEST(MgisOperator, ConsistentTangentIsTheDerivativeOfStressByStrain) {
    for (const char* hypothesis : hypotheses) {
        Point p = strained(hypothesis);
        const WithParameter tight(p.behaviour, "tolerance", 1e-11);
        ASSERT_EQ(p.run(consistent_tangent), 1) << p.said();
        const int n = p.components();
        for (int c = 0; c < n; ++c) {
            constexpr double small = 1e-7;
            Point ahead = p, behind = p;
            ahead.strain1[c] += small;
            behind.strain1[c] -= small;
            ASSERT_EQ(ahead.run(no_operator), 1);
            ASSERT_EQ(behind.run(no_operator), 1);
            for (int r = 0; r < n; ++r)
                EXPECT_NEAR((ahead.stress1[r] - behind.stress1[r]) / (2.0 * small), p.K[r * n + c],
                            1e-4 * std::abs(p.K[0]))
                    << hypothesis << " " << r << " " << c;
        }
    }
}

TEST(MgisOperator, SecantAndTangentAreTheRateAlongTheIncrementAtItsEnd) {
    for (const char* hypothesis : hypotheses)
        for (const int wanted : {secant, tangent}) {
            Point p = strained(hypothesis);
            ASSERT_EQ(p.run(wanted), 1) << p.said();
            const LibraryPoint library(p.components(), GRIT_TANGENT_CONTINUUM);
            expect_end(p, library);
            expect_operator(p, library.tangent);
        }
}

void elastic_stiffness(const LibraryPoint& at, double C[36]) {
    const grit_sand sand = catalogue_sand("lausitz", 1.0);
    grit_sand_stiffness(&sand, at.stress, at.state[GRIT_SAND_VOID_RATIO], C, nullptr);
    for (int i = 0; i < 36; ++i) C[i] *= 5.0;  // m_R
}

TEST(MgisOperator, ElasticOperatorIsTheStiffnessAtTheEndInsideTheElasticRange) {
    for (const char* hypothesis : hypotheses) {
        Point p = strained(hypothesis);
        ASSERT_EQ(p.run(elastic), 1) << p.said();
        const LibraryPoint library(p.components(), GRIT_TANGENT_NONE);
        expect_end(p, library);
        double C[36];
        elastic_stiffness(library, C);
        expect_operator(p, C);
    }
}

TEST(MgisOperator, ElasticOperatorIsLWithoutIntergranularStrain) {
    Point p = Point::lausitz("Tridimensional"), with = p;
    p.properties[9] = 0.0;  // m_R
    ASSERT_EQ(p.run(prediction_elastic), 1) << p.said();
    ASSERT_EQ(with.run(prediction_elastic), 1) << with.said();
    for (int i = 0; i < 36; ++i) EXPECT_NEAR(5.0 * p.K[i], with.K[i], 1e-7) << i;
}

TEST(MgisPrediction, GivesTheOperatorAtTheStartAndIntegratesNothing) {
    for (const char* hypothesis : hypotheses)
        for (const int wanted : {prediction_tangent, prediction_secant, prediction_elastic}) {
            Point p = strained(hypothesis);
            ASSERT_EQ(p.run(wanted), 1) << p.said();
            const LibraryPoint library(p.components(), GRIT_TANGENT_CONTINUUM, 0.0);
            double C[36];
            elastic_stiffness(library, C);
            expect_operator(p, wanted == prediction_elastic ? C : library.tangent);
            for (int c = 0; c < 6; ++c) EXPECT_EQ(p.stress1[c], -1.0);
            for (int i = 0; i < 10; ++i) EXPECT_EQ(p.state1[i], -1.0);
            EXPECT_EQ(p.dissipated1[0], -1.0);
        }
}

TEST(MgisOperator, NoOperatorLeavesAllOfKAlone) {
    for (const double wanted : {0.0, 100.0}) {
        Point p = strained("Tridimensional");
        ASSERT_EQ(p.run(wanted), 1) << p.said();
        EXPECT_EQ(p.K[0], wanted);
        for (int i = 1; i < 36; ++i) EXPECT_EQ(p.K[i], -1.0) << i;
        expect_end(p, LibraryPoint(6, GRIT_TANGENT_NONE));
    }
}

TEST(MgisOperator, IsChosenByIntervalsOfK0) {
    const struct {
        double given;
        int means;
    } codes[] = {{-7.0, prediction_tangent},
                 {-2.6, prediction_tangent},
                 {-2.4, prediction_secant},
                 {-0.6, prediction_elastic},
                 {0.6, elastic},
                 {1.6, secant},
                 {3.4, tangent},
                 {3.6, consistent_tangent},
                 {17.0, consistent_tangent}};
    for (const auto& code : codes) {
        Point p = strained("Tridimensional"), expected = p;
        ASSERT_EQ(p.run(code.given), 1);
        ASSERT_EQ(expected.run(code.means), 1);
        EXPECT_EQ(p.K, expected.K) << code.given;
        EXPECT_EQ(p.stress1, expected.stress1) << code.given;
    }
}

TEST(MgisSpeedOfSound, BelongsToTheWaveModulusAtTheEnd) {
    const grit_sand sand = catalogue_sand("lausitz", 1.0);
    for (const int wanted : {0, 1, 2, 3, 4}) {
        Point p = strained("Tridimensional"), alone = p;
        ASSERT_EQ(p.run(wanted + and_speed_of_sound), 1) << p.said();
        ASSERT_EQ(alone.run(wanted), 1);
        EXPECT_EQ(alone.speed_of_sound[0], -1.0) << "nobody asked";
        const LibraryPoint library(6, GRIT_TANGENT_NONE);
        double modulus = 0.0;
        grit_sand_wave_modulus(&sand, 0, library.stress, library.state[GRIT_SAND_VOID_RATIO],
                               &modulus);
        EXPECT_NEAR(p.speed_of_sound[0], std::sqrt(modulus / 1.6), 1e-8);
        EXPECT_EQ(p.stress1, alone.stress1);
        for (int i = 1; i < 36; ++i) EXPECT_EQ(p.K[i], alone.K[i]) << i;
    }
}

TEST(MgisSpeedOfSound, BelongsToTheStartInAPrediction) {
    Point p = strained("Axisymmetrical"), still = Point::lausitz("Axisymmetrical");
    ASSERT_EQ(p.run(prediction_elastic + and_speed_of_sound), 1) << p.said();
    ASSERT_EQ(still.run(no_operator + and_speed_of_sound), 1) << still.said();
    EXPECT_EQ(p.speed_of_sound[0], still.speed_of_sound[0]);
    EXPECT_EQ(p.stress1[0], -1.0);
}

}  // namespace
