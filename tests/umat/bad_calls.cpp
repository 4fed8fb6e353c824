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

// Hosts print the texts and look for them: word for word.
TEST(BadCall, SaysTheSameWords) {
    struct Call {
        Batch batch = random_batch(sand, 3, 84);
        Options o = options_with();
        Points q = batch.views();
        std::vector<double> moduli = std::vector<double>(3);
        const grit_sand* s = sand;
        const Points* points = &q;
        double* m = moduli.data();
        std::ptrdiff_t n = 3;
        bool waves = false;
    };
    const auto expect = [](const std::function<void(Call&)>& spoil, const std::string& text) {
        Call c;
        spoil(c);
        grit_error error{};
        const grit_status status =
            c.waves ? grit_sand_wave_moduli(c.s, &c.o, c.n, c.points, c.m, &error)
                    : grit_sand_update(c.s, &c.o, c.n, c.points, nullptr, &error);
        EXPECT_EQ(status, GRIT_BAD_CALL) << text;
        EXPECT_EQ(error.status, GRIT_BAD_CALL) << text;
        EXPECT_EQ(error.point, -1) << text;
        EXPECT_EQ(error.message, text);
    };
    // Of both entries; the one that is being asked goes before what is null.
    for (const bool waves : {false, true}) {
        const std::string name = waves ? "grit_sand_wave_moduli" : "grit_sand_update";
        const auto of_both = [&](const std::function<void(Call&)>& spoil, const std::string& text) {
            expect(
                [&](Call& c) {
                    c.waves = waves;
                    spoil(c);
                },
                text);
        };
        of_both([](Call& c) { c.s = nullptr; }, name + ": sand is null");
        of_both([](Call& c) { c.points = nullptr; }, name + ": points is null");
        of_both([](Call& c) { c.n = -6; }, name + ": n must be >= 0, got -6");
        of_both([](Call& c) { c.o.struct_size = 9000; },
                "grit_sand_options.struct_size 9000 is not understood: call grit_sand_options_init "
                "first");
        of_both([](Call& c) { c.q.struct_size = 1; },
                "grit_sand_points.struct_size 1 is not understood: set it to sizeof");
        of_both([](Call& c) { c.o.intergranular_off = 2; },
                "intergranular_off must be 0 or 1, got 2");
        of_both([](Call& c) { c.q.components = 5; },
                "components must be 6 or 4 (11 22 33 12), got 5");
        of_both([](Call& c) { c.q.stress.base = nullptr; }, "stress has no base pointer");
        of_both([](Call& c) { c.q.state.base = nullptr; }, "state has no base pointer");
    }
    expect(
        [](Call& c) {
            c.waves = true;
            c.m = nullptr;
        },
        "grit_sand_wave_moduli: moduli is null");
    expect([](Call& c) { c.o.stress_is_rotated = -1; }, "stress_is_rotated must be 0 or 1, got -1");
    expect([](Call& c) { c.o.validate_only = 7; }, "validate_only must be 0 or 1, got 7");
    expect([](Call& c) { c.q.reserved = 3; }, "grit_sand_points.reserved must be 0, got 3");
    expect([](Call& c) { c.q.strain_increment.base = nullptr; },
           "strain_increment has no base pointer");
    expect([](Call& c) { c.q.stress.point_stride = 0; },
           "stress is written: point_stride must not be 0 for 3 points");
    expect([](Call& c) { c.q.state.point_stride = 0; },
           "state is written: point_stride must not be 0 for 3 points");
    expect(
        [](Call& c) {
            c.q.substep = {c.m, 0, 1};
        },
        "substep is written: point_stride must not be 0 for 3 points");
    expect([](Call& c) { c.q.stress.component_stride = 0; },
           "component_stride of stress and state must not be 0");
    expect([](Call& c) { c.q.state.component_stride = 0; },
           "component_stride of stress and state must not be 0");
    expect([](Call& c) { c.q.strain_increment.component_stride = 0; },
           "component_stride of strain_increment must not be 0");
    const auto expect_of_tangent = [&](std::ptrdiff_t point, std::ptrdiff_t row,
                                       std::ptrdiff_t column, const std::string& text) {
        expect(
            [=](Call& c) {
                c.o.tangent = GRIT_TANGENT_CONTINUUM;
                c.q.tangent = {c.m, point, row, column};
            },
            text);
    };
    expect_of_tangent(0, 6, 1, "tangent is written: point_stride must not be 0 for 3 points");
    for (const int at : {0, 1})
        expect_of_tangent(36, at ? 6 : 0, at ? 0 : 1,
                          "tangent is written: row_stride and column_stride must not be 0");
    expect(
        [](Call& c) {
            c.o.tangent = GRIT_TANGENT_CONSISTENT;
            c.q.tangent.base = nullptr;
        },
        "tangent 2 is asked for, but its view has no base pointer");
    grit_error error{};
    grit_sand none;
    EXPECT_EQ(grit_sand_prepare(nullptr, &none, &error), GRIT_BAD_CALL);
    EXPECT_STREQ(error.message, "grit_sand_prepare: parameters is null");
    grit_sand_parameters parameters{};
    EXPECT_EQ(grit_sand_prepare(&parameters, nullptr, &error), GRIT_BAD_CALL);
    EXPECT_STREQ(error.message, "grit_sand_prepare: sand is null");
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
