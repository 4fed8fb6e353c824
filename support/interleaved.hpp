// SPDX-License-Identifier: BSD-3-Clause
// Vectors of 2 or 3 components that lie one behind the other, turned into one pack per component and
// back: W vectors are C packs of memory, moved by shuffles of two packs instead of one number at a time.
#pragma once

#include <utility>

#include "support/pack.hpp"

GRIT_KERNEL_BEGIN

// The lanes of a, then those of b; lane l of the result is number index(l) of them.
template <int W, class Index>
GRIT_INLINE typename Pack<W>::Vector shuffled(const typename Pack<W>::Vector& a,
                                              const typename Pack<W>::Vector& b, Index) {
    return [&]<int... lane>(std::integer_sequence<int, lane...>) {
        return __builtin_shufflevector(a, b, Index()(lane)...);
    }
    (std::make_integer_sequence<int, W>());
}

// Component k of W vectors: number C lane + k of the packs in memory.
template <int C, int W, int k>
GRIT_INLINE Pack<W> component_of(const typename Pack<W>::Vector (&memory)[C]) {
    const auto low =
        shuffled<W>(memory[0], memory[1], [](int l) { return C * l + k < 2 * W ? C * l + k : 0; });
    if constexpr (C == 2) return low;
    else
        return shuffled<W>(low, memory[2],
                           [](int l) { return C * l + k < 2 * W ? l : C * l + k - W; });
}

// Pack j of the memory: number W j + lane is component (W j + lane) % C of vector (W j + lane) / C.
template <int C, int W, int j> GRIT_INLINE Pack<W> memory_of(const Pack<W> (&component)[C]) {
    const auto low = shuffled<W>(component[0].v, component[1].v, [](int l) {
        const int vector = (W * j + l) / C, c = (W * j + l) % C;
        return c == 0 ? vector : c == 1 ? W + vector : 0;
    });
    if constexpr (C == 2) return low;
    else
        return shuffled<W>(low, component[2].v,
                           [](int l) { return (W * j + l) % C < 2 ? l : W + (W * j + l) / C; });
}

template <int C, int W>
GRIT_INLINE void load_interleaved(const double* p, Pack<W> (&component)[C]) {
    typename Pack<W>::Vector memory[C];
    __builtin_memcpy(memory, p, sizeof memory);
    component[0] = component_of<C, W, 0>(memory);
    component[1] = component_of<C, W, 1>(memory);
    if constexpr (C == 3) component[2] = component_of<C, W, 2>(memory);
}

template <int C, int W>
GRIT_INLINE void store_interleaved(const Pack<W> (&component)[C], double* p) {
    Pack<W> memory[C];
    memory[0] = memory_of<C, W, 0>(component);
    memory[1] = memory_of<C, W, 1>(component);
    if constexpr (C == 3) memory[2] = memory_of<C, W, 2>(component);
    __builtin_memcpy(p, memory, sizeof memory);
}

GRIT_KERNEL_END
