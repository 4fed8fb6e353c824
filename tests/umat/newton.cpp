// SPDX-License-Identifier: BSD-3-Clause
// What hosts do with the tangent: drained triaxial compression, the lateral strains by Newton.
#include "support/update.hpp"

namespace {

using namespace tests;

constexpr double tolerance = 1e-8;

struct Solution {
    State end;
    std::vector<double> residuals;  // relative to the lateral stress
};

// One increment of axial strain at constant stress in the five other components.
Solution axial_increment(const Sand& sand, const State& x, double axial, int tangent,
                         int iterations) {
    Solution s;
    Vec dE = principal(axial, -0.3 * axial, -0.3 * axial);
    for (int i = 0; i < iterations; ++i) {
        Point point = point_of(x);
        const Outcome out =
            update(sand, point, voigt_strain(dE).data(), options_with(tolerance, tangent));
        EXPECT_EQ(out.status, GRIT_OK) << out.error.message;
        s.end = state_of(point);
        const Eigen::Matrix<double, 5, 1> residual = (s.end.T - x.T).tail<5>();
        s.residuals.push_back(residual.norm() / x.T.norm());
        if (s.residuals.back() < 1e-13) break;
        const Mat C = stiffness_from(out.tangent);
        dE.tail<5>() -= C.bottomRightCorner<5, 5>().partialPivLu().solve(residual);
    }
    return s;
}

State triaxial_start(const Sand& sand, double looseness) {
    State x;
    x.T = -100.0 * identity();
    x.h = -sand.p.elastic_strain_radius / std::sqrt(3.0) * identity();
    const VoidRatios e = void_ratios(sand, 100.0);
    x.e = e.e_d + looseness * (e.e_c - e.e_d);
    return x;
}

TEST(Newton, ConvergesQuadraticallyWithTheConsistentTangent) {
    for (const Sand& sand : four_sands())
        for (const double axial : {-1e-5, -1e-4, -1e-3}) {
            SCOPED_TRACE(sand.name + ", " + std::to_string(axial));
            const State x = triaxial_start(sand, 0.5);
            const Solution s = axial_increment(sand, x, axial, GRIT_TANGENT_CONSISTENT, 12);
            EXPECT_LE(s.residuals.back(), 1e-11);
            EXPECT_LE(s.residuals.size(), 9u);
            // digits double from the first residual below 1e-3 to the level of the integration
            for (std::size_t i = 0; i + 1 < s.residuals.size(); ++i)
                if (s.residuals[i] < 1e-3 && s.residuals[i + 1] > 1e-10) {
                    EXPECT_LE(s.residuals[i + 1], 1e3 * s.residuals[i] * s.residuals[i]);
                }
        }
}

TEST(Newton, NeedsFewerIterationsThanWithTheContinuumTangent) {
    for (const Sand& sand : four_sands()) {
        const State x = triaxial_start(sand, 0.5);
        const auto good = axial_increment(sand, x, -1e-4, GRIT_TANGENT_CONSISTENT, 20);
        const auto poor = axial_increment(sand, x, -1e-4, GRIT_TANGENT_CONTINUUM, 20);
        EXPECT_LT(good.residuals.size(), poor.residuals.size()) << sand.name;
    }
}

// Lausitz sand, p_0 = 100 kPa, |h| = R, at 20 % of axial logarithmic strain.
void expect_triaxial_end(double e_0, double axial_stress, double e_end) {
    const Sand sand = sand_named("lausitz");
    State x = triaxial_start(sand, 0.5);
    x.e = e_0;
    double done = 0.0;
    while (done < 0.20 - 1e-12) {
        const double axial = std::fmin(done < 2e-3 ? 2e-5 : 5e-4, 0.20 - done);
        const Solution s = axial_increment(sand, x, -axial, GRIT_TANGENT_CONSISTENT, 12);
        ASSERT_LE(s.residuals.back(), 1e-7);
        x = s.end;
        done += axial;
    }
    EXPECT_NEAR(x.T[0] / axial_stress, 1.0, 5e-4);
    EXPECT_NEAR(x.T[1] / -100.0, 1.0, 5e-4);
    EXPECT_NEAR(x.e / e_end, 1.0, 5e-4);
}

TEST(DrainedTriaxialCompression, OfDenseLausitzSandEndsAtTheReference) {
    expect_triaxial_end(0.55, -398.912, 0.6127);
}

TEST(DrainedTriaxialCompression, OfLooseLausitzSandEndsAtTheReference) {
    expect_triaxial_end(0.80, -315.184, 0.7293);
}

}  // namespace
