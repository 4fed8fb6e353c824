// SPDX-License-Identifier: BSD-3-Clause
// Calls that are wrong as a whole: no node is touched, no report written.
#include <functional>

#include "support/nodes.hpp"

namespace {

using namespace tests;

using Options = grit_contact_options;
using Views = grit_contact_nodes;

void expect_bad_call(const std::function<void(Options&, Views&)>& spoil, const char* part) {
    Nodes nodes = random_nodes(3, 3, 41);
    const std::vector<Node> before = nodes.node;
    Options options = options_with();
    Views q = nodes.views();
    spoil(options, q);
    EXPECT_EQ(nodes.correct(options, q, 3), GRIT_BAD_CALL) << part;
    EXPECT_EQ(nodes.error.point, -1);
    EXPECT_NE(std::string(nodes.error.message).find(part), std::string::npos)
        << nodes.error.message;
    EXPECT_TRUE(same_bits(nodes.node, before)) << part;
    EXPECT_EQ(nodes.reports[0].state, 0);
}

TEST(BadContactCall, OptionsOutOfRangeAreRefused) {
    const double nan = std::nan("");
    for (const int c : {0, 1, 4})
        expect_bad_call([=](Options& o, Views&) { o.components = c; }, "components must be 2 or 3");
    expect_bad_call([](Options& o, Views&) { o.law = 2; }, "law must be");
    for (const double k : {0.0, -1.0, 2e6, nan})
        expect_bad_call([=](Options& o, Views&) { o.penalty_power = k; },
                        "penalty_power must be in (0, 1e6] [-]");
    for (const double mu : {-0.1, nan})
        expect_bad_call([=](Options& o, Views&) { o.friction_coefficient = mu; },
                        "friction_coefficient must be in [0, 1e100] [-]");
    expect_bad_call([](Options& o, Views&) { o.adhesion = -1.0; }, "adhesion must be");
    expect_bad_call([](Options& o, Views&) { o.adhesion = 1.0; }, "adhesion 1 needs time_step");
    for (const double dt : {-1.0, nan, 1e-200})
        expect_bad_call([=](Options& o, Views&) { o.time_step = dt; }, "time_step must be");
    for (const double tolerance : {-1e-3, 0.5, nan})
        expect_bad_call([=](Options& o, Views&) { o.mass_tolerance = tolerance; },
                        "mass_tolerance must be in [0, 0.5) [-]");
    expect_bad_call([=](Options& o, Views&) { o.gap_tolerance = nan; }, "gap_tolerance");
    expect_bad_call([](Options& o, Views&) { o.rigid = 3; }, "rigid must be");
    expect_bad_call([](Options& o, Views&) { o.allow_zero_normal = 2; }, "allow_zero_normal");
    expect_bad_call([](Options& o, Views&) { o.validate_only = -1; }, "validate_only");
    expect_bad_call([](Options& o, Views&) { o.instruction_set = 9; }, "instruction_set 9");
    expect_bad_call([](Options& o, Views&) { o.struct_size = 3; }, "struct_size 3");
}

TEST(BadContactCall, ViewsThatCannotBeUsedAreRefused) {
    expect_bad_call([](Options&, Views& q) { q.struct_size = 0; }, "struct_size 0");
    expect_bad_call([](Options&, Views& q) { q.mass_a.base = nullptr; }, "mass_a has no base");
    expect_bad_call([](Options&, Views& q) { q.mass_b.base = nullptr; }, "mass_b has no base");
    expect_bad_call([](Options&, Views& q) { q.normal.base = nullptr; }, "normal has no base");
    expect_bad_call([](Options&, Views& q) { q.distance.base = nullptr; }, "distance has no base");
    expect_bad_call([](Options&, Views& q) { q.cell_size.base = nullptr; },
                    "Geo-contact needs cell_size or spacing");
    expect_bad_call([](Options&, Views& q) { q.velocity_a.base = nullptr; }, "velocity_a has no");
    expect_bad_call([](Options&, Views& q) { q.velocity_b.base = nullptr; }, "velocity_b has no");
    expect_bad_call(
        [](Options& o, Views& q) {
            o.adhesion = o.time_step = 1.0;
            q.contact_area.base = nullptr;
        },
        "contact_area has no base");
    expect_bad_call([](Options&, Views& q) { q.normal.component_stride = 0; },
                    "normal has 3 components: component_stride must not be 0");
    expect_bad_call([](Options&, Views& q) { q.velocity_b.component_stride = 0; },
                    "velocity_b has 3 components: component_stride must not be 0");
    expect_bad_call([](Options&, Views& q) { q.velocity_a.point_stride = 0; },
                    "velocity_a is written: strides of 0 (nodes) and 1 (components) put two of its "
                    "numbers in one place");
    expect_bad_call([](Options&, Views& q) { q.velocity_a.point_stride = 1; },
                    "velocity_a is written: strides of 1 (nodes) and 1 (components)");
    expect_bad_call(
        [](Options&, Views& q) { q.velocity_b.component_stride = -q.velocity_b.point_stride; },
        "velocity_b is written: strides of");
    expect_bad_call([](Options&, Views& q) { q.acceleration_a = q.velocity_a; },
                    "acceleration_a is to be corrected: needs time_step > 0");
    expect_bad_call([](Options&, Views& q) { q.acceleration_b = q.velocity_b; },
                    "acceleration_b is to be corrected: needs time_step > 0");
}

TEST(BadContactCall, MissingArgumentsAreRefused) {
    grit_error error;
    EXPECT_EQ(grit_contact_correct(nullptr, 1, nullptr, nullptr, nullptr, &error), GRIT_BAD_CALL);
    EXPECT_STREQ(error.message, "grit_contact_correct: nodes is null");
    Nodes nodes = random_nodes(1, 3, 42);
    const Views q = nodes.views();
    EXPECT_EQ(grit_contact_correct(nullptr, -1, &q, nullptr, nullptr, &error), GRIT_BAD_CALL);
    EXPECT_STREQ(error.message, "grit_contact_correct: n must be >= 0, got -1");
    EXPECT_EQ(grit_contact_sums_add(nullptr, &nodes.sums), GRIT_BAD_CALL);
    EXPECT_EQ(grit_contact_sums_read(&nodes.sums, nullptr), GRIT_BAD_CALL);
}

}  // namespace
