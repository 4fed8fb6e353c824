// SPDX-License-Identifier: BSD-3-Clause
#include <span>

#include "../larger.hpp"
#include "support/reference.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

constexpr double increments[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
constexpr int states = 60;  // per sand and increment

struct Task {
    const Sand* sand;
    State start;
    Vec dE;
    State exact;
};

// Random states and increments whose path stays in the domain, with the referee's result.
std::vector<Task> random_tasks(Intergranular igs, std::uint64_t seed,
                               std::span<const double> sizes = increments) {
    std::vector<Task> tasks;
    Random random(seed);
    for (const Sand& sand : four_sands())
        for (const double increment : sizes)
            for (int kept = 0; kept < states;) {
                const State x = random_state(sand, random);
                const Vec dE = increment * random.direction();
                const Reference r = referee(sand, x, dE, igs);
                if (!r.in_domain) continue;
                tasks.push_back({&sand, x, dE, r.end});
                ++kept;
            }
    return tasks;
}

struct Delivered {
    double within = 0.0;    // share of calls with error <= tolerance
    double in_share = 0.0;  // ... and <= tolerance times the relative change of the stress
    double worst = 0.0;     // largest error / tolerance
    double worst_h = 0.0;   // largest error of h / R
    double worst_e = 0.0;
};

Delivered delivered(const std::vector<Task>& tasks, Intergranular igs, double tolerance) {
    Delivered d;
    grit_sand_options options = options_with(tolerance);
    options.intergranular_off = igs == Intergranular::off;
    for (const Task& t : tasks) {
        const State x = updated(*t.sand, t.start, t.dE, options);
        const double size = std::fmax(t.exact.T.norm(), t.start.T.norm());
        const double error = (x.T - t.exact.T).norm() / size / tolerance;
        const double change = (t.exact.T - t.start.T).norm() / size;
        const double least_change = 10.0 * t.dE.norm();  // docs/adr/0001
        d.within += (error <= 1.0) / static_cast<double>(tasks.size());
        d.in_share += (error <= std::fmin(std::fmax(change, least_change), 1.0)) /
                      static_cast<double>(tasks.size());
        d.worst = larger(d.worst, error);
        if (igs == Intergranular::on) {
            const double error_h = (x.h - t.exact.h).norm() / t.sand->p.elastic_strain_radius;
            d.worst_h = larger(d.worst_h, error_h);
        }
        d.worst_e = larger(d.worst_e, std::fabs(x.e - t.exact.e));
    }
    return d;
}

void expect_error_asked_for(Intergranular igs, std::uint64_t seed) {
    const std::vector<Task> tasks = random_tasks(igs, seed);
    for (const double tolerance : {1e-2, 3e-3, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
        SCOPED_TRACE(tolerance);
        const Delivered d = delivered(tasks, igs, tolerance);
        EXPECT_GE(d.within, 0.99);
        EXPECT_GE(d.in_share, 0.985);
        EXPECT_LE(d.worst, 10.0);
        EXPECT_LE(d.worst_h, std::fmax(100.0 * tolerance, 1e-7));
        EXPECT_LE(d.worst_e, 1e-12);
    }
}

TEST(Integration, DeliversTheErrorAskedForWithIntergranularStrain) {
    expect_error_asked_for(Intergranular::on, 161);
}

TEST(Integration, DeliversTheErrorAskedForWithoutIntergranularStrain) {
    expect_error_asked_for(Intergranular::off, 162);
}

// Single steps over whole increments, whose error estimates must see what the stress alone does to the rate.
TEST(Integration, DeliversTheErrorAskedForInSingleStepsWithoutIntergranularStrain) {
    constexpr double sizes[] = {2e-4, 5e-4, 1e-3, 2e-3};
    const std::vector<Task> tasks = random_tasks(Intergranular::off, 169, sizes);
    for (const double tolerance : {3e-3, 3e-4}) {
        SCOPED_TRACE(tolerance);
        const Delivered d = delivered(tasks, Intergranular::off, tolerance);
        EXPECT_GE(d.in_share, 0.99);
    }
}

// Where h is almost mobilised it hardly moves, and yet rho^chi still falls over a length of R.
TEST(Integration, DeliversTheErrorAskedForCloseToFullMobilisation) {
    std::vector<Task> tasks;
    Random random(168);
    for (const Sand& sand : four_sands())
        for (int kept = 0; kept < 100;) {
            const Vec D = (deviator(random.direction()) - 0.3 * identity()).normalized();
            State x = random_state(sand, random, 50.0, 500.0);
            x.h = (1.0 - random.log_uniform(1e-5, 1e-2)) * sand.p.elastic_strain_radius * D;
            const Vec dE = random.log_uniform(3e-5, 3e-3) * D;
            const Reference r = referee(sand, x, dE);
            if (!r.in_domain) continue;
            tasks.push_back({&sand, x, dE, r.end});
            ++kept;
        }
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) {
        SCOPED_TRACE(tolerance);
        const Delivered d = delivered(tasks, Intergranular::on, tolerance);
        EXPECT_GE(d.within, 0.99);
        EXPECT_LE(d.worst, 10.0);
    }
}

// (G3) has no derivative at h = 0: the smaller beta_r, the steeper the start.
TEST(Integration, ConvergesFromNoMemoryAtEveryTolerance) {
    for (const Sand& sand : four_sands())
        for (const double increment : increments) {
            Random random(167);
            State x = random_state(sand, random);
            x.h.setZero();
            const Vec dE = -increment / std::sqrt(3.0) * identity();
            const Vec exact = referee(sand, x, dE).end.T;
            for (const double tolerance : {1e-3, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12}) {
                Point point = point_of(x);
                const Outcome out =
                    update(sand, point, voigt_strain(dE).data(), options_with(tolerance));
                ASSERT_EQ(out.status, GRIT_OK) << sand.name << ": " << out.error.message;
                const double error = (state_of(point).T - exact).norm() / exact.norm();
                EXPECT_LE(error, 10.0 * tolerance + 1e-12)
                    << sand.name << ", increment " << increment << ", tolerance " << tolerance;
            }
        }
}

}  // namespace
