// SPDX-License-Identifier: BSD-3-Clause
// Undrained points that fail keep every bit, of their water too, and the others are done.
#include <functional>
#include <limits>

#include "support/batch.hpp"
#include "support/undrained.hpp"

namespace {

using namespace tests;

constexpr std::size_t n = 300, bad = 270;  // in the second piece of a call
const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

const Sand& sand() {
    static const Sand lausitz = sand_named("lausitz");
    return lausitz;
}

struct Call {
    Batch batch = random_batch(sand(), n, 190);
    std::vector<double> p_w = std::vector<double>(n, 50.0);
    std::vector<Voigt> total = std::vector<Voigt>(n, Voigt{1.5, 1.5, 1.5, 1.5, 1.5, 1.5});
    grit_sand_options options = options_with(1e-5, GRIT_TANGENT_CONSISTENT);
    grit_sand_water water{};

    Call() {
        water = water_of({1e5}, nullptr);
        water.pore_pressure = grit_mutable_view_of(p_w.data(), 1, 1);
        water.total_stress = grit_mutable_view_of(total[0].data(), 6, 1);
    }
    Call(const Call&) = delete;

    grit_status run() {
        const grit_sand_points q = batch.views();
        return grit_sand_update_undrained(sand(), &options, &water, static_cast<std::ptrdiff_t>(n),
                                          &q, batch.reports.data(), &batch.error);
    }
    bool same(const Call& other) const {
        return same_bits(batch, other.batch) && total == other.total &&
               std::memcmp(p_w.data(), other.p_w.data(), n * sizeof(double)) == 0;
    }
};

struct Failure {
    grit_status status;
    std::vector<std::string> words;
    std::function<void(Call&)> spoil;
};

const std::vector<Failure> failures = {
    {GRIT_BAD_STATE,
     {"point 270: pore_pressure must be finite, got nan"},
     [](Call& c) { c.p_w[bad] = not_a_number; }},
    {GRIT_BAD_STATE,
     {"point 270: pore_pressure must be finite, got -inf"},
     [](Call& c) { c.p_w[bad] = -infinite; }},
    {GRIT_BAD_STATE,
     {"point 270: stress 11 must be finite", "nan"},
     [](Call& c) { c.batch.points[bad].stress[0] = not_a_number; }},
    {GRIT_BAD_STATE,
     {"point 270: void ratio must be in (0, 1e+09], got 0"},
     [](Call& c) { c.batch.points[bad].state[GRIT_SAND_VOID_RATIO] = 0.0; }},
    {GRIT_BAD_CALL,
     {"point 270: strain_increment 22 must be finite", "inf"},
     [](Call& c) { c.batch.strain[bad][1] = infinite; }},
    {GRIT_NOT_CONVERGED,
     {"point 270", "at most 0.2, got 0.5"},
     [](Call& c) { c.batch.strain[bad] = {0.0, -0.5, 0.0, 0.0, 0.0, 0.0}; }},
};

TEST(UndrainedFailures, LeaveThePointAloneAndTheOthersDone) {
    Call good;
    ASSERT_EQ(good.run(), GRIT_OK) << good.batch.error.message;
    for (const Failure& f : failures) {
        SCOPED_TRACE(f.words[0]);
        Call start, call;
        f.spoil(start);
        f.spoil(call);
        EXPECT_EQ(call.run(), f.status);
        EXPECT_EQ(call.batch.error.point, static_cast<std::ptrdiff_t>(bad));
        for (const std::string& word : f.words)
            EXPECT_NE(std::string(call.batch.error.message).find(word), std::string::npos)
                << call.batch.error.message;
        for (std::size_t i = 0; i < n; ++i) {
            const Call& expected = i == bad ? start : good;
            EXPECT_TRUE(same_bits(call.batch.points[i], expected.batch.points[i])) << i;
            EXPECT_EQ(std::memcmp(&call.p_w[i], &expected.p_w[i], sizeof(double)), 0) << i;
            EXPECT_EQ(call.total[i], expected.total[i]) << i;
            EXPECT_EQ(call.batch.tangents[i], expected.batch.tangents[i]) << i;
            EXPECT_EQ(call.batch.reports[i].status, i == bad ? f.status : GRIT_OK);
        }
        EXPECT_GT(call.batch.reports[bad].step_reduction, 0.0);
    }
}

TEST(UndrainedFailures, NameTheFirstPointWhateverIsWrongWithIt) {
    Call call;
    call.p_w[20] = not_a_number;
    call.batch.points[10].stress[0] = not_a_number;
    call.p_w[280] = not_a_number;
    EXPECT_EQ(call.run(), GRIT_BAD_STATE);
    EXPECT_EQ(call.batch.error.point, 10);
    call.p_w[5] = not_a_number;
    EXPECT_EQ(call.run(), GRIT_BAD_STATE);
    EXPECT_EQ(call.batch.error.point, 5);
    EXPECT_EQ(call.batch.reports[20].status, GRIT_BAD_STATE);
    EXPECT_EQ(call.batch.reports[280].status, GRIT_BAD_STATE);
}

TEST(UndrainedFailures, OfAPressureBeyondAllNumbersTouchNothing) {
    Call start, call;
    for (Call* c : {&start, &call}) {
        c->water.bulk_modulus = 1e308;
        c->water.porosity = 1e-8;
        for (auto& strain : c->batch.strain) strain = {-1e-3, 0.0, 0.0, 0.0, 0.0, 0.0};
    }
    EXPECT_EQ(call.run(), GRIT_BAD_STATE);
    EXPECT_NE(std::string(call.batch.error.message).find("units of bulk_modulus (1e+308)?"),
              std::string::npos)
        << call.batch.error.message;
    EXPECT_TRUE(call.same(start));
}

TEST(UndrainedFailures, RefuseWatersThatAreNone) {
    const struct {
        grit_status status;
        const char* words;
        std::function<void(Call&)> spoil;
    } refusals[] = {
        {GRIT_BAD_PARAMETER, "bulk_modulus of the water is not set",
         [](Call& c) { c.water.bulk_modulus = not_a_number; }},
        {GRIT_BAD_PARAMETER, "bulk_modulus must be >= 0 and finite [stress], got -1",
         [](Call& c) { c.water.bulk_modulus = -1.0; }},
        {GRIT_BAD_PARAMETER, "bulk_modulus must be >= 0 and finite [stress], got inf",
         [](Call& c) { c.water.bulk_modulus = infinite; }},
        {GRIT_BAD_PARAMETER,
         "porosity must be 0, for that of the void ratio, or in (0, 1], got 1.05",
         [](Call& c) { c.water.porosity = 1.05; }},
        {GRIT_BAD_PARAMETER,
         "porosity must be 0, for that of the void ratio, or in (0, 1], got nan",
         [](Call& c) { c.water.porosity = not_a_number; }},
        {GRIT_BAD_PARAMETER, "largest_tension must be >= 0 [stress], got -100",
         [](Call& c) { c.water.largest_tension = -100.0; }},
        {GRIT_BAD_CALL, "pore_pressure has no base pointer",
         [](Call& c) { c.water.pore_pressure.base = nullptr; }},
        {GRIT_BAD_CALL, "pore_pressure is written: point_stride must not be 0 for 300 points",
         [](Call& c) { c.water.pore_pressure.point_stride = 0; }},
        {GRIT_BAD_CALL, "total_stress is written: point_stride must not be 0 for 300 points",
         [](Call& c) { c.water.total_stress.point_stride = 0; }},
        {GRIT_BAD_CALL, "component_stride of total_stress must not be 0",
         [](Call& c) { c.water.total_stress.component_stride = 0; }},
        {GRIT_BAD_CALL, "grit_sand_water.struct_size 3 is not understood",
         [](Call& c) { c.water.struct_size = 3; }},
        {GRIT_BAD_CALL, "tolerance must be in", [](Call& c) { c.options.tolerance = 0.0; }},
    };
    for (const auto& refusal : refusals) {
        Call start, call;
        refusal.spoil(call);
        EXPECT_EQ(call.run(), refusal.status);
        EXPECT_NE(std::string(call.batch.error.message).find(refusal.words), std::string::npos)
            << call.batch.error.message;
        EXPECT_EQ(call.batch.error.point, -1);
        EXPECT_TRUE(call.same(start)) << refusal.words;
    }
    Call call;
    const grit_sand_points q = call.batch.views();
    EXPECT_EQ(
        grit_sand_update_undrained(sand(), nullptr, nullptr, 1, &q, nullptr, &call.batch.error),
        GRIT_BAD_CALL);
    EXPECT_STREQ(call.batch.error.message, "grit_sand_update_undrained: water is null");
}

TEST(UndrainedUpdate, ValidatesWithoutAChange) {
    Call start, call;
    call.options.validate_only = 1;
    EXPECT_EQ(call.run(), GRIT_OK);
    EXPECT_TRUE(call.same(start));
    call.p_w[bad] = infinite;
    EXPECT_EQ(call.run(), GRIT_BAD_STATE);
    EXPECT_EQ(call.batch.error.point, static_cast<std::ptrdiff_t>(bad));
}

// Of a caller that knows no more than the bulk modulus; one that wants what is not known here is refused.
TEST(UndrainedUpdate, TakesStructsOfOtherLengths) {
    struct Longer {
        grit_sand_water known;
        double more;
    };
    Call expected;
    ASSERT_EQ(expected.run(), GRIT_OK);
    Call call;
    Longer longer{};
    grit_sand_water_init(&longer.known, sizeof longer);
    EXPECT_EQ(longer.known.largest_tension, infinite);
    longer.known.bulk_modulus = 1e5;
    longer.known.pore_pressure = call.water.pore_pressure;
    longer.known.total_stress = call.water.total_stress;
    const grit_sand_points q = call.batch.views();
    const auto run = [&] {
        return grit_sand_update_undrained(sand(), &call.options, &longer.known,
                                          static_cast<std::ptrdiff_t>(n), &q,
                                          call.batch.reports.data(), &call.batch.error);
    };
    longer.more = 1.0;
    EXPECT_EQ(run(), GRIT_BAD_CALL);
    longer.more = 0.0;
    EXPECT_EQ(run(), GRIT_OK);
    EXPECT_TRUE(call.same(expected));
}

}  // namespace
