// SPDX-License-Identifier: BSD-3-Clause
// Undrained tests on one point, the total stress beside it held by Newton's method with the tangent.
#include "support/batch.hpp"
#include "support/undrained.hpp"

namespace {

using namespace tests;

// A triaxial sample in its cell, axis 11 [kPa].
struct Triaxial {
    Sand sand;
    Water water;
    double cell;  // total stress around it
    WetPoint point{};
    double tangent[36] = {};
    int iterations = 0;  // at the most of a step

    Triaxial(const Sand& of, const Water& in, double p, double p_w, double e)
        : sand(of), water(in), cell(-p - p_w) {
        State x;
        x.T = -p * identity();
        x.h = -sand.p.elastic_strain_radius / std::sqrt(3.0) * identity();
        x.e = e;
        point.sand = point_of(x);
        point.p_w = p_w;
    }

    Vec effective() const { return stress_from(point.sand.stress); }
    double p() const { return -trace(effective()) / 3.0; }
    double q() const { return point.sand.stress[1] - point.sand.stress[0]; }
    // Bulk modulus of the skeleton for small strains, m_R 1:L:1/9.
    double skeleton() const {
        double L[36], sum = 0.0;
        EXPECT_EQ(grit_sand_stiffness(sand, point.sand.stress,
                                      point.sand.state[GRIT_SAND_VOID_RATIO], L, nullptr),
                  GRIT_OK);
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) sum += L[6 * r + c];
        return sand.p.reversal_stiffness * sum / 9.0;
    }

    void strain_axially(double axial, double tolerance = 1e-8) {
        double lateral = -0.5 * axial;
        const double enough = 1e-9 * std::fabs(cell);
        for (int i = 1; i <= 20; ++i) {
            WetPoint trial = point;
            const double strain[6] = {axial, lateral, lateral, 0.0, 0.0, 0.0};
            const Outcome out = update_undrained(sand, water, trial, strain,
                                                 options_with(tolerance, GRIT_TANGENT_CONSISTENT));
            ASSERT_EQ(out.status, GRIT_OK) << out.error.message;
            iterations = std::max(iterations, i);
            const double off = trial.total[1] - cell;
            if (std::fabs(off) <= enough) {
                point = trial;
                std::copy_n(out.tangent, 36, tangent);
                return;
            }
            lateral -= off / (out.tangent[6 + 1] + out.tangent[6 + 2]);
        }
        FAIL() << "Newton's method did not converge";
    }
};

// Stiff water keeps the volume; the skeleton as it is for small strains, where it is stiffest.
TEST(UndrainedTests, ComeNearConstantVolumeAsWaterIsStiff) {
    for (const double e : {0.55, 0.7, 0.8}) {
        double last = 1.0;
        for (const double ratio : {100.0, 1000.0, 10000.0}) {
            const Sand sand = sand_named("lausitz");
            Triaxial test(sand, {0.0}, 100.0, 0.0, e);
            test.water.bulk_modulus = ratio * test.skeleton();
            Point isochoric = test.point.sand;
            double worst = 0.0;
            for (int i = 0; i < 300; ++i) {
                const double d = -1e-4, strain[6] = {d, -0.5 * d, -0.5 * d, 0.0, 0.0, 0.0};
                test.strain_axially(d);
                ASSERT_EQ(update(sand, isochoric, strain, options_with(1e-8)).status, GRIT_OK);
                const Vec T = stress_from(isochoric.stress);
                worst = std::fmax(worst, (test.effective() - T).norm() / T.norm());
            }
            EXPECT_LE(worst, 0.1 / ratio);
            EXPECT_LE(worst, 0.11 * last);
            last = worst;
        }
    }
}

// A closed path of strain closes the pores again, to the bits of the sum of strains; cavities on the way too.
TEST(UndrainedTests, ReturnThePressureOfAClosedPath) {
    const Sand sand = sand_named("lausitz");
    Random random(191);
    for (const double largest_tension : {0.0, 100.0, 1e9}) {
        const Water water{1e6, 0.0, largest_tension};
        Triaxial test(sand, water, 200.0, 50.0, 0.7);
        Vec sum = Vec::Zero();
        bool cavitated = false;
        for (int leg = 0; leg < 200; ++leg) {
            const Vec dE =
                leg == 199 ? Vec(-sum) : Vec(random.log_uniform(1e-6, 3e-3) * random.direction());
            sum += dE;
            const Outcome out = update_undrained(sand, water, test.point, voigt_strain(dE).data());
            ASSERT_EQ(out.status, GRIT_OK) << out.error.message;
            cavitated = cavitated || (out.report.flags & GRIT_SAND_CAVITATED);
        }
        EXPECT_NEAR(test.point.p_w, 50.0, 1e-14 * 200 * 1e6);
        EXPECT_EQ(cavitated, largest_tension < 1e9);
    }
}

// Cycles drive the pressure of the grains into the water. What is then sheared on comes to its critical state, at the
// pressure whose e_c is its void ratio.
TEST(UndrainedTests, OfLooseSandLiquefyInCyclesAndComeBack) {
    const Sand sand = sand_named("lausitz");
    Triaxial test(sand, {2.2e6, 0.0, 100.0}, 100.0, 200.0, 0.7);
    int cycles = 0;
    while (test.p() > 2.0 && cycles < 30) {
        for (int i = 0; i < 80; ++i) {
            test.strain_axially(i < 20 || i >= 60 ? -5e-5 : 5e-5);
            ASSERT_NEAR(test.point.total[1], test.cell, 1e-6);
        }
        ++cycles;
    }
    EXPECT_GT(cycles, 3);
    EXPECT_LT(cycles, 30);
    EXPECT_NEAR(test.point.p_w, 300.0, 3.0);
    EXPECT_LT(std::fabs(test.q()), 2.0);
    for (int i = 0; i < 4000; ++i) test.strain_axially(-2.5e-4);
    const double e_c = void_ratios(sand, test.p()).e_c;
    EXPECT_NEAR(test.point.sand.state[GRIT_SAND_VOID_RATIO], e_c, 3e-3);  // it is slow at the end
    EXPECT_GT(test.p(), 50.0);
    EXPECT_LE(test.iterations, 4);
}

}  // namespace
