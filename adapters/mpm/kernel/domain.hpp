// SPDX-License-Identifier: BSD-3-Clause
// The domain of a CPDI particle and the weights of its corners, (A1)-(A3). Convected particle domains:
// Sadeghirad, Brannon & Burghardt (2011), doi 10.1002/nme.3110; weighted with r, the integrals over
// the true ring.
#pragma once

#include "adapters/mpm/kernel/place.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

GRIT_INLINE Vec4 xi() { return Vec4{-1.0, 1.0, 1.0, -1.0}; }
GRIT_INLINE Vec4 eta() { return Vec4{-1.0, -1.0, 1.0, 1.0}; }

struct CornerWeights {
    Vec4 S, G_r, G_z;  // [-], [1/m]
};

// k = 1/(3 r_p) in axisymmetry, 0 in plane strain.
GRIT_INLINE CornerWeights corner_weights(const Domain& d, double k) {
    const double per_area = 1.0 / d.area();
    const Vec4 e1 = xi(), e2 = eta(), e12 = e1 * e2;
    CornerWeights w;
    w.S = 0.25 + (0.25 * k) * (e1 * d.r1r + e2 * d.r2r);  // (A1)
    w.G_r =
        per_area * (e1 * d.r2z - e2 * d.r1z + e12 * (k * (d.r2r * d.r2z - d.r1r * d.r1z)));  // (A2)
    w.G_z = per_area * (e2 * d.r1r - e1 * d.r2r + e12 * (k * (d.r1r * d.r1r - d.r2r * d.r2r)));
    return w;
}

GRIT_KERNEL_END
