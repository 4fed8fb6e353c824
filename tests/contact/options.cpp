// SPDX-License-Identifier: BSD-3-Clause
#include <grit/contact.h>
#include <gtest/gtest.h>

TEST(ContactOptions, StartAsDocumented) {
    grit_contact_options options;
    ASSERT_EQ(grit_contact_options_init(&options, sizeof options), GRIT_OK);
    EXPECT_EQ(options.components, 3);
    EXPECT_EQ(options.law, GRIT_CONTACT_GEO);
    EXPECT_EQ(options.penalty_power, 6.0);
    EXPECT_EQ(options.friction_coefficient, 0.0);
    EXPECT_EQ(options.mass_tolerance, 1e-10);
    EXPECT_EQ(options.relaxation_time, 0.0);
    EXPECT_EQ(options.contact_stiffness, 0.0);
    EXPECT_EQ(options.rigid, GRIT_CONTACT_NONE_RIGID);
}
