// SPDX-License-Identifier: BSD-3-Clause
// What says how far a sample can be trusted, on series whose answer is known.
#include <gtest/gtest.h>

#include "element/calibration/diagnostics.hpp"
#include "support/trials/split_mix.hpp"

namespace {

using namespace calibration;

// x' = a x + noise, of variance 1: its correlation time is (1 + a)/(1 - a).
std::vector<double> series(std::uint64_t seed, double a, int length, double offset = 0.0) {
    grit::SplitMix random(seed);
    std::vector<double> out;
    double x = random.normal();
    for (int i = 0; i < length; ++i) {
        x = a * x + std::sqrt(1.0 - a * a) * random.normal();
        out.push_back(x + offset);
    }
    return out;
}

TEST(AutocorrelationTime, OfAFirstOrderProcessIsKnown) {
    for (const double a : {0.0, 0.5, 0.9}) {
        std::vector<std::vector<double>> chains;
        for (int k = 0; k < 20; ++k)
            chains.push_back(series(static_cast<std::uint64_t>(k), a, 5000));
        EXPECT_NEAR(autocorrelation_time(chains) * (1.0 - a) / (1.0 + a), 1.0, 0.12) << a;
    }
}

TEST(RHat, IsOneWhereChainsAgreeAndMoreWhereOneIsElsewhere) {
    std::vector<std::vector<double>> chains;
    for (int k = 0; k < 4; ++k) chains.push_back(series(static_cast<std::uint64_t>(k), 0.3, 4000));
    EXPECT_NEAR(split_r_hat(chains), 1.0, 0.01);
    chains[2] = series(9, 0.3, 4000, 2.0);
    EXPECT_GT(split_r_hat(chains), 1.2);
}

TEST(RHat, SeesAChainThatDrifts) {
    std::vector<std::vector<double>> chains;
    for (int k = 0; k < 4; ++k) {
        chains.push_back(series(static_cast<std::uint64_t>(k), 0.3, 4000));
        for (std::size_t i = 0; i < 4000; ++i) chains.back()[i] += 0.001 * double(i);
    }
    EXPECT_GT(split_r_hat(chains), 1.2);
}

TEST(Quantile, IsLinearBetweenNeighbours) {
    std::vector<double> values = {4.0, 1.0, 3.0, 2.0};
    EXPECT_DOUBLE_EQ(quantile(values, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile(values, 1.0), 4.0);
}

}  // namespace
