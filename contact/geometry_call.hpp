// SPDX-License-Identifier: BSD-3-Clause
// What the entry points of normals and distances ask of every call.
#pragma once

#include <cstddef>

#include "support/require.hpp"
#include "support/views.hpp"

namespace grit {

inline bool is_finite_number(double x) { return x - x == 0.0; }

// The mask of node i, if it has one.
inline int fixed_of(const int* fixed, std::ptrdiff_t stride, std::ptrdiff_t i) {
    return fixed ? fixed[i * (stride ? stride : 1)] : 0;
}

}  // namespace grit
