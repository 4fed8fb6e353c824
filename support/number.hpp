// SPDX-License-Identifier: BSD-3-Clause
// The operations a kernel may use on a number, for plain double. pack.hpp and dual.hpp give the same
// names to several points at once and to a value with its derivatives.
#pragma once

#include <bit>
#include <cstdint>

#include "support/kernel.hpp"

GRIT_KERNEL_BEGIN

// a b + c: fused where the instruction set has it, the same for scalars and packs of one target.
GRIT_INLINE double fma(double a, double b, double c) {
#ifdef __FMA__
    return __builtin_fma(a, b, c);
#else
    return a * b + c;
#endif
}

GRIT_INLINE double sqrt(double x) { return __builtin_sqrt(x); }
GRIT_INLINE double fabs(double x) { return __builtin_fabs(x); }
GRIT_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }
GRIT_INLINE bool select(bool mask, bool yes, bool no) { return mask ? yes : no; }
GRIT_INLINE bool any(bool mask) { return mask; }
GRIT_INLINE double value(double x) { return x; }

// 2^k for an integral-valued k in [-1022, 1023].
GRIT_INLINE double exp2_integer(double k) {
    // k + 1.5 2^52 carries the integer in its low bits: no conversion that a NaN could break.
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(k + (0x1.8p52 + 1023.0)) << 52);
}

// x = m 2^k with m in [1/sqrt 2, sqrt 2): returns k, leaves m in x. x must be positive and normal.
GRIT_INLINE double split_exponent(double& x) {
    constexpr std::uint64_t half_root = 0x3fe6a09e667f3bcdULL;  // 1/sqrt 2
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::int64_t k = static_cast<std::int64_t>(bits - half_root) >> 52;
    x = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k) << 52));
    return static_cast<double>(k);
}

// How a kernel names the mask and the plain number that go with a number type.
template <class Real> struct NumberTraits {
    using Mask = bool;
    using Plain = double;
    static constexpr int lanes = 1;
};

template <class Real> using MaskOf = typename NumberTraits<Real>::Mask;
template <class Real> using PlainOf = typename NumberTraits<Real>::Plain;

template <class Real> GRIT_INLINE Real min(const Real& a, const Real& b) {
    return select(b < a, b, a);
}
template <class Real> GRIT_INLINE Real max(const Real& a, const Real& b) {
    return select(a < b, b, a);
}
template <class Real> GRIT_INLINE Real square(const Real& x) { return x * x; }

// to = x where the mask holds.
template <class T> GRIT_INLINE void assign(bool where, T& to, const T& x) {
    if (where) to = x;
}
template <class Mask, class T> GRIT_INLINE void assign(const Mask& where, T& to, const T& x) {
    to = select(where, x, to);
}

// f(x), f(x, y): dual.hpp has a shorter way to their derivatives.
template <class F, class Real> GRIT_INLINE Real chained(const F& f, const Real& x) { return f(x); }
template <class F, class Real> GRIT_INLINE Real chained(const F& f, const Real& x, const Real& y) {
    return f(x, y);
}

GRIT_KERNEL_END
