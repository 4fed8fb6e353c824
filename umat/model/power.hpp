// SPDX-License-Identifier: BSD-3-Clause
// x^q with the exponents of sands: most are multiples of a quarter and need no logarithm.
#pragma once

#include <cstdint>

#include "support/elementary.hpp"
#include "umat/model/sensitive_material.hpp"

GRIT_KERNEL_BEGIN

// x^(q/4) for q >= 0, without a loop up to the first power.
template <class Real> GRIT_INLINE Real quarter_power(std::int64_t q, const Real& x) {
    if (q == 4) return x;
    const std::int64_t whole = q / 4, part = q % 4;
    Real result = Real(1.0);
    if (part != 0) {
        const Real root = sqrt(x);
        result = part == 1 ? sqrt(root) : part == 2 ? root : root * sqrt(root);
    }
    Real square_of = x;
    for (std::int64_t left = whole; left > 0; left /= 2) {
        if (left % 2 == 1) result = result * square_of;
        if (left > 1) square_of = square_of * square_of;
    }
    return result;
}

// x^q for x > 0, by q too.
template <class Plain, class Part, int parts>
GRIT_INLINE DualOf<Plain, Part, parts> power(const SensitiveExponent<DualOf<Plain, Part, parts>>& q,
                                             const DualOf<Plain, Part, parts>& x) {
    const Plain log_x = log(x.v);
    const Plain y = q.quarters < 0 ? exp(q.value.v * log_x) : quarter_power(q.quarters, x.v);
    return {y, scaled_sum(x.d, y * q.value.v / x.v, q.value.d * (y * log_x))};
}

// x^q for x > 0. The same for every lane: the branches hang on the material.
template <class Real> GRIT_INLINE Real power(const Exponent& q, const Real& x) {
    return q.quarters < 0 ? exp(q.value * log(x)) : quarter_power(q.quarters, x);
}

GRIT_KERNEL_END
