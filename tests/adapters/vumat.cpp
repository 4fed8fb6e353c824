// SPDX-License-Identifier: BSD-3-Clause
// The VUMAT is the UMAT in blocks: orders, shears, old and new, and a frame that turns by itself.
#include <gtest/gtest.h>

#include <random>

#include "support/library.hpp"
#include "support/umat_call.hpp"
#include "support/vumat_call.hpp"

namespace {

// The UMAT and point i of the block have come to the same bits.
void expect_point(const VumatCall& block, int i, const UmatCall& point) {
    const std::vector<double> stress = block.stress(i);
    for (int c = 0; c < point.ntens; ++c)
        EXPECT_EQ(stress[static_cast<std::size_t>(c)], point.stress[c]) << c;
    for (int k = 0; k < point.nstatv; ++k) EXPECT_EQ(block.state_new(i, k), point.statev[k]) << k;
}

// Blocks of any size, points that differ, all six components, loading and unloading.
TEST(Vumat, GivesEveryPointTheBitsOfAUmat) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (const int n : {1, 3, 64, 65, 130}) {
        for (const int shears : {3, 1}) {
            VumatCall block(n, shears);
            std::vector<UmatCall> points(static_cast<std::size_t>(n), UmatCall::hochstetten());
            for (UmatCall& point : points)
                if (shears == 1) point.use_components(4);
            for (int increment = 0; increment < 4; ++increment) {
                for (int i = 0; i < n; ++i) {
                    double d[6] = {};
                    for (int c = 0; c < 3 + shears; ++c) d[c] = 3e-4 * any(random);
                    block.set_strain(i, d);
                    UmatCall& point = points[static_cast<std::size_t>(i)];
                    point.set_dstran(d[0], d[1], d[2], d[3], d[4], d[5]);
                    point.run();
                    ASSERT_EQ(point.pnewdt, 1.0);
                }
                block.run();
                EXPECT_TRUE(block.in_bounds());
                for (int i = 0; i < n; ++i)
                    expect_point(block, i, points[static_cast<std::size_t>(i)]);
                block.advance();
            }
        }
    }
}

TEST(Vumat, TakesTheToleranceOfAUmatAndGoesBackToTheDefault) {
    const double d[6] = {-5e-3, 1e-3, 2e-3, 4e-3, -3e-3, 2e-3};
    UmatCall usual = UmatCall::hochstetten();
    usual.set_dstran(d[0], d[1], d[2], d[3], d[4], d[5]);
    const UmatCall start = usual;
    usual.run();
    for (const double tolerance : {1e-6, 0.0, 1e-4, 3e-2, 0.0}) {
        VumatCall block(2);
        for (int i = 0; i < 2; ++i) block.set_strain(i, d);
        UmatCall point = start;
        if (tolerance > 0.0) {
            block.set_tolerance(tolerance);
            point.set_tolerance(tolerance);
        }
        block.run();
        point.run();
        for (int i = 0; i < 2; ++i) expect_point(block, i, point);
        EXPECT_EQ(point.stress == usual.stress, tolerance == 0.0) << tolerance;
    }
}

// Of the mixture, of the water itself, cavitating.
TEST(Vumat, HasTheWaterOfAUmat) {
    const double d[6] = {4e-4, -1e-4, 2e-4, 4e-4, -3e-4, 2e-4};
    for (const double itself : {0.0, 1.0})
        for (const double largest_tension : {0.0, 100.0}) {
            VumatCall block(3);
            UmatCall point = UmatCall::hochstetten();
            block.set_water(2.2e6, largest_tension, itself);
            point.set_water(2.2e6, largest_tension, itself);
            for (const double sign : {1.0, -1.0, -1.0}) {
                double strain[6];
                for (int c = 0; c < 6; ++c) strain[c] = sign * d[c];
                for (int i = 0; i < 3; ++i) block.set_strain(i, strain);
                point.set_dstran(strain[0], strain[1], strain[2], strain[3], strain[4], strain[5]);
                block.run();
                point.run();
                for (int i = 0; i < 3; ++i) expect_point(block, i, point);
                block.advance();
            }
        }
}

TEST(Vumat, LeavesStressAndMemoryBitwiseAloneInAPureRotation) {
    const double first[6] = {-3e-4, 1e-4, 2e-5, 1e-4, -5e-5, 7e-5}, none[6] = {};
    for (const double K_w : {0.0, 2e6}) {
        VumatCall block(5);
        for (int i = 0; i < 5; ++i) block.set_strain(i, first);
        block.props[14] = K_w;
        block.run();
        block.advance();
        const VumatCall before = block;
        for (int i = 0; i < 5; ++i) block.set_strain(i, none);
        for (int turn = 0; turn < 10; ++turn) {  // relSpinInc is large, strainInc zero
            block.run();
            block.advance();
        }
        EXPECT_EQ(block.stress_old, before.stress_old);
        for (int i = 0; i < 5; ++i) {
            for (const int k : {0, 1, 2, 3, 4, 5, 6, 7, 12, 13})
                EXPECT_EQ(block.state_old(i, k), before.state_old(i, k)) << k;
            for (const int k : {8, 10, 11})  // output, of the effective stress
                EXPECT_NEAR(block.state_old(i, k), before.state_old(i, k), 1e-10) << k;
        }
    }
}

TEST(Vumat, KeepsWithinThirteenStatevAndPassesOnWhatIsBehindFourteen) {
    const double d[6] = {-3e-4, 1e-4, 2e-5, 1e-4, -5e-5, 7e-5};
    VumatCall with(2, 3, 16), without(2, 3, 13);
    for (VumatCall* call : {&with, &without})
        for (int i = 0; i < 2; ++i) call->set_strain(i, d);
    with.state_old(1, 14) = 3.0;
    with.state_old(1, 15) = 4.0;
    with.run();
    without.run();
    EXPECT_TRUE(with.in_bounds() && without.in_bounds());
    EXPECT_EQ(with.stress_new, without.stress_new);
    EXPECT_EQ(with.state_new(1, 14), 3.0);
    EXPECT_EQ(with.state_new(1, 15), 4.0);
}

TEST(Vumat, AddsTheWorkPerMassToTheInternalEnergy) {
    VumatCall block(3);
    double d[6] = {-3e-4, 1e-4, 2e-5, 1e-4, -5e-5, 7e-5};
    for (int i = 0; i < 3; ++i) {
        d[0] -= 1e-4;
        block.density[static_cast<std::size_t>(i)] = 1.5 + 0.2 * i;
        block.set_strain(i, d);
    }
    block.run();
    d[0] = -3e-4;
    for (int i = 0; i < 3; ++i) {
        d[0] -= 1e-4;
        double work = 0.0;
        const std::vector<double> stress = block.stress(i);
        for (int c = 0; c < 6; ++c)
            work += 0.5 * d[c] * ((c < 3 ? -100.0 : 0.0) + stress[static_cast<std::size_t>(c)]);
        EXPECT_NEAR(block.intern_new(i, 0), 5.0 + work / (1.5 + 0.2 * i), 1e-13);
        EXPECT_GT(work, 0.0);
        EXPECT_EQ(block.inelas_new(i, 0), 6.0);
    }
}

TEST(Vumat, DoesWithoutEnergiesTimesAndDensity) {
    const double d[6] = {-3e-4, 1e-4, 2e-5, 1e-4, -5e-5, 7e-5};
    VumatCall full(2), sparse(2);
    for (VumatCall* call : {&full, &sparse})
        for (int i = 0; i < 2; ++i) call->set_strain(i, d);
    full.run();
    const auto function = reinterpret_cast<VumatFunction>(symbol_of(GRIT_VUMAT_LIBRARY, "vumat"));
    const double* none = nullptr;
    function(&sparse.nblock, &sparse.ndir, &sparse.nshr, &sparse.nstatev, nullptr, &sparse.nprops,
             nullptr, none, none, none, nullptr, none, none, sparse.props.data(), none,
             sparse.strain_inc.data(), none, none, none, none, none, sparse.stress_old.data(),
             sparse.state_old.data(), none, none, none, none, none, none, sparse.stress_new.data(),
             sparse.state_new.data(), nullptr, nullptr, 0);
    EXPECT_EQ(sparse.stress_new, full.stress_new);
    EXPECT_EQ(sparse.state_new, full.state_new);
}

}  // namespace
