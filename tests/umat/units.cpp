// SPDX-License-Identifier: BSD-3-Clause
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

// Stress and state after a path of 40 random increments, the stress in kPa.
State end_of_path(const std::string& name, double unit, double tolerance) {
    const Sand in_kPa = sand_named(name);
    const Sand sand = sand_named(name, unit);
    Random random(18);
    State x = random_state(in_kPa, random, 200.0, 500.0);
    x.T *= unit;
    for (int i = 0; i < 40; ++i) {
        const Vec D = (deviator(random.direction()) - 0.2 * identity()).normalized();
        x = updated(sand, x, random.log_uniform(1e-6, 1e-3) * D, options_with(tolerance));
    }
    x.T /= unit;
    return x;
}

TEST(Units, ThePathIsTheSameInPascalKilopascalAndMegapascal) {
    for (const Sand& sand : four_sands())
        for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
            SCOPED_TRACE(sand.name);
            const State kPa = end_of_path(sand.name, 1.0, tolerance);
            for (const double unit : {1e3, 1e-3}) {
                const State other = end_of_path(sand.name, unit, tolerance);
                EXPECT_LE((other.T - kPa.T).norm(), 1e-12 * kPa.T.norm());
                EXPECT_LE((other.h - kPa.h).norm(), 1e-12 * sand.p.elastic_strain_radius);
                EXPECT_NEAR(other.e, kPa.e, 1e-14);
            }
        }
}

TEST(Units, StiffnessScalesWithTheUnitOfStress) {
    for (const Sand& sand : four_sands()) {
        const Sand in_Pa = sand_named(sand.name, 1e3);
        Random random(181);
        const State x = random_state(sand, random);
        State y = x;
        y.T *= 1e3;
        const Vec D = random.direction();
        const Mat kPa = stiffness_M(sand, x, D);
        EXPECT_LE((stiffness_M(in_Pa, y, D) / 1e3 - kPa).norm(), 1e-12 * kPa.norm()) << sand.name;
    }
}

// Stresses up to ten times h_s, whatever its number is.
TEST(Units, WhatGoesTooFarDoesSoInAnyUnit) {
    for (const Sand& sand : four_sands())
        for (const double strain : {-1e-3, -3e-2}) {
            const State x{-5.0 * sand.p.granulate_hardness * identity(), Vec::Zero(), 0.5};
            const auto outcome_in = [&](double unit) {
                State scaled = x;
                scaled.T *= unit;
                Point point = point_of(scaled);
                return update(sand_named(sand.name, unit), point,
                              voigt_strain(strain * identity()).data());
            };
            const Outcome kPa = outcome_in(1.0);
            for (const double unit : {1e-12, 1e12}) {
                const Outcome other = outcome_in(unit);
                EXPECT_EQ(other.status, kPa.status) << sand.name << ' ' << strain << ' ' << unit;
                EXPECT_EQ(other.report.step_reduction, kPa.report.step_reduction);
            }
        }
}

}  // namespace
