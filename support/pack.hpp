// SPDX-License-Identifier: BSD-3-Clause
// Pack<W>: W doubles that take the same path through a kernel, on GCC vector extensions.
// Every operation is lane-wise and IEEE, so a lane's result is that of the plain double.
#pragma once

#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "support/lanes.hpp"
#include "support/number.hpp"

GRIT_KERNEL_BEGIN

#if defined(__AVX512F__)
constexpr int native_lanes = 8;
#elif defined(__AVX2__)
constexpr int native_lanes = 4;
#else
constexpr int native_lanes = 2;
#endif

template <int W> struct PackMask {
    using Vector = typename VectorTypes<W>::Bits;
    Vector v;  // all bits set or none, lane by lane
    PackMask() = default;
    GRIT_INLINE PackMask(Vector vector) : v(vector) {}
    GRIT_INLINE PackMask(bool b) : v(Vector{} - static_cast<std::int64_t>(b)) {}
    GRIT_INLINE bool operator[](int lane) const { return v[lane] != 0; }
    GRIT_INLINE void set(int lane, bool b) { v[lane] = -static_cast<std::int64_t>(b); }
    friend GRIT_INLINE PackMask operator&(PackMask a, PackMask b) { return a.v & b.v; }
    friend GRIT_INLINE PackMask operator|(PackMask a, PackMask b) { return a.v | b.v; }
    friend GRIT_INLINE PackMask operator!(PackMask a) { return ~a.v; }
};

template <int W> struct Pack {
    using Vector = typename VectorTypes<W>::Real;
    using Mask = PackMask<W>;
    Vector v;
    Pack() = default;
    GRIT_INLINE Pack(Vector vector) : v(vector) {}
    GRIT_INLINE Pack(double x) : v(x - Vector{}) {}  // -0 stays -0
    GRIT_INLINE double operator[](int lane) const { return v[lane]; }
    GRIT_INLINE void set(int lane, double x) { v[lane] = x; }
    // of(lane) in every lane.
    template <class Of> static GRIT_INLINE Pack each(const Of& of) {
        return each(of, std::make_integer_sequence<int, W>());
    }

    friend GRIT_INLINE Pack operator+(Pack a, Pack b) { return a.v + b.v; }
    friend GRIT_INLINE Pack operator-(Pack a, Pack b) { return a.v - b.v; }
    friend GRIT_INLINE Pack operator*(Pack a, Pack b) { return a.v * b.v; }
    friend GRIT_INLINE Pack operator/(Pack a, Pack b) { return a.v / b.v; }
    friend GRIT_INLINE Pack operator-(Pack a) { return -a.v; }
    friend GRIT_INLINE Pack fma(Pack a, Pack b, Pack c) { return fused(a.v, b.v, c.v); }
    friend GRIT_INLINE Mask operator<(Pack a, Pack b) { return a.v < b.v; }
    friend GRIT_INLINE Mask operator<=(Pack a, Pack b) { return a.v <= b.v; }
    friend GRIT_INLINE Mask operator>(Pack a, Pack b) { return a.v > b.v; }
    friend GRIT_INLINE Mask operator>=(Pack a, Pack b) { return a.v >= b.v; }

  private:
    template <class Of, int... lane>
    static GRIT_INLINE Pack each(const Of& of, std::integer_sequence<int, lane...>) {
        return Vector{of(lane)...};
    }
    static GRIT_INLINE Vector fused(Vector a, Vector b, Vector c) {
#if defined(__AVX512F__)
        if constexpr (W == 8) return (Vector)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#endif
#if defined(__FMA__)
        if constexpr (W == 4) return (Vector)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#endif
        Vector sum{};
        for (int lane = 0; lane < W; ++lane)
            sum[lane] = grit::GRIT_TARGET::fma(a[lane], b[lane], c[lane]);
        return sum;
    }
};

template <int W> struct NumberTraits<Pack<W>> {
    using Mask = PackMask<W>;
    using Plain = Pack<W>;
    static constexpr int lanes = W;
};

template <int W> GRIT_INLINE Pack<W> select(PackMask<W> mask, Pack<W> yes, Pack<W> no) {
    return mask.v ? yes.v : no.v;
}
template <int W> GRIT_INLINE PackMask<W> select(PackMask<W> mask, PackMask<W> yes, PackMask<W> no) {
    return mask.v ? yes.v : no.v;
}
template <int W> GRIT_INLINE Pack<W> value(Pack<W> x) { return x; }

// The first count of W numbers one behind the other; the others are 0.
template <int W> GRIT_INLINE Pack<W> load_first(const double* from, int count) {
#if defined(__AVX512F__)
    if constexpr (W == 8)
        return typename Pack<W>::Vector(
            _mm512_maskz_loadu_pd(static_cast<__mmask8>((1U << count) - 1U), from));
#endif
    return Pack<W>::each([&](int lane) { return lane < count ? from[lane] : 0.0; });
}
// What lies behind them is left alone.
template <int W> GRIT_INLINE void store_first(double* to, int count, const Pack<W>& x) {
#if defined(__AVX512F__)
    if constexpr (W == 8)
        return _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1U << count) - 1U), (__m512d)x.v);
#endif
    for (int lane = 0; lane < count; ++lane) to[lane] = x[lane];
}

template <int W> GRIT_INLINE bool any(PackMask<W> mask) {
#if defined(__AVX512F__)
    if constexpr (W == 8) return _mm512_test_epi64_mask((__m512i)mask.v, (__m512i)mask.v) != 0;
#endif
#if defined(__AVX2__)
    if constexpr (W == 4) return _mm256_testz_si256((__m256i)mask.v, (__m256i)mask.v) == 0;
#endif
    std::int64_t bits = 0;
    for (int lane = 0; lane < W; ++lane) bits |= mask.v[lane];
    return bits != 0;
}

template <int W> GRIT_INLINE Pack<W> sqrt(Pack<W> x) {
#if defined(__AVX512F__)
    if constexpr (W == 8) return typename Pack<W>::Vector(_mm512_sqrt_pd((__m512d)x.v));
#endif
#if defined(__AVX2__)
    if constexpr (W == 4) return typename Pack<W>::Vector(_mm256_sqrt_pd((__m256d)x.v));
#endif
#if defined(__SSE2__)
    if constexpr (W == 2) return typename Pack<W>::Vector(_mm_sqrt_pd((__m128d)x.v));
#endif
    Pack<W> root(0.0);
    for (int lane = 0; lane < W; ++lane) root.v[lane] = __builtin_sqrt(x.v[lane]);
    return root;
}

template <int W> GRIT_INLINE Pack<W> fabs(Pack<W> x) {
    using Bits = typename PackMask<W>::Vector;
    return (typename Pack<W>::Vector)((Bits)x.v & (Bits{} + 0x7fffffffffffffffLL));
}

template <int W> GRIT_INLINE Pack<W> exp2_integer(Pack<W> k) {
    using Bits = typename PackMask<W>::Vector;
    // k + 1.5 2^52 carries the integer in its low bits: no conversion instruction needed.
    const Bits shifted = (Bits)((k + Pack<W>(0x1.8p52 + 1023.0)).v);
    return (typename Pack<W>::Vector)(shifted << 52);
}

template <int W> GRIT_INLINE Pack<W> split_exponent(Pack<W>& x) {
    // Unsigned, so that lanes that are not asked for may hold anything. Biased by 2048 octaves so that a
    // logical shift serves where there is no 64-bit arithmetic one.
    using Unsigned = typename VectorTypes<W>::Unsigned;
    const Unsigned bits = (Unsigned)x.v;
    const Unsigned shifted = bits - 0x3fe6a09e667f3bcdULL + (2048ULL << 52);
    const Unsigned k = shifted >> 52;  // in [0, 4096)
    x = Pack<W>((typename Pack<W>::Vector)(bits - ((k - 2048ULL) << 52)));
    const auto magic = (typename Pack<W>::Vector)(k + 0x4330000000000000ULL);  // 2^52 + k
    return Pack<W>(magic) - Pack<W>(0x1p52 + 2048.0);
}

// A lane; a number has one.
GRIT_INLINE void set_lane(double& x, int, double value) { x = value; }
template <int W> GRIT_INLINE void set_lane(Pack<W>& x, int lane, double value) {
    x.set(lane, value);
}
GRIT_INLINE double lane_of(double x, int) { return x; }
template <int W> GRIT_INLINE double lane_of(const Pack<W>& x, int lane) { return x[lane]; }
GRIT_INLINE bool lane_of(bool x, int) { return x; }
template <int W> GRIT_INLINE bool lane_of(const PackMask<W>& x, int lane) { return x[lane]; }

GRIT_KERNEL_END
