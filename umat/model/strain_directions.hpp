// SPDX-License-Identifier: BSD-3-Clause
// Directions of strain that derivatives are carried along: orthonormal, and the first three span I, the strain
// increment and h, on which the course of a path depends. Its scalars do not change along the others.
#pragma once

#include "umat/model/dual_tensor.hpp"

GRIT_KERNEL_BEGIN

constexpr int course_directions = 3;

// Six numbers side by side, of a tensor or of the directions; lanes beyond them are 0.
using Six = Dual::Derivatives;

struct StrainDirections {
    Six d[6];          // direction i
    Six component[6];  // of all of them: derivatives of a component of the strain
};

// d_0 ~ I, deviators and shears.
inline StrainDirections volume_first() {
    constexpr double root_third = 0x1.279a74590331cp-1, root_sixth = 0x1.a20bd700c2c3ep-2;
    constexpr double d[6][8] = {{root_third, root_third, root_third},
                                {root_half, -root_half},
                                {root_sixth, root_sixth, -2.0 * root_sixth},
                                {0.0, 0.0, 0.0, 1.0},
                                {0.0, 0.0, 0.0, 0.0, 1.0},
                                {0.0, 0.0, 0.0, 0.0, 0.0, 1.0}};
    StrainDirections r;
    for (int k = 0; k < 6; ++k) {
        r.d[k] = Six::along([&](int c) { return d[k][c]; });
        r.component[k] = Six::along([&](int i) { return i < 6 ? d[i][k] : 0.0; });
    }
    return r;
}

GRIT_INLINE Six weighted_sum(const double (&weight)[6], const Six (&of)[6]) {
    Six sum = of[0] * weight[0];
    for (int i = 1; i < 6; ++i) sum = scaled_sum(of[i], weight[i], sum);
    return sum;
}

// Householder's reflection of d_k ... d_5: d_k becomes the part of A that the directions before it do not span.
// They stay orthonormal whatever A is.
inline void turn_into(const Tensor<double>& A, int k, StrainDirections& r) {
    const Six along_A = weighted_sum(A.c, r.component);
    double normal[6], rest_sq = 0.0;
    for (int i = 0; i < 6; ++i) {
        normal[i] = i < k ? 0.0 : along_A[i];
        rest_sq += square(normal[i]);
    }
    constexpr double least = 1e-280;
    if (!(rest_sq > least)) return;
    const double rest = normal[k] < 0.0 ? -sqrt(rest_sq) : sqrt(rest_sq);
    const double half_square = rest * (rest + normal[k]);
    normal[k] += rest;
    const Six across = weighted_sum(normal, r.d) * (1.0 / half_square);
    const Six normals = Six::along([&](int i) { return i < 6 ? normal[i] : 0.0; });
    for (int i = 0; i < 6; ++i) {
        r.d[i] = scaled_sum(across, -normal[i], r.d[i]);
        r.component[i] = scaled_sum(normals, -across[i], r.component[i]);
    }
}

inline StrainDirections strain_directions(const Tensor<double>& strain, const Tensor<double>& h) {
    StrainDirections r = volume_first();
    turn_into(strain, 1, r);
    turn_into(h, 2, r);
    return r;
}

// A with its derivatives along these directions.
inline Tensor<Dual> variable(const Tensor<double>& A, const StrainDirections& along) {
    Tensor<Dual> r;
    for (int c = 0; c < 6; ++c) r[c] = {A[c], along.component[c]};
    return r;
}

// dT/d(strain) from the derivatives of T along the directions: row by row, Mandel.
inline Six by_strain(const Dual& component, const StrainDirections& along) {
    double slope[6];
    for (int i = 0; i < 6; ++i) slope[i] = component.d[i];
    return weighted_sum(slope, along.d);
}

GRIT_KERNEL_END
