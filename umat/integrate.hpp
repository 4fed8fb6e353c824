// SPDX-License-Identifier: BSD-3-Clause
// Error-controlled integration of the stress along a straight strain path: docs/adr/0001.
//
// The path is cut where the intergranular strain turns from unloading to loading (known exactly), so
// that every segment is smooth. Positions within a segment are plain fractions of it: a derivative
// carried through differentiates the segment's ends and replays the accepted steps.
#pragma once

#include "umat/cone.hpp"
#include "umat/runge_kutta.hpp"
#include "umat/segment.hpp"
#include "umat/step_control.hpp"

GRIT_KERNEL_BEGIN

template <class Real>
GRIT_INLINE void assign(const MaskOf<Real>& where, const Marched<Real>& from, Marched<Real>& to) {
    to.T = select(where, from.T, to.T);
    to.P = select(where, from.P, to.P);
    to.G = select(where, from.G, to.G);
}

// x^(1/5) for x in [1e-30, 1e30]
template <class Plain> GRIT_INLINE Plain fifth_root(const Plain& x) { return exp(0.2 * log(x)); }

// One point, or one per lane, on its way along a path. Masks say which lanes an action is for; what
// the other lanes hold is never changed.
template <class Real, bool igs> class Integrator {
    using Plain = PlainOf<Real>;
    using Mask = MaskOf<Real>;

  public:
    Integrator(const Material& material, const Control& limits, const StraightPath<Real>& along,
               const Tensor<Real>& T_0, const Plain& advised)
        : m(material), control(limits), path(along), advised_step(advised),
          p_open(opening_per_floor * m.p_floor), reach(fifth_root(control.tolerance)),
          start_norm(norm(value(T_0))), seg(first_segment<Real, igs>(m, along)) {
        out.y.T = T_0;
        out.y.P = select(seg.loading, -log(max(1.0 - path.u_0, Real(1e-16))), Real(0.0));
        out.y.G = Real(0.0);
        out.failed = out.separated = out.outside_cone = Mask(false);
        out.separation_at = path.length;
        out.error = out.substeps = out.evaluations = out.next_step = Plain(0.0);
        out.progress = Plain(1.0);
        for (int i = 0; i < 6; ++i) k1.T[i] = Real(0.0);
        k1.P = k1.G = Real(0.0);
        step = change = allowed = Plain(0.0);
        active = needs_rate = fresh = Mask(true);
        quick = Mask(false);
    }

    Integrated<Real> run() {
        while (any(active)) {
            locate();
            evaluate_rate();
            choose_step();
            attempt();
            judge();
            advance();
        }
        out.h = intergranular_strain(m, path, path.length, out.y, seg.loading);
        return out;
    }

  private:
    void locate() {
        segment_length = seg.end - seg.start;
        plain_length = value(segment_length);
        s = fma(Real(seg.done), segment_length, seg.start);
        stress_scale = max(max(start_norm, norm(value(out.y.T))), Plain(p_open));
    }

    void evaluate_rate() {
        give_up(active & needs_rate & !affordable(1.0));
        const Mask here = active & needs_rate;
        if (!any(here)) return;
        assign<Real>(here, marched_rate<Real, igs>(m, path, s, out.y, seg.loading), k1);
        count(here, 1.0);
    }

    // At the start of a segment: is it short enough for Heun, and if not, what is the first step?
    void choose_step() {
        const Plain memory = memory_rate<Real, igs>(m, path, out.y, k1, seg.loading);
        const Plain relative_rate = norm(value(k1.T)) / stress_scale;
        memory_weight = min(memory_price * m.R * relative_rate, Plain(1.0));
        const Mask starting = active & fresh;
        change = Plain(0.0);  // of the stiffness over the segment, relative
        if (any(starting)) {
            // Stiffness changes by up to m_R chi (1 - rho): more than h itself where rho is near 1.
            const Plain stiffness_change = min(m.m_R * m.chi * memory, Plain(1.0));
            change = stiffness_change * (m.inverse_R * plain_length);
            const Plain growth = relative_rate * plain_length;
            const Plain guess = heun_safety * 0.1 * growth * square(growth + change);
            allow(relative_rate);
            quick = starting & (guess <= allowed) & affordable(1.0);
            if constexpr (igs)
                if (m.chi < 2.0) quick = quick & !(seg.loading & (start_memory() < change));
            const Plain first =
                reach / max(0.1 * m.inverse_R * memory + 0.3 * relative_rate, Plain(1e-30));
            const Plain none(0.0);
            step = select(starting, select(advised_step > none, advised_step, first), step);
            if constexpr (igs)
                step = select(starting & seg.loading, min(step, gentle_start()), step);
        }
        // Near saturation h changes ever more slowly; before it, a step much beyond R looks past
        // the change of h and its error estimate cannot be trusted.
        if constexpr (igs) step = min(step, m.R * memory_reach * reach / max(memory, Plain(1e-30)));
        step = min(step, growth_reach * reach / max(relative_rate, Plain(1e-30)));
        // The last two steps of a segment are made equal.
        const Plain left = 1.0 - seg.done;
        fraction = step / plain_length;
        to_end = quick | (step >= 0.95 * (left * plain_length));
        fraction = select(2.0 * fraction > left, 0.5 * left, fraction);
        fraction = select(to_end, left, fraction);
    }

    // Rates have no derivative where h = 0: rho^beta_r (G3), rho^chi (G1). Steps grow from the one
    // whose error, of order 1 + the smaller exponent, is within what is allowed, or with rho itself.
    Plain gentle_start() const {
        const double order = 1.0 + (m.beta_r < m.chi ? m.beta_r : m.chi);
        const Plain error = allowed / (error_safety * max(memory_weight, Plain(1e-30)));
        const Plain smooth = exp(log(max(error, Plain(1e-30))) * (1.0 / order));
        return m.R * max(smooth, 3.0 * start_memory());
    }

    // rho where the loading starts
    Plain start_memory() const {
        const Plain rho = sqrt(fma(value(path.u_0), value(path.u_0), value(path.tau_sq)));
        const Plain crossing = sqrt(value(path.tau_sq));
        return select(path.u_0 >= Real(0.0), rho, crossing);
    }

    void give_up(const Mask& failed) {
        out.failed = out.failed | failed;
        out.progress = select(failed, value(s) / value(path.length), out.progress);
        active = active & !failed;
    }

    Mask affordable(double evaluations) const {
        return out.evaluations + evaluations <=
               Plain(static_cast<double>(control.evaluation_limit));
    }

    // What the call may add to the error: the tolerance times the share of the stress it changes, so
    // that errors over many small increments sum to what one large increment is allowed.
    void allow(const Plain& relative_rate) {
        const Plain length = value(path.length);
        const Plain share = length * max(relative_rate, Plain(slowest_rate));
        const Plain asked = control.tolerance * min(share, Plain(1.0));
        allowed = select(allowed > Plain(0.0), allowed, asked);
    }

    void attempt() {
        const StepContext<Real> c{
            m, path, s, segment_length * fraction, seg.loading, stress_scale, memory_weight};
        stepped = active & !quick & affordable(6.0);
        const Mask quickly = active & quick;
        if (any(stepped)) {
            trial = dormand_prince_step<Real, igs>(c, out.y, k1);
            trial.error = error_safety * trial.error;
            count(stepped, 6.0);
        } else {
            trial.y = trial.rate = k1;
            trial.error = Plain(0.0);
        }
        if (any(quickly)) {
            const Trial<Real> heun = heun_step<Real, igs>(c, out.y, k1, change);
            assign<Real>(quickly, heun.y, trial.y);
            trial.error = select(quickly, heun_safety * heun.error, trial.error);
            count(quickly, 1.0);
        }
    }

    // Accepted, separating or rejected. Comparisons are written so that a NaN is a rejection.
    void judge() {
        const Plain zero(0.0);
        const Plain p_0 = trace(value(out.y.T)) * (-1.0 / 3.0);
        const Plain p_1 = trace(value(trial.y.T)) * (-1.0 / 3.0);
        const Mask good = trial.error <= allowed;
        above = (p_1 >= Plain(p_open)) | ((p_1 >= p_0) & (p_1 > zero));
        accepted = (stepped | (active & quick)) & good & above;
        // Falling below the opening pressure: the point separates, from close above it only.
        const Mask close = (p_0 <= Plain(2.0 * p_open)) & (trace(value(k1.T)) > zero);
        separating = stepped & good & !above & (p_1 < p_0) & close;
        rejected = active & !(accepted | separating);
        if (any(separating)) separate();
    }

    void separate() {
        const Real here = trace(out.y.T) * (-1.0 / 3.0);
        const Real there = trace(trial.y.T) * (-1.0 / 3.0);
        const Real part = (here - p_open) / (here - there);
        const Real at = fma(min(max(part, Real(0.0)), Real(1.0)), segment_length * fraction, s);
        out.separation_at = select(separating, at, out.separation_at);
        out.separated = out.separated | separating;
    }

    void advance() {
        const Plain zero(0.0);
        const Plain one(1.0);
        assign<Real>(accepted, trial.y, out.y);
        assign<Real>(accepted & stepped, trial.rate, k1);
        const Mask projected = back_into_cone(out.y.T, accepted);
        out.outside_cone = out.outside_cone | projected;
        out.error = out.error + select(accepted, trial.error, zero);
        out.substeps = out.substeps + select(accepted | separating, one, zero);
        seg.done = select(accepted, select(to_end, one, seg.done + fraction), seg.done);
        adapt_step();

        const Mask ended = accepted & (seg.done >= one);
        const Mask finished = ended & seg.last;
        const Mask turned = ended & !seg.last;
        const Mask underflow = rejected & stepped & (step < smallest_fraction * plain_length);
        give_up(underflow | (active & !quick & !stepped));
        active = active & !(separating | finished);
        needs_rate = projected | turned;
        fresh = turned;
        quick = Mask(false);
        if (any(turned)) turn(turned);
    }

    void adapt_step() {
        const Plain ratio = allowed / max(trial.error, 1e-30 * allowed);
        Plain factor = 0.9 * fifth_root(max(ratio, Plain(1e-30)));
        factor = min(max(factor, Plain(0.2)), Plain(8.0));
        const Plain largest = select(above, Plain(0.9), Plain(0.5));
        factor = select(rejected, min(factor, largest), factor);
        factor = select(trial.error <= Plain(1e300), factor, Plain(0.2));
        step = select(stepped, fraction * plain_length * factor, step);
        out.next_step = select(active, step, out.next_step);
    }

    // From unloading to loading of the intergranular strain; P and G are still zero.
    void turn(const Mask& turned) {
        seg.start = select(turned, seg.end, seg.start);
        seg.end = select(turned, path.length, seg.end);
        seg.done = select(turned, Plain(0.0), seg.done);
        seg.loading = seg.loading | turned;
        seg.last = seg.last | turned;
    }

    void count(const Mask& where, double evaluations) {
        out.evaluations = out.evaluations + select(where, Plain(evaluations), Plain(0.0));
    }

    const Material& m;
    const Control& control;
    const StraightPath<Real>& path;
    const Plain advised_step;
    const double p_open;  // pressure below which a loaded point separates
    const double reach;   // tolerance^(1/5)
    const Plain start_norm;

    Segment<Real> seg;
    Integrated<Real> out;
    Marched<Real> k1;  // rate at the current position
    Plain step;        // next step to try [strain]
    Plain allowed;     // error of the call, of the stress norm
    Mask active;
    Mask needs_rate;
    Mask fresh;  // at the start of a segment
    Mask quick;  // tries Heun over the whole segment

    // of the current attempt
    Real s, segment_length;
    Plain plain_length, stress_scale, memory_weight, change, fraction;
    Mask to_end, stepped, accepted, separating, rejected, above;
    Trial<Real> trial;
};

template <class Real, bool igs>
inline Integrated<Real> integrate(const Material& m, const Control& control,
                                  const StraightPath<Real>& path, const Tensor<Real>& T_0,
                                  const PlainOf<Real>& advised_step) {
    return Integrator<Real, igs>(m, control, path, T_0, advised_step).run();
}

GRIT_KERNEL_END
