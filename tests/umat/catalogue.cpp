// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "support/sands.hpp"

namespace {

using namespace tests;

TEST(Catalogue, EveryRecordIsFoundByItsNameAndNamesItsSource) {
    ASSERT_GE(grit_sand_record_count(), 4);
    std::set<std::string> names;
    for (int i = 0; i < grit_sand_record_count(); ++i) {
        const grit_sand_record* record = grit_sand_record_at(i);
        ASSERT_NE(record, nullptr);
        EXPECT_EQ(grit_sand_record_find(record->name), i);
        EXPECT_TRUE(names.insert(record->name).second) << record->name;
        EXPECT_GT(std::string(record->title).size(), 0u);
        EXPECT_GT(std::string(record->source).size(), 10u);
        EXPECT_NE(record->note, nullptr);
        const std::string status = record->status;
        EXPECT_TRUE(status == "A" || status == "B") << status;
    }
}

TEST(Catalogue, EveryRecordCanBePrepared) {
    for (int i = 0; i < grit_sand_record_count(); ++i)
        for (const double scale : {1.0, 1e3, 1e-3})
            EXPECT_NO_THROW(sand_named(grit_sand_record_at(i)->name, scale));
}

TEST(Catalogue, UnknownRecordsAreTold) {
    EXPECT_EQ(grit_sand_record_find("moon dust"), -1);
    EXPECT_EQ(grit_sand_record_find(nullptr), -1);
    EXPECT_EQ(grit_sand_record_at(-1), nullptr);
    EXPECT_EQ(grit_sand_record_at(grit_sand_record_count()), nullptr);
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    EXPECT_EQ(grit_sand_record_parameters(-1, 1.0, &p), GRIT_BAD_CALL);
    for (const double scale : {0.0, -1.0, std::nan(""), HUGE_VAL})
        EXPECT_EQ(grit_sand_record_parameters(0, scale, &p), GRIT_BAD_CALL) << scale;
}

// Gowda, Moormann & Stolle, Table 1.
TEST(Catalogue, LausitzSandIsThatOfTheTable) {
    const grit_sand_parameters p = parameters_of("lausitz", 1e3);
    EXPECT_NEAR(p.critical_friction_angle, 33.0 * M_PI / 180.0, 1e-15);
    EXPECT_DOUBLE_EQ(p.granulate_hardness, 1.6e9);
    EXPECT_EQ(p.stiffness_exponent, 0.19);
    EXPECT_EQ(p.densest_void_ratio, 0.44);
    EXPECT_EQ(p.critical_void_ratio, 0.85);
    EXPECT_EQ(p.loosest_void_ratio, 1.0);
    EXPECT_EQ(p.pyknotropy_exponent, 0.25);
    EXPECT_EQ(p.stiffness_void_exponent, 1.0);
    EXPECT_EQ(p.pressure_shift, 0.0);
    EXPECT_EQ(p.reversal_stiffness, 5.0);
    EXPECT_EQ(p.transverse_stiffness, 2.0);
    EXPECT_EQ(p.elastic_strain_radius, 1e-4);
    EXPECT_EQ(p.evolution_exponent, 0.5);
    EXPECT_EQ(p.stiffness_interpolation_exponent, 6.0);
}

TEST(Catalogue, ASandWithoutPublishedIntergranularStrainComesWithoutIt) {
    const grit_sand_parameters p = parameters_of("karlsruhe-medium");
    EXPECT_TRUE(std::isnan(p.reversal_stiffness));
    EXPECT_TRUE(std::isnan(p.elastic_strain_radius));
}

}  // namespace
