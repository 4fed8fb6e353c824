// SPDX-License-Identifier: BSD-3-Clause
// Symmetric second-order tensors as Mandel 6-vectors (11 22 33 and sqrt 2 times 12 13 23): the double
// contraction A:B is the dot product.
#pragma once

#include "support/elementary.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct Tensor {
    Real c[6];
    GRIT_INLINE Real& operator[](int i) { return c[i]; }
    GRIT_INLINE const Real& operator[](int i) const { return c[i]; }
};

template <class Real> GRIT_INLINE Real trace(const Tensor<Real>& A) { return A[0] + A[1] + A[2]; }

template <class A, class B>
GRIT_INLINE auto contract(const Tensor<A>& a, const Tensor<B>& b) -> decltype(a[0] * b[0]) {
    return fma(a[0], b[0], fma(a[1], b[1], a[2] * b[2])) +
           fma(a[3], b[3], fma(a[4], b[4], a[5] * b[5]));
}

// A:A
template <class Real> GRIT_INLINE Real square(const Tensor<Real>& A) { return contract(A, A); }

template <class Real> GRIT_INLINE Real norm(const Tensor<Real>& A) { return sqrt(square(A)); }

template <class Real, class Scale>
GRIT_INLINE auto scaled(const Tensor<Real>& A, const Scale& s) -> Tensor<decltype(A[0] * s)> {
    return {A[0] * s, A[1] * s, A[2] * s, A[3] * s, A[4] * s, A[5] * s};
}

// s A + B
template <class Real, class Scale>
GRIT_INLINE Tensor<Real> scaled_sum(const Scale& s, const Tensor<Real>& A, const Tensor<Real>& B) {
    return {fma(s, A[0], B[0]), fma(s, A[1], B[1]), fma(s, A[2], B[2]),
            fma(s, A[3], B[3]), fma(s, A[4], B[4]), fma(s, A[5], B[5])};
}

template <class Real>
GRIT_INLINE Tensor<Real> difference(const Tensor<Real>& A, const Tensor<Real>& B) {
    return {A[0] - B[0], A[1] - B[1], A[2] - B[2], A[3] - B[3], A[4] - B[4], A[5] - B[5]};
}

template <class Real> GRIT_INLINE Tensor<Real> deviator(const Tensor<Real>& A) {
    const Real mean = trace(A) * (1.0 / 3.0);
    return {A[0] - mean, A[1] - mean, A[2] - mean, A[3], A[4], A[5]};
}

template <class Real> GRIT_INLINE Tensor<Real> isotropic(const Real& x) {
    const Real zero = x * 0.0;
    return {x, x, x, zero, zero, zero};
}

template <class Mask, class Real>
GRIT_INLINE Tensor<Real> select(const Mask& mask, const Tensor<Real>& A, const Tensor<Real>& B) {
    Tensor<Real> r;
    for (int i = 0; i < 6; ++i) r[i] = select(mask, A[i], B[i]);
    return r;
}

template <class Real> GRIT_INLINE Tensor<PlainOf<Real>> value(const Tensor<Real>& A) {
    return {value(A[0]), value(A[1]), value(A[2]), value(A[3]), value(A[4]), value(A[5])};
}

GRIT_KERNEL_END
