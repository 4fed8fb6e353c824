// SPDX-License-Identifier: BSD-3-Clause
// Places of one point's course as lanes. Of a dual only the directions that a course depends on are carried.
#pragma once

#include "umat/model/intergranular_strain.hpp"
#include "umat/model/strain_directions.hpp"

GRIT_KERNEL_BEGIN

// Whether the places of a point are taken as lanes. With derivatives they are where one register holds them;
// else there are too many of them to be kept.
template <class Real>
constexpr bool takes_lanes = std::is_same_v<Real, double> ||
                             (std::is_same_v<Real, Dual> && native_lanes == 8);

template <int W> using DualPack = DualOf<Pack<W>, Pack<W>, course_directions>;

template <int W> GRIT_INLINE Pack<W> in_lanes(double x) { return x; }
template <int W> GRIT_INLINE DualPack<W> in_lanes(const Dual& x) {
    return {x.v, DualPack<W>::Derivatives::each([&](int i) { return Pack<W>(x.d[i]); })};
}

template <int W> GRIT_INLINE double of_lane(const Pack<W>& x, int lane) { return x[lane]; }
template <int W> GRIT_INLINE Dual of_lane(const DualPack<W>& x, int lane) {
    return {x.v[lane], Dual::Derivatives::along(
                           [&](int i) { return i < course_directions ? x.d[i][lane] : 0.0; })};
}

// What one lane holds, in all.
template <int W> GRIT_INLINE Pack<W> spread(const Pack<W>& x, int lane) { return x[lane]; }
template <int W> GRIT_INLINE DualPack<W> spread(const DualPack<W>& x, int lane) {
    return {x.v[lane],
            DualPack<W>::Derivatives::each([&](int i) { return Pack<W>(x.d[i][lane]); })};
}

template <class Real, int W> using InLanes = decltype(in_lanes<W>(Real()));

template <int W, class Real>
GRIT_INLINE Course<InLanes<Real, W>> course_in_lanes(const Course<Real>& x) {
    const LoadingCurve<Real>& c = x.curve;
    return {x.loading,
            {in_lanes<W>(c.E_sq), in_lanes<W>(c.across), in_lanes<W>(c.y), in_lanes<W>(c.kappa)},
            in_lanes<W>(x.u_0),
            in_lanes<W>(x.tau_sq)};
}

GRIT_KERNEL_END
