// SPDX-License-Identifier: BSD-3-Clause
// Directions of strain that derivatives are carried along: orthonormal, and the first three span I, the strain
// increment and h, on which the course of a path depends. Its scalars do not change along the others.
#pragma once

#include "umat/dual_tensor.hpp"

GRIT_KERNEL_BEGIN

constexpr int course_directions = 3;

struct StrainDirections {
    Tensor<double> d[6];
};

// d_0 ~ I and deviators.
constexpr double root_third = 0x1.279a74590331cp-1, root_sixth = 0x1.a20bd700c2c3ep-2;
constexpr StrainDirections volume_first = {
    {{{root_third, root_third, root_third, 0.0, 0.0, 0.0}},
     {{root_half, -root_half, 0.0, 0.0, 0.0, 0.0}},
     {{root_sixth, root_sixth, -2.0 * root_sixth, 0.0, 0.0, 0.0}},
     {{0.0, 0.0, 0.0, 1.0, 0.0, 0.0}},
     {{0.0, 0.0, 0.0, 0.0, 1.0, 0.0}},
     {{0.0, 0.0, 0.0, 0.0, 0.0, 1.0}}}};

// Householder's reflection of d_k ... d_5: d_k becomes the part of A that the directions before it do not span.
// They stay orthonormal whatever A is.
inline void turn_into(const Tensor<double>& A, int k, StrainDirections& r) {
    double normal[6] = {}, rest_sq = 0.0;
    for (int i = k; i < 6; ++i) {
        normal[i] = contract(r.d[i], A);
        rest_sq += square(normal[i]);
    }
    constexpr double least = 1e-280;
    if (!(rest_sq > least)) return;
    const double rest = normal[k] < 0.0 ? -sqrt(rest_sq) : sqrt(rest_sq);
    const double half_square = rest * (rest + normal[k]);
    normal[k] += rest;
    Tensor<double> across = scaled(r.d[k], normal[k] / half_square);
    for (int i = k + 1; i < 6; ++i) across = scaled_sum(normal[i] / half_square, r.d[i], across);
    for (int i = k; i < 6; ++i) r.d[i] = scaled_sum(-normal[i], across, r.d[i]);
}

inline StrainDirections strain_directions(const Tensor<double>& strain, const Tensor<double>& h) {
    StrainDirections r = volume_first;
    turn_into(strain, 1, r);
    turn_into(h, 2, r);
    return r;
}

// A with its derivatives along these directions.
inline Tensor<Dual> variable(const Tensor<double>& A, const StrainDirections& along) {
    Tensor<Dual> r;
    for (int c = 0; c < 6; ++c)
        r[c] = {A[c], Dual::Derivatives::along([&](int i) { return i < 6 ? along.d[i][c] : 0.0; })};
    return r;
}

// dT/d(strain) from the derivatives of T along the directions: row by row, Mandel.
inline Tensor<double> by_strain(const Dual& component, const StrainDirections& along) {
    Tensor<double> row = scaled(along.d[0], component.d[0]);
    for (int i = 1; i < 6; ++i) row = scaled_sum(component.d[i], along.d[i], row);
    return row;
}

GRIT_KERNEL_END
