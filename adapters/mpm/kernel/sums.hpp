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
struct LargestSizes {
    Vec8 size{}, sum{};

    GRIT_INLINE void add(const Vec8& x) {
        size = x > size ? x : size;
        sum += x;
    }
    GRIT_INLINE double operator[](int c) const { return sum[c] == sum[c] ? size[c] : sum[c]; }
};

// x scale, rounded to an integer by the addition of 1.5 2^52, which leaves the integer in the last bits. Without
// sign: sums that are too large wrap, and are done again with another scale.
struct FixedSums {
    static constexpr double magic = 0x1.8p52;
    NodeIntegers* nodes;
    Vec8 scale;
    LargestSizes largest;

    GRIT_INLINE void add(std::ptrdiff_t node, const Vec8& x) {
        const Vec8 scaled = x * scale;
        largest.add(scaled < 0.0 ? -scaled : scaled);
        const Vec8 shifted = scaled + magic, zero = Vec8{} + magic;
        *reinterpret_cast<Integers*>(nodes + node) +=
            reinterpret_cast<const Integers&>(shifted) - reinterpret_cast<const Integers&>(zero);
    }
};

// work(sums), which adds contributions.
template <class Work> GRIT_INLINE void add_in_fixed_point(FixedPoint& to, const Work& work) {
    FixedSums sums{to.nodes, {}, {}};
    for (int c = 0; c < record::size; ++c) sums.scale[c] = to.scale[c];
    work(sums);
    for (int c = 0; c < record::size; ++c) to.largest[c] = sums.largest[c];
}

GRIT_KERNEL_END
