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

// Of the part of an axis between two places. What a body has of a cell and is a sliver belongs to its particles in the cell
// beside it: nodes beyond that are reached by slivers alone have no step that cells allow.
inline std::vector<Slab> cut(const Axis& axis, double from, double to, int per_cell) {
    struct Piece {
        double begin, end, cells;
        bool is_sliver;
    };
    std::vector<Piece> pieces;
    const double least = roundoff * axis.shortest(),
                 sliver = (1.0 - 1e-6) * std::min(0.25, 0.5 / per_cell);
    for (int c = 0; c < axis.cells(); ++c) {
        const double cell = axis[c + 1] - axis[c];
        const double begin = std::max(axis[c], from), end = std::min(axis[c + 1], to);
        if (!(end - begin > least)) continue;
        const double share = (end - begin) / cell;
        const bool is_sliver = share < sliver;
        if (!pieces.empty() && (is_sliver || pieces.back().is_sliver))
            pieces.back() = {pieces.back().begin, end, pieces.back().cells + share, false};
        else pieces.push_back({begin, end, share, is_sliver});
    }
    std::vector<Slab> out;
    for (const Piece& piece : pieces) {
        const int n = std::max(1, static_cast<int>(std::lround(per_cell * piece.cells)));
        const double half = 0.5 * (piece.end - piece.begin) / n;
        for (int i = 0; i < n; ++i) out.push_back({piece.begin + (2 * i + 1) * half, half});
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
