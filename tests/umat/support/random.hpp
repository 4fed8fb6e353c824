// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same on every machine: SplitMix64 (Steele, Lea & Flood 2014).
#pragma once

#include <cstdint>

#include "support/tensors.hpp"

namespace tests {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state(seed) {}

    double uniform() {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }
    // Uniform on the unit sphere of symmetric tensors.
    Vec direction() {
        Vec A;
        for (int i = 0; i < 6; ++i) A[i] = normal();
        return A.normalized();
    }
    Full rotation() {
        const double w = normal(), x = normal(), y = normal(), z = normal();
        return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    }

  private:
    std::uint64_t state;
};

}  // namespace tests
