// SPDX-License-Identifier: BSD-3-Clause
// One point on its way through an update: read from the host's arrays, checked, turned, decided.
#pragma once

#include <cstddef>

#include "support/views.hpp"
#include "umat/batch/request.hpp"
#include "umat/model/notation.hpp"

GRIT_KERNEL_BEGIN

struct RawPoint {
    double strain[6], stress[6], state[GRIT_SAND_STATE_SIZE], Q[9];
    double substep;
    bool rotates;
};

constexpr double tolerated_tilt = 1e-12;  // of a Q about axis 3 with 4 components

// With 4 components what a Q tilts out of the plane is roundoff, and h13 and h23 stay zero: not taken over.
template <class Real> GRIT_INLINE void keep_in_plane(Real Q[9]) {
    for (const int c : {2, 5, 6, 7})
        Q[c] = select(fabs(Q[c]) <= Real(tolerated_tilt), Real(0.0), Q[c]);
}

inline RawPoint read_point(const grit_sand_points& q, std::ptrdiff_t at) {
    RawPoint raw;
    const int n = q.components == 0 ? 6 : q.components;
    for (int c = 0; c < 6; ++c) {
        const auto& d = q.strain_increment;
        const auto& t = q.stress;
        raw.strain[c] = c < n ? component(d, at, c) : 0.0;
        raw.stress[c] = c < n ? component(t, at, c) : 0.0;
    }
    const auto& s = q.state;
    for (int c = 0; c < GRIT_SAND_STATE_SIZE; ++c) raw.state[c] = component(s, at, c);
    const auto& r = q.rotation_increment;
    raw.rotates = false;  // by Q = I nothing is touched
    if (r.base) {
        for (int c = 0; c < 9; ++c) raw.Q[c] = component(r, at, c);
        if (n == 4) keep_in_plane(raw.Q);
        for (int c = 0; c < 9; ++c)
            raw.rotates = raw.rotates || raw.Q[c] != (c % 4 == 0 ? 1.0 : 0.0);
    }
    raw.substep = q.substep.base ? q.substep.base[at * q.substep.point_stride] : 0.0;
    return raw;
}

constexpr double largest_increment = 0.2;        // |strain increment| [-]
constexpr double largest_stress_per_h_s = 10.0;  // |stress| / h_s
constexpr double largest_void_ratio = 1e9;       // of a separated point that is stretched on
constexpr double smallest_increment = 1e-100;    // below it the increment is zero
constexpr double tolerated_h_excess = 1.01;      // |h| / R scaled back instead of refused

template <class Real> inline MaskOf<Real> is_rotation(const Real Q[9], bool in_plane) {
    Real worst(0.0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) {
            const Real dot =
                Q[3 * i] * Q[3 * j] + Q[3 * i + 1] * Q[3 * j + 1] + Q[3 * i + 2] * Q[3 * j + 2];
            worst = max(worst, fabs(dot - (i == j ? 1.0 : 0.0)));
        }
    const Real det = Q[0] * (Q[4] * Q[8] - Q[5] * Q[7]) - Q[1] * (Q[3] * Q[8] - Q[5] * Q[6]) +
                     Q[2] * (Q[3] * Q[7] - Q[4] * Q[6]);
    const Real out_of_plane = max(max(fabs(Q[2]), fabs(Q[5])), max(fabs(Q[6]), fabs(Q[7])));
    const MaskOf<Real> proper = (worst <= Real(1e-8)) & (det > Real(0.0));
    return in_plane ? proper & (out_of_plane <= Real(tolerated_tilt)) : proper;
}

// (H9), of a point and of its end alike.
GRIT_INLINE double void_ratio_after(double e, double volumetric) {
    return fma(1.0 + e, exp(volumetric), -1.0);
}
GRIT_INLINE bool is_void_ratio(double e) { return e > 0.0 && e <= largest_void_ratio; }

GRIT_INLINE bool is_stress(const Material& m, const double stress[6]) {
    for (int c = 0; c < 6; ++c)
        if (!(fabs(stress[c]) <= largest_stress_per_h_s * m.h_s)) return false;
    return true;
}

inline Fault check_point(const Material& m, const grit_sand_options& options, bool igs,
                         int components, const RawPoint& raw) {
    if (!are_finite(raw.strain, 6)) return Fault::strain_not_finite;
    if (!are_finite(raw.stress, 6)) return Fault::stress_not_finite;
    if (!are_finite(raw.state, GRIT_SAND_STATE_SIZE)) return Fault::state_not_finite;
    if (!are_finite(&raw.substep, 1)) return Fault::substep_not_finite;
    if (raw.rotates && (!are_finite(raw.Q, 9) || !is_rotation(raw.Q, components == 4)))
        return Fault::rotation_improper;
    const double e = raw.state[GRIT_SAND_VOID_RATIO];
    if (!is_void_ratio(e)) return Fault::void_ratio_out_of_range;
    if (!(raw.state[GRIT_SAND_SEPARATION] >= 0.0)) return Fault::separation_negative;
    if (igs) {
        if (components == 4 && (raw.state[GRIT_SAND_H13] != 0.0 || raw.state[GRIT_SAND_H23] != 0.0))
            return Fault::h_out_of_plane;
        if (!(norm(strain_from_voigt(raw.state)) <= tolerated_h_excess * m.R))
            return Fault::h_too_long;
    }
    if (!is_stress(m, raw.stress)) return Fault::stress_too_large;
    if (raw.rotates && !options.stress_is_rotated) {
        double turned[6];
        stress_to_voigt(rotated(raw.Q, stress_from_voigt(raw.stress)), turned);
        if (!is_stress(m, turned)) return Fault::turned_stress_too_large;
    }
    double largest = 0.0;
    for (double component : raw.strain) largest = max(largest, fabs(component));
    if (!(largest <= 1.0)) return Fault::increment_too_large;
    const Tensor<double> dE = strain_from_voigt(raw.strain);
    if (!(norm(dE) <= largest_increment)) return Fault::increment_too_large;
    if (!is_void_ratio(void_ratio_after(e, trace(dE)))) return Fault::void_ratio_leaves_range;
    return Fault::none;
}

GRIT_KERNEL_END
