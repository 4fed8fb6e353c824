// SPDX-License-Identifier: BSD-3-Clause
// What a node must satisfy: positive conditions, so that a NaN fails them. The kernels ask whether all
// hold, the C entry point which one does not.
#pragma once

#include "contact/nodal/pair_law.hpp"
#include "contact/normals/limits.hpp"

GRIT_KERNEL_BEGIN

template <class Real> GRIT_INLINE MaskOf<Real> good_mass(const Real& m) {
    return (m >= Real(0.0)) & (m <= Real(largest_number));
}
template <class Real, int C> GRIT_INLINE MaskOf<Real> good_vector(const Vector<Real, C>& v) {
    Real sum = fabs(v[0]);  // a NaN stays
    for (int i = 1; i < C; ++i) sum = sum + fabs(v[i]);
    return sum <= Real(largest_number);
}
template <class Real, int C> GRIT_INLINE MaskOf<Real> good_normal(const Vector<Real, C>& n) {
    return fabs(fused_dot(n, n) - Real(1.0)) <= Real(normal_tolerance);
}
template <class Real, int C> GRIT_INLINE MaskOf<Real> zero_normal(const Vector<Real, C>& n) {
    Real sum = fabs(n[0]);
    for (int i = 1; i < C; ++i) sum = sum + fabs(n[i]);
    return sum <= Real(0.0);
}
// s or gap: +infinity says that there is nothing near.
template <class Real> GRIT_INLINE MaskOf<Real> good_signed_length(const Real& s) {
    return s >= Real(-largest_number);
}
template <class Real> GRIT_INLINE MaskOf<Real> good_length(const Real& d) {
    return (d >= Real(1.0 / largest_number)) & (d <= Real(largest_number));
}
template <class Real> GRIT_INLINE MaskOf<Real> good_area(const Real& area) {
    return (area >= Real(0.0)) & (area <= Real(largest_number));
}
template <class Real> GRIT_INLINE MaskOf<Real> good_impulse(const Real& J) {
    return fabs(J) <= Real(largest_number);
}

GRIT_KERNEL_END
