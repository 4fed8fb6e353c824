// SPDX-License-Identifier: BSD-3-Clause
// Numbers that every machine draws alike: a fixed seed through std::mt19937_64, without the
// distributions of the library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace tests {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    double normal() {
        return std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0))) *
               std::cos(2.0 * M_PI * uniform(0.0, 1.0));
    }

  private:
    std::mt19937_64 engine;
};

}  // namespace tests
