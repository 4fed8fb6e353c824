// SPDX-License-Identifier: BSD-3-Clause
// Dual: a value and its derivatives by the (up to eight) inputs of a point.
// The value is computed exactly as a plain double is, so a result with derivatives has the same bits
// as one without; comparisons look at the value only.
#pragma once

#include "support/elementary.hpp"

GRIT_KERNEL_BEGIN

struct Gradient {
    static constexpr int size = 8;
    static constexpr int parts = size / native_lanes;
    Pack<native_lanes> part[parts];

    GRIT_INLINE double operator[](int i) const { return part[i / native_lanes][i % native_lanes]; }
    GRIT_INLINE void set(int i, double x) { part[i / native_lanes].set(i % native_lanes, x); }

    static GRIT_INLINE Gradient zero() {
        Gradient g;
        for (auto& p : g.part) p = Pack<native_lanes>(0.0);
        return g;
    }
    friend GRIT_INLINE Gradient operator*(const Gradient& g, double s) {
        Gradient r;
        for (int i = 0; i < parts; ++i) r.part[i] = g.part[i] * Pack<native_lanes>(s);
        return r;
    }
    friend GRIT_INLINE Gradient operator+(const Gradient& a, const Gradient& b) {
        Gradient r;
        for (int i = 0; i < parts; ++i) r.part[i] = a.part[i] + b.part[i];
        return r;
    }
    friend GRIT_INLINE Gradient operator-(const Gradient& a, const Gradient& b) {
        Gradient r;
        for (int i = 0; i < parts; ++i) r.part[i] = a.part[i] - b.part[i];
        return r;
    }
    // a s + b
    friend GRIT_INLINE Gradient scaled_sum(const Gradient& a, double s, const Gradient& b) {
        Gradient r;
        for (int i = 0; i < parts; ++i)
            r.part[i] = fma(a.part[i], Pack<native_lanes>(s), b.part[i]);
        return r;
    }
};

struct Dual {
    double v;
    Gradient d;

    Dual() = default;
    GRIT_INLINE Dual(double x) : v(x), d(Gradient::zero()) {}
    GRIT_INLINE Dual(double x, const Gradient& g) : v(x), d(g) {}
    static GRIT_INLINE Dual variable(double x, int i) {
        Dual r(x);
        r.d.set(i, 1.0);
        return r;
    }

    friend GRIT_INLINE Dual operator+(const Dual& a, const Dual& b) {
        return {a.v + b.v, a.d + b.d};
    }
    friend GRIT_INLINE Dual operator+(const Dual& a, double b) { return {a.v + b, a.d}; }
    friend GRIT_INLINE Dual operator+(double a, const Dual& b) { return {a + b.v, b.d}; }
    friend GRIT_INLINE Dual operator-(const Dual& a, const Dual& b) {
        return {a.v - b.v, a.d - b.d};
    }
    friend GRIT_INLINE Dual operator-(const Dual& a, double b) { return {a.v - b, a.d}; }
    friend GRIT_INLINE Dual operator-(double a, const Dual& b) { return {a - b.v, b.d * -1.0}; }
    friend GRIT_INLINE Dual operator-(const Dual& a) { return {-a.v, a.d * -1.0}; }
    friend GRIT_INLINE Dual operator*(const Dual& a, const Dual& b) {
        return {a.v * b.v, scaled_sum(a.d, b.v, b.d * a.v)};
    }
    friend GRIT_INLINE Dual operator*(const Dual& a, double b) { return {a.v * b, a.d * b}; }
    friend GRIT_INLINE Dual operator*(double a, const Dual& b) { return {a * b.v, b.d * a}; }
    friend GRIT_INLINE Dual operator/(const Dual& a, const Dual& b) {
        const double q = a.v / b.v;
        const double inverse = 1.0 / b.v;
        return {q, scaled_sum(b.d, -q * inverse, a.d * inverse)};
    }
    friend GRIT_INLINE Dual operator/(const Dual& a, double b) {
        return {a.v / b, a.d * (1.0 / b)};
    }
    friend GRIT_INLINE Dual operator/(double a, const Dual& b) {
        const double q = a / b.v;
        return {q, b.d * (-q / b.v)};
    }
    friend GRIT_INLINE bool operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
    friend GRIT_INLINE bool operator<=(const Dual& a, const Dual& b) { return a.v <= b.v; }
    friend GRIT_INLINE bool operator>(const Dual& a, const Dual& b) { return a.v > b.v; }
    friend GRIT_INLINE bool operator>=(const Dual& a, const Dual& b) { return a.v >= b.v; }
};

template <> struct NumberTraits<Dual> {
    using Mask = bool;
    using Plain = double;
    static constexpr int lanes = 1;
};

GRIT_INLINE double value(const Dual& x) { return x.v; }
GRIT_INLINE Dual select(bool mask, const Dual& yes, const Dual& no) {
    Dual r;
    r.v = mask ? yes.v : no.v;
    for (int i = 0; i < Gradient::parts; ++i) r.d.part[i] = mask ? yes.d.part[i] : no.d.part[i];
    return r;
}
GRIT_INLINE Dual fma(const Dual& a, const Dual& b, const Dual& c) {
    return {fma(a.v, b.v, c.v), scaled_sum(a.d, b.v, scaled_sum(b.d, a.v, c.d))};
}
GRIT_INLINE Dual fma(const Dual& a, double b, const Dual& c) {
    return {fma(a.v, b, c.v), scaled_sum(a.d, b, c.d)};
}
GRIT_INLINE Dual fma(double a, const Dual& b, const Dual& c) { return fma(b, a, c); }
GRIT_INLINE Dual fma(const Dual& a, const Dual& b, double c) {
    return {fma(a.v, b.v, c), scaled_sum(a.d, b.v, b.d * a.v)};
}
GRIT_INLINE Dual fma(const Dual& a, double b, double c) { return {fma(a.v, b, c), a.d * b}; }
GRIT_INLINE Dual sqrt(const Dual& x) {
    const double root = sqrt(x.v);
    return {root, x.d * (0.5 / root)};
}
GRIT_INLINE Dual fabs(const Dual& x) { return {fabs(x.v), x.d * (x.v < 0.0 ? -1.0 : 1.0)}; }
GRIT_INLINE Dual exp(const Dual& x) {
    const double y = exp(x.v);
    return {y, x.d * y};
}
GRIT_INLINE Dual log(const Dual& x) { return {log(x.v), x.d * (1.0 / x.v)}; }

GRIT_KERNEL_END
