// SPDX-License-Identifier: BSD-3-Clause
// The deformation of a particle in a step: F, and strain and rotation increments by the midpoint rule of
// Hughes & Winget (1980), doi 10.1002/nme.1620151210, for which a rigid rotation strains nothing.
#pragma once

#include "adapters/mpm/kernel/call.hpp"
#include "adapters/mpm/kernel/record_lanes.hpp"
#include "adapters/mpm/kernel/reduced_domain.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

GRIT_INLINE bool is_separated(const ParticleView& q, std::ptrdiff_t p,
                              const Separation& separation) {
    namespace c = column;
    return separation.void_ratio >= 0 && q[c::S_rr][p] == 0.0 && q[c::S_zz][p] == 0.0 &&
           q[c::S_tt][p] == 0.0 && q[c::S_rz][p] == 0.0;
}

GRIT_INLINE bool opens_too_far(const ParticleView& q, std::ptrdiff_t p, const Gradient& L,
                               const Separation& separation) {
    return is_separated(q, p, separation) && L.trace() > 0.0 &&
           q[separation.void_ratio][p] >= separation.cap;
}

// M = L (I + L/2)^-1, the gradient against the middle of the step.
GRIT_INLINE Gradient midpoint_gradient(const Gradient& L) {
    const double a = 1.0 + 0.5 * L.rr, d = 1.0 + 0.5 * L.zz;
    const double b = 0.5 * L.rz, e = 0.5 * L.zr;
    const double per_det = 1.0 / (a * d - b * e);
    return {(L.rr * d - L.rz * e) * per_det, (L.rz * a - L.rr * b) * per_det,
            (L.zr * d - L.zz * e) * per_det, (L.zz * a - L.zr * b) * per_det,
            L.tt / (1.0 + 0.5 * L.tt)};
}

GRIT_INLINE void deform(const ParticleView& q, std::ptrdiff_t p, const Gradient& given,
                        const Separation& separation, bool reduces, Increments& out,
                        std::ptrdiff_t i) {
    namespace c = column;
    // What has opened to the cap keeps its domain and does not turn.
    const bool held = opens_too_far(q, p, given, separation);
    const Gradient L = held ? Gradient{} : given;
    const double F_rr = q[c::F_rr][p], F_rz = q[c::F_rz][p];
    const double F_zr = q[c::F_zr][p], F_zz = q[c::F_zz][p];
    q[c::F_rr][p] = F_rr + L.rr * F_rr + L.rz * F_zr;  // (A5)
    q[c::F_rz][p] = F_rz + L.rr * F_rz + L.rz * F_zz;
    q[c::F_zr][p] = F_zr + L.zr * F_rr + L.zz * F_zr;
    q[c::F_zz][p] = F_zz + L.zr * F_rz + L.zz * F_zz;
    q[c::F_tt][p] += q[c::F_tt][p] * L.tt;
    if (reduces) reduce_domain(q, p);

    const Gradient M = midpoint_gradient(L);
    out.strain[0][i] = M.rr;
    out.strain[1][i] = M.zz;
    out.strain[2][i] = M.tt;
    out.strain[3][i] = M.rz + M.zr;

    // Q = (I - W/2)^-1 (I + W/2), W_rz = -W_zr = 2w.
    const double w = 0.25 * (M.rz - M.zr), per = 1.0 / (1.0 + w * w);
    const double cosine = (1.0 - w * w) * per, sine = 2.0 * w * per;
    out.rotation[0][i] = cosine;
    out.rotation[1][i] = sine;
    out.rotation[3][i] = -sine;
    out.rotation[4][i] = cosine;
}

GRIT_KERNEL_END
