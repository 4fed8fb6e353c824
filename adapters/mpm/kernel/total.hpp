// SPDX-License-Identifier: BSD-3-Clause
// A sum over particles or nodes, of a whole run or a step: in double, or in fixed point, where neither the
// order nor the threads or processes that added to it change a bit.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "support/kernel.hpp"

namespace grit::mpm {

class Total {
  public:
    Total() = default;
    explicit Total(double x) : in_double(x) {}

    // Integers that hold the fixed-point part; those of processes are added as integers.
    static constexpr int words = 5;
    static constexpr double unit = 0x1p-80;    // [J], [N], ...
    static constexpr double largest = 0x1p34;  // of one addend; 2^12 of it fit. Beyond: NaN.

    GRIT_INLINE void add(double x, bool fixed_point) {
        if (!fixed_point) in_double += x;
        else if (std::fabs(x) < largest) invalid += plus(static_cast<Integer>(x * (1.0 / unit)));
        else ++invalid;
    }
    Total& operator+=(const Total& other) {
        in_double += other.in_double;
        invalid += other.invalid + plus(other.units);
        return *this;
    }
    Total& operator-=(const Total& other) {
        in_double -= other.in_double;
        invalid += other.invalid + plus(-other.units);
        return *this;
    }
    double value() const {
        if (invalid > 0) return std::numeric_limits<double>::quiet_NaN();
        return in_double + static_cast<double>(units) * unit;
    }
    // Limbs of 32 bits, of which the last one has the sign, and the count of what did not fit.
    void write(std::int64_t* word) const {
        for (int i = 0; i < 3; ++i)
            word[i] = static_cast<std::int64_t>(units >> 32 * i & 0xffffffff);
        word[3] = static_cast<std::int64_t>(units >> 96);
        word[4] = invalid;
    }
    void read(const std::int64_t* word) {
        units = 0;
        invalid = word[4];
        for (int i = 3; i >= 0; --i) {
            invalid += __builtin_mul_overflow(units, Integer{1} << 32, &units);
            invalid += plus(word[i]);
        }
    }

  private:
    __extension__ typedef __int128 Integer;
    GRIT_INLINE bool plus(Integer more) { return __builtin_add_overflow(units, more, &units); }
    double in_double = 0.0;
    Integer units = 0;
    std::int64_t invalid = 0;
};

}  // namespace grit::mpm
