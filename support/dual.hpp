// SPDX-License-Identifier: BSD-3-Clause
// Numbers with derivatives. The value is computed exactly as without them, so a result with derivatives
// has the same bits as one without; comparisons look at the value only.
#pragma once

#include <type_traits>

#include "support/elementary.hpp"

GRIT_KERNEL_BEGIN

// Derivatives of a Plain, one or several directions to a part.
template <class Plain, class Part, int parts> struct Gradient {
    static constexpr int per_part = NumberTraits<Part>::lanes / NumberTraits<Plain>::lanes;
    Part part[parts];

    Gradient() = default;
    // Copied part by part: what is moved as a whole goes in pieces that a load of a part would have to wait for.
    GRIT_INLINE Gradient(const Gradient& x) { *this = x; }
    GRIT_INLINE Gradient& operator=(const Gradient& x) {
        for (int i = 0; i < parts; ++i) part[i] = x.part[i];
        return *this;
    }

    GRIT_INLINE Plain operator[](int i) const {
        if constexpr (per_part == 1) return part[i];
        else return part[i / per_part][i % per_part];
    }
    GRIT_INLINE void set(int i, const Plain& x) {
        if constexpr (per_part == 1) part[i] = x;
        else part[i / per_part].set(i % per_part, x);
    }

    template <class Of> static GRIT_INLINE Gradient each(const Of& of) {
        Gradient r;
        for (int i = 0; i < parts; ++i) r.part[i] = of(i);
        return r;
    }
    // by(i) along direction i.
    template <class By> static GRIT_INLINE Gradient along(const By& by) {
        if constexpr (per_part == 1) return each(by);
        else
            return each([&](int p) {
                return Part::each([&](int lane) { return by(p * per_part + lane); });
            });
    }
    static GRIT_INLINE Gradient zero() {
        return each([](int) { return Part(0.0); });
    }
    friend GRIT_INLINE Gradient operator*(const Gradient& g, const Plain& s) {
        return each([&](int i) { return g.part[i] * Part(s); });
    }
    friend GRIT_INLINE Gradient operator+(const Gradient& a, const Gradient& b) {
        return each([&](int i) { return a.part[i] + b.part[i]; });
    }
    friend GRIT_INLINE Gradient operator-(const Gradient& a, const Gradient& b) {
        return each([&](int i) { return a.part[i] - b.part[i]; });
    }
    // a s + b
    friend GRIT_INLINE Gradient scaled_sum(const Gradient& a, const Plain& s, const Gradient& b) {
        return each([&](int i) { return fma(a.part[i], Part(s), b.part[i]); });
    }
    friend GRIT_INLINE Gradient select(const MaskOf<Plain>& mask, const Gradient& yes,
                                       const Gradient& no) {
        if constexpr (std::is_same_v<Plain, Part>)
            return each([&](int i) { return select(mask, yes.part[i], no.part[i]); });
        else return each([&](int i) { return mask ? yes.part[i] : no.part[i]; });
    }
};

template <class Plain, class Part, int parts> struct DualOf {
    using Derivatives = Gradient<Plain, Part, parts>;
    using Mask = MaskOf<Plain>;
    Plain v;
    Derivatives d;

    DualOf() = default;
    GRIT_INLINE DualOf(const DualOf& x) : v(x.v), d(x.d) {}
    GRIT_INLINE DualOf& operator=(const DualOf& x) {
        v = x.v;
        d = x.d;
        return *this;
    }
    explicit(!std::is_same_v<Plain, double>) GRIT_INLINE DualOf(const Plain& x)
        : v(x), d(Derivatives::zero()) {}
    GRIT_INLINE DualOf(const Plain& x, const Derivatives& g) : v(x), d(g) {}
    static GRIT_INLINE DualOf variable(const Plain& x, int i) {
        DualOf r(x);
        r.d.set(i, 1.0);
        return r;
    }

    friend GRIT_INLINE DualOf operator+(const DualOf& a, const DualOf& b) {
        return {a.v + b.v, a.d + b.d};
    }
    friend GRIT_INLINE DualOf operator+(const DualOf& a, const Plain& b) { return {a.v + b, a.d}; }
    friend GRIT_INLINE DualOf operator+(const Plain& a, const DualOf& b) { return {a + b.v, b.d}; }
    friend GRIT_INLINE DualOf operator-(const DualOf& a, const DualOf& b) {
        return {a.v - b.v, a.d - b.d};
    }
    friend GRIT_INLINE DualOf operator-(const DualOf& a, const Plain& b) { return {a.v - b, a.d}; }
    friend GRIT_INLINE DualOf operator-(const Plain& a, const DualOf& b) {
        return {a - b.v, b.d * -1.0};
    }
    friend GRIT_INLINE DualOf operator-(const DualOf& a) { return {-a.v, a.d * -1.0}; }
    friend GRIT_INLINE DualOf operator*(const DualOf& a, const DualOf& b) {
        return {a.v * b.v, scaled_sum(a.d, b.v, b.d * a.v)};
    }
    friend GRIT_INLINE DualOf operator*(const DualOf& a, const Plain& b) {
        return {a.v * b, a.d * b};
    }
    friend GRIT_INLINE DualOf operator*(const Plain& a, const DualOf& b) {
        return {a * b.v, b.d * a};
    }
    friend GRIT_INLINE DualOf operator/(const DualOf& a, const DualOf& b) {
        const Plain q = a.v / b.v;
        const Plain inverse = 1.0 / b.v;
        return {q, scaled_sum(b.d, -q * inverse, a.d * inverse)};
    }
    friend GRIT_INLINE DualOf operator/(const DualOf& a, const Plain& b) {
        return {a.v / b, a.d * (1.0 / b)};
    }
    friend GRIT_INLINE DualOf operator/(const Plain& a, const DualOf& b) {
        const Plain q = a / b.v;
        return {q, b.d * (-q / b.v)};
    }
    friend GRIT_INLINE Mask operator<(const DualOf& a, const DualOf& b) { return a.v < b.v; }
    friend GRIT_INLINE Mask operator<=(const DualOf& a, const DualOf& b) { return a.v <= b.v; }
    friend GRIT_INLINE Mask operator>(const DualOf& a, const DualOf& b) { return a.v > b.v; }
    friend GRIT_INLINE Mask operator>=(const DualOf& a, const DualOf& b) { return a.v >= b.v; }

    friend GRIT_INLINE Plain value(const DualOf& x) { return x.v; }
    friend GRIT_INLINE DualOf select(const Mask& mask, const DualOf& yes, const DualOf& no) {
        return {select(mask, yes.v, no.v), select(mask, yes.d, no.d)};
    }
    friend GRIT_INLINE DualOf fma(const DualOf& a, const DualOf& b, const DualOf& c) {
        return {fma(a.v, b.v, c.v), scaled_sum(a.d, b.v, scaled_sum(b.d, a.v, c.d))};
    }
    friend GRIT_INLINE DualOf fma(const DualOf& a, const Plain& b, const DualOf& c) {
        return {fma(a.v, b, c.v), scaled_sum(a.d, b, c.d)};
    }
    friend GRIT_INLINE DualOf fma(const Plain& a, const DualOf& b, const DualOf& c) {
        return fma(b, a, c);
    }
    friend GRIT_INLINE DualOf fma(const DualOf& a, const DualOf& b, const Plain& c) {
        return {fma(a.v, b.v, c), scaled_sum(a.d, b.v, b.d * a.v)};
    }
    friend GRIT_INLINE DualOf fma(const DualOf& a, const Plain& b, const Plain& c) {
        return {fma(a.v, b, c), a.d * b};
    }
    friend GRIT_INLINE DualOf fma(const Plain& a, const DualOf& b, const Plain& c) {
        return fma(b, a, c);
    }
    friend GRIT_INLINE DualOf square(const DualOf& x) { return {x.v * x.v, x.d * (2.0 * x.v)}; }
    friend GRIT_INLINE DualOf sqrt(const DualOf& x) {
        const Plain root = sqrt(x.v);
        return {root, x.d * (0.5 / root)};
    }
    friend GRIT_INLINE DualOf fabs(const DualOf& x) {
        return {fabs(x.v), x.d * select(x.v < Plain(0.0), Plain(-1.0), Plain(1.0))};
    }
    friend GRIT_INLINE DualOf exp(const DualOf& x) {
        const Plain y = exp(x.v);
        return {y, x.d * y};
    }
    friend GRIT_INLINE DualOf exp_small(const DualOf& x) {
        const Plain y = exp_small(x.v);
        return {y, x.d * y};
    }
    friend GRIT_INLINE DualOf log(const DualOf& x) { return {log(x.v), x.d * (1.0 / x.v)}; }
};

template <class P, class Part, int parts> struct NumberTraits<DualOf<P, Part, parts>> {
    using Mask = MaskOf<P>;
    using Plain = P;
    static constexpr int lanes = NumberTraits<P>::lanes;
};

// Of a point, along up to eight directions.
using Dual = DualOf<double, Pack<native_lanes>, 8 / native_lanes>;
// Of a function of few numbers, by these.
template <int count> using Partial = DualOf<double, double, count>;

// f(x), f(x, y), differentiated by its few arguments first: the chain rule ends with one sum along the
// directions.
template <class F> GRIT_INLINE Dual chained(const F& f, const Dual& x) {
    const Partial<1> r = f(Partial<1>::variable(x.v, 0));
    return {r.v, x.d * r.d[0]};
}
template <class F, class Part, int parts>
GRIT_INLINE DualOf<double, Part, parts> chained(const F& f, const DualOf<double, Part, parts>& x,
                                                const DualOf<double, Part, parts>& y) {
    const Partial<2> r = f(Partial<2>::variable(x.v, 0), Partial<2>::variable(y.v, 1));
    return {r.v, scaled_sum(x.d, r.d[0], y.d * r.d[1])};
}

GRIT_KERNEL_END
