// SPDX-License-Identifier: BSD-3-Clause
// What a call hands on to the next: pore water, energies, void ratio, separation.
#include <gtest/gtest.h>

#include <cmath>

#include "../catalogue.hpp"
#include "support/mgis_point.hpp"

namespace {

using namespace mgis_host;

TEST(MgisWater, StiffensTheNormalEntriesAndTheSpeedOfSound) {
    constexpr double K_w = 5e6;
    for (const int wanted : {-3, -1, 1, 3, 4}) {
        Point dry = strained("Axisymmetrical"), wet = dry;
        wet.properties[14] = K_w;
        ASSERT_EQ(dry.run(wanted + and_speed_of_sound), 1);
        ASSERT_EQ(wet.run(wanted + and_speed_of_sound), 1);
        for (int r = 0; r < 4; ++r)
            for (int c = 0; c < 4; ++c)
                EXPECT_NEAR(wet.K[4 * r + c] - dry.K[4 * r + c], r < 3 && c < 3 ? K_w : 0.0, 1e-6);
        const double c_dry = dry.speed_of_sound[0], c_wet = wet.speed_of_sound[0];
        EXPECT_NEAR(c_wet * c_wet - c_dry * c_dry, K_w / 1.6, 1e-3);
    }
}

TEST(MgisWater, ItselfHasTheStiffnessOfThePoresUntilItCavitates) {
    constexpr double K_w = 2.2e6;
    Point dry = strained("Axisymmetrical"), wet = dry;
    wet.properties[14] = K_w;
    const int pressure = wet.behaviour.place_of("ExcessPorePressure");
    const int void_ratio = wet.behaviour.place_of("VoidRatio");
    ASSERT_EQ(wet.behaviour.set_integer("water_itself", 1), 1);
    for (const int wanted : {-3, -1, 1, 3, 4})
        for (const double p_w : {0.0, -1e6}) {
            const WithParameter set(wet.behaviour, "largest_water_tension", 1e5);
            wet.state0[pressure] = p_w;  // or far beyond
            const double borne = p_w < 0.0 ? -1e5 : p_w;
            for (int c = 0; c < 3; ++c) wet.stress0[c] = dry.stress0[c] - borne;
            ASSERT_EQ(dry.run(wanted + and_speed_of_sound), 1);
            ASSERT_EQ(wet.run(wanted + and_speed_of_sound), 1) << wet.said();
            const double e = wanted < 0 ? wet.state0[void_ratio] : wet.state1[void_ratio];
            const double K = p_w < 0.0 ? 0.0 : K_w * (1.0 + e) / e;
            for (int r = 0; r < 4; ++r)
                for (int c = 0; c < 4; ++c)
                    EXPECT_NEAR(wet.K[4 * r + c] - dry.K[4 * r + c], r < 3 && c < 3 ? K : 0.0,
                                1e-6);
            const double c_dry = dry.speed_of_sound[0], c_wet = wet.speed_of_sound[0];
            EXPECT_NEAR(c_wet * c_wet - c_dry * c_dry, K / 1.6, 1e-3);
            if (wanted < 0) continue;
            EXPECT_NEAR(wet.state1[pressure], p_w - K_w * std::log(e / wet.state0[void_ratio]),
                        1e-6);
            const double end = p_w < 0.0 ? -1e5 : wet.state1[pressure];
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(wet.stress1[c] + end, dry.stress1[c], 1e-8);
        }
    ASSERT_EQ(wet.behaviour.set_integer("water_itself", 0), 1);
}

TEST(MgisWater, CarriesThePressureThatVolumeStrainMakes) {
    Point p = strained("Tridimensional"), dry = p;
    p.properties[14] = 1e4;
    const int place = p.behaviour.place_of("ExcessPorePressure");
    p.state0[place] = 20.0;
    for (int c = 0; c < 3; ++c) p.stress0[c] -= 20.0;
    ASSERT_EQ(p.run(consistent_tangent + and_speed_of_sound), 1) << p.said();
    ASSERT_EQ(dry.run(), 1);
    EXPECT_NEAR(p.state1[place],
                20.0 - 1e4 * (general_strain[0] + general_strain[1] + general_strain[2]), 1e-10);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(p.stress1[c] + p.state1[place], dry.stress1[c], 1e-9);
    for (int c = 3; c < 6; ++c) EXPECT_NEAR(p.stress1[c], dry.stress1[c], 1e-9);
}

TEST(MgisBehaviour, RemembersHowFarAStressFreePointHasOpened) {
    Point p = Point::lausitz("PlaneStrain");
    const int place = p.behaviour.place_of("Separation");
    const auto strain_all = [&](double each) {
        p.set_strain({each, each, each, 0, 0, 0});
        EXPECT_EQ(p.run(), 1) << p.said();
        p.accept();
    };
    strain_all(3e-2);
    const double opened = p.state0[place];
    EXPECT_GT(opened, 0.01);
    EXPECT_EQ(p.stress0[0], 0.0);
    strain_all(-0.25 * opened);
    EXPECT_NEAR(p.state0[place], 0.25 * opened, 1e-15);
    EXPECT_EQ(p.stress0[0], 0.0) << "not yet closed";
    strain_all(-0.25 * opened);
    EXPECT_EQ(p.state0[place], 0.0);
    EXPECT_LT(p.stress0[0], 0.0);
}

TEST(MgisEnergy, DissipatedIsTheWorkOfTheEffectiveStress) {
    Point p = strained("Tridimensional");
    ASSERT_EQ(p.run(no_operator), 1);
    double work = 0.0;
    for (int c = 0; c < 6; ++c) work += 0.5 * (p.stress0[c] + p.stress1[c]) * general_strain[c];
    EXPECT_GT(work, 0.05);
    EXPECT_NEAR(p.dissipated1[0], 5.0 + work, 1e-12);
    EXPECT_EQ(p.stored1[0], 3.0) << "carried along";
}

// Taking sqrt 2 and the pore pressure off and on again costs a bit in many a number, not in all.
TEST(MgisBehaviour, ChangesNoBitInAnIncrementWithoutStrain) {
    Point p = Point::lausitz("Tridimensional");
    p.properties[14] = 1e4;
    for (int i = 0; i < 100; ++i) {
        for (int c = 0; c < 6; ++c) {
            p.stress0[c] = (c < 3 ? -100.0 : 1.0) - 0.137 * i - c;
            p.state0[c] = 3e-7 * (i % 50 + c) - 1e-5;
        }
        p.state0[p.behaviour.place_of("ExcessPorePressure")] = 0.1 * i;
        ASSERT_EQ(p.run(), 1) << p.said();
        EXPECT_EQ(p.stress1, p.stress0) << i;
        EXPECT_EQ(p.state1, p.state0) << i;
        EXPECT_EQ(p.dissipated1, p.dissipated0);
    }
}

TEST(MgisWater, IsFeltWhereTheSandHasNoStress) {
    Point p = Point::lausitz("Axisymmetrical");
    p.properties[14] = 1e3;
    p.state0[p.behaviour.place_of("Separation")] = 0.01;
    for (int c = 0; c < 3; ++c) p.stress0[c] = 0.0;
    p.set_strain({-1e-3, 0, 0, 0, 0, 0});
    ASSERT_EQ(p.run(), 1) << p.said();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(p.stress1[c], -1.0, 1e-12);
    EXPECT_NEAR(p.state1[p.behaviour.place_of("ExcessPorePressure")], 1.0, 1e-12);
}

TEST(MgisBehaviour, TakesTheVoidRatioOfItsPropertiesWhereTheHostHasSetNone) {
    const grit_sand sand = catalogue_sand("lausitz", 1.0);
    for (const double e_0 : {10.62, 0.62}) {
        Point p = Point::lausitz("Axisymmetrical");
        const int place = p.behaviour.place_of("VoidRatio");
        p.state0[place] = 0.0;
        p.properties[15] = e_0;
        ASSERT_EQ(p.run(), 1) << p.said();
        double expected = 0.62;
        if (e_0 < 10.0) grit_sand_void_ratio_at_pressure(&sand, e_0, 100.0, &expected);
        EXPECT_NEAR(p.state1[place], expected, 1e-15) << e_0;
    }
}

}  // namespace
