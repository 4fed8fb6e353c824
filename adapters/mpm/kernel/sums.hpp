// SPDX-License-Identifier: BSD-3-Clause
// How a contribution is added to a node: in double, or in fixed point, where no order matters.
#pragma once

#include "adapters/mpm/kernel/call.hpp"
#include "adapters/mpm/kernel/record_lanes.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

struct DoubleSums {
    NodeRecord* nodes;
    GRIT_INLINE void add(std::ptrdiff_t node, const Vec8& x) {
        *reinterpret_cast<Vec8*>(nodes + node) += x;
    }
};

// The largest of many sizes; no number if one of them is none: no comparison sees that, a sum keeps it.
template <int lanes> struct LargestSizes {
    using Vec = typename grit::GRIT_TARGET::VectorTypes<lanes>::RealInPlace;
    Vec size{}, sum{};

    GRIT_INLINE void add(const Vec& x) {
        size = x > size ? x : size;
        sum += x;
    }
    GRIT_INLINE double operator[](int c) const { return sum[c] == sum[c] ? size[c] : sum[c]; }
};

// x scale, rounded to an integer by the addition of 1.5 2^52, which leaves the integer in the last bits. Without
// sign: sums that are too large wrap, and are done again with another scale.
template <int lanes> struct FixedSumsOf {
    using Vec = typename grit::GRIT_TARGET::VectorTypes<lanes>::RealInPlace;
    using Integers = typename grit::GRIT_TARGET::VectorTypes<lanes>::UnsignedInPlace;
    static constexpr double magic = 0x1.8p52;
    IntegersOf<lanes>* nodes;
    Vec scale;
    LargestSizes<lanes> largest;

    explicit GRIT_INLINE FixedSumsOf(const FixedPointOf<lanes>& to)
        : nodes(to.nodes), scale{}, largest{} {
        for (int c = 0; c < lanes; ++c) scale[c] = to.scale[c];
    }
    GRIT_INLINE void tell_largest(FixedPointOf<lanes>& to) const {
        for (int c = 0; c < lanes; ++c) to.largest[c] = largest[c];
    }
    GRIT_INLINE void add(std::ptrdiff_t node, const Vec& x) {
        const Vec scaled = x * scale;
        largest.add(scaled < 0.0 ? -scaled : scaled);
        const Vec shifted = scaled + magic, zero = Vec{} + magic;
        *reinterpret_cast<Integers*>(nodes + node) +=
            reinterpret_cast<const Integers&>(shifted) - reinterpret_cast<const Integers&>(zero);
    }
};
using FixedSums = FixedSumsOf<record::size>;

// work(sums), which adds contributions.
template <int lanes, class Work>
GRIT_INLINE void add_in_fixed_point(FixedPointOf<lanes>& to, const Work& work) {
    FixedSumsOf<lanes> sums(to);
    work(sums);
    sums.tell_largest(to);
}

GRIT_KERNEL_END
