// SPDX-License-Identifier: BSD-3-Clause
// Error-controlled integration of the stress along a segment of a strain path: docs/adr/0001. A derivative
// carried through differentiates the ends of the steps and replays those that were accepted.
#pragma once

#include "umat/integrate/course_search.hpp"
#include "umat/integrate/runge_kutta.hpp"
#include "umat/integrate/segment.hpp"
#include "umat/model/cone.hpp"

GRIT_KERNEL_BEGIN

template <class Real>
GRIT_INLINE MaskOf<Real> is_affordable(const Control& control, const Integrated<Real>& so_far,
                                       double evaluations) {
    return so_far.evaluations + evaluations <=
           PlainOf<Real>(static_cast<double>(control.evaluation_limit));
}

// One point, or one per lane, on its way along a segment. Masks say which lanes an action is for; what
// the other lanes hold is never changed.
template <class Real, bool igs> class Integrator {
    using Plain = PlainOf<Real>;
    using Mask = MaskOf<Real>;

  public:
    // The lanes "where", from the start of the segment; out goes on.
    Integrator(const MaterialOf<Real>& material, const Control& limits,
               const StraightPath<Real>& along, const Segment<Real>& start, const Mask& where,
               const Plain& allowed_here, const Plain& advised, Integrated<Real>& result)
        : m(material), control(limits), path(along), seg(start), allowed(allowed_here),
          advised_step(advised), out(result), k1(start.rate), here(start.at), active(where) {
        assign(active, out.y, start.y);
        assign(active, out.h, start.h);
        out.s = select(active, start.s, out.s);
        const Real zero = path.length * 0.0;
        from = {zero, zero + 1.0, start.s, start.e};
        step = Plain(0.0);
        needs_rate = Mask(false);
    }

    void run() {
        while (any(active)) {
            left = seg.end - out.s;
            stress_scale = max(seg.stress_scale, norm(value(out.y.T)));
            if (any(active & needs_rate)) evaluate_rate(active & needs_rate);
            give_up(active & !affordable(6.0));
            if (!any(active)) break;
            choose_step();
            attempt();
            judge();
            advance();
        }
    }

  private:
    void evaluate_rate(const Mask& needed) {
        give_up(needed & !affordable(1.0));
        const Mask now = needed & active;
        Waypoint<Real> at;
        from.e = select(now, void_ratio(path, from.s), from.e);
        if constexpr (igs) {
            const Mobilisation<Real> h = mobilisation(m, seg.course, from.q, from.decay);
            at = waypoint(m, seg.course.loading, h, from.e);
            assign(now, out.h, h);
        } else {
            at = basic_waypoint(m, from.e);
        }
        assign(now, here, at);
        assign(now, out.y, marched(m, out.y.T));
        assign(now, k1, course_rate<Real, igs>(m, path, at, out.y));
        count(now, 1.0);
    }

    void choose_step() {
        const Plain relative_rate = norm(value(k1.T)) / stress_scale;  // per q
        const Real all = predicted_course(m, out.h.J, out.h.J_growth, left);
        choose_length(relative_rate, value(all));
        dq = select(to_end, all, Real(step));
        find_course();
        if constexpr (igs) meet_end_of_segment();
    }

    void choose_length(const Plain& relative_rate, const Plain& all) {
        const Plain none(0.0), least(1e-30);
        const Mask starting = active & (step <= none);
        if (any(starting)) {
            const Plain change_of_h = 0.2 * value(out.h.J) * memory_here();
            const Plain first = control.reach / max(change_of_h + 0.5 * relative_rate, least);
            const Plain advised = advised_step / value(here.ds);
            step = select(starting, select(advised > none, advised, first), step);
            if constexpr (igs)
                if (any(starting & seg.course.loading))
                    step = select(starting & seg.course.loading, min(step, gentle_start()), step);
        }
        const Plain longest = growth_reach * control.reach / max(relative_rate, least);
        const Plain smooth = 2.0 / max(fabs(value(out.h.J_growth)), least);  // e-folds of J
        step = select(active, min(step, min(longest, smooth)), step);
        // The last two steps of a segment are made equal.
        to_end = step >= 0.95 * all;
        step = select(active & !to_end & (2.0 * step > all), 0.5 * all, step);
    }

    Plain memory_here() const {
        if constexpr (igs) return memory_of(out.h, seg.course.loading);
        return Plain(0.0);
    }

    // Rates have no derivative where h = 0: rho^chi (G1). Steps grow from the one whose error is within
    // what is allowed, or with rho itself.
    Plain gentle_start() const {
        const double chi = plain(m).chi, beta_r = plain(m).beta_r;
        const double order = chi < 1.0 + beta_r ? 1.0 + chi : 2.0 + beta_r;
        const Plain rate = plain(m).R * norm(value(k1.T)) / stress_scale / value(here.ds);
        const Plain error = allowed / (error_safety * max(rate, Plain(1e-30)));
        const Plain smooth = rough_root(max(error, Plain(1e-30)), order);
        return max(start_reach * smooth, 3.0 * value(out.h.rho));
    }

    // A step to the end of the segment ends there, and none goes beyond; but no farther than the step that was meant.
    void meet_end_of_segment() {
        const Mask loading = active & seg.course.loading;
        to_end = to_end | (loading & (value(course.arc) > value(left)));
        Mask open = loading & to_end;
        CourseSearch<Real> search(plain(m), value(left));
        for (int i = 0; i < longest_search; ++i) {
            const Real excess = course.arc - left;
            open = open & !(fabs(value(excess)) <= control.tolerated_excess() * value(left));
            if (!any(open)) break;
            dq = select(open, search.next(open, dq, excess, m.R * course.end.J), dq);
            find_course();
            open = open & (search.lowest() <= 1.1 * step);
        }
        const Mask beyond =
            active & to_end & !((value(dq) <= 1.1 * step) & (search.lowest() <= 1.1 * step));
        if (any(beyond | open)) {
            dq = select(beyond, Real(step), select(open, Real(search.lowest()), dq));
            to_end = to_end & !(beyond | open);
            find_course();
        }
    }

    void find_course() {
        if constexpr (!igs) {
            basic_step_course(m, path, from, dq, course);
            return;
        }
        step_course(m, path, seg.course, from, out.h.J, dq, course);
        const Plain rho = value(out.h.rho);
        const Panels panels = control.panels(plain(m));
        const Mask sharp = active & seg.course.loading & panels.needed<Plain>(rho, value(dq));
        if (any(sharp))
            course.arc =
                select(sharp, arc_length(m, seg.course, from.q, dq, rho, panels), course.arc);
    }

    void attempt() {
        arc = select(to_end, left, course.arc);
        const StepContext<Real> c{m, path, dq, arc, stress_scale};
        if constexpr (igs) average(m, seg.course, here, course, averaged);
        else basic_average(m, course, averaged);
        trial = dormand_prince_step<Real, igs>(c, out.y, k1, here, averaged);
        count(active, 6.0);
    }

    // Accepted, separating or rejected. Comparisons are written so that a NaN is a rejection.
    void judge() {
        const Plain p_open(opening_pressure(plain(m)));
        const Plain p_0 = trace(value(out.y.T)) * (-1.0 / 3.0);
        const Plain p_1 = trace(value(trial.y.T)) * (-1.0 / 3.0);
        // Where the stress falls, it is told from none: a point must not go on with what is noise at its start.
        const Plain told = resolution * max(norm(value(trial.y.T)), 20.0 * p_open) / stress_scale;
        tolerable = select(p_1 < p_0, min(allowed, told), allowed);
        const Mask good = trial.error <= tolerable;
        above = (p_1 >= p_open) | ((p_1 >= p_0) & (p_1 > Plain(0.0)));
        accepted = active & good & above;
        // Falling below the opening pressure: the point separates, from close above it only.
        const Mask close = (p_0 <= 2.0 * p_open) & (trace(value(k1.T)) > Plain(0.0));
        separating = active & good & !above & (p_1 < p_0) & close;
        rejected = active & !(accepted | separating);
        if (any(separating)) separate();
    }

    void separate() {
        const Real p_0 = trace(out.y.T) * (-1.0 / 3.0);
        const Real p_1 = trace(trial.y.T) * (-1.0 / 3.0);
        const Real part = (p_0 - opening_pressure(m)) / (p_0 - p_1);
        Real at = fma(min(max(part, Real(0.0)), Real(1.0)), arc, out.s);
        if constexpr (is_sensitive<Real>) {
            // It moves with the place of p_0, a hair before it: the slope there is not that of the whole step.
            const Plain slope = trace(value(k1.T)) * (-1.0 / 3.0) / value(here.ds);
            const Real moved = out.s + (opening_pressure(m) - p_0) / slope;
            const Mask within = (value(part) > Plain(0.0)) & (value(part) < Plain(1.0));
            at = select(within, value(at) + (moved - value(moved)), at);
        }
        out.separation_at = select(separating, at, out.separation_at);
        out.separated = out.separated | separating;
    }

    void advance() {
        const Plain zero(0.0);
        const Plain one(1.0);
        assign(accepted, out.y, trial.y);
        out.s = select(accepted, select(to_end, seg.end, out.s + arc), out.s);
        assign(accepted, out.h, course.end);
        from.q = select(accepted, from.q + dq, from.q);
        from.decay = select(accepted, course.end_decay, from.decay);
        from.s = out.s;
        from.e = select(accepted, (1.0 + from.e) * exp_small(arc * path.tr_D) - 1.0, from.e);
        assign(accepted, here, averaged.end);
        assign(accepted, k1, trial.rate);
        const Mask projected = back_into_cone(out.y.T, accepted);
        out.outside_cone = out.outside_cone | projected;
        out.error = out.error + select(accepted, trial.error, zero);
        out.substeps = out.substeps + select(accepted | separating, one, zero);

        const Mask ended = accepted & to_end;
        out.h_late = select(ended, of_memory(left) - of_memory(course.arc), out.h_late);
        if (control.next_step_wanted || any(active & !(ended | separating))) adapt_step();
        give_up(rejected & (step * plain(m).R < smallest_fraction * value(path.length)));
        active = active & !(separating | ended);
        needs_rate = projected;
    }

    void adapt_step() {
        const Plain ratio = tolerable / max(trial.error, 1e-30 * tolerable);
        Plain factor = 0.9 * rough_root(max(ratio, Plain(1e-30)), trial.order);
        factor = min(max(factor, Plain(0.2)), Plain(8.0));
        const Plain largest = select(above, Plain(0.9), Plain(0.5));
        factor = select(rejected, min(factor, largest), factor);
        factor = select(trial.error <= Plain(1e300), factor, Plain(0.2));
        step = select(active, value(dq) * factor, step);
        out.next_step = select(active, step * value(here.ds), out.next_step);
    }

    void give_up(const Mask& failed) {
        out.failed = out.failed | failed;
        out.progress = select(failed, value(out.s) / value(path.length), out.progress);
        active = active & !failed;
    }

    Mask affordable(double evaluations) const { return is_affordable(control, out, evaluations); }

    void count(const Mask& where, double evaluations) {
        out.evaluations = out.evaluations + select(where, Plain(evaluations), Plain(0.0));
    }

    const MaterialOf<Real>& m;
    const Control& control;
    const StraightPath<Real>& path;
    const Segment<Real>& seg;
    const Plain allowed;  // error of the call, of the stress norm
    const Plain advised_step;

    Integrated<Real>& out;
    Position<Real> from;
    Marched<Real> k1;  // rate at the current position
    Waypoint<Real> here;
    Plain step;  // next dq to try
    Mask active;
    Mask needs_rate;

    // of the current attempt
    Real left, dq, arc;
    StepCourse<Real, DormandPrinceNodes> course;
    AveragedCourse<Real, DormandPrinceNodes> averaged;
    Plain stress_scale, tolerable;
    Mask to_end, accepted, separating, rejected, above;
    Trial<Real> trial;
};

GRIT_KERNEL_END
