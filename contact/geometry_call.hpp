// SPDX-License-Identifier: BSD-3-Clause
// What the entry points of normals and distances ask of every call.
#pragma once

#include <cstddef>

#include "support/require.hpp"

#define GRIT_REQUIRE(condition, ...)                                                               \
    if (!(condition)) return failure(error, GRIT_BAD_CALL, -1, __VA_ARGS__)

namespace grit {

inline bool is_finite_number(double x) { return x - x == 0.0; }

// The mask of node i, if it has one.
inline int fixed_of(const int* fixed, std::ptrdiff_t stride, std::ptrdiff_t i) {
    return fixed ? fixed[i * (stride ? stride : 1)] : 0;
}

// Views that are read or written need a base and, for vectors, a stride between components.
template <class View> inline bool usable(const View& view, int components) {
    return view.base && (components == 1 || view.component_stride != 0);
}

}  // namespace grit
