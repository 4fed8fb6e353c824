// SPDX-License-Identifier: BSD-3-Clause
// Particles along an axis: cells, cut where a body begins or ends; how many a body may have.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "adapters/mpm/kernel/axis.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {

inline constexpr double roundoff = 1e-9;       // of a length
inline constexpr double most_particles = 1e8;  // of a body, beside its shapes too

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

// Before the memory is asked for: throws std::invalid_argument.
inline void check_particles(double asked, const std::string& body) {
    if (asked > most_particles)
        throw std::invalid_argument("body " + body + ": its outlines would be filled with " +
                                    text(asked) + " particles, at most " + text(most_particles) +
                                    " are possible");
}

}  // namespace grit::mpm
