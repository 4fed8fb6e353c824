// SPDX-License-Identifier: BSD-3-Clause
// Random numbers for trials, the same on every machine: SplitMix64 (Steele, Lea & Flood 2014), without the
// distributions of the standard library. Every seed gives an independent stream.
#pragma once

#include <cmath>
#include <cstdint>

namespace grit {

class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // [0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    int below(int n) { return static_cast<int>(uniform() * n); }
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }

  private:
    std::uint64_t state;
};

}  // namespace grit
