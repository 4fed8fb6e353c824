// SPDX-License-Identifier: BSD-3-Clause
// Views as the C entry points read and judge them.
#pragma once

#include <cstddef>

#include <grit/view.h>

#include "support/require.hpp"

namespace grit {

inline bool is_switch(int x) { return x == 0 || x == 1; }

inline double component(const grit_view& view, std::ptrdiff_t i, std::ptrdiff_t c) {
    return view.base[i * view.point_stride + c * view.component_stride];
}
inline double& component(const grit_mutable_view& view, std::ptrdiff_t i, std::ptrdiff_t c) {
    return view.base[i * view.point_stride + c * view.component_stride];
}

// Views that are read or written need a base and, for vectors, a stride between components.
template <class View> inline bool usable(const View& view, std::ptrdiff_t components) {
    return view.base && (components == 1 || view.component_stride != 0);
}
template <class View>
inline grit_status check_usable(const View& view, std::ptrdiff_t components, const char* name,
                                grit_error* error) {
    GRIT_REQUIRE(usable(view, components), "%s needs a base pointer and a component_stride", name);
    return GRIT_OK;
}

// What is written for several points, by name as what: nodes, points.
template <class View>
inline grit_status check_written(const View& view, std::ptrdiff_t n, const char* name,
                                 const char* what, grit_error* error) {
    GRIT_REQUIRE(!view.base || n <= 1 || view.point_stride != 0,
                 "%s is written: point_stride must not be 0 for %td %s", name, n, what);
    return GRIT_OK;
}

// Do two of the numbers of n points, each of so many components, lie at the same place?
inline bool overlaps_itself(const grit_mutable_view& view, std::ptrdiff_t components,
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
