// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "support/sands.hpp"

namespace {

using namespace tests;

// The message of a refusal, which must leave the sand untouched; empty if there is none.
std::string refusal(const grit_sand_parameters& p) {
    grit_sand sand, before;
    std::memset(&sand, 0x5a, sizeof sand);
    before = sand;
    grit_error error{};
    const grit_status status = grit_sand_prepare(&p, &sand, &error);
    if (status == GRIT_OK) return "";
    EXPECT_EQ(status, GRIT_BAD_PARAMETER);
    EXPECT_EQ(error.status, GRIT_BAD_PARAMETER);
    EXPECT_EQ(error.point, -1);
    EXPECT_EQ(std::memcmp(&sand, &before, sizeof sand), 0);
    return error.message;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const grit_sand_parameters lausitz = parameters_of("lausitz");

TEST(Parameters, OfAKnownSandAreAccepted) { EXPECT_EQ(refusal(lausitz), ""); }

TEST(Parameters, AnAngleInDegreesIsRefusedWithAHint) {
    grit_sand_parameters p = lausitz;
    p.critical_friction_angle = 33.0;
    const std::string message = refusal(p);
    EXPECT_TRUE(contains(message, "critical_friction_angle")) << message;
    EXPECT_TRUE(contains(message, "got 33")) << message;
    EXPECT_TRUE(contains(message, "[0.1745, 1.047] rad")) << message;
    EXPECT_TRUE(contains(message, "degrees?")) << message;
}

TEST(Parameters, EveryMissingOneIsNamed) {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info* info = grit_sand_parameter_describe(i);
        ASSERT_NE(info, nullptr);
        grit_sand_parameters p = lausitz;
        ASSERT_EQ(grit_sand_parameter_set(&p, i, std::nan("")), GRIT_OK);
        const std::string message = refusal(p);
        EXPECT_NE(message, "") << info->name;
        if (info->optional != 2) {
            EXPECT_TRUE(contains(message, info->name)) << message;
        }
    }
}

TEST(Parameters, OfTheIntergranularStrainAreGivenAllOrNone) {
    grit_sand_parameters p = lausitz;
    p.evolution_exponent = std::nan("");
    const std::string message = refusal(p);
    EXPECT_TRUE(contains(message, "4 of 5")) << message;
    EXPECT_TRUE(contains(message, "beta_r")) << message;
    p.reversal_stiffness = p.transverse_stiffness = std::nan("");
    p.elastic_strain_radius = p.stiffness_interpolation_exponent = std::nan("");
    EXPECT_EQ(refusal(p), "");
}

TEST(Parameters, OutsideTheirLimitsAreRefusedWithNameLimitsAndValue) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info* info = grit_sand_parameter_describe(i);
        for (const double bad : {-infinite, info->lowest - 1.0, info->highest + 1.0, infinite}) {
            if (bad >= info->lowest && bad <= info->highest && std::isfinite(bad)) continue;
            grit_sand_parameters p = lausitz;
            ASSERT_EQ(grit_sand_parameter_set(&p, i, bad), GRIT_OK);
            const std::string message = refusal(p);
            EXPECT_TRUE(contains(message, info->name)) << info->name << ": " << message;
            EXPECT_TRUE(contains(message, "must be in [")) << message;
            EXPECT_TRUE(contains(message, "got ")) << message;
        }
    }
}

TEST(Parameters, VoidRatiosMustBeInOrder) {
    grit_sand_parameters p = lausitz;
    std::swap(p.densest_void_ratio, p.critical_void_ratio);
    std::string message = refusal(p);
    EXPECT_TRUE(contains(message, "densest_void_ratio (e_d0) must be below critical_void_ratio"))
        << message;
    p = lausitz;
    p.loosest_void_ratio = p.critical_void_ratio;
    message = refusal(p);
    EXPECT_TRUE(contains(message, "critical_void_ratio (e_c0) must be below loosest_void_ratio"))
        << message;
    EXPECT_TRUE(contains(message, "0.85")) << message;
}

TEST(Parameters, TransverseStiffnessIsAtMostTheReversalStiffness) {
    grit_sand_parameters p = lausitz;
    p.transverse_stiffness = 6.0;
    EXPECT_TRUE(contains(refusal(p), "transverse_stiffness (m_T) must be at most"));
    p.transverse_stiffness = p.reversal_stiffness;
    EXPECT_EQ(refusal(p), "");
}

TEST(Parameters, APressureShiftInAnotherUnitIsRefused) {
    grit_sand_parameters p = lausitz;
    p.pressure_shift = 2.0 * p.granulate_hardness;
    EXPECT_TRUE(contains(refusal(p), "units?"));
}

TEST(Parameters, WithoutIsotropicStiffnessAreRefused) {
    grit_sand_parameters p = lausitz;
    p.critical_void_ratio = p.densest_void_ratio + 0.01;
    p.pyknotropy_exponent = 2.0;
    EXPECT_TRUE(contains(refusal(p), "isotropic stiffness is not positive"));
}

TEST(Parameters, AreReturnedByThePreparedSand) {
    const Sand sand = prepared("lausitz", lausitz);
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    ASSERT_EQ(grit_sand_parameters_of(sand, &p), GRIT_OK);
    EXPECT_EQ(std::memcmp(&p, &lausitz, sizeof p), 0);
}

TEST(Parameters, NullPointersAreABadCall) {
    grit_sand sand;
    grit_error error{};
    EXPECT_EQ(grit_sand_prepare(nullptr, &sand, &error), GRIT_BAD_CALL);
    EXPECT_TRUE(contains(error.message, "null"));
    EXPECT_EQ(grit_sand_prepare(&lausitz, nullptr, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_parameters_init(nullptr, 100), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_parameter_describe(-1), nullptr);
    EXPECT_EQ(grit_sand_parameter_describe(GRIT_SAND_PARAMETER_COUNT), nullptr);
}

}  // namespace
