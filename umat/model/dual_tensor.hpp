// SPDX-License-Identifier: BSD-3-Clause
// Invariants of tensors with derivatives: their gradients are tensors themselves.
#pragma once

#include "support/dual.hpp"
#include "umat/model/notation.hpp"

GRIT_KERNEL_BEGIN

// G:dA
template <class Part, int parts>
GRIT_INLINE Gradient<double, Part, parts>
derivatives_along(const Tensor<double>& G, const Tensor<DualOf<double, Part, parts>>& A) {
    const auto half = [&](int i) {
        return scaled_sum(A[i].d, G[i], scaled_sum(A[i + 1].d, G[i + 1], A[i + 2].d * G[i + 2]));
    };
    return half(0) + half(3);
}

template <class Part, int parts>
GRIT_INLINE DualOf<double, Part, parts> square(const Tensor<DualOf<double, Part, parts>>& A) {
    const Tensor<double> v = value(A);
    return {square(v), derivatives_along(scaled(v, 2.0), A)};
}

template <class Part, int parts>
GRIT_INLINE DualOf<double, Part, parts> determinant(const Tensor<DualOf<double, Part, parts>>& A) {
    const Tensor<double> v = value(A);
    return {determinant(v), derivatives_along(cofactors(v), A)};
}

GRIT_KERNEL_END
