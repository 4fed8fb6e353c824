// SPDX-License-Identifier: BSD-3-Clause
// Nodes read from and written to the host's arrays, one or a pack at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include <grit/view.h>

#include "contact/nodal/pair_law.hpp"
#include "support/interleaved.hpp"

GRIT_KERNEL_BEGIN

// The nodes that the lanes of one pass hold.
template <int W> struct NodeIndices {
    std::ptrdiff_t at[W];  // idle lanes repeat the first
    int used;
    bool consecutive;  // at[lane] = at[0] + lane, all lanes used
};

template <int W>
GRIT_INLINE NodeIndices<W> node_indices(const std::ptrdiff_t* index, std::ptrdiff_t first,
                                        int used) {
    NodeIndices<W> p;
    p.used = used;
    p.consecutive = !index && used == W;
    for (int lane = 0; lane < W; ++lane) {
        const std::ptrdiff_t i = first + (lane < used ? lane : 0);
        p.at[lane] = index ? index[i] : i;
    }
    return p;
}

template <class Real> inline constexpr int lanes_of = NumberTraits<Real>::lanes;

// The offset of a number of a component is summed before it is added to the base: what lies between need not be
// in the array.
GRIT_INLINE double gather(const double* base, std::ptrdiff_t from, std::ptrdiff_t stride,
                          const NodeIndices<1>& indices, double) {
    return base[from + indices.at[0] * stride];
}
template <int W>
GRIT_INLINE Pack<W> gather(const double* base, std::ptrdiff_t from, std::ptrdiff_t stride,
                           const NodeIndices<W>& indices, Pack<W>) {
    using V = typename Pack<W>::Vector;
    const auto x = [&](int lane) { return base[from + indices.at[lane] * stride]; };
    if constexpr (W == 8) return V{x(0), x(1), x(2), x(3), x(4), x(5), x(6), x(7)};
    else if constexpr (W == 4) return V{x(0), x(1), x(2), x(3)};
    else return V{x(0), x(1)};
}

// x where the mask holds, 0 elsewhere. The compiler may not look behind it: it would compare what the
// other lanes hold, before they are blanked, and a comparison with a NaN can trap.
GRIT_INLINE double where(bool mask, double x) {
    x = select(mask, x, 0.0);
#if defined(__x86_64__)
    __asm__("" : "+x"(x));
#endif
    return x;
}
template <int W> GRIT_INLINE Pack<W> where(const PackMask<W>& mask, Pack<W> x) {
    x = select(mask, x, Pack<W>(0.0));
#if defined(__x86_64__)
    __asm__("" : "+x"(x.v));
#endif
    return x;
}
template <class Mask, class Real, int C>
GRIT_INLINE Vector<Real, C> where(const Mask& mask, const Vector<Real, C>& v) {
    Vector<Real, C> r;
    for (int i = 0; i < C; ++i) r[i] = where(mask, v[i]);
    return r;
}

// Columns are a dozen streams and more, too many for a processor to foresee all of them: what a later pack takes is
// asked for.
constexpr std::ptrdiff_t nodes_ahead = 64;

// An address, not a pointer: it may lie behind the end of the array.
GRIT_INLINE void ask_for(const double* p, std::ptrdiff_t ahead) {
    const auto address = reinterpret_cast<std::uintptr_t>(p);
    const auto bytes = static_cast<std::uintptr_t>(ahead) * sizeof(double);
    __builtin_prefetch(reinterpret_cast<const void*>(address + bytes));
}

template <class Real> inline constexpr bool is_pack = (lanes_of<Real>) != 1;

template <class Real, class View>
GRIT_INLINE Real load(const View& view, int component, const NodeIndices<lanes_of<Real>>& indices) {
    const std::ptrdiff_t from = component * view.component_stride;
    if constexpr (is_pack<Real>)
        if (indices.consecutive && view.point_stride == 1) {
            const double* p = view.base + (from + indices.at[0]);
            Real x;
            __builtin_memcpy(&x.v, p, sizeof x.v);
            ask_for(p, nodes_ahead);
            return x;
        }
    return gather(view.base, from, view.point_stride, indices, Real());
}

// The nodes' vectors lie one behind the other.
template <int C, class Real, class View>
GRIT_INLINE bool interleaved(const View& view, const NodeIndices<lanes_of<Real>>& indices) {
    return is_pack<Real> && indices.consecutive && view.component_stride == 1 &&
           view.point_stride == C;
}

template <int C, class Real, class View>
GRIT_INLINE Vector<Real, C> load_vector(const View& view,
                                        const NodeIndices<lanes_of<Real>>& indices) {
    Vector<Real, C> v;
    if constexpr (is_pack<Real>)
        if (interleaved<C, Real>(view, indices)) {
            load_interleaved(view.base + C * indices.at[0], v.c);
            return v;
        }
    for (int i = 0; i < C; ++i) v[i] = load<Real>(view, i, indices);
    return v;
}

template <class Real>
GRIT_INLINE void store(const Real& x, const grit_mutable_view& view, int component,
                       const NodeIndices<lanes_of<Real>>& indices) {
    const std::ptrdiff_t from = component * view.component_stride;
    if constexpr (is_pack<Real>)
        if (indices.consecutive && view.point_stride == 1) {
            __builtin_memcpy(view.base + (from + indices.at[0]), &x.v, sizeof x.v);
            return;
        }
#pragma GCC unroll 8
    for (int lane = 0; lane < lanes_of<Real>; ++lane)
        if (lane < indices.used)
            view.base[from + indices.at[lane] * view.point_stride] = lane_of(x, lane);
}

template <int C, class Real>
GRIT_INLINE void store_vector(const Vector<Real, C>& v, const grit_mutable_view& view,
                              const NodeIndices<lanes_of<Real>>& indices) {
    if constexpr (is_pack<Real>)
        if (interleaved<C, Real>(view, indices))
            return store_interleaved(v.c, view.base + C * indices.at[0]);
    for (int i = 0; i < C; ++i) store(v[i], view, i, indices);
}

GRIT_KERNEL_END
