// SPDX-License-Identifier: BSD-3-Clause
// An array with canaries on both sides: whoever writes out of bounds is found out.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

template <int size> class Guarded {
  public:
    explicit Guarded(double fill = 0.0) {
        memory.fill(canary);
        for (int i = 0; i < size; ++i) memory[margin + i] = fill;
    }

    double* data() { return memory.data() + margin; }
    const double* data() const { return memory.data() + margin; }
    double& operator[](int i) { return memory[margin + i]; }
    double operator[](int i) const { return memory[margin + i]; }

    // Nothing was written outside the first used elements.
    bool intact_beyond(int used) const {
        for (int i = 0; i < margin; ++i)
            if (memory[i] != canary) return false;
        for (int i = margin + size; i < margin + size + margin; ++i)
            if (memory[i] != canary) return false;
        for (int i = used; i < size; ++i)
            if (memory[margin + i] != canary) return false;
        return true;
    }
    // Declare the elements beyond used to be out of bounds.
    void close_beyond(int used) {
        for (int i = used; i < size; ++i) memory[margin + i] = canary;
    }

    // Same bits, NaN included.
    bool operator==(const Guarded& other) const {
        const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
        return std::equal(memory.begin(), memory.end(), other.memory.begin(),
                          [&](double a, double b) { return bits(a) == bits(b); });
    }

  private:
    static constexpr int margin = 8;
    static constexpr double canary = -7.25e77;
    std::array<double, size + 2 * margin> memory;
};
