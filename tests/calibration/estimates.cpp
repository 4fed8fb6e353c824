// SPDX-License-Identifier: BSD-3-Clause
// Parameters straight from tests, where the answer is known.
#include <gtest/gtest.h>

#include "element/calibration/estimates.hpp"
#include "samples.hpp"

namespace {

using namespace calibration;

// At a peak of the law itself, f_d is what its void ratio says.
TEST(Peak, OfADenseSampleTellsItsDensityFactor) {
    const grit_sand_parameters sand = lausitz();
    Experiment test = triaxial(100.0, 0.55);
    test.options.intergranular_strain = false;
    test.start.intergranular_strain = element::IntergranularStrain::off;
    measure(test, sand, 0.01);
    double q = 0.0, strain = 0.0;
    const std::size_t half = test.readings.size() / 2;
    for (std::size_t i = 0; i < half; ++i)
        if (test.readings[i].value > q) {
            q = test.readings[i].value;
            strain = test.readings[half + i].value;
        }
    const double p = 100.0 + q / 3.0, e = 1.55 * std::exp(strain) - 1.0;
    const double scale =
        std::exp(-std::pow(3.0 * p / sand.granulate_hardness, sand.stiffness_exponent));
    const double f_d = std::pow((e / scale - sand.densest_void_ratio) /
                                    (sand.critical_void_ratio - sand.densest_void_ratio),
                                sand.pyknotropy_exponent);
    EXPECT_NEAR(density_factor_at_peak(sand.critical_friction_angle, (100.0 + q) / 100.0), f_d,
                0.01);
}

TEST(Peak, AtTheCriticalStressRatioIsTheCriticalState) {
    const double s = std::sin(0.55);
    EXPECT_NEAR(density_factor_at_peak(0.55, (1.0 + s) / (1.0 - s)), 1.0, 1e-12);
}

TEST(Compression, AlongTheLawGivesItsHardnessAndExponent) {
    std::vector<double> p, e;
    for (int i = 0; i <= 30; ++i) {
        p.push_back(10.0 * std::pow(100.0, i / 30.0));
        e.push_back(1.1 * std::exp(-std::pow(3.0 * p.back() / 2e6, 0.27)));
    }
    const auto found = compression_curve(p, e);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->exponent, 0.27, 0.005);
    EXPECT_NEAR(std::log(found->hardness / 2e6), 0.0, 0.1);
    EXPECT_NEAR(found->void_ratio, 1.1, 0.005);
}

TEST(Estimates, LetEverySampleStart) {
    grit_sand_parameters nothing;
    grit_sand_parameters_init(&nothing, sizeof nothing);
    Experiment dense = triaxial(100.0, 0.50), loose = oedometer(0.84);
    measure(dense, lausitz(), 0.01);
    measure(loose, lausitz(), 0.01);
    for (Experiment* each : {&dense, &loose}) {
        each->options.intergranular_strain = false;
        each->start.intergranular_strain = element::IntergranularStrain::off;
    }
    IndexTests index;
    index.least_void_ratio = 0.6;  // above the dense sample
    const auto found = estimate({dense, loose}, index, nothing);
    grit_sand_parameters sand = nothing;
    for (int i = 0; i < 8; ++i) set(sand, i, found[static_cast<std::size_t>(i)].value);
    EXPECT_EQ(predict(dense, sand).failure, "");
    EXPECT_EQ(predict(loose, sand).failure, "");
}

}  // namespace
