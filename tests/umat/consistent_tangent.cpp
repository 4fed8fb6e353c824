// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

struct Differentiated {
    Mat tangent;
    int substeps;
};

Differentiated with_tangent(const Sand& sand, const State& x, const Vec& dE, double tolerance) {
    Point point = point_of(x);
    const Outcome out = update(sand, point, voigt_strain(dE).data(),
                               options_with(tolerance, GRIT_TANGENT_CONSISTENT));
    EXPECT_EQ(out.status, GRIT_OK) << out.error.message;
    return {stiffness_from(out.tangent), out.report.substeps};
}

Mat central_differences(const Sand& sand, const State& x, const Vec& dE, double probe,
                        double tolerance) {
    Mat C;
    for (int j = 0; j < 6; ++j) {
        const Vec step = probe * Vec::Unit(j);
        const Vec up = updated(sand, x, dE + step, options_with(tolerance)).T;
        const Vec down = updated(sand, x, dE - step, options_with(tolerance)).T;
        C.col(j) = (up - down) / (2.0 * probe);
    }
    return C;
}

// Away from the kink at h:D = 0, which differences would straddle.
State smooth_state(const Sand& sand, Random& random, const Vec& D, double length) {
    for (;;) {
        State x = random_state(sand, random, 50.0, 500.0);
        const double along = x.h.dot(D);
        if (std::fabs(along) > 0.05 * x.h.norm() + 0.01 * length &&
            std::fabs(along + length) > 0.05 * length)
            return x;
    }
}

// Loose enough that nearly each call is one step a segment, whatever the probe does.
TEST(ConsistentTangent, IsTheDerivativeOfTheStepsTaken) {
    for (const Sand& sand : four_sands())
        for (const double length : {1e-6, 1e-5, 5e-5}) {
            SCOPED_TRACE(sand.name + ", increment " + std::to_string(length));
            Random random(171);
            int compared = 0;
            for (int i = 0; i < 30; ++i) {
                const Vec D = random.direction();
                const State x = smooth_state(sand, random, D, length);
                const Vec dE = length * D;
                const Differentiated r = with_tangent(sand, x, dE, 0.1);
                const bool turns = x.h.dot(D) < 0.0 && x.h.dot(D) > -length;
                if (r.substeps != (turns ? 2 : 1)) continue;
                ++compared;
                const Mat C = central_differences(sand, x, dE, 1e-4 * length, 0.1);
                EXPECT_LE((C - r.tangent).norm(), 1e-6 * r.tangent.norm());
            }
            EXPECT_GE(compared, 20);
        }
}

// Largest error of the stress that the tangent predicts for a change of strain as long as dE.
double predicted_error(const Mat& C, const Mat& exact, double length, const State& x) {
    return (C - exact).jacobiSvd().singularValues()[0] * length / x.T.norm();
}

TEST(ConsistentTangent, IsTheDerivativeOfTheExactResponseWithinTenTolerances) {
    constexpr double differences = 1e-6;  // what the differences themselves leave
    for (const Sand& sand : four_sands())
        for (const double length : {1e-5, 1e-4, 1e-3}) {
            Random random(172);
            for (int i = 0; i < 25; ++i) {
                const Vec D = random.direction();
                const State x = smooth_state(sand, random, D, length);
                const Vec dE = length * D;
                const Mat exact = central_differences(sand, x, dE, 1e-3 * length, 1e-11);
                for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
                    const Mat C = with_tangent(sand, x, dE, tolerance).tangent;
                    EXPECT_LE(predicted_error(C, exact, length, x), 10.0 * tolerance + differences)
                        << sand.name << ", increment " << length << ", tolerance " << tolerance;
                }
            }
        }
}

// Turned back exactly, h goes through 0, or past it at the distance of roundoff, or of a small turn.
TEST(ConsistentTangent, IsTheDerivativeWhereAnExactReversalCrossesNoMemory) {
    for (const Sand& sand : four_sands()) {
        const double R = sand.p.elastic_strain_radius;
        Random random(173);
        for (int i = 0; i < 40; ++i) {
            const Vec D = random.direction();
            State x = random_state(sand, random, 50.0, 500.0);
            x.h = -random.uniform(0.2, 1.0) * R * D;
            if (i % 2) x.h += random.log_uniform(1e-16, 1e-8) * R * random.direction();
            if (x.h.norm() > R) x.h *= R / x.h.norm();
            const Vec dE = random.uniform(2.0, 10.0) * R * D;
            const Mat exact = central_differences(sand, x, dE, 1e-4 * dE.norm(), 1e-10);
            const Mat C = with_tangent(sand, x, dE, 2e-4).tangent;
            EXPECT_LE((C - exact).norm(), 1e-3 * exact.norm()) << sand.name << ", path " << i;
        }
    }
}

TEST(ConsistentTangent, ComesWithTheSameStressAsWithout) {
    for (const Sand& sand : four_sands()) {
        Random random(174);
        for (int i = 0; i < 50; ++i) {
            const Point start = point_of(random_state(sand, random));
            const Voigt dE = voigt_strain(random.log_uniform(1e-7, 2e-3) * random.direction());
            Point with = start, without = start;
            update(sand, with, dE.data(), options_with(1e-5, GRIT_TANGENT_CONSISTENT));
            update(sand, without, dE.data(), options_with(1e-5));
            EXPECT_TRUE(same_bits(with, without)) << sand.name;
        }
    }
}

TEST(ContinuumTangent, IsMAtTheEndOfTheIncrement) {
    for (const Sand& sand : four_sands()) {
        Random random(175);
        for (int i = 0; i < 20; ++i) {
            const State x = random_state(sand, random);
            const Vec dE = 1e-5 * random.direction();
            Point point = point_of(x);
            const Outcome out = update(sand, point, voigt_strain(dE).data(),
                                       options_with(1e-5, GRIT_TANGENT_CONTINUUM));
            const Mat M = stiffness_M(sand, state_of(point), dE);
            EXPECT_LE((stiffness_from(out.tangent) - M).norm(), 1e-11 * M.norm()) << sand.name;
        }
    }
}

}  // namespace
