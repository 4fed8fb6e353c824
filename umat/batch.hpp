// SPDX-License-Identifier: BSD-3-Clause
// Many points: those that need integration are collected until a pack is full, the others are done on
// the spot. A lane never looks at its neighbours, so the result of a point does not depend on n.
#pragma once

#include "support/dual.hpp"
#include "umat/ordinary_points.hpp"

GRIT_KERNEL_BEGIN

using Lanes = Pack<native_lanes>;

struct Queued {
    Point point;
    Start<double> start;
    std::ptrdiff_t i, at;
    double spent;  // evaluations of a short increment that was not accepted, or 0
};

struct Queue {
    Queued points[native_lanes];
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
        const bool plain = q.options->tangent == GRIT_TANGENT_NONE && !q.options->validate_only;
        if (plain && q.n == 1) {
            q.igs ? take_alone<true>() : take_alone<false>();
        } else if (plain) {
            for (std::ptrdiff_t i = 0; i < q.n; i += native_lanes)
                q.igs ? take_pack<true>(i) : take_pack<false>(i);
        } else {
            for (std::ptrdiff_t i = 0; i < q.n; ++i) take(i);
        }
        flush(turning);
        flush(others);
        return outcome;
    }

  private:
    std::ptrdiff_t place(std::ptrdiff_t i) const {
        return q.points->index ? q.points->index[i] : i;
    }

    // Short increments of ordinary points end here; the other points are taken one by one.
    template <bool igs> void take_pack(std::ptrdiff_t first) {
        const Places<Lanes> places(q.points->index, first, q.n);
        const OrdinaryPoints<Lanes> x = read_ordinary(q, places);
        PackMask<native_lanes> done = x.ordinary;
        Lanes spent(0.0);
        if (any(done)) {
            const StraightPath<Lanes> path = straight_path(m, x.strain_increment, x.h, x.e);
            const Segment<Lanes> start = first_segment<Lanes, igs>(m, path, x.T);
            const auto end = short_increment<Lanes, igs>(m, control, path, start,
                                                         allowed_error(control, path, start), 0.0);
            spent = select(end.accepted, Lanes(0.0), end.evaluations);
            done = write_short(q, first, places, x, path, end, start.last);
        }
        for (int lane = 0; lane < places.count; ++lane)
            if (!done[lane]) {
                if (x.ordinary[lane])
                    enqueue(queued(lane_of(x, lane), first + lane, places.at[lane], spent[lane]));
                else take(first + lane);
            }
    }

    template <bool igs> void take_alone() {
        const Places<double> places(q.points->index, 0, 1);
        const OrdinaryPoints<double> x = read_ordinary(q, places);
        if (!x.ordinary) return take(0);
        const StraightPath<double> path = straight_path(m, x.strain_increment, x.h, x.e);
        const Segment<double> start = first_segment<double, igs>(m, path, x.T);
        const double allowed = allowed_error(control, path, start);
        const auto quick = short_increment<double, igs>(m, control, path, start, allowed, 0.0);
        if (write_short(q, 0, places, x, path, quick, start.last)) return;
        finish(queued(x, 0, places.at[0], 0.0), path,
               integrate<double, igs>(m, control, path, start, quick, allowed, x.advised_step));
    }

    void take(std::ptrdiff_t i) {
        const std::ptrdiff_t at = place(i);
        const RawPoint raw = read_point(*q.points, at);
        const Fault fault = check_point(m, q.igs, q.points->components, raw);
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
        enqueue({p, start_of<double>(m, p, p.strain_increment), i, at, 0.0});
    }

    static Queued queued(const OrdinaryPoints<double>& x, std::ptrdiff_t i, std::ptrdiff_t at,
                         double spent) {
        return {{x.T, x.h, x.strain_increment, x.e, 0.0, x.advised_step, 0, false, false, false},
                {x.T, x.h, x.strain_increment, x.e},
                i,
                at,
                spent};
    }

    // Points of the same kind have as many segments and about as many steps.
    void enqueue(const Queued& x) {
        const bool turns = contract(x.start.h, x.start.strain_increment) < 0.0;
        Queue& queue = turns ? turning : others;
        queue.points[queue.count++] = x;
        if (queue.count == native_lanes) flush(queue);
    }

    void flush(Queue& queue) {
        if (queue.count == 1) alone(queue.points[0]);
        else if (queue.count > 1) together(queue);
        queue.count = 0;
    }

    template <class Real>
    Integrated<Real> integrated(const StraightPath<Real>& path, const Tensor<Real>& T,
                                const PlainOf<Real>& advised, const PlainOf<Real>& spent) const {
        return q.igs ? integrate<Real, true>(m, control, path, T, advised, spent)
                     : integrate<Real, false>(m, control, path, T, advised, spent);
    }

    void alone(const Queued& x) {
        const auto path = straight_path(m, x.start.strain_increment, x.start.h, x.start.e);
        finish(x, path, integrated<double>(path, x.start.T, x.point.advised_step, x.spent));
    }

    void together(const Queue& queue) {
        Tensor<Lanes> dE, T, h;
        Lanes e, advised, spent;
        for (int lane = 0; lane < native_lanes; ++lane) {
            const Queued& x =
                queue.points[lane < queue.count ? lane : 0];  // idle lanes repeat the first point
            for (int c = 0; c < 6; ++c) {
                dE[c].set(lane, x.start.strain_increment[c]);
                T[c].set(lane, x.start.T[c]);
                h[c].set(lane, x.start.h[c]);
            }
            e.set(lane, x.start.e);
            advised.set(lane, x.point.advised_step);
            spent.set(lane, x.spent);
        }
        const StraightPath<Lanes> path = straight_path(m, dE, h, e);
        const Integrated<Lanes> end = integrated<Lanes>(path, T, advised, spent);
        for (int lane = 0; lane < queue.count; ++lane)
            finish(queue.points[lane], lane_of(path, lane), lane_of(end, lane));
    }

    void with_derivatives(const Point& p, std::ptrdiff_t i, std::ptrdiff_t at) {
        Tensor<Dual> dE;
        for (int c = 0; c < 6; ++c) dE[c] = Dual::variable(p.strain_increment[c], c);
        const Start<Dual> start = start_of<Dual>(m, p, dE);
        const auto path = straight_path(m, start.strain_increment, start.h, start.e);
        const Integrated<Dual> end = integrated<Dual>(path, start.T, p.advised_step, 0.0);
        Queued x{p,
                 {value(start.T), value(start.h), value(start.strain_increment), start.e.v},
                 i,
                 at,
                 0.0};
        if (end.failed) return fail(x, end.progress, static_cast<int>(end.evaluations));
        PointResult r = result_of(m, q.igs, p, plain(path), plain(end));
        if (!storable(m, r)) return fail(x, 0.0, r.evaluations);
        r.has_tangent = true;
        for (int row = 0; row < 6; ++row)
            for (int c = 0; c < 6; ++c) r.tangent.c[row][c] = end.y.T[row].d[c];
        for (const auto& row : r.tangent.c)
            if (!finite(row, 6)) return fail(x, 0.0, r.evaluations);
        write_point(q, i, at, p, r);
    }

    void finish(const Queued& x, const StraightPath<double>& path, const Integrated<double>& end) {
        if (end.failed) return fail(x, end.progress, static_cast<int>(end.evaluations));
        const PointResult r = result_of(m, q.igs, x.point, path, end);
        if (!storable(m, r)) return fail(x, 0.0, r.evaluations);
        write_point(q, x.i, x.at, x.point, r);
    }

    void fail(const Queued& x, double progress, int evaluations) {
        double strain[6];
        strain_to_voigt(x.point.strain_increment, strain);
        fail(x.i, Fault::evaluation_limit, strain, progress, evaluations);
    }

    void fail(std::ptrdiff_t i, Fault fault, const double strain[6], double progress,
              int evaluations) {
        write_failure(q, i, fault, norm(strain_from_voigt(strain)), progress, evaluations);
        if (outcome.point < 0 || i < outcome.point) outcome = {fault, i, progress, evaluations};
    }

    template <class Many, class Pick>
    static StraightPath<double> path_with(const StraightPath<Many>& x, Pick pick) {
        StraightPath<double> r;
        for (int c = 0; c < 6; ++c) {
            r.D_hat[c] = pick(x.D_hat[c]);
            r.tau[c] = pick(x.tau[c]);
        }
        r.length = pick(x.length);
        r.tr_D = pick(x.tr_D);
        r.tau_sq = pick(x.tau_sq);
        r.u_0 = pick(x.u_0);
        r.e_0 = pick(x.e_0);
        r.e_end = pick(x.e_end);
        return r;
    }

    template <class Many, class Pick>
    static Integrated<double> integrated_with(const Integrated<Many>& x, Pick pick) {
        Integrated<double> r;
        for (int c = 0; c < 6; ++c) r.y.T[c] = pick(x.y.T[c]);
        r.s = pick(x.s);
        r.h.rho = pick(x.h.rho);
        r.h.c = pick(x.h.c);
        r.h.across = pick(x.h.across);
        r.h.rho_beta = pick(x.h.rho_beta);
        r.h.J = r.h.J_growth = 0.0;
        r.h_late = pick(x.h_late);
        r.failed = pick(x.failed);
        r.separated = pick(x.separated);
        r.outside_cone = pick(x.outside_cone);
        r.separation_at = pick(x.separation_at);
        r.progress = pick(x.progress);
        r.error = pick(x.error);
        r.substeps = pick(x.substeps);
        r.evaluations = pick(x.evaluations);
        r.next_step = pick(x.next_step);
        return r;
    }

    static OrdinaryPoints<double> lane_of(const OrdinaryPoints<Lanes>& x, int lane) {
        OrdinaryPoints<double> r;
        for (int c = 0; c < 6; ++c) {
            r.T[c] = x.T[c][lane];
            r.h[c] = x.h[c][lane];
            r.strain_increment[c] = x.strain_increment[c][lane];
        }
        r.e = x.e[lane];
        r.advised_step = x.advised_step[lane];
        return r;
    }
    static StraightPath<double> lane_of(const StraightPath<Lanes>& x, int lane) {
        return path_with(x, [lane](const auto& y) { return y[lane]; });
    }
    static Integrated<double> lane_of(const Integrated<Lanes>& x, int lane) {
        return integrated_with(x, [lane](const auto& y) { return y[lane]; });
    }
    static StraightPath<double> plain(const StraightPath<Dual>& x) {
        return path_with(x, [](const Dual& y) { return y.v; });
    }
    static Integrated<double> plain(const Integrated<Dual>& x) {
        struct Value {
            double operator()(const Dual& y) const { return y.v; }
            double operator()(double y) const { return y; }
            bool operator()(bool y) const { return y; }
        };
        return integrated_with(x, Value{});
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
