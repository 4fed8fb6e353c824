// SPDX-License-Identifier: BSD-3-Clause
// Weights of the nodes of one axis, of which those of uGIMP and of linear shape functions are products.
#pragma once

#include "adapters/mpm/kernel/axis.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Mean of the hat functions and of their slope over [x - l, x + l], at nodes first ... first + 3.
struct LineWeights {
    int first;
    double S[4] = {}, G[4] = {};

    GRIT_INLINE LineWeights(const AxisView& axis, int cell, double x, double l) {
        first = cell > 0 ? cell - 1 : 0;
        const int last = cell + 1 < axis.cells ? cell + 1 : cell;
        for (int c = first; c <= last; ++c) {
            // The outermost cells go on beyond the grid.
            const double lower = x - l, upper = x + l;
            const double a = c > 0 && axis.node[c] > lower ? axis.node[c] : lower;
            const double b =
                c + 1 < axis.cells && axis.node[c + 1] < upper ? axis.node[c + 1] : upper;
            if (!(b > a)) continue;
            const double share = (b - a) / (2.0 * l);
            const double middle = (0.5 * (a + b) - axis.node[c]) * axis.inverse[c];
            S[c - first] += share * (1.0 - middle);
            S[c - first + 1] += share * middle;
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
