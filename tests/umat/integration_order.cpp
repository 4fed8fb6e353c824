// SPDX-License-Identifier: BSD-3-Clause
// Order of convergence, and independence of how a host cuts a straight increment.
#include "support/reference.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

struct Mean {
    double error = 0.0, evaluations = 0.0;  // geometric means
};

// Paths that start at rho = 0.7 along their direction, so that there is no kink to cut at.
State smooth_start(const Sand& sand, Random& random, const Vec& D) {
    State x = random_state(sand, random);
    x.h = 0.7 * sand.p.elastic_strain_radius * D;
    return x;
}

Vec compressive_direction(Random& random) {
    return (deviator(random.direction()) - 0.3 * identity()).normalized();
}

Mean mean_over_states(const Sand& sand, double increment, double tolerance, Intergranular igs) {
    Random random(163);
    Mean mean;
    constexpr int count = 20;
    grit_sand_options options = options_with(tolerance);
    options.intergranular_off = igs == Intergranular::off;
    for (int i = 0; i < count; ++i) {
        const Vec D = compressive_direction(random);
        const State x = smooth_start(sand, random, D);
        const Vec exact = referee(sand, x, increment * D, igs).end.T;
        Point point = point_of(x);
        const Outcome out = update(sand, point, voigt_strain(increment * D).data(), options);
        EXPECT_EQ(out.status, GRIT_OK);
        const double error = (state_of(point).T - exact).norm() / exact.norm();
        mean.error += std::log(error) / count;
        mean.evaluations += std::log(out.report.evaluations) / count;
    }
    return mean;
}

// error ~ evaluations^-order
double observed_order(const Sand& sand, Intergranular igs) {
    const Mean rough = mean_over_states(sand, 5e-3, 1e-4, igs);
    const Mean fine = mean_over_states(sand, 5e-3, 1e-9, igs);
    return -(fine.error - rough.error) / (fine.evaluations - rough.evaluations);
}

TEST(Integration, LongIncrementsConvergeWithOrderFive) {
    for (const Sand& sand : four_sands())
        for (const auto igs : {Intergranular::off, Intergranular::on}) {
            const double order = observed_order(sand, igs);
            EXPECT_GE(order, 4.5) << sand.name;
        }
}

State in_parts(const Sand& sand, State x, const Vec& dE, int parts,
               const grit_sand_options& options) {
    for (int i = 0; i < parts; ++i) x = updated(sand, x, dE / parts, options);
    return x;
}

// With a loose tolerance every call is one step of Heun's method.
TEST(Integration, ShortIncrementsConvergeWithOrderTwo) {
    for (const Sand& sand : four_sands()) {
        Random random(164);
        double ratio = 0.0;
        constexpr int count = 20;
        for (int i = 0; i < count; ++i) {
            const Vec D = compressive_direction(random);
            const State x = smooth_start(sand, random, D);
            const Vec dE = 0.2 * sand.p.elastic_strain_radius * D;
            const Vec exact = referee(sand, x, dE).end.T;
            const auto loose = options_with(0.1);
            const double coarse = (in_parts(sand, x, dE, 8, loose).T - exact).norm();
            const double fine = (in_parts(sand, x, dE, 16, loose).T - exact).norm();
            ratio += std::log2(coarse / fine) / count;
        }
        EXPECT_NEAR(ratio, 2.0, 0.15) << sand.name;
    }
}

TEST(Integration, ResultDoesNotDependOnHowTheHostCutsAStraightIncrement) {
    for (const Sand& sand : four_sands()) {
        SCOPED_TRACE(sand.name);
        Random random(165);
        for (int i = 0; i < 30; ++i) {
            const State x = random_state(sand, random, 50.0, 500.0);
            const Vec dE = random.log_uniform(1e-5, 5e-3) * compressive_direction(random);
            for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
                const auto options = options_with(tolerance);
                const State whole = updated(sand, x, dE, options);
                for (const int parts : {2, 3, 10}) {
                    const State cut = in_parts(sand, x, dE, parts, options);
                    const double allowed = (1 + parts) * tolerance;  // one for each call
                    EXPECT_LE((cut.T - whole.T).norm(),
                              allowed * std::fmax(x.T.norm(), whole.T.norm()));
                    EXPECT_LE((cut.h - whole.h).norm(),
                              10.0 * allowed * sand.p.elastic_strain_radius);
                    EXPECT_NEAR(cut.e, whole.e, 1e-14);
                }
            }
        }
    }
}

TEST(Integration, VoidRatioFollowsTheVolumeExactly) {
    for (const Sand& sand : four_sands()) {
        Random random(166);
        const State x = random_state(sand, random, 200.0, 500.0);
        const Vec dE = 5e-3 * compressive_direction(random);
        const State y = updated(sand, x, dE, options_with(0.1));
        EXPECT_NEAR(y.e, (1.0 + x.e) * std::exp(trace(dE)) - 1.0, 1e-15) << sand.name;
    }
}

}  // namespace
