// SPDX-License-Identifier: BSD-3-Clause
// exp and log: the same operations for scalar and pack, so that a lane gives the bits of the scalar.
// Accurate to about 1 ulp; the kernels never leave the ranges stated.
#pragma once

#include "support/pack.hpp"

GRIT_KERNEL_BEGIN

// exp(x) for finite x; arguments are clamped to [-700, 700].
// Cody & Waite reduction x = k ln 2 + r, |r| <= ln 2 / 2, Taylor series to degree 13.
template <class Plain> GRIT_INLINE Plain exp_plain(Plain x) {
    x = min(max(x, Plain(-700.0)), Plain(700.0));
    const Plain magic(0x1.8p52);
    const Plain k = fma(x, Plain(0x1.71547652b82fep+0), magic) - magic;
    Plain r = fma(k, Plain(-0x1.62e42fee00000p-1), x);
    r = fma(k, Plain(-0x1.a39ef35793c76p-33), r);
    const Plain r2 = r * r;
    const Plain r4 = r2 * r2;
    // Estrin's scheme over 1/2! ... 1/13!
    const Plain a = fma(r, Plain(1.0 / 6.0), Plain(0.5));
    const Plain b = fma(r, Plain(1.0 / 120.0), Plain(1.0 / 24.0));
    const Plain c = fma(r, Plain(1.0 / 5040.0), Plain(1.0 / 720.0));
    const Plain d = fma(r, Plain(1.0 / 362880.0), Plain(1.0 / 40320.0));
    const Plain f = fma(r, Plain(1.0 / 39916800.0), Plain(1.0 / 3628800.0));
    const Plain g = fma(r, Plain(1.0 / 6227020800.0), Plain(1.0 / 479001600.0));
    const Plain low = fma(r2, b, a);
    const Plain mid = fma(r2, d, c);
    const Plain high = fma(r2, g, f);
    const Plain tail = fma(r4, fma(r4, high, mid), low);
    return (Plain(1.0) + fma(r2, tail, r)) * exp2_integer(k);
}

// exp(x) for |x| <= 0.35, the volumetric strain of an increment: Taylor series to degree 12.
template <class Real> GRIT_INLINE Real exp_small(const Real& x) {
    const Real x_2 = x * x;
    const Real x_4 = x_2 * x_2;
    const auto pair = [&](double low, double high) {
        return fma(x, Real(1.0 / high), Real(1.0 / low));
    };
    const Real a = fma(x_2, pair(24.0, 120.0), pair(2.0, 6.0));
    const Real b = fma(x_2, pair(40320.0, 362880.0), pair(720.0, 5040.0));
    const Real c = fma(x_2, Real(1.0 / 479001600.0), pair(3628800.0, 39916800.0));
    return Real(1.0) + fma(x_2, fma(x_4, fma(x_4, c, b), a), x);
}

// log(x) for positive normal x: x = m 2^k, log m = 2 artanh(s), s = (m - 1)/(m + 1).
template <class Plain> GRIT_INLINE Plain log_plain(Plain x) {
    const Plain k = split_exponent(x);
    const Plain f = x - Plain(1.0);
    const Plain s = f / (Plain(2.0) + f);
    const Plain z = s * s;
    const Plain z2 = z * z;
    const Plain z4 = z2 * z2;
    const Plain a = fma(z, Plain(2.0 / 5.0), Plain(2.0 / 3.0));
    const Plain b = fma(z, Plain(2.0 / 9.0), Plain(2.0 / 7.0));
    const Plain c = fma(z, Plain(2.0 / 13.0), Plain(2.0 / 11.0));
    const Plain d = fma(z, Plain(2.0 / 17.0), Plain(2.0 / 15.0));
    const Plain g = fma(z, Plain(2.0 / 21.0), Plain(2.0 / 19.0));
    const Plain series = fma(z4, fma(z4, g, fma(z2, d, c)), fma(z2, b, a));
    const Plain half_square = Plain(0.5) * f * f;
    const Plain tail =
        s * fma(z, series, half_square);  // log m = f - (f^2/2 - s (f^2/2 + z series))
    const Plain low = fma(k, Plain(0x1.a39ef35793c76p-33), tail);
    return fma(k, Plain(0x1.62e42fee00000p-1), f - (half_square - low));
}

GRIT_INLINE double exp(double x) { return exp_plain(x); }
GRIT_INLINE double log(double x) { return log_plain(x); }
template <int W> GRIT_INLINE Pack<W> exp(Pack<W> x) { return exp_plain(x); }
template <int W> GRIT_INLINE Pack<W> log(Pack<W> x) { return log_plain(x); }

GRIT_KERNEL_END
