// SPDX-License-Identifier: BSD-3-Clause
// Every wrong call gets one sentence, changes nothing and asks for a smaller step.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "support/mgis_point.hpp"

namespace {

using namespace mgis_host;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 6> strain = {-1e-3, 2e-4, 1e-4, 3e-4, 0, 0};

void expect_refusal(Point& p, double wanted, const std::string& sentence) {
    EXPECT_EQ(p.call(wanted), -1) << sentence;
    EXPECT_EQ(p.said(), "GritSand, " + p.behaviour.hypothesis + ": " + sentence);
    EXPECT_TRUE(p.untouched()) << sentence;
    EXPECT_EQ(p.rdt[0], 0.1) << sentence;
}

struct WrongValue {
    std::function<void(Point&)> spoil;
    const char* sentence;
};

Point good(const char* hypothesis = "Axisymmetrical") {
    Point p = Point::lausitz(hypothesis);
    p.set_strain(strain);
    p.connect();
    return p;
}

TEST(MgisFailure, NamesEveryWrongMaterialProperty) {
    const WrongValue wrong[] = {
        {[](Point& p) { p.properties[0] = 0.576; },
         "CriticalFrictionAngle must be in [10, 60] degrees, got 0.576: radians?"},
        {[](Point& p) { p.properties[0] = 61.0; },
         "CriticalFrictionAngle must be in [10, 60] degrees, got 61"},
        {[](Point& p) { p.properties[0] = nan; },
         "CriticalFrictionAngle must be in [10, 60] degrees, got nan"},
        {[](Point& p) { p.properties[14] = -1.0; },
         "WaterStiffness must be >= 0 and finite, in the unit of stress, got -1"},
        {[](Point& p) { p.properties[14] = infinity; },
         "WaterStiffness must be >= 0 and finite, in the unit of stress, got inf"},
        {[](Point& p) {
             p.properties[15] = -0.5;
             p.state0[p.behaviour.place_of("VoidRatio")] = 0.0;
         },
         "no void ratio: VoidRatio is below 0.001 and InitialVoidRatio is -0.5"},
    };
    for (const auto& value : wrong) {
        Point p = good();
        value.spoil(p);
        expect_refusal(p, consistent_tangent, value.sentence);
    }
}

TEST(MgisFailure, RefusesWhatTheLibraryRefusesInItsWords) {
    constexpr double nothing_like_it[14] = {0.0,  -1.0, -1.0, -1.0, -1.0, -1.0, -1.0,
                                            -1.0, -1.0, 0.7,  -1.0, -1.0, -1.0, -1.0};
    for (int i = 1; i < 14; ++i) {
        for (const double value : {nan, nothing_like_it[i]}) {
            Point p = good();
            p.properties[i] = value;
            EXPECT_EQ(p.call(consistent_tangent), -1) << i;
            EXPECT_TRUE(p.untouched()) << i;
            const std::string said = p.said();
            const bool names_it =
                said.find(std::isnan(value) ? "not a number" : "got ") < said.size() ||
                said.find("4 of 5 are given") < said.size();
            EXPECT_TRUE(names_it) << said;
        }
    }
}

TEST(MgisFailure, NamesEveryValueOfTheStateThatIsNotFinite) {
    for (const char* hypothesis : hypotheses) {
        const int n = good(hypothesis).components();
        for (int c = 0; c < n; ++c)
            for (const auto& [array, value] :
                 {std::pair{&Point::stress0, nan}, std::pair{&Point::strain1, infinity},
                  std::pair{&Point::strain0, nan}}) {
                Point p = good(hypothesis);
                (p.*array)[c] = value;
                EXPECT_EQ(p.call(consistent_tangent), -1) << hypothesis << " " << c;
                EXPECT_TRUE(p.untouched());
                EXPECT_EQ(p.said().find("GritSand, " + std::string(hypothesis) + ": "), 0u);
                EXPECT_EQ(p.said().find("point 0"), std::string::npos) << p.said();
            }
        for (int i = 0; i < n; ++i) {
            Point p = good(hypothesis);
            p.state0[i] = nan;
            EXPECT_EQ(p.call(consistent_tangent), -1) << hypothesis << " h " << i;
            EXPECT_TRUE(p.untouched());
        }
        Point p = good(hypothesis);
        p.state0[p.behaviour.place_of("ExcessPorePressure")] = nan;
        expect_refusal(p, no_operator, "ExcessPorePressure must be finite, got nan");
    }
}

TEST(MgisFailure, NamesEveryNullPointerThatTheSandNeeds) {
    const WrongValue wrong[] = {
        {[](Point& p) { p.view.s0.gradients = nullptr; }, "s0.gradients is a null pointer"},
        {[](Point& p) { p.view.s1.gradients = nullptr; }, "s1.gradients is a null pointer"},
        {[](Point& p) { p.view.s0.thermodynamic_forces = nullptr; },
         "s0.thermodynamic_forces is a null pointer"},
        {[](Point& p) { p.view.s1.thermodynamic_forces = nullptr; },
         "s1.thermodynamic_forces is a null pointer"},
        {[](Point& p) { p.view.s0.internal_state_variables = nullptr; },
         "s0.internal_state_variables is a null pointer"},
        {[](Point& p) { p.view.s1.internal_state_variables = nullptr; },
         "s1.internal_state_variables is a null pointer"},
        {[](Point& p) { p.view.s1.material_properties = nullptr; },
         "s1.material_properties is a null pointer"},
        {[](Point& p) { p.view.speed_of_sound = nullptr; }, "speed_of_sound is a null pointer"},
        {[](Point& p) { p.view.s1.mass_density = nullptr; }, "s1.mass_density is a null pointer"},
        {[](Point& p) { p.view.K = nullptr; }, "K is a null pointer"},
    };
    for (const auto& value : wrong) {
        Point p = good();
        value.spoil(p);
        expect_refusal(p, consistent_tangent + and_speed_of_sound, value.sentence);
    }
}

TEST(MgisFailure, OfACallWithoutDataIsAStatusAlone) {
    EXPECT_EQ(good().behaviour.integrate(nullptr), -1);
}

TEST(MgisBehaviour, DoesWithoutEveryOtherPointer) {
    Point all = good(), few = good();
    few.view.error_message = nullptr;
    few.view.rdt = few.view.speed_of_sound = nullptr;
    for (auto* state : {&few.view.s0, &few.view.s1}) {
        state->mass_density = state->external_state_variables = nullptr;
        state->stored_energy = state->dissipated_energy = nullptr;
    }
    few.view.s0.material_properties = nullptr;
    ASSERT_EQ(all.call(consistent_tangent), 1) << all.said();
    ASSERT_EQ(few.call(consistent_tangent), 1);
    EXPECT_EQ(few.stress1, all.stress1);
    EXPECT_EQ(few.state1, all.state1);
    EXPECT_EQ(few.K, all.K);
    few.strain1[0] = nan;
    EXPECT_EQ(few.call(consistent_tangent), -1) << "with nobody to tell";
}

TEST(MgisPrediction, DoesWithoutAPlaceForTheEnd) {
    Point p = good();
    p.view.s1.thermodynamic_forces = nullptr;
    p.view.s1.internal_state_variables = nullptr;
    EXPECT_EQ(p.call(prediction_elastic), 1) << p.said();
}

TEST(MgisFailure, NamesAnOperatorThatIsNone) {
    for (const double code : {nan, infinity, -infinity}) {
        Point p = good();
        const std::string number = std::isnan(code) ? "nan" : code > 0.0 ? "inf" : "-inf";
        expect_refusal(
            p, code, "K[0] must be in -3 ... 4, or 100 more for the speed of sound, got " + number);
    }
}

TEST(MgisFailure, NamesADensityWithoutASpeedOfSound) {
    for (const double density : {0.0, -1.6}) {
        Point p = good();
        p.density1[0] = density;
        expect_refusal(p, and_speed_of_sound,
                       std::string("mass_density must be > 0 and finite for the speed of sound, "
                                   "got ") +
                           (density < 0.0 ? "-1.6" : "0"));
    }
}

TEST(MgisFailure, AsksForTheStepThatTheIncrementNeeds) {
    Point p = good();
    p.strain1[0] = -0.3;  // 30 %: more than one call may be
    EXPECT_EQ(p.call(consistent_tangent), -1);
    EXPECT_TRUE(p.untouched());
    EXPECT_LT(p.rdt[0], 1.0);
    EXPECT_GT(p.rdt[0], 0.1) << "a third is not needed to be a tenth";
    Point careful = p;
    careful.connect();
    {
        const WithParameter set(p.behaviour, "minimal_time_step_scaling_factor", 0.95);
        EXPECT_EQ(careful.call(consistent_tangent), -1);
        EXPECT_EQ(careful.rdt[0], p.rdt[0]) << "it never rises";
        careful.rdt[0] = 10.0;
        EXPECT_EQ(careful.call(consistent_tangent), -1);
        EXPECT_EQ(careful.rdt[0], 0.95) << "no less than the user wants";
    }
    p.strain1[0] *= p.rdt[0];
    EXPECT_EQ(p.call(consistent_tangent), 1) << p.said();
}

TEST(MgisFailure, NeverRaisesTheStepOfTheHost) {
    Point p = good();
    p.rdt[0] = 0.01;
    p.strain1[0] = nan;
    EXPECT_EQ(p.call(consistent_tangent), -1);
    EXPECT_EQ(p.rdt[0], 0.01);
}

TEST(MgisBehaviour, LeavesTheStepAndTheMessageOfTheHostAloneWhereAllIsWell) {
    Point p = good();
    ASSERT_EQ(p.call(consistent_tangent), 1);
    EXPECT_EQ(p.rdt[0], 10.0);
    for (const char c : p.message) EXPECT_EQ(c, '#');
}

TEST(MgisFailure, EndsItsMessageInsideOfTheBuffer) {
    Point p = good();
    p.strain1[0] = nan;
    EXPECT_EQ(p.call(consistent_tangent), -1);
    EXPECT_LT(p.said().size(), 512u);
    EXPECT_TRUE(p.in_bounds());
}

}  // namespace
