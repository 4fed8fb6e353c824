// SPDX-License-Identifier: BSD-3-Clause
// Ordinary points: nothing to scale back, to close or to refuse. They need no decisions one by one,
// so that they are read, checked and written as packs; every other point goes through point.hpp.
#pragma once

#include "umat/batch/finish.hpp"
#include "umat/batch/lane_points.hpp"

GRIT_KERNEL_BEGIN

template <class Real> GRIT_INLINE MaskOf<Real> only_lane(int lane) {
    Real x(0.0);
    set_lane(x, lane, 1.0);
    return x > Real(0.5);
}

template <class Real> struct OrdinaryPoints {
    Tensor<Real> T, h, strain_increment;  // T shifted by p_t
    Real e, advised_step;
    MaskOf<Real> ordinary;
};

// What is not turned stays as it is to the last bit.
template <class Real>
GRIT_INLINE void turn(const UpdateRequest& request, const LanePoints<Real>& lane_points,
                      OrdinaryPoints<Real>& r) {
    const grit_sand_points& q = *request.points;
    Real Q[9], off(0.0);
    for (int c = 0; c < 9; ++c) Q[c] = read(q.rotation_increment, lane_points, c);
    if (q.components == 4) keep_in_plane(Q);
    for (int c = 0; c < 9; ++c) off = off + fabs(Q[c] - (c % 4 == 0 ? 1.0 : 0.0));
    const MaskOf<Real> stays = off <= Real(0.0);
    r.ordinary = r.ordinary & (stays | is_rotation(Q, q.components == 4));
    r.h = select(stays, r.h, rotated(Q, r.h));
    if (!request.options->stress_is_rotated) r.T = select(stays, r.T, rotated(Q, r.T));
}

template <class Real>
GRIT_INLINE OrdinaryPoints<Real> read_ordinary(const UpdateRequest& request,
                                               const LanePoints<Real>& lane_points) {
    const Material& m = *request.material;
    const grit_sand_points& q = *request.points;
    const bool igs = request.igs;
    const int n = q.components == 0 ? 6 : q.components;
    const Real zero(0.0);
    OrdinaryPoints<Real> r;
    for (int c = 0; c < 6; ++c) {
        const double to_strain = c < 3 ? 1.0 : root_half, to_stress = c < 3 ? 1.0 : root_2;
        r.strain_increment[c] = c < n ? to_strain * read(q.strain_increment, lane_points, c) : zero;
        r.T[c] = c < n ? to_stress * read(q.stress, lane_points, c) : zero;
        r.h[c] = to_strain * read(q.state, lane_points, c);
    }
    r.e = read(q.state, lane_points, GRIT_SAND_VOID_RATIO);
    const Real w = read(q.state, lane_points, GRIT_SAND_SEPARATION);
    r.advised_step = zero;
    r.ordinary = MaskOf<Real>(true);
    for (int lane = lane_points.count; lane < LanePoints<Real>::lanes; ++lane)
        r.ordinary = r.ordinary & !only_lane<Real>(lane);
    if (q.substep.base) r.advised_step = read(q.substep, lane_points, 0);
    if (q.rotation_increment.base) turn(request, lane_points, r);

    // Comparisons are written so that a NaN is not ordinary.
    const auto within = [](const Tensor<Real>& A, double limit) {
        return contract(A, A) <= Real(limit * limit);
    };
    r.ordinary = r.ordinary & within(r.T, largest_stress_per_h_s * m.h_s) &
                 within(r.strain_increment, largest_increment) &
                 (contract(r.strain_increment, r.strain_increment) >= Real(1e-190));
    r.ordinary = r.ordinary & within(r.h, igs ? m.R * (1.0 + 1e-6) : 1e150);
    if (n == 4 && igs) r.ordinary = r.ordinary & (fabs(r.h[4]) + fabs(r.h[5]) <= zero);
    const Real opened =
        (1.0 + r.e) * (1.0 + trace(r.strain_increment));  // a bound of 1 + e at the end
    r.ordinary = r.ordinary & (r.e > zero) & (r.e <= Real(0.5 * largest_void_ratio)) &
                 (opened > Real(1.0 + 1e-9)) & (w <= zero) & (w >= zero) &
                 (r.advised_step >= zero) & (r.advised_step <= Real(1e300));
    for (int c = 0; c < 3; ++c) r.T[c] = r.T[c] - m.p_t;  // (H10)
    const Real pressure = trace(r.T) * (-1.0 / 3.0);
    r.ordinary = r.ordinary & (pressure >= Real(m.p_floor)) & !outside_cone(r.T);
    return r;
}

// Where a path ended, by one short increment or step by step.
template <class Real> struct PathEnd {
    Tensor<Real> T;
    Mobilisation<Real> h;
    PlainOf<Real> h_late, next_step, error, substeps, evaluations;
    MaskOf<Real> outside_cone;
    MaskOf<Real> reached;  // with stress
    Marched<Real> start;   // of the path, or no stress: flags take a logarithm then
};

template <class Real>
GRIT_INLINE PathEnd<Real> end_of(const StraightPath<Real>& path, const Segment<Real>& start,
                                 const ShortIncrement<Real>& x) {
    return {x.T,
            x.h,
            x.h_late,
            path.length,
            x.error,
            PlainOf<Real>(1.0),
            x.evaluations,
            x.outside_cone,
            MaskOf<Real>(x.accepted & start.last),
            start.y};
}

template <class Real> GRIT_INLINE PathEnd<Real> end_of(const Integrated<Real>& x) {
    return {x.y.T,
            x.h,
            x.h_late,
            x.next_step,
            x.error,
            x.substeps,
            x.evaluations,
            x.outside_cone,
            MaskOf<Real>(!(x.failed | x.separated)),
            {isotropic(Real(0.0)), {Real(0.0), Real(1.0)}}};
}

template <class Real>
GRIT_INLINE void write_reports(const UpdateRequest& request, const LanePoints<Real>& lane_points,
                               const StraightPath<Real>& path, const PathEnd<Real>& end,
                               const MaskOf<Real>& done) {
    const MaskOf<Real> clamped =
        void_clamped(*request.material, end.start, end.T, path.e_end, done);
    for (int lane = 0; lane < LanePoints<Real>::lanes; ++lane) {
        if (!lane_of(done, lane)) continue;
        const int flags = (lane_of(end.outside_cone, lane) ? GRIT_SAND_OUTSIDE_CONE : 0) |
                          (lane_of(clamped, lane) ? GRIT_SAND_VOID_CLAMPED : 0);
        write_report(request.reports + lane_points.i[lane], flags,
                     static_cast<int>(lane_of(end.substeps, lane)),
                     static_cast<int>(lane_of(end.evaluations, lane)), lane_of(end.error, lane));
    }
}

// Writes the ordinary points that reached their ends: says which.
template <class Real>
GRIT_INLINE MaskOf<Real> write_ends(const UpdateRequest& request,
                                    const LanePoints<Real>& lane_points,
                                    const OrdinaryPoints<Real>& x, const StraightPath<Real>& path,
                                    const PathEnd<Real>& end) {
    const Material& m = *request.material;
    const grit_sand_points& q = *request.points;
    const double limit = largest_stress_per_h_s * m.h_s - m.p_t;
    const MaskOf<Real> done =
        x.ordinary & end.reached & (contract(end.T, end.T) <= Real(limit * limit));
    if (!any(done)) return done;
    const int n = q.components == 0 ? 6 : q.components;
    for (int c = 0; c < n; ++c) {
        const Real T = c < 3 ? end.T[c] + m.p_t : end.T[c] * root_half;  // (H10)
        write(q.stress, lane_points, c, T, done);
    }
    Tensor<Real> h = x.h;
    if (request.igs) {
        h = h_at_end(m, path, end.h, end.h_late);
        for (int c = 0; c < 6; ++c)
            write(q.state, lane_points, c, c < 3 ? h[c] : h[c] * root_2, done);
    }
    write(q.state, lane_points, GRIT_SAND_VOID_RATIO, path.e_end, done);
    write(q.state, lane_points, GRIT_SAND_SEPARATION, Real(0.0), done);
    if (q.substep.base) write(q.substep, lane_points, 0, end.next_step, done);
    if (request.reports) write_reports(request, lane_points, path, end, done);
    if (request.options->tangent == GRIT_TANGENT_CONTINUUM)
        for (int lane = 0; lane < LanePoints<Real>::lanes; ++lane)
            if (lane_of(done, lane))
                write_tangent(q, lane_points.at[lane],
                              continuum_tangent(m, request.igs, lane_of(end.T, lane),
                                                lane_of(h, lane), lane_of(path.e_end, lane),
                                                lane_of(x.strain_increment, lane)));
    return done;
}

GRIT_KERNEL_END
