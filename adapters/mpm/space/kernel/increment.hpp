// SPDX-License-Identifier: BSD-3-Clause
// The deformation of a particle in a step: F, and strain and rotation increments by the midpoint rule of
// Hughes & Winget (1980), doi 10.1002/nme.1620151210, for which a rigid rotation strains nothing.
#pragma once

#include "adapters/mpm/space/kernel/call.hpp"

GRIT_KERNEL_BEGIN_OF(mpm::space)

GRIT_INLINE bool is_separated(const ParticleView& q, std::ptrdiff_t p,
                              const Separation& separation) {
    if (separation.void_ratio < 0) return false;
    bool free = true;
    for (int k = 0; k < 6; ++k) free = free && q[column::S_xx + k][p] == 0.0;
    return free;
}

GRIT_INLINE bool opens_too_far(const ParticleView& q, std::ptrdiff_t p, const Gradient& L,
                               const Separation& separation) {
    return is_separated(q, p, separation) && L.trace() > 0.0 &&
           q[separation.void_ratio][p] >= separation.cap;
}

// M = L (I + L/2)^-1, the gradient against the middle of the step.
GRIT_INLINE Gradient midpoint_gradient(const Gradient& L) {
    double a[3][3], cofactor[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) a[i][j] = 0.5 * L.of[i][j] + (i == j ? 1.0 : 0.0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            cofactor[i][j] = a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
        }
    const double per_det =
        1.0 / (a[0][0] * cofactor[0][0] + a[0][1] * cofactor[0][1] + a[0][2] * cofactor[0][2]);
    Gradient M;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            M.of[i][j] = per_det * (L.of[i][0] * cofactor[j][0] + L.of[i][1] * cofactor[j][1] +
                                    L.of[i][2] * cofactor[j][2]);
    return M;
}

// Q = (I - W/2)^-1 (I + W/2): with a, the axis of A = W/2, it is I + 2 (A + A^2)/(1 + a^2).
GRIT_INLINE void turn_by(const Gradient& M, double (&rotation)[9][Increments::capacity],
                         std::ptrdiff_t i) {
    const double a[3] = {0.25 * (M.of[2][1] - M.of[1][2]), 0.25 * (M.of[0][2] - M.of[2][0]),
                         0.25 * (M.of[1][0] - M.of[0][1])};
    const double a2 = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    const double twice = 2.0 / (1.0 + a2), diagonal = 1.0 - twice * a2;
    rotation[0][i] = diagonal + twice * a[0] * a[0];
    rotation[4][i] = diagonal + twice * a[1] * a[1];
    rotation[8][i] = diagonal + twice * a[2] * a[2];
    const double xy = a[0] * a[1], xz = a[0] * a[2], yz = a[1] * a[2];
    rotation[1][i] = twice * (xy - a[2]);
    rotation[3][i] = twice * (xy + a[2]);
    rotation[2][i] = twice * (xz + a[1]);
    rotation[6][i] = twice * (xz - a[1]);
    rotation[5][i] = twice * (yz - a[0]);
    rotation[7][i] = twice * (yz + a[0]);
}

GRIT_INLINE void deform(const ParticleView& q, std::ptrdiff_t p, const Gradient& given,
                        const Separation& separation, Increments& out, std::ptrdiff_t i) {
    // What has opened to the cap keeps its domain and does not turn.
    const Gradient L = opens_too_far(q, p, given, separation) ? Gradient{} : given;
    for (int k = 0; k < 3; ++k) {  // (A5), column by column
        const double F[3] = {q.F(0, k, p), q.F(1, k, p), q.F(2, k, p)};
        for (int j = 0; j < 3; ++j)
            q[column::F_xx + 3 * j + k][p] =
                F[j] + L.of[j][0] * F[0] + L.of[j][1] * F[1] + L.of[j][2] * F[2];
    }
    const Gradient M = midpoint_gradient(L);
    for (int k = 0; k < 3; ++k) out.strain[k][i] = M.of[k][k];
    out.strain[3][i] = M.of[0][1] + M.of[1][0];
    out.strain[4][i] = M.of[0][2] + M.of[2][0];
    out.strain[5][i] = M.of[1][2] + M.of[2][1];
    turn_by(M, out.rotation, i);
}

GRIT_KERNEL_END
