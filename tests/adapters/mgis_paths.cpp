// SPDX-License-Identifier: BSD-3-Clause
// The same tests on the behaviour, in every hypothesis that can do them, and on the library.
#include <element/grit_law.hpp>
#include <element/laboratory.hpp>
#include <element/simulate.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../catalogue.hpp"
#include "support/mgis_law.hpp"

namespace {

using namespace mgis_host;
using element::Program;
using element::Vector6;

constexpr double pressure = 100.0, start_void_ratio = 0.6;

element::History on_library(const Program& program, double K_w) {
    element::GritLawOptions options;
    options.water_stiffness = K_w;
    const element::GritLaw law(catalogue_parameters("lausitz", 1.0), options);
    element::Sample sample;
    sample.point = law.start(-pressure * element::unit_tensor(), start_void_ratio);
    law.mobilise(sample.point, -element::unit_tensor(), 1.0);
    return element::simulate(law, sample, program);
}

element::History on_behaviour(const std::string& hypothesis, const Program& program, double K_w) {
    Point prototype = Point::lausitz(hypothesis);
    prototype.properties[14] = K_w;
    const MgisLaw law(prototype);
    element::Sample sample;
    const Vector6 h = -element::unit_tensor() * (prototype.properties[11] / std::sqrt(3.0));
    sample.point = law.start(-pressure * element::unit_tensor(), h, start_void_ratio);
    return element::simulate(law, sample, program);
}

// The largest difference at the end: stress relative to its norm, void ratio, pore pressure over it.
double difference(const std::string& hypothesis, const Program& program, double K_w = 0.0) {
    const element::History a = on_library(program, K_w), b = on_behaviour(hypothesis, program, K_w);
    EXPECT_FALSE(a.failure) << a.failure->message;
    EXPECT_FALSE(b.failure) << b.failure->message;
    const element::Record &x = a.records.back(), &y = b.records.back();
    EXPECT_EQ(a.records.size(), b.records.size());
    const double norm = x.effective_stress.norm();
    EXPECT_GT((x.effective_stress + pressure * element::unit_tensor()).norm(), 1.0) << "a test";
    if (hypothesis == "PlaneStrain") {
        EXPECT_EQ(y.strain[2], 0.0);
    }
    const double stress = (x.effective_stress - y.effective_stress).norm() / norm;
    const double pore_pressure = std::abs(x.pore_pressure - y.pore_pressure) / norm;
    const double void_ratio = std::abs(x.void_ratio - y.void_ratio);
    EXPECT_TRUE(std::isfinite(stress + pore_pressure + void_ratio)) << "std::max passes over NaN";
    return std::max({stress, pore_pressure, void_ratio});
}

Program with_increments(Program program, int n) {
    for (auto& step : program) step.increments = n;
    return program;
}

Program cycles(element::Step (*there)(double), double amplitude) {
    Program program = {there(amplitude)};
    for (int i = 0; i < 3; ++i) {
        program.push_back(there(-2.0 * amplitude));
        program.push_back(there(2.0 * amplitude));
    }
    return with_increments(program, 20);
}

constexpr double limit = 1e-9;

TEST(MgisPath, OedometerIsThatOfTheLibraryInEveryHypothesis) {
    const Program program =
        with_increments({element::oedometer_stress(-200.0), element::oedometer_stress(100.0)}, 40);
    for (const char* hypothesis : hypotheses)
        EXPECT_LT(difference(hypothesis, program), limit) << hypothesis;
}

TEST(MgisPath, DrainedTriaxialTestIsThatOfTheLibrary) {
    const Program program = with_increments({element::triaxial_drained(-0.05)}, 100);
    for (const char* hypothesis : {"Tridimensional", "Axisymmetrical", "GeneralisedPlaneStrain"})
        EXPECT_LT(difference(hypothesis, program), limit) << hypothesis;
}

TEST(MgisPath, DrainedBiaxialTestIsThatOfTheLibraryInPlaneStrain) {
    const Program program = with_increments({element::biaxial_drained(-0.03)}, 60);
    for (const char* hypothesis : {"PlaneStrain", "GeneralisedPlaneStrain", "Tridimensional"})
        EXPECT_LT(difference(hypothesis, program), limit) << hypothesis;
}

TEST(MgisPath, UndrainedTriaxialTestIsThatOfTheLibrary) {
    const Program program = with_increments({element::triaxial_undrained(-0.02)}, 60);
    for (const char* hypothesis : {"Tridimensional", "Axisymmetrical", "GeneralisedPlaneStrain"})
        EXPECT_LT(difference(hypothesis, program), limit) << hypothesis;
}

TEST(MgisPath, PoreWaterOfTheBehaviourIsThatOfTheLibrary) {
    const Program program = with_increments({element::triaxial_drained(-0.01)}, 60);
    const double K_w = 2.2e6 / 0.4;
    for (const char* hypothesis : {"Tridimensional", "Axisymmetrical", "GeneralisedPlaneStrain"})
        EXPECT_LT(difference(hypothesis, program, K_w), limit) << hypothesis;
}

TEST(MgisPath, DrainedCyclesAreThoseOfTheLibrary) {
    const Program program = cycles(element::triaxial_drained, -1e-3);
    for (const char* hypothesis : {"Tridimensional", "Axisymmetrical", "GeneralisedPlaneStrain"})
        EXPECT_LT(difference(hypothesis, program), limit) << hypothesis;
}

TEST(MgisPath, CyclesOfSimpleShearAreThoseOfTheLibraryInEveryHypothesis) {
    const Program program = cycles(element::simple_shear_constant_volume, 1e-3);
    for (const char* hypothesis : hypotheses)
        EXPECT_LT(difference(hypothesis, program), limit) << hypothesis;
}

}  // namespace
