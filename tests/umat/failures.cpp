// SPDX-License-Identifier: BSD-3-Clause
// A point that fails keeps every bit, says why, and does not disturb the others.
#include <functional>
#include <limits>

#include "support/batch.hpp"
#include "support/random_sand.hpp"
#include "support/states.hpp"

namespace {

using namespace tests;

constexpr std::size_t n = 21;
constexpr std::size_t bad = 13;
const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

struct Failure {
    const char* name;
    grit_status status;
    std::vector<std::string> message;  // what it must contain
    std::function<void(Batch&)> spoil;
};

const std::vector<Failure> failures = {
    {"NaN strain",
     GRIT_BAD_CALL,
     {"point 13", "strain_increment 12", "nan"},
     [](Batch& b) { b.strain[bad][3] = not_a_number; }},
    {"infinite strain",
     GRIT_BAD_CALL,
     {"point 13", "strain_increment 33", "inf"},
     [](Batch& b) { b.strain[bad][2] = infinite; }},
    {"NaN stress",
     GRIT_BAD_STATE,
     {"point 13", "stress 23", "nan"},
     [](Batch& b) { b.points[bad].stress[5] = not_a_number; }},
    {"infinite stress",
     GRIT_BAD_STATE,
     {"point 13", "stress 11", "-inf"},
     [](Batch& b) { b.points[bad].stress[0] = -infinite; }},
    {"NaN h",
     GRIT_BAD_STATE,
     {"point 13", "state component 4", "nan"},
     [](Batch& b) { b.points[bad].state[4] = not_a_number; }},
    {"NaN void ratio",
     GRIT_BAD_STATE,
     {"point 13", "state component 6", "nan"},
     [](Batch& b) { b.points[bad].state[6] = not_a_number; }},
    {"no voids",
     GRIT_BAD_STATE,
     {"point 13", "void ratio", "(0, 1e+09]", "got 0"},
     [](Batch& b) { b.points[bad].state[6] = 0.0; }},
    {"negative void ratio",
     GRIT_BAD_STATE,
     {"point 13", "void ratio", "-0.1"},
     [](Batch& b) { b.points[bad].state[6] = -0.1; }},
    {"negative separation",
     GRIT_BAD_STATE,
     {"point 13", "separation", ">= 0", "-0.25"},
     [](Batch& b) { b.points[bad].state[7] = -0.25; }},
    {"|h| > R",
     GRIT_BAD_STATE,
     {"point 13", "|h|", "0.0001", "0.0003"},
     [](Batch& b) {
         std::fill_n(b.points[bad].state, 6, 0.0);
         b.points[bad].state[1] = 3e-4;
     }},
    {"stress in another unit",
     GRIT_BAD_STATE,
     {"point 13", "stress", "10 h_s", "units?"},
     [](Batch& b) { b.points[bad].stress[1] = -1e9; }},
    {"large increment",
     GRIT_NOT_CONVERGED,
     {"point 13", "0.2", "0.5", "smaller steps"},
     [](Batch& b) { b.strain[bad] = {0.0, -0.5, 0.0, 0.0, 0.0, 0.0}; }},
    {"voids closed",
     GRIT_NOT_CONVERGED,
     {"point 13", "e = 0.05", "out of"},
     [](Batch& b) {
         b.points[bad].state[6] = 0.05;
         b.strain[bad] = {-0.04, -0.04, -0.04, 0.0, 0.0, 0.0};
     }},
    {"NaN substep",
     GRIT_BAD_CALL,
     {"point 13", "substep", "nan"},
     [](Batch& b) { b.substeps[bad] = not_a_number; }},
};

const Sand& sand = four_sands()[0];

void expect_message(const Batch& batch, const Failure& failure) {
    EXPECT_EQ(batch.error.status, failure.status);
    EXPECT_EQ(batch.error.point, static_cast<std::ptrdiff_t>(bad));
    const std::string message = batch.error.message;
    for (const std::string& part : failure.message)
        EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' in: " << message;
}

TEST(Failure, LeavesThePointBitwiseUntouchedAndComputesTheOthers) {
    for (const int tangent : {GRIT_TANGENT_NONE, GRIT_TANGENT_CONSISTENT}) {
        Batch good = random_batch(sand, n, 70);
        ASSERT_EQ(good.update(sand, options_with(1e-5, tangent)), GRIT_OK);
        for (const Failure& failure : failures) {
            SCOPED_TRACE(failure.name);
            Batch batch = random_batch(sand, n, 70);
            failure.spoil(batch);
            const Batch start = batch;
            EXPECT_EQ(batch.update(sand, options_with(1e-5, tangent)), failure.status);
            expect_message(batch, failure);
            EXPECT_EQ(batch.reports[bad].status, failure.status);
            for (std::size_t i = 0; i < n; ++i) {
                const Batch& expected = i == bad ? start : good;
                EXPECT_TRUE(same_bits(batch.points[i], expected.points[i])) << i;
                EXPECT_EQ(std::memcmp(&batch.tangents[i], &expected.tangents[i], 36 * 8), 0) << i;
                EXPECT_EQ(std::memcmp(&batch.substeps[i], &expected.substeps[i], 8), 0) << i;
                if (i != bad) {
                    EXPECT_EQ(batch.reports[i].status, GRIT_OK);
                }
            }
        }
    }
}

TEST(Failure, OfAStressThatLeavesItsRangeNamesTheLimit) {
    const double h_s = sand.p.granulate_hardness;
    for (const int tangent : {GRIT_TANGENT_NONE, GRIT_TANGENT_CONSISTENT}) {
        Batch batch = random_batch(sand, n, 73);
        batch.points[bad] = point_of({-9.999 * h_s * identity(), Vec::Zero(), 0.5});
        batch.strain[bad] = {-1e-3, -1e-3, -1e-3, 0.0, 0.0, 0.0};
        const Batch start = batch;
        EXPECT_EQ(batch.update(sand, options_with(1e-5, tangent)), GRIT_NOT_CONVERGED);
        expect_message(batch,
                       {"", GRIT_NOT_CONVERGED, {"point 13", "out of 10 h_s", "smaller"}, {}});
        EXPECT_TRUE(same_bits(batch.points[bad], start.points[bad]));
        EXPECT_LT(batch.reports[bad].step_reduction, 1.0);
    }
}

TEST(Failure, IsFoundByValidationAlone) {
    grit_sand_options options = options_with();
    options.validate_only = 1;
    for (const Failure& failure : failures) {
        SCOPED_TRACE(failure.name);
        Batch batch = random_batch(sand, n, 71);
        failure.spoil(batch);
        const Batch start = batch;
        EXPECT_EQ(batch.update(sand, options), failure.status);
        expect_message(batch, failure);
        EXPECT_TRUE(same_bits(batch, start));
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_EQ(batch.reports[i].status, i == bad ? failure.status : GRIT_OK);
    }
}

TEST(Validation, OfGoodPointsChangesNothing) {
    grit_sand_options options = options_with();
    options.validate_only = 1;
    Batch batch = random_batch(sand, n, 72);
    const Batch start = batch;
    EXPECT_EQ(batch.update(sand, options), GRIT_OK);
    EXPECT_TRUE(same_bits(batch, start));
}

TEST(Failure, AtTheEvaluationLimitAdvisesASmallerStep) {
    for (const int tangent : {GRIT_TANGENT_NONE, GRIT_TANGENT_CONSISTENT}) {
        Batch batch = random_batch(sand, n, 73);
        batch.strain[bad] = {-5e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0};
        const Batch start = batch;
        grit_sand_options options = options_with(1e-10, tangent);
        options.evaluation_limit = 40;
        EXPECT_EQ(batch.update(sand, options), GRIT_NOT_CONVERGED);
        const grit_sand_report& r = batch.reports[bad];
        EXPECT_EQ(r.status, GRIT_NOT_CONVERGED);
        EXPECT_GT(r.step_reduction, 0.0);
        EXPECT_LT(r.step_reduction, 1.0);
        EXPECT_LE(r.evaluations, 40);
        EXPECT_TRUE(same_bits(batch.points[bad], start.points[bad]));
        EXPECT_EQ(std::memcmp(&batch.tangents[bad], &start.tangents[bad], 36 * 8), 0);
        const std::string message = batch.error.message;
        EXPECT_NE(message.find("tolerance 1e-10"), std::string::npos) << message;
        EXPECT_NE(message.find("limit 40"), std::string::npos) << message;
    }
}

TEST(Failure, TheEvaluationLimitIsNeverExceeded) {
    for (const int limit : {2, 3, 6, 7, 8, 13, 30}) {
        Batch batch = random_batch(sand, n, 74);
        grit_sand_options options = options_with(1e-8);
        options.evaluation_limit = limit;
        batch.update(sand, options);
        for (const grit_sand_report& r : batch.reports) EXPECT_LE(r.evaluations, limit);
    }
}

TEST(Failure, OfALargeIncrementAdvisesAStepThatIsAccepted) {
    Batch batch = random_batch(sand, 1, 74);
    batch.strain[0] = {0.0, -0.9, 0.0, 0.0, 0.0, 0.0};
    EXPECT_EQ(batch.update(sand, options_with()), GRIT_NOT_CONVERGED);
    batch.strain[0][1] *= batch.reports[0].step_reduction;
    EXPECT_EQ(batch.update(sand, options_with()), GRIT_OK) << batch.error.message;
}

// Where a point fails, most calls know it long before their evaluations are spent: steps that have become too short.
TEST(Failure, IsSeenBeforeTheEvaluationsAreSpent) {
    Random random(5);
    int failed = 0, spent = 0;
    for (int i = 0; i < 2000; ++i) {
        const Sand any = random_sand(random);
        State x = random_state(any, random);
        x.h = random_memory(any, random);
        Batch batch;
        batch.points = {point_of(x)};
        const double size = random.log_uniform(1e-6, 0.3);  // the same order for every compiler
        batch.strain = {voigt_strain(size * random.direction())};
        batch.reports.resize(1);
        batch.tangents.resize(1);
        batch.substeps = {0.0};
        grit_sand_options options = options_with(random.log_uniform(1e-9, 1e-2));
        options.evaluation_limit = 20000;
        batch.update(any, options);
        const grit_sand_report& r = batch.reports[0];
        if (r.status != GRIT_NOT_CONVERGED || r.evaluations == 0) continue;
        ++failed;
        spent += r.evaluations > 10000;
    }
    EXPECT_GT(failed, 40);
    EXPECT_LT(spent, failed / 4);
}

TEST(Failure, ReportsTheFirstOfSeveral) {
    Batch batch = random_batch(sand, n, 75);
    batch.points[17].state[6] = -1.0;
    batch.strain[5][0] = not_a_number;
    EXPECT_EQ(batch.update(sand, options_with()), GRIT_BAD_CALL);
    EXPECT_EQ(batch.error.point, 5);
    EXPECT_EQ(batch.reports[17].status, GRIT_BAD_STATE);
}

// |h| above R by less than 1 %: roundoff of a host, scaled back and flagged.
TEST(Failure, IsNotMadeOfASmallExcessOfTheMemory) {
    Batch batch = random_batch(sand, 1, 76);
    Vec h = strain_from(batch.points[0].state) + 1e-6 * identity();
    h *= 1.005 * sand.p.elastic_strain_radius / h.norm();
    std::copy_n(voigt_strain(h).begin(), 6, batch.points[0].state);
    ASSERT_EQ(batch.update(sand, options_with()), GRIT_OK);
    EXPECT_TRUE(batch.reports[0].flags & GRIT_SAND_H_CLAMPED);
    EXPECT_LE(state_of(batch.points[0]).h.norm(), sand.p.elastic_strain_radius * (1.0 + 1e-12));
}

}  // namespace
