// SPDX-License-Identifier: BSD-3-Clause
// A particle as shape functions and contact see it: where it is, and the domain that its weights cover.
#pragma once

#include <cmath>

#include "adapters/mpm/kernel/call.hpp"
#include "adapters/mpm/kernel/record_lanes.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Half-side vectors r1, r2 [m]. Corners in the order (--), (+-), (++), (-+).
struct Domain {
    double r1r, r1z, r2r, r2z;
    GRIT_INLINE double area() const { return 4.0 * (r1r * r2z - r1z * r2r); }
};

// Shrunk as a whole until no half extent exceeds its limit: for weights only, mass and volume stay.
GRIT_INLINE Domain limited(Domain d, double limit_r, double limit_z) {
    const double extent_r = std::fabs(d.r1r) + std::fabs(d.r2r);
    const double extent_z = std::fabs(d.r1z) + std::fabs(d.r2z);
    if (extent_r <= limit_r && extent_z <= limit_z) return d;
    const double by_r = limit_r / extent_r, by_z = limit_z / extent_z;
    const double s = by_r < by_z ? by_r : by_z;
    return {s * d.r1r, s * d.r1z, s * d.r2r, s * d.r2z};
}

// A domain of the same area, centre and directions whose sides do not differ more than this in length,
// as principal stretches: the gradient's error grows with their ratio, without limit for a particle that
// was sheared along a pile. With H = [r1 r2] = U diag(s1, s2) V^T it is x H + y cof H, because
// cof H = U diag(s2, s1) V^T.
GRIT_INLINE Domain rounded(const Domain& d) {
    constexpr double most = 9.0;  // s1 / s2
    const double det = d.r1r * d.r2z - d.r1z * d.r2r;
    const double squares = d.r1r * d.r1r + d.r1z * d.r1z + d.r2r * d.r2r + d.r2z * d.r2z;
    if (squares <= (most + 1.0 / most) * det || !(det > 0.0)) return d;
    const double sum = std::sqrt(squares + 2.0 * det), difference = std::sqrt(squares - 2.0 * det);
    const double s1 = 0.5 * (sum + difference), s2 = 0.5 * (sum - difference);
    const double short_side = std::sqrt(det / most), long_side = most * short_side;
    const double per = 1.0 / (sum * difference);
    const double x = (long_side * s1 - short_side * s2) * per;
    const double y = (short_side * s1 - long_side * s2) * per;
    return {x * d.r1r + y * d.r2z, x * d.r1z - y * d.r2r, x * d.r2r - y * d.r1z,
            x * d.r2z + y * d.r1r};
}

// Particle p as the shape functions see it.
struct Place {
    double r, z;  // [m]
    int cell_r, cell_z;
    Domain domain;
    double l_r, l_z;  // initial half sides, shrunk as domains are [m]
};

template <bool axisymmetric>
GRIT_INLINE Place place_of(const GridView& grid, const ParticleView& q, std::ptrdiff_t p) {
    Place place;
    place.r = q[column::r][p];
    place.z = q[column::z][p];
    place.cell_r = grid.r.cell_of(place.r);
    place.cell_z = grid.z.cell_of(place.z);
    double limit_r = grid.r.limit[place.cell_r];
    const double limit_z = grid.z.limit[place.cell_z];
    if (axisymmetric && place.r < limit_r) limit_r = place.r;  // nothing reaches across the axis
    const double l_r = q[column::l_r][p], l_z = q[column::l_z][p];
    place.domain = limited(rounded({q[column::F_rr][p] * l_r, q[column::F_zr][p] * l_r,
                                    q[column::F_rz][p] * l_z, q[column::F_zz][p] * l_z}),
                           limit_r, limit_z);
    place.l_r = l_r < limit_r ? l_r : limit_r;
    place.l_z = l_z < limit_z ? l_z : limit_z;
    return place;
}

GRIT_KERNEL_END
