// SPDX-License-Identifier: BSD-3-Clause
// Domains of sheared particles, kept compact: where r1, r2 and their images tile the plane, so do r1, r2 - k r1, with
// the same area, centre and rows along r1 (Lagrange 1773: the reduced basis of a lattice).
#pragma once

#include <cmath>

#include "adapters/mpm/kernel/call.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Where the longer side leans along the shorter one by more than its length; then by no more than half of it. What has
// become the shorter one may lean in turn: that is the next step's.
GRIT_INLINE void reduce_domain(const ParticleView& q, std::ptrdiff_t p) {
    namespace c = column;
    const double l_r = q[c::l_r][p], l_z = q[c::l_z][p];
    double r1r = q[c::F_rr][p] * l_r, r1z = q[c::F_zr][p] * l_r;
    double r2r = q[c::F_rz][p] * l_z, r2z = q[c::F_zz][p] * l_z;
    const double square_1 = r1r * r1r + r1z * r1z, square_2 = r2r * r2r + r2z * r2z;
    const double product = r1r * r2r + r1z * r2z;
    const double shorter = square_1 < square_2 ? square_1 : square_2;
    if (!(std::fabs(product) > shorter)) return;
    const double k = std::nearbyint(product / shorter);
    if (square_1 < square_2) {
        r2r -= k * r1r;
        r2z -= k * r1z;
        q[c::F_rz][p] = r2r / l_z;
        q[c::F_zz][p] = r2z / l_z;
    } else {
        r1r -= k * r2r;
        r1z -= k * r2z;
        q[c::F_rr][p] = r1r / l_r;
        q[c::F_zr][p] = r1z / l_r;
    }
}

GRIT_KERNEL_END
