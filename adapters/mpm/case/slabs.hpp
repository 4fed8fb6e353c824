// SPDX-License-Identifier: BSD-3-Clause
// Particles along an axis: cells, cut where a body begins or ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "adapters/mpm/kernel/axis.hpp"

namespace grit::mpm {

inline constexpr double roundoff = 1e-9;  // of a length

struct Slab {
    double centre, half;  // [m]
};

// Of the part of an axis between two places.
inline std::vector<Slab> cut(const Axis& axis, double from, double to, int per_cell) {
    std::vector<Slab> out;
    const double least = roundoff * axis.shortest();
    for (int c = 0; c < axis.cells(); ++c) {
        const double cell = axis[c + 1] - axis[c];
        const double begin = std::max(axis[c], from), end = std::min(axis[c + 1], to);
        if (!(end - begin > least)) continue;
        const int n = std::max(1, static_cast<int>(std::lround(per_cell * ((end - begin) / cell))));
        const double half = 0.5 * (end - begin) / n;
        for (int i = 0; i < n; ++i) out.push_back({begin + (2 * i + 1) * half, half});
    }
    return out;
}

}  // namespace grit::mpm
