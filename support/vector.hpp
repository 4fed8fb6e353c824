// SPDX-License-Identifier: BSD-3-Clause
// A vector of one, two or three components, of numbers or of packs of them. Sums are taken in the order of the
// components, each product rounded.
#pragma once

#include <cmath>

#include "support/kernel.hpp"

namespace grit {

template <class Real, int C> struct Vector {
    Real c[C];
    GRIT_INLINE Real& operator[](int i) { return c[i]; }
    GRIT_INLINE const Real& operator[](int i) const { return c[i]; }
};
using Vector2 = Vector<double, 2>;
using Vector3 = Vector<double, 3>;

template <class Real, int C>
GRIT_INLINE Vector<Real, C> operator+(const Vector<Real, C>& a, const Vector<Real, C>& b) {
    Vector<Real, C> r;
    for (int i = 0; i < C; ++i) r[i] = a[i] + b[i];
    return r;
}

template <class Real, int C>
GRIT_INLINE Vector<Real, C> operator-(const Vector<Real, C>& a, const Vector<Real, C>& b) {
    Vector<Real, C> r;
    for (int i = 0; i < C; ++i) r[i] = a[i] - b[i];
    return r;
}

template <class Real, int C>
GRIT_INLINE Vector<Real, C> operator*(const Real& s, const Vector<Real, C>& a) {
    Vector<Real, C> r;
    for (int i = 0; i < C; ++i) r[i] = s * a[i];
    return r;
}

template <class Real, int C>
GRIT_INLINE Vector<Real, C> operator/(const Vector<Real, C>& a, const Real& divisor) {
    Vector<Real, C> r;
    for (int i = 0; i < C; ++i) r[i] = a[i] / divisor;
    return r;
}

template <class Real, int C>
GRIT_INLINE Real dot(const Vector<Real, C>& a, const Vector<Real, C>& b) {
    Real sum = a[0] * b[0];
    for (int i = 1; i < C; ++i) sum = sum + a[i] * b[i];
    return sum;
}

template <int C> GRIT_INLINE double norm(const Vector<double, C>& a) {
    return std::sqrt(dot(a, a));
}

}  // namespace grit
