// SPDX-License-Identifier: BSD-3-Clause
// Views, lists, masks and switches as a host passes them: how they are read, and whether they can be used. Kernels
// ask the same questions as the C entries (call_checks.hpp puts the answers into words): nothing here is left to the
// linker to merge (kernel.hpp).
#pragma once

#include <cstddef>

#include <grit/view.h>

#include "support/kernel.hpp"

namespace grit {

GRIT_INLINE double component(const grit_view& view, std::ptrdiff_t i, std::ptrdiff_t c) {
    return view.base[i * view.point_stride + c * view.component_stride];
}
GRIT_INLINE double& component(const grit_mutable_view& view, std::ptrdiff_t i, std::ptrdiff_t c) {
    return view.base[i * view.point_stride + c * view.component_stride];
}

// Integers with a stride of their own; 0: one behind the other.
GRIT_INLINE std::ptrdiff_t integer_stride(std::ptrdiff_t given) { return given ? given : 1; }
GRIT_INLINE int integer_at(const int* list, std::ptrdiff_t stride, std::ptrdiff_t i) {
    return list[i * integer_stride(stride)];
}
// The mask of a node, if it has one.
GRIT_INLINE int mask_at(const int* list, std::ptrdiff_t stride, std::ptrdiff_t i) {
    return list ? integer_at(list, stride, i) : 0;
}

GRIT_INLINE bool is_switch(int x) { return x == 0 || x == 1; }

GRIT_INLINE bool is_finite(double x) { return x - x == 0.0; }

GRIT_INLINE bool are_finite(const double* x, int n) {
    double sum = 0.0;  // 0 x is 0 for a finite x, NaN otherwise
    for (int i = 0; i < n; ++i) sum += 0.0 * x[i];
    return sum == 0.0;
}

// 0 if all of them are finite.
GRIT_INLINE int first_not_finite(const double* x, int n) {
    for (int i = 0; i < n; ++i)
        if (!is_finite(x[i])) return i;
    return 0;
}

// Something of which there are n.
GRIT_INLINE bool is_index(std::ptrdiff_t i, std::ptrdiff_t n) { return i >= 0 && i < n; }

// The entries first ... last-1 of a list.
GRIT_INLINE bool is_range(std::ptrdiff_t first, std::ptrdiff_t last) {
    return first >= 0 && first <= last;
}

// One bit per component.
GRIT_INLINE bool is_mask(int bits, int components) { return bits >= 0 && bits < 1 << components; }

// Views that are read or written need a base and, for vectors, a stride between components.
template <class View> GRIT_INLINE bool has_components(const View& view, std::ptrdiff_t components) {
    return components == 1 || view.component_stride != 0;
}
template <class View> GRIT_INLINE bool is_usable(const View& view, std::ptrdiff_t components) {
    return view.base && has_components(view, components);
}
template <class MatrixView> GRIT_INLINE bool has_entries(const MatrixView& view) {
    return view.row_stride != 0 && view.column_stride != 0;
}

// What is written, if at all, for n points: each has its place.
template <class View> GRIT_INLINE bool has_points(const View& view, std::ptrdiff_t n) {
    return !view.base || n <= 1 || view.point_stride != 0;
}

// Do two of the numbers of n points, each of so many components, lie at the same place?
GRIT_INLINE bool overlaps_itself(const grit_mutable_view& view, std::ptrdiff_t components,
                                 std::ptrdiff_t n) {
    const std::ptrdiff_t point = view.point_stride, step = view.component_stride;
    if (components > 1 && step == 0) return true;
    if (n > 1 && point == 0) return true;
    for (std::ptrdiff_t c = 1; c < components && n > 1; ++c) {
        const std::ptrdiff_t apart = step * c / point;
        if (step * c % point == 0 && apart < n && apart > -n) return true;
    }
    return false;
}

}  // namespace grit
