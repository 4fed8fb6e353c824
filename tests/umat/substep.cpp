// SPDX-License-Identifier: BSD-3-Clause
// The first step to try, in; advice for the next call, out.
#include "support/batch.hpp"

namespace {

using namespace tests;

const Sand& sand = four_sands()[0];

TEST(Substep, ComesBackPositiveAndServesTheNextCall) {
    for (const double tolerance : {1e-4, 1e-8}) {
        Batch batch = random_batch(sand, 50, 50);
        const Batch start = batch;
        ASSERT_EQ(batch.update(sand, options_with(tolerance)), GRIT_OK);
        for (const double substep : batch.substeps) {
            EXPECT_GT(substep, 0.0);
            EXPECT_TRUE(std::isfinite(substep));
        }
        batch.points = start.points;
        ASSERT_EQ(batch.update(sand, options_with(tolerance)), GRIT_OK);
    }
}

TEST(Substep, ABadProposalCostsEvaluationsAndNotAccuracy) {
    Random random(51);
    for (int i = 0; i < 30; ++i) {
        const State x = random_state(sand, random, 100.0, 500.0);
        const Vec dE = 1e-3 * (deviator(random.direction()) - 0.3 * identity()).normalized();
        const Vec exact = updated(sand, x, dE, options_with(1e-11)).T;
        for (const double proposal : {1e-9, 1e-5, 1.0}) {
            Batch batch;
            batch.points = {point_of(x)};
            batch.strain = {voigt_strain(dE)};
            batch.reports.resize(1);
            batch.tangents.resize(1);
            batch.substeps = {proposal};
            ASSERT_EQ(batch.update(sand, options_with(1e-5)), GRIT_OK);
            const Vec T = state_of(batch.points[0]).T;
            EXPECT_LE((T - exact).norm(), 1e-4 * exact.norm()) << proposal;
        }
    }
}

TEST(Report, CountsStepsAndEvaluationsAndEstimatesTheError) {
    Batch batch = random_batch(sand, 50, 52);
    ASSERT_EQ(batch.update(sand, options_with(1e-6)), GRIT_OK);
    for (const grit_sand_report& r : batch.reports) {
        EXPECT_EQ(r.status, GRIT_OK);
        EXPECT_GE(r.substeps, 1);
        EXPECT_GE(r.evaluations, 2 * r.substeps);
        EXPECT_GE(r.error_estimate, 0.0);
        EXPECT_EQ(r.step_reduction, 1.0);
    }
}

// How long steps are and what is added to estimates changes no result that another test could see, but what a call costs
// and what it says: these are the numbers of the method as it is. Who changes it writes down new ones, and whoever did not
// mean to has found something.
TEST(Report, HasTheWorkAndTheEstimatesOfThisMethod) {
    struct Expected {
        double tolerance, evaluations, error;
    };
    for (const Expected& is :
         {Expected{1e-3, 11511, 0.0336470}, {1e-6, 27952, 0.209444}, {1e-9, 77860, 0.846750}}) {
        double evaluations = 0.0, error = 0.0;
        for (const Sand& each : four_sands()) {
            Batch batch = random_batch(each, 200, 77);
            ASSERT_EQ(batch.update(each, options_with(is.tolerance)), GRIT_OK);
            for (const grit_sand_report& r : batch.reports) {
                evaluations += r.evaluations;
                error += r.error_estimate / is.tolerance / 800.0;
            }
        }
        EXPECT_NEAR(evaluations, is.evaluations, 3e-4 * is.evaluations) << is.tolerance;
        EXPECT_NEAR(error, is.error, 3e-4 * is.error) << is.tolerance;
    }
}

TEST(Report, ATighterToleranceTakesMoreEvaluations) {
    Batch loose = random_batch(sand, 50, 53), tight = loose;
    ASSERT_EQ(loose.update(sand, options_with(1e-3)), GRIT_OK);
    ASSERT_EQ(tight.update(sand, options_with(1e-9)), GRIT_OK);
    for (std::size_t i = 0; i < loose.size(); ++i)
        EXPECT_GE(tight.reports[i].evaluations, loose.reports[i].evaluations);
}

}  // namespace
