// SPDX-License-Identifier: BSD-3-Clause
// x^q with the exponents of sands: most are multiples of a quarter and need no logarithm.
#pragma once

#include "support/elementary.hpp"
#include "umat/material.hpp"

GRIT_KERNEL_BEGIN

// x^q for x > 0. The same for every lane: the branches hang on the material.
template <class Real> GRIT_INLINE Real power(const Exponent& q, const Real& x) {
    if (q.quarters < 0) return exp(q.value * log(x));
    Real result = Real(1.0), square_of = x;
    bool first = true;
    const auto times = [&](const Real& factor) {
        result = first ? factor : result * factor;
        first = false;
    };
    for (int whole = q.quarters / 4; whole > 0; whole /= 2) {
        if (whole % 2 == 1) times(square_of);
        if (whole > 1) square_of = square_of * square_of;
    }
    if (q.quarters % 4 != 0) {
        const Real root = sqrt(x);
        if (q.quarters & 2) times(root);
        if (q.quarters & 1) times(sqrt(root));
    }
    return result;
}

GRIT_KERNEL_END
