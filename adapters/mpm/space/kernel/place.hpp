// SPDX-License-Identifier: BSD-3-Clause
// A particle in space as shape functions and contact see it: where it is, and the domain that its weights cover.
#pragma once

#include <cmath>

#include "adapters/mpm/space/kernel/call.hpp"

GRIT_KERNEL_BEGIN_OF(mpm::space)

// Half-side vectors: r[k] along the k-th side [m].
struct Domain {
    Vector3 r[3];
};

GRIT_INLINE Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// a_k . r_j = 1 where k = j, else 0.
GRIT_INLINE Domain reciprocal(const Domain& d) {
    const Vector3 c = cross(d.r[1], d.r[2]);
    const double per_det = 1.0 / dot(d.r[0], c);
    return {{per_det * c, per_det * cross(d.r[2], d.r[0]), per_det * cross(d.r[0], d.r[1])}};
}

GRIT_INLINE double squares(const Domain& d) {
    return dot(d.r[0], d.r[0]) + dot(d.r[1], d.r[1]) + dot(d.r[2], d.r[2]);
}

// Shrunk as a whole until no half extent exceeds its limit: for weights only, mass and volume stay.
GRIT_INLINE Domain limited(const Domain& d, const Vector3& limit) {
    double s = 1.0;
    for (int k = 0; k < 3; ++k) {
        const double extent = std::fabs(d.r[0][k]) + std::fabs(d.r[1][k]) + std::fabs(d.r[2][k]);
        const double by = limit[k] / extent;
        s = extent > limit[k] && by < s ? by : s;
    }
    return s < 1.0 ? Domain{{s * d.r[0], s * d.r[1], s * d.r[2]}} : d;
}

// Eigenvalues and orthonormal eigenvectors v[k] of a symmetric matrix, by Jacobi's rotations.
struct Principal {
    double value[3];
    double v[3][3];

    explicit Principal(double (&a)[3][3]) {
        double V[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int sweep = 0; sweep < 8; ++sweep)  // quadratic: four are enough
            for (int i = 0; i < 2; ++i)
                for (int j = i + 1; j < 3; ++j) {
                    if (a[i][j] == 0.0) continue;
                    const double cot2 = (a[j][j] - a[i][i]) / (2.0 * a[i][j]);
                    const double t = (cot2 < 0.0 ? -1.0 : 1.0) /
                                     (std::fabs(cot2) + std::sqrt(cot2 * cot2 + 1.0));
                    const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
                    for (int k = 0; k < 3; ++k) {
                        const double x = a[k][i], y = a[k][j];
                        a[k][i] = c * x - s * y;
                        a[k][j] = s * x + c * y;
                    }
                    for (int k = 0; k < 3; ++k) {
                        const double x = a[i][k], y = a[j][k];
                        a[i][k] = c * x - s * y;
                        a[j][k] = s * x + c * y;
                    }
                    for (int k = 0; k < 3; ++k) {
                        const double x = V[k][i], y = V[k][j];
                        V[k][i] = c * x - s * y;
                        V[k][j] = s * x + c * y;
                    }
                }
        for (int i = 0; i < 3; ++i) {
            value[i] = a[i][i];
            for (int k = 0; k < 3; ++k) v[i][k] = V[k][i];
        }
    }
};

// Principal stretches brought to a ratio of no more than `most`, with the same product: the shortest m and the longest
// most m.
GRIT_INLINE void bring_together(double (&s)[3], double most) {
    double least = s[0] < s[1] ? s[0] : s[1], largest = s[0] < s[1] ? s[1] : s[0];
    least = s[2] < least ? s[2] : least;
    largest = s[2] > largest ? s[2] : largest;
    const double det = s[0] * s[1] * s[2], middle = det / (least * largest);
    double m = std::sqrt(det / (most * middle));
    if (middle < m) m = std::cbrt(det / most);
    if (middle > most * m) m = std::cbrt(det / (most * most));
    for (double& x : s) x = x < m ? m : x > most * m ? most * m : x;
}

// A domain of the same volume, centre and directions whose sides do not differ more than this in length, as
// principal stretches; see the plane's. With H = [r1 r2 r3] = U S V^T it is H V S^-1 S' V^T.
inline Domain rounded_anew(const Domain& d, double most) {
    double C[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) C[i][j] = dot(d.r[i], d.r[j]);
    const Principal principal(C);
    double s[3], wanted[3], factor[3][3] = {};
    for (int k = 0; k < 3; ++k) wanted[k] = s[k] = std::sqrt(principal.value[k]);
    bring_together(wanted, most);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                factor[i][j] += principal.v[k][i] * (wanted[k] / s[k]) * principal.v[k][j];
    Domain out;
    for (int j = 0; j < 3; ++j)
        out.r[j] = factor[0][j] * d.r[0] + factor[1][j] * d.r[1] + factor[2][j] * d.r[2];
    return out;
}

// The product of the squares of a domain and of its reciprocal vectors is 3 + sum (s_i/s_j)^2 over all pairs: below
// this no two differ by `most`.
GRIT_INLINE Domain rounded(const Domain& d) {
    constexpr double most = 9.0;
    constexpr double surely = 3.0 + most * most + 1.0 / (most * most) + 2.0 * (most + 1.0 / most);
    const Domain areas{{cross(d.r[1], d.r[2]), cross(d.r[2], d.r[0]), cross(d.r[0], d.r[1])}};
    const double det = dot(d.r[0], areas.r[0]);
    if (squares(d) * squares(areas) <= surely * (det * det) || !(det > 0.0)) return d;
    return rounded_anew(d, most);
}

// Particle p as the shape functions see it.
struct Place {
    Vector3 at;  // [m]
    int cell[3];
    Domain domain;
    Vector3 l;  // initial half sides, shrunk as domains are [m]
};

GRIT_INLINE Place place_of(const GridView& grid, const ParticleView& q, std::ptrdiff_t p) {
    Place place;
    place.at = q.position(p);
    Vector3 limit;
    for (int k = 0; k < 3; ++k) {
        place.cell[k] = grid.axis[k].cell_of(place.at[k]);
        limit[k] = grid.axis[k].limit[place.cell[k]];
        const double l = q[column::l_x + k][p];
        place.l[k] = l < limit[k] ? l : limit[k];
        place.domain.r[k] = {l * q.F(0, k, p), l * q.F(1, k, p), l * q.F(2, k, p)};
    }
    place.domain = limited(rounded(place.domain), limit);
    return place;
}

GRIT_KERNEL_END
