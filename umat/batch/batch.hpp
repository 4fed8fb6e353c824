// SPDX-License-Identifier: BSD-3-Clause
// Many points: ordinary ones as packs, those that need more than a short increment collected until a pack is
// full; the others alone. A lane never looks at its neighbours: the result of a point does not depend on n.
#pragma once

#include "umat/batch/ordinary_points.hpp"

GRIT_KERNEL_BEGIN

using Lanes = Pack<native_lanes>;

// Of an increment that may well be short enough for one step, in R. Where the others are integrated, the same
// step is tried: what is right here is a matter of time alone.
constexpr double promising_length = 0.3;

// Ordinary points to be integrated.
struct Queue {
    std::ptrdiff_t points[native_lanes];
    double spent[native_lanes];  // evaluations of a short increment that was not accepted, or 0
    int count = 0;
};

class Batch {
  public:
    explicit Batch(const UpdateRequest& request)
        : q(request), m(*request.material), control{request.options->tolerance,
                                                    request.options->evaluation_limit} {
        control.next_step_wanted = q.points->substep.base != nullptr;
    }

    UpdateOutcome run() {
        if (q.options->tangent == GRIT_TANGENT_CONSISTENT || q.options->validate_only)
            for (std::ptrdiff_t i = 0; i < q.n; ++i) take(i);
        else q.igs ? take_all<true>() : take_all<false>();
        return outcome;
    }

  private:
    template <bool igs> void take_all() {
        if (q.n == 1) return take_alone<igs>();
        for (std::ptrdiff_t i = 0; i < q.n; i += native_lanes) take_pack<igs>(i);
        flush<igs>(turning);
        flush<igs>(others);
    }

    // Short increments of ordinary points end here.
    template <bool igs> void take_pack(std::ptrdiff_t first) {
        const auto lane_points = LanePoints<Lanes>::from(q, first);
        const OrdinaryPoints<Lanes> x = read_ordinary(q, lane_points);
        const StraightPath<Lanes> path = straight_path(m, x.strain_increment, x.h, x.e);
        PackMask<native_lanes> turns(false), shorter = x.ordinary;
        if constexpr (igs) {
            turns = turns_on_the_way(m, path);
            shorter = shorter & !turns & (path.length <= Lanes(promising_length * m.R));
        }
        PackMask<native_lanes> done(false);
        Lanes spent(0.0);
        if (any(shorter)) {
            const Segment<Lanes> start = first_segment<Lanes, igs>(m, path, x.T);
            const auto end = short_increment<Lanes, igs>(m, control, path, start,
                                                         allowed_error(m, control, path, start),
                                                         select(shorter, Lanes(0.0), Lanes(1.0)));
            spent = select(shorter & !end.accepted, end.evaluations, Lanes(0.0));
            done = write_ends(q, lane_points, x, path, end_of(path, start, end));
        }
        for (int lane = 0; lane < lane_points.count; ++lane) {
            if (done[lane]) continue;
            if (x.ordinary[lane])
                enqueue<igs>(turns[lane] ? turning : others, lane_points.i[lane], spent[lane]);
            else take(lane_points.i[lane]);
        }
    }

    template <bool igs> void take_alone() {
        const auto lane_points = LanePoints<double>::from(q, 0);
        const OrdinaryPoints<double> x = read_ordinary(q, lane_points);
        if (!x.ordinary) return take(0);
        const StraightPath<double> path = straight_path(m, x.strain_increment, x.h, x.e);
        const Segment<double> start = first_segment<double, igs>(m, path, x.T);
        const double allowed = allowed_error(m, control, path, start);
        const auto quick = short_increment<double, igs>(m, control, path, start, allowed, 0.0);
        if (write_ends(q, lane_points, x, path, end_of(path, start, quick))) return;
        const auto end =
            integrate<double, igs>(m, control, path, start, quick, allowed, x.advised_step);
        if (!write_ends(q, lane_points, x, path, end_of(end))) take(0);
    }

    // Points of the same kind have as many segments and about as many steps.
    template <bool igs> void enqueue(Queue& queue, std::ptrdiff_t i, double spent) {
        queue.points[queue.count] = i;
        queue.spent[queue.count++] = spent;
        if (queue.count == native_lanes) flush<igs>(queue);
    }

    template <bool igs> void flush(Queue& queue) {
        if (queue.count == 0) return;
        const auto lane_points = LanePoints<Lanes>::of(q, queue.points, queue.count);
        const OrdinaryPoints<Lanes> x = read_ordinary(q, lane_points);
        Lanes spent;
        for (int lane = 0; lane < native_lanes; ++lane)
            spent.set(lane, queue.spent[lane < queue.count ? lane : 0]);
        const StraightPath<Lanes> path = straight_path(m, x.strain_increment, x.h, x.e);
        const auto end = integrate<Lanes, igs>(m, control, path, x.T, x.advised_step, spent);
        const PackMask<native_lanes> done = write_ends(q, lane_points, x, path, end_of(end));
        for (int lane = 0; lane < queue.count; ++lane)
            if (!done[lane]) take(lane_points.i[lane]);
        queue.count = 0;
    }

    // A point that may be anything, or comes to an end that is not ordinary.
    void take(std::ptrdiff_t i) {
        const std::ptrdiff_t at = q.points->index ? q.points->index[i] : i;
        const RawPoint raw = read_point(*q.points, at);
        const Fault fault = check_point(m, *q.options, q.igs, q.points->components, raw);
        if (fault != Fault::none) return fail(i, fault, raw.strain, 0.0, 0);
        if (q.options->validate_only) {
            write_report(q.reports ? q.reports + i : nullptr, 0, 0, 0, 0.0);
            return;
        }
        Point p = prepare_point(*q.options, raw);
        enter_domain(m, q.igs, p);
        if (p.resting) return write_resting(q, i, at, raw, p);
        if (p.stress_free) return write_point(q, i, at, p, separated_result(q.igs, p));
        if (q.options->tangent == GRIT_TANGENT_CONSISTENT) return with_derivatives(p, i, at);
        const Start<double> start = start_of<double>(m, p, p.strain_increment);
        const auto path = straight_path(m, start.strain_increment, start.h, start.e);
        const auto end = integrated<double>(path, start.T, p.advised_step);
        if (end.failed) return fail(p, i, end);
        const PointResult r = result_of(m, q.igs, p, path, end);
        if (const Fault f = fault_of(m, r); f != Fault::none) return fail(p, i, end, f);
        write_point(q, i, at, p, r);
    }

    template <class Real>
    Integrated<Real> integrated(const StraightPath<Real>& path, const Tensor<double>& T,
                                double advised) const {
        return q.igs ? integrate<Real, true>(m, control, path, T, advised, 0.0)
                     : integrate<Real, false>(m, control, path, T, advised, 0.0);
    }

    void with_derivatives(const Point& p, std::ptrdiff_t i, std::ptrdiff_t at) {
        const StrainDirections along =
            strain_directions(p.strain_increment, q.igs ? p.h : isotropic(0.0));
        const Start<Dual> start = start_of<Dual>(m, p, variable(p.strain_increment, along));
        const auto path = straight_path(m, start.strain_increment, start.h, start.e);
        const Integrated<Dual> dual_end = integrated<Dual>(path, start.T, p.advised_step);
        const Integrated<double> end = plain(dual_end);
        if (end.failed) return fail(p, i, end);
        PointResult r = result_of(m, q.igs, p, plain(path), end);
        if (const Fault f = fault_of(m, r); f != Fault::none) return fail(p, i, end, f);
        r.has_tangent = true;
        for (int row = 0; row < 6; ++row) {
            const Six slope = by_strain(dual_end.y.T[row], along);
            for (int c = 0; c < 6; ++c) r.tangent.c[row][c] = slope[c];
            if (!are_finite(r.tangent.c[row], 6)) return fail(p, i, end);
        }
        write_point(q, i, at, p, r);
    }

    void fail(const Point& p, std::ptrdiff_t i, const Integrated<double>& end,
              Fault fault = Fault::evaluation_limit) {
        double strain[6];
        strain_to_voigt(p.strain_increment, strain);
        fail(i, fault, strain, end.failed ? end.progress : 0.0, static_cast<int>(end.evaluations));
    }

    void fail(std::ptrdiff_t i, Fault fault, const double strain[6], double progress,
              int evaluations) {
        write_failure(q, i, fault, norm(strain_from_voigt(strain)), progress, evaluations);
        if (outcome.point < 0 || i < outcome.point) outcome = {fault, i, progress, evaluations};
    }

    static StraightPath<double> plain(const StraightPath<Dual>& x) {
        return {value(x.D_hat), value(x.tau), x.length.v, x.tr_D.v,
                x.tau_sq.v,     x.u_0.v,      x.e_0.v,    x.e_end.v};
    }
    static Integrated<double> plain(const Integrated<Dual>& x) {
        Integrated<double> r;
        r.y.T = value(x.y.T);
        r.s = x.s.v;
        r.h = {x.h.rho.v, x.h.c.v, x.h.across.v, x.h.J.v, x.h.J_growth.v, x.h.rho_beta};
        r.h_late = x.h_late;
        r.failed = x.failed;
        r.separated = x.separated;
        r.outside_cone = x.outside_cone;
        r.separation_at = x.separation_at.v;
        r.progress = x.progress;
        r.error = x.error;
        r.substeps = x.substeps;
        r.evaluations = x.evaluations;
        r.next_step = x.next_step;
        return r;
    }

    const UpdateRequest& q;
    const Material& m;
    Control control;
    Queue turning, others;
    UpdateOutcome outcome;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

UpdateOutcome update(const UpdateRequest& request) { return Batch(request).run(); }

}  // namespace grit::GRIT_TARGET
