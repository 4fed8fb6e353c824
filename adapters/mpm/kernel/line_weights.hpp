// SPDX-License-Identifier: BSD-3-Clause
// Weights of the nodes of one axis, of which those of uGIMP and of linear shape functions are products.
#pragma once

#include "adapters/mpm/kernel/axis.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// A step that cells allow is short enough for a node that is reached by this share of its cell alone: G^2 / S is 1/(l h) then,
// and without bound where particles are slivers.
constexpr double thinnest_domain = 0.125;

// Mean of the hat functions and of their slope over [x - l, x + l], at nodes first ... first + 3.
struct LineWeights {
    int first;
    double S[4] = {}, G[4] = {};

    GRIT_INLINE LineWeights(const AxisView& axis, int cell, double x, double half_side) {
        const double least = thinnest_domain * (axis.node[cell + 1] - axis.node[cell]);
        const double l = half_side > least ? half_side : least;
        first = cell > 0 ? cell - 1 : 0;
        const int last = cell + 1 < axis.cells ? cell + 1 : cell;
        for (int c = first; c <= last; ++c) {
            // The outermost cells go on beyond the grid.
            const double lower = x - l, upper = x + l;
            const double a = c > 0 && axis.node[c] > lower ? axis.node[c] : lower;
            const double b =
                c + 1 < axis.cells && axis.node[c + 1] < upper ? axis.node[c + 1] : upper;
            if (!(b > a)) continue;
            const double share = (b - a) / (2.0 * l), half = 0.5 * (b - a);
            // Each from its own end: a node that is reached by roundoff alone has the mass that its slope needs, or one such
            // particle is stiffer than any step is short.
            S[c - first] += share * ((axis.node[c + 1] - b + half) * axis.inverse[c]);
            S[c - first + 1] += share * ((a - axis.node[c] + half) * axis.inverse[c]);
            G[c - first] -= share * axis.inverse[c];
            G[c - first + 1] += share * axis.inverse[c];
        }
    }
    GRIT_INLINE LineWeights(const AxisView& axis, int cell, double x) : first(cell) {
        S[1] = (x - axis.node[cell]) * axis.inverse[cell];
        S[0] = 1.0 - S[1];
        G[1] = axis.inverse[cell];
        G[0] = -G[1];
    }
};

GRIT_KERNEL_END
