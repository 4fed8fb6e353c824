// SPDX-License-Identifier: BSD-3-Clause
// Components of some points between the host's arrays and the lanes of a pack. Columns of neighbouring points
// are read and written whole, anything else lane by lane.
#pragma once

#include "support/pack.hpp"
#include "umat/batch/point.hpp"

GRIT_KERNEL_BEGIN

template <class Real> GRIT_INLINE Tensor<double> lane_of(const Tensor<Real>& A, int lane) {
    Tensor<double> r;
    for (int c = 0; c < 6; ++c) r[c] = lane_of(A[c], lane);
    return r;
}

template <class Real> struct LanePoints {
    static constexpr int lanes = NumberTraits<Real>::lanes;
    std::ptrdiff_t i[lanes];   // numbers of the points in the call
    std::ptrdiff_t at[lanes];  // and where they lie
    int count;                 // lanes in use; the others repeat a point
    bool neighbours;           // all lanes in use, one point after the other

    // Points first, first + 1, ... of a call, as far as there are any.
    template <class Request>
    static GRIT_INLINE LanePoints from(const Request& q, std::ptrdiff_t first) {
        LanePoints r;
        r.count = q.n - first < lanes ? static_cast<int>(q.n - first) : lanes;
        for (int lane = 0; lane < lanes; ++lane)
            r.i[lane] = first + (lane < r.count ? lane : r.count - 1);
        r.find(q.points->index);
        return r;
    }
    template <class Request>
    static GRIT_INLINE LanePoints of(const Request& q, const std::ptrdiff_t* points, int count) {
        LanePoints r;
        r.count = count;
        for (int lane = 0; lane < lanes; ++lane) r.i[lane] = points[lane < count ? lane : 0];
        r.find(q.points->index);
        return r;
    }

  private:
    LanePoints() = default;
    GRIT_INLINE void find(const std::ptrdiff_t* index) {
        neighbours = lanes > 1 && count == lanes;
        for (int lane = 0; lane < lanes; ++lane) {
            at[lane] = index ? index[i[lane]] : i[lane];
            neighbours = neighbours && at[lane] == at[0] + lane;
        }
    }
};

template <class Real, class View>
GRIT_INLINE Real read(const View& view, const LanePoints<Real>& lane_points, int c) {
    Real x;
    if (lane_points.neighbours && view.point_stride == 1) {
        __builtin_memcpy(&x, view.base + lane_points.at[0] + c * view.component_stride, sizeof x);
        return x;
    }
    for (int lane = 0; lane < LanePoints<Real>::lanes; ++lane)
        set_lane(x, lane, component(view, lane_points.at[lane], c));
    return x;
}

template <class Real>
GRIT_INLINE void write(const grit_mutable_view& view, const LanePoints<Real>& lane_points, int c,
                       const Real& x, const MaskOf<Real>& where) {
    if (lane_points.neighbours && view.point_stride == 1) {
        const Real there = select(where, x, read(view, lane_points, c));
        __builtin_memcpy(view.base + lane_points.at[0] + c * view.component_stride, &there,
                         sizeof there);
        return;
    }
    for (int lane = 0; lane < LanePoints<Real>::lanes; ++lane)
        if (lane_of(where, lane)) component(view, lane_points.at[lane], c) = lane_of(x, lane);
}

GRIT_KERNEL_END
