// SPDX-License-Identifier: BSD-3-Clause
// The cone tan psi < sqrt 2, outside of which F of (H5) is not positive: docs/adr/0002-low-stress.md.
#pragma once

#include "umat/model/hypoplastic_stiffness.hpp"

GRIT_KERNEL_BEGIN

template <class Plain> GRIT_INLINE MaskOf<Plain> outside_cone(const Tensor<Plain>& T) {
    constexpr double limit = cone_limit * root_2;
    const Plain tr = trace(T);
    const Tensor<Plain> dev = deviator(T);
    return 3.0 * contract(dev, dev) > (limit * limit * (1.0 + 1e-12)) * tr * tr;
}

// Scale the deviator of T back to the cone where it lies outside; says where that was.
template <class Real>
GRIT_INLINE MaskOf<Real> back_into_cone(Tensor<Real>& T, const MaskOf<Real>& where) {
    constexpr double limit = cone_limit * root_2;
    const MaskOf<Real> outside = where & outside_cone(value(T));
    if (any(outside)) {
        const Tensor<Real> T_dev = deviator(T);
        const Real scale = limit * fabs(trace(T)) / sqrt(3.0 * contract(T_dev, T_dev) + 1e-300);
        const Tensor<Real> inside = scaled_sum(scale, T_dev, isotropic(trace(T) * (1.0 / 3.0)));
        assign(outside, T, inside);
    }
    return outside;
}

GRIT_KERNEL_END
