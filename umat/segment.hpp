// SPDX-License-Identifier: BSD-3-Clause
// Segments of a straight strain path: smooth pieces between the events of the intergranular strain.
#pragma once

#include "umat/stress_rate.hpp"

GRIT_KERNEL_BEGIN

// Between two events of a path, and how far the steps have come.
template <class Real> struct Segment {
    Real start, end;       // arc lengths
    MaskOf<Real> loading;  // branch of the intergranular strain
    MaskOf<Real> last;
    PlainOf<Real> done;  // fraction
};

template <class Real, bool igs>
GRIT_INLINE Segment<Real> first_segment(const Material& m, const StraightPath<Real>& path) {
    Segment<Real> g;
    g.start = path.length * 0.0;
    g.done = PlainOf<Real>(0.0);
    g.end = path.length;
    g.loading = MaskOf<Real>(true);
    g.last = MaskOf<Real>(true);
    if constexpr (igs) {
        const Real reversal = -m.R * path.u_0;  // arc length where h:D_hat = 0
        g.loading = path.u_0 >= Real(0.0);
        g.last = g.loading | (reversal >= path.length);
        g.end = select(g.last, path.length, reversal);
    }
    return g;
}

// Share of |dh| in |de| [-]: 1 where h follows the strain, 0 where it is saturated along D_hat.
template <class Real, bool igs>
GRIT_INLINE PlainOf<Real> memory_rate(const Material& m, const StraightPath<Real>& path,
                                      const Marched<Real>& y, const Marched<Real>& rate,
                                      const MaskOf<Real>& loading) {
    using Plain = PlainOf<Real>;
    if constexpr (!igs) return Plain(0.0);
    const Plain along = exp(-value(y.P)) * fabs(value(rate.P));
    const Plain across = exp(-value(y.G)) * sqrt(value(path.tau_sq)) * fabs(value(rate.G));
    return select(loading, min(m.R * (along + across), Plain(1.0)), Plain(1.0));
}

GRIT_KERNEL_END
