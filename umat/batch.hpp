// SPDX-License-Identifier: BSD-3-Clause
// Many points: those that need integration are collected until a pack is full, the others are done on
// the spot. A lane never looks at its neighbours, so the result of a point does not depend on n.
#pragma once

#include "support/dual.hpp"
#include "umat/finish.hpp"

GRIT_KERNEL_BEGIN

using Lanes = Pack<native_lanes>;

struct Queued {
    Point point;
    Start<double> start;
    std::ptrdiff_t i, at;
};

class Batch {
  public:
    explicit Batch(const UpdateRequest& request)
        : q(request), m(*request.material), control{request.options->tolerance,
                                                    request.options->evaluation_limit} {}

    UpdateOutcome run() {
        for (std::ptrdiff_t i = 0; i < q.n; ++i) take(i);
        flush();
        return outcome;
    }

  private:
    void take(std::ptrdiff_t i) {
        const std::ptrdiff_t at = q.points->index ? q.points->index[i] : i;
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
        queue[queued++] = {p, start_of<double>(m, p, p.strain_increment), i, at};
        if (queued == native_lanes) flush();
    }

    void flush() {
        if (queued == 1) alone(queue[0]);
        else if (queued > 1) together();
        queued = 0;
    }

    template <class Real>
    Integrated<Real> integrated(const StraightPath<Real>& path, const Tensor<Real>& T,
                                const PlainOf<Real>& advised) const {
        return q.igs ? integrate<Real, true>(m, control, path, T, advised)
                     : integrate<Real, false>(m, control, path, T, advised);
    }

    void alone(const Queued& x) {
        const auto path = straight_path(m, x.start.strain_increment, x.start.h, x.start.e);
        finish(x, path, integrated<double>(path, x.start.T, x.point.advised_step));
    }

    void together() {
        Tensor<Lanes> dE, T, h;
        Lanes e, advised;
        for (int lane = 0; lane < native_lanes; ++lane) {
            const Queued& x = queue[lane < queued ? lane : 0];  // idle lanes repeat the first point
            for (int c = 0; c < 6; ++c) {
                dE[c].set(lane, x.start.strain_increment[c]);
                T[c].set(lane, x.start.T[c]);
                h[c].set(lane, x.start.h[c]);
            }
            e.set(lane, x.start.e);
            advised.set(lane, x.point.advised_step);
        }
        const StraightPath<Lanes> path = straight_path(m, dE, h, e);
        const Integrated<Lanes> end = integrated<Lanes>(path, T, advised);
        for (int lane = 0; lane < queued; ++lane)
            finish(queue[lane], lane_of(path, lane), lane_of(end, lane));
    }

    void with_derivatives(const Point& p, std::ptrdiff_t i, std::ptrdiff_t at) {
        Tensor<Dual> dE;
        for (int c = 0; c < 6; ++c) dE[c] = Dual::variable(p.strain_increment[c], c);
        const Start<Dual> start = start_of<Dual>(m, p, dE);
        const auto path = straight_path(m, start.strain_increment, start.h, start.e);
        const Integrated<Dual> end = integrated<Dual>(path, start.T, p.advised_step);
        Queued x{
            p, {value(start.T), value(start.h), value(start.strain_increment), start.e.v}, i, at};
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
        return r;
    }

    template <class Many, class Pick>
    static Integrated<double> integrated_with(const Integrated<Many>& x, Pick pick) {
        Integrated<double> r;
        for (int c = 0; c < 6; ++c) r.y.T[c] = pick(x.y.T[c]);
        r.y.P = pick(x.y.P);
        r.y.G = pick(x.y.G);
        r.h = {pick(x.h.u), pick(x.h.g)};
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
    const Control control;
    Queued queue[native_lanes];
    int queued = 0;
    UpdateOutcome outcome;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

UpdateOutcome update(const UpdateRequest& request) { return Batch(request).run(); }

}  // namespace grit::GRIT_TARGET
