// SPDX-License-Identifier: BSD-3-Clause
// Calls that are wrong as a whole: no point is touched.
#include <functional>

#include "support/batch.hpp"

namespace {

using namespace tests;

const Sand& sand = four_sands()[0];

using Options = grit_sand_options;
using Points = grit_sand_points;

void expect_bad_call(const std::function<void(Options&, Points&)>& spoil, const char* part) {
    Batch batch = random_batch(sand, 3, 80);
    const Batch start = batch;
    Options options = options_with();
    Points q = batch.views();
    spoil(options, q);
    EXPECT_EQ(batch.update(sand, options, q), GRIT_BAD_CALL) << part;
    EXPECT_EQ(batch.error.point, -1);
    EXPECT_NE(std::string(batch.error.message).find(part), std::string::npos)
        << batch.error.message;
    EXPECT_TRUE(same_bits(batch, start)) << part;
}

TEST(BadCall, OptionsOutOfRangeAreRefused) {
    for (const double tolerance : {0.0, 1e-13, 0.2, std::nan("")})
        expect_bad_call([=](Options& o, Points&) { o.tolerance = tolerance; }, "[1e-12, 0.1]");
    expect_bad_call([](Options& o, Points&) { o.evaluation_limit = 1; }, "evaluation_limit");
    expect_bad_call([](Options& o, Points&) { o.intergranular_off = 2; }, "intergranular_off");
    expect_bad_call([](Options& o, Points&) { o.tangent = 3; }, "tangent");
    expect_bad_call([](Options& o, Points&) { o.instruction_set = 9; }, "instruction_set");
    expect_bad_call([](Options& o, Points&) { o.stress_is_rotated = -1; }, "stress_is_rotated");
    expect_bad_call([](Options& o, Points&) { o.validate_only = 7; }, "validate_only");
}

TEST(BadCall, ViewsThatCannotBeUsedAreRefused) {
    expect_bad_call([](Options&, Points& q) { q.stress.base = nullptr; }, "stress");
    expect_bad_call([](Options&, Points& q) { q.state.base = nullptr; }, "state");
    expect_bad_call([](Options&, Points& q) { q.strain_increment.base = nullptr; }, "strain");
    expect_bad_call([](Options&, Points& q) { q.components = 3; }, "components");
    expect_bad_call([](Options&, Points& q) { q.reserved = 1; }, "reserved");
    expect_bad_call([](Options&, Points& q) { q.struct_size = 0; }, "struct_size");
    expect_bad_call([](Options&, Points& q) { q.stress.point_stride = 0; }, "point_stride");
    expect_bad_call(
        [](Options& o, Points& q) {
            o.tangent = GRIT_TANGENT_CONTINUUM;
            q.tangent.base = nullptr;
        },
        "tangent");
}

TEST(BadCall, WithoutPointsOrSandIsRefused) {
    Batch batch = random_batch(sand, 1, 81);
    const Points q = batch.views();
    EXPECT_EQ(grit_sand_update(nullptr, nullptr, 1, &q, nullptr, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_update(sand, nullptr, 1, nullptr, nullptr, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_update(sand, nullptr, -1, &q, nullptr, nullptr), GRIT_BAD_CALL);
    grit_sand unprepared{};
    EXPECT_EQ(grit_sand_update(&unprepared, nullptr, 1, &q, nullptr, nullptr), GRIT_BAD_CALL);
}

TEST(Call, WithoutPointsToUpdateOrWithoutOptionsReportsAndErrorIsFine) {
    Batch batch = random_batch(sand, 2, 82);
    const Points q = batch.views();
    EXPECT_EQ(grit_sand_update(sand, nullptr, 0, &q, nullptr, nullptr), GRIT_OK);
    EXPECT_EQ(grit_sand_update(sand, nullptr, 2, &q, nullptr, nullptr), GRIT_OK);
}

TEST(Call, APreparedSandMayBeCopiedAsBytes) {
    Sand copy = sand;
    Batch a = random_batch(sand, 5, 83), b = a;
    ASSERT_EQ(a.update(sand, options_with()), GRIT_OK);
    ASSERT_EQ(b.update(copy, options_with()), GRIT_OK);
    EXPECT_TRUE(same_bits(a, b));
}

TEST(Status, EveryOneHasAName) {
    for (int s = GRIT_OK; s <= GRIT_INTERNAL; ++s)
        EXPECT_STRNE(grit_status_name(s), "unknown status");
    EXPECT_STREQ(grit_status_name(-5), "unknown status");
    EXPECT_STREQ(grit_status_name(GRIT_OK), "ok");
}

}  // namespace
