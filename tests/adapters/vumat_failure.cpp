// SPDX-License-Identifier: BSD-3-Clause
// What the VUMAT does at time zero, with calls that cannot be answered, and with points that fail.
#include <grit/sand_operators.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/vumat_call.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double strain[6] = {-3e-4, 1e-4, 2e-5, 1e-4, -5e-5, 7e-5};

VumatCall loaded(int n) {
    VumatCall block(n);
    for (int i = 0; i < n; ++i) block.set_strain(i, strain);
    return block;
}

double wave_modulus_of_hochstetten() {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    p.critical_friction_angle = 33.0 * std::acos(-1.0) / 180.0;
    p.granulate_hardness = 1e6;
    p.stiffness_exponent = 0.25;
    p.densest_void_ratio = 0.55;
    p.critical_void_ratio = 0.95;
    p.loosest_void_ratio = 1.05;
    p.pyknotropy_exponent = 0.25;
    p.stiffness_void_exponent = 1.5;
    p.reversal_stiffness = 5.0;
    p.transverse_stiffness = 2.0;
    p.elastic_strain_radius = 1e-4;
    p.evolution_exponent = 0.5;
    p.stiffness_interpolation_exponent = 6.0;
    grit_sand sand;
    EXPECT_EQ(grit_sand_prepare(&p, &sand, nullptr), GRIT_OK);
    const double stress[6] = {-100, -100, -100, 0, 0, 0};
    double modulus = 0.0;
    EXPECT_EQ(grit_sand_wave_modulus(&sand, 0, stress, 10.70 - 10.0, &modulus), GRIT_OK);
    return modulus;
}

TEST(VumatAtTimeZero, IsElasticWithTheSandsWaveModulusAndKeepsTheState) {
    const double M = wave_modulus_of_hochstetten();
    for (const double K_w : {0.0, 2e6}) {
        VumatCall block = loaded(3);
        block.step_time = block.total_time = 0.0;
        block.props[14] = K_w;
        block.state_old(1, 0) = 3e-5;
        block.state_old(2, 6) = 0.70;
        const VumatCall before = block;
        block.run();
        const double lambda = M / 3.0, mu = M / 3.0;
        const double volumetric = strain[0] + strain[1] + strain[2];
        for (int i = 0; i < 3; ++i) {
            const std::vector<double> stress = block.stress(i);
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_NEAR(stress[c],
                            c < 3 ? -100.0 + (lambda + K_w) * volumetric + 2.0 * mu * strain[c]
                                  : mu * strain[c],
                            1e-9)
                    << c;
        }
        EXPECT_EQ(block.state_new, before.state_old);
        EXPECT_EQ(block.intern_new, before.intern_old);
    }
}

TEST(VumatAtTimeZero, EndsWithTheFirstIncrement) {
    VumatCall elastic = loaded(1), first = loaded(1);
    elastic.step_time = elastic.total_time = 0.0;
    first.step_time = 0.0;  // of a later step
    elastic.run();
    first.run();
    EXPECT_NE(first.stress_new(0, 0), elastic.stress_new(0, 0));
    EXPECT_NE(first.state_new(0, 0), 0.0);
}

TEST(VumatFailure, LeavesABadPointStandingAndDoesTheOthers) {
    const std::function<void(VumatCall&, int)> spoilers[] = {
        [](VumatCall& x, int i) { x.strain_inc(i, 2) = nan; },
        [](VumatCall& x, int i) { x.stress_old(i, 4) = nan; },
        [](VumatCall& x, int i) { x.state_old(i, 6) = nan; },
        [](VumatCall& x, int i) { x.state_old(i, 0) = 1.0; },
        [](VumatCall& x, int i) { x.strain_inc(i, 0) = -0.6; }};
    VumatCall good = loaded(70);
    good.run();
    for (const auto& spoil : spoilers)
        for (const int bad : {0, 63, 64, 69}) {
            VumatCall block = loaded(70);
            spoil(block, bad);
            const std::string said = block.complaint();
            EXPECT_EQ(
                said.rfind("Grit VUMAT: point " + std::to_string(bad + 1) + " of a block of 70: ",
                           0),
                0U)
                << said;
            EXPECT_EQ(said.find('\n'), said.size() - 1);
            for (int i = 0; i < 70; ++i)
                for (int c = 0; c < 6; ++c) {
                    const double expected =
                        i == bad ? block.stress_old(i, c) : good.stress_new(i, c);
                    EXPECT_TRUE(block.stress_new(i, c) == expected || std::isnan(expected)) << i;
                }
            for (const int k : {0, 1, 5, 7, 8, 10, 13})
                EXPECT_EQ(block.state_new(bad, k), block.state_old(bad, k)) << k;
            EXPECT_EQ(block.state_new(bad, 9), -1.0) << "STATEV(10) marks it";
            EXPECT_GT(block.state_new(bad == 0 ? 1 : 0, 9), 0.0);
        }
}

// Points without a void ratio are not even handed to the library: the others keep their places.
TEST(VumatFailure, FindsTheOthersWhereAPointHasNoVoidRatio) {
    VumatCall good(70);
    good.props[15] = 0.0;
    for (int i = 0; i < 70; ++i) {
        const double d[6] = {-1e-5 * i, 1e-4, 2e-5, 1e-4, -5e-5, 7e-5};
        good.set_strain(i, d);
        good.state_old(i, 6) = 0.7;
    }
    VumatCall block = good;
    good.run();
    for (const int bad : {5, 66}) block.state_old(bad, 6) = 0.0;
    const std::string said = block.complaint();
    EXPECT_EQ(said.rfind("Grit VUMAT: point 6 of a block of 70: no void ratio: STATEV(7)", 0), 0U)
        << said;
    for (int i = 0; i < 70; ++i) {
        const bool bad = i == 5 || i == 66;
        for (int c = 0; c < 6; ++c)
            EXPECT_EQ(block.stress_new(i, c), bad ? block.stress_old(i, c) : good.stress_new(i, c));
        if (bad) {
            EXPECT_EQ(block.state_new(i, 9), -1.0);
            continue;
        }
        for (int k = 0; k < 14; ++k)
            EXPECT_EQ(block.state_new(i, k), good.state_new(i, k)) << i << ", " << k;
    }
}

void expect_nothing_written(const std::function<void(VumatCall&)>& spoil, const char* word) {
    VumatCall block = loaded(4);
    spoil(block);
    const VumatCall before = block;
    const std::string said = block.complaint();
    EXPECT_EQ(said.rfind("Grit VUMAT: ", 0), 0U) << said;
    EXPECT_NE(said.find(word), std::string::npos) << said;
    EXPECT_EQ(block.stress_new, before.stress_new);
    EXPECT_EQ(block.state_new, before.state_new);
    EXPECT_EQ(block.intern_new, before.intern_new);
}

TEST(VumatFailure, WritesNothingWhereTheCallIsWrong) {
    expect_nothing_written([](VumatCall& x) { x.nprops = 15; }, "nprops must be at least 16");
    expect_nothing_written([](VumatCall& x) { x.nstatev = 12; }, "nstatev must be at least 13");
    expect_nothing_written([](VumatCall& x) { x.ndir = 2; }, "ndir must be 3");
    expect_nothing_written([](VumatCall& x) { x.nshr = 2; }, "nshr 3 or 1");
    expect_nothing_written([](VumatCall& x) { x.nblock = -1; }, "nblock must be >= 0");
}

TEST(VumatFailure, LeavesAllPointsStandingWhereTheMaterialIsWrong) {
    const struct {
        int place;
        double value;
        const char* word;
    } wrong[] = {{0, 0.576, "radians?"},
                 {3, nan, "n"},
                 {14, -1.0, "K_w"},
                 {16, 0.2, "PROPS(17) (tolerance) must be 0 or in [1e-12, 0.1], got 0.2"}};
    for (const double time : {0.0, 1e-3})
        for (const auto& prop : wrong) {
            VumatCall block = loaded(70);
            block.step_time = block.total_time = time;
            block.set_tolerance(0.0);
            block.props[static_cast<std::size_t>(prop.place)] = prop.value;
            const std::string said = block.complaint();
            EXPECT_EQ(said.rfind("Grit VUMAT: ", 0), 0U) << said;
            EXPECT_NE(said.find(prop.word), std::string::npos) << said;
            EXPECT_EQ(block.stress_new, block.stress_old);
            EXPECT_EQ(block.intern_new, block.intern_old);
            for (int i = 0; i < 70; ++i)
                for (int k = 0; k < 14; ++k)
                    EXPECT_EQ(block.state_new(i, k), k == 9 ? -1.0 : block.state_old(i, k));
            EXPECT_TRUE(block.in_bounds());
        }
}

TEST(VumatFailure, NamesEveryNullPointerThatTheSandNeeds) {
    for (const char* name : {"nblock", "ndir", "nshr", "nstatev", "nprops", "props", "strainInc",
                             "stressOld", "stateOld", "stressNew", "stateNew"})
        expect_nothing_written([&](VumatCall& x) { x.missing = name; },
                               (std::string(name) + " is a null pointer").c_str());
}

TEST(VumatFailure, KnowsASinglePrecisionCallerByItsProps) {
    expect_nothing_written(
        [](VumatCall& x) {
            float single[16];
            for (std::size_t i = 0; i < 16; ++i) single[i] = static_cast<float>(x.props[i]);
            std::copy_n(reinterpret_cast<const char*>(single), sizeof single,
                        reinterpret_cast<char*>(x.props.data()));
        },
        "single precision: run Abaqus/Explicit with double=both");
}

TEST(VumatFailure, TakesAnEmptyBlock) {
    VumatCall block(0);
    EXPECT_EQ(block.complaint(), "");
}

// A host may have no arrays for it, and what is said of it is what the first failure cannot say any more.
TEST(VumatFailure, TakesAnEmptyBlockOfNoArrays) {
    for (const char* argument : {"stressNew", "strainInc", "props"}) {
        VumatCall block(0);
        block.missing = argument;
        EXPECT_EQ(block.complaint(), "");
    }
}

TEST(VumatFailure, SaysWhatIsWrongOfEachKindInOneBlock) {
    for (const int bad : {1, 40, 68}) {
        VumatCall block = loaded(70);
        block.strain_inc(0, 0) = -0.6;
        block.strain_inc(bad, 2) = nan;
        const std::string said = block.complaint();
        EXPECT_NE(said.find("point 1 of a block of 70: "), std::string::npos) << said;
        EXPECT_NE(said.find("use smaller steps"), std::string::npos) << said;
        const std::size_t other =
            said.find("point " + std::to_string(bad + 1) + " of a block of 70: ");
        ASSERT_NE(other, std::string::npos) << said;
        EXPECT_NE(said.find("must be finite, got nan", other), std::string::npos) << said;
    }
}

}  // namespace
