// SPDX-License-Identifier: BSD-3-Clause
// Error-controlled integration of the stress along a straight strain path.
//
// The path is cut where the intergranular strain turns from unloading to loading (known exactly), so
// that every segment is smooth. Positions within a segment are plain fractions of it: a derivative
// carried through differentiates the segment's ends and replays the accepted steps.
#pragma once

#include "umat/runge_kutta.hpp"

GRIT_KERNEL_BEGIN

struct Control {
    double tolerance;
    int evaluation_limit;
};

template <class Real> struct Integrated {
    Marched<Real> y;
    InPlane<Real> h;              // at the end
    MaskOf<Real> failed;          // evaluation limit or step underflow
    MaskOf<Real> separated;       // p fell below the floor: stress-free from separation_at on
    MaskOf<Real> outside_cone;
    Real separation_at;           // arc length
    PlainOf<Real> progress;       // fraction of the path done (where it failed)
    PlainOf<Real> error, substeps, evaluations, next_step;
};

// Between two events of a path, and how far the steps have come.
template <class Real> struct Segment {
    Real start, end;       // arc lengths
    MaskOf<Real> loading;  // branch of the intergranular strain
    MaskOf<Real> last;
    PlainOf<Real> done;  // fraction
};

// Constants of the step control, calibrated so that single calls deliver what was asked: see the
// table of docs/accuracy.md.
constexpr double error_safety = 12.0; // embedded estimates are optimistic where h changes
constexpr double heun_safety = 0.5;   // ... and pessimistic for steps far below R
constexpr double memory_reach = 2.2;  // longest step while h changes, in R tolerance^(1/5)
constexpr double smallest_fraction = 1e-9;

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

template <class Real>
GRIT_INLINE MaskOf<Real> back_into_cone(Tensor<Real>& T, const MaskOf<Real>& where) {
    using Plain = PlainOf<Real>;
    constexpr double limit = cone_limit * root_2;
    const Tensor<Plain> plain = value(T);
    const Plain tr = trace(plain);
    const Tensor<Plain> dev = deviator(plain);
    const MaskOf<Real> outside =
        where & (3.0 * contract(dev, dev) > (limit * limit * (1.0 + 1e-12)) * tr * tr);
    if (any(outside)) {
        const Tensor<Real> T_dev = deviator(T);
        const Real scale = limit * fabs(trace(T)) / sqrt(3.0 * contract(T_dev, T_dev) + 1e-300);
        const Tensor<Real> inside =
            scaled_sum(scale, T_dev, isotropic(trace(T) * (1.0 / 3.0)));
        T = select(outside, inside, T);
    }
    return outside;
}

template <class Plain> GRIT_INLINE Plain fifth_root(const Plain& x) { return exp(0.2 * log(x)); }

template <class Real, bool igs>
inline Integrated<Real> integrate(const Material& m, const Control& control,
                                  const StraightPath<Real>& path, const Tensor<Real>& T_0,
                                  const PlainOf<Real>& advised_step) {
    using Plain = PlainOf<Real>;
    using Mask = MaskOf<Real>;
    const Plain zero(0.0);
    const Plain one(1.0);
    const double tolerance = control.tolerance;
    const double p_open = opening_per_floor * m.p_floor;
    const double reach = exp(0.2 * log(tolerance));

    Segment<Real> seg = first_segment<Real, igs>(m, path);
    Integrated<Real> out;
    out.y.T = T_0;
    out.y.P = select(seg.loading, -log(max(1.0 - path.u_0, Real(1e-16))), Real(0.0));
    out.y.G = Real(0.0);
    out.failed = out.separated = out.outside_cone = Mask(false);
    out.separation_at = path.length;
    out.error = out.substeps = out.evaluations = out.next_step = zero;
    out.progress = one;

    Marched<Real> k1;
    Plain step = zero;
    Mask active(true);
    Mask needs_rate(true);
    Mask fresh(true);  // at the start of a segment
    Mask quick(false); // tries Heun over the whole segment
    for (int i = 0; i < 6; ++i) k1.T[i] = Real(0.0);
    k1.P = k1.G = Real(0.0);

    while (any(active)) {
        const Real segment_length = seg.end - seg.start;
        const Real s = fma(Real(seg.done), segment_length, seg.start);
        const Plain plain_length = value(segment_length);

        const Mask evaluate = active & needs_rate;
        if (any(evaluate)) {
            const Marched<Real> k = marched_rate<Real, igs>(m, path, s, out.y, seg.loading);
            k1.T = select(evaluate, k.T, k1.T);
            k1.P = select(evaluate, k.P, k1.P);
            k1.G = select(evaluate, k.G, k1.G);
            out.evaluations = out.evaluations + select(evaluate, one, zero);
        }
        const Plain stress_scale =
            max(max(norm(value(T_0)), norm(value(out.y.T))), Plain(2.0 * m.p_floor));
        Plain change = zero;  // of h over the segment, in R
        const Mask start = active & fresh;
        if (any(start)) {
            const Plain memory = memory_rate<Real, igs>(m, path, out.y, k1, seg.loading);
            const Plain relative_rate = norm(value(k1.T)) / stress_scale;
            change = memory * (m.inverse_R * plain_length);
            const Plain growth = relative_rate * plain_length;
            const Plain guess = heun_safety * 0.1 * growth * square(growth + change);
            quick = start & (guess <= Plain(tolerance));
            const Plain first =
                reach / max(0.1 * m.inverse_R * memory + 0.3 * relative_rate, Plain(1e-30));
            step = select(start, select(advised_step > zero, advised_step, first), step);
        }
        // Near saturation h changes ever more slowly; before it, a step much beyond R looks past
        // the change of h and its error estimate cannot be trusted.
        if constexpr (igs) {
            const Plain memory = memory_rate<Real, igs>(m, path, out.y, k1, seg.loading);
            step = min(step, m.R * memory_reach * reach / max(memory, Plain(1e-30)));
        }
        const Plain left = 1.0 - seg.done;
        Plain fraction = step / plain_length;
        fraction = select(2.0 * fraction > left, 0.5 * left, fraction);
        const Mask to_end = quick | (step >= 0.95 * (left * plain_length));
        fraction = select(to_end, left, fraction);

        StepContext<Real> c{m, path, s, segment_length * fraction, seg.loading, stress_scale};
        Trial<Real> trial;
        const Mask stepped = active & !quick;
        if (any(stepped)) {
            trial = dormand_prince_step<Real, igs>(c, out.y, k1);
            trial.error = error_safety * trial.error;
            out.evaluations = out.evaluations + select(stepped, Plain(6.0), zero);
        }
        const Mask quickly = active & quick;
        if (any(quickly)) {
            const Trial<Real> heun = heun_step<Real, igs>(c, out.y, k1, change);
            if (any(stepped)) {
                trial.y.T = select(quickly, heun.y.T, trial.y.T);
                trial.y.P = select(quickly, heun.y.P, trial.y.P);
                trial.y.G = select(quickly, heun.y.G, trial.y.G);
                trial.error = select(quickly, heun_safety * heun.error, trial.error);
            } else {
                trial = heun;
                trial.error = heun_safety * heun.error;
            }
            out.evaluations = out.evaluations + select(quickly, one, zero);
        }

        // Verdict. Comparisons are written so that a NaN is a rejection.
        const Plain p_0 = trace(value(out.y.T)) * (-1.0 / 3.0);
        const Plain p_1 = trace(value(trial.y.T)) * (-1.0 / 3.0);
        const Mask good = trial.error <= Plain(tolerance);
        // Falling below the opening pressure: the point separates, from close above it only.
        const Mask falling = p_1 < p_0;
        const Mask above = (p_1 >= Plain(p_open)) | ((p_1 >= p_0) & (p_1 > zero));
        const Mask near_opening = (p_0 <= Plain(2.0 * p_open)) & (trace(value(k1.T)) > zero);
        const Mask accepted = active & good & above;
        const Mask separating = stepped & good & !above & falling & near_opening;
        const Mask rejected = active & !(accepted | separating);

        out.error = out.error + select(accepted, trial.error, zero);
        out.substeps = out.substeps + select(accepted | separating, one, zero);
        if (any(separating)) {
            const Real here = trace(out.y.T) * (-1.0 / 3.0);
            const Real there = trace(trial.y.T) * (-1.0 / 3.0);
            const Real part = (here - p_open) / (here - there);
            const Real at = fma(min(max(part, Real(0.0)), Real(1.0)), c.ds, s);
            out.separation_at = select(separating, at, out.separation_at);
            out.separated = out.separated | separating;
        }
        out.y.T = select(accepted, trial.y.T, out.y.T);
        out.y.P = select(accepted, trial.y.P, out.y.P);
        out.y.G = select(accepted, trial.y.G, out.y.G);
        const Mask projected = back_into_cone(out.y.T, accepted);
        out.outside_cone = out.outside_cone | projected;
        seg.done = select(accepted, select(to_end, one, seg.done + fraction), seg.done);
        const Mask reusable = accepted & stepped;
        k1.T = select(reusable, trial.rate.T, k1.T);
        k1.P = select(reusable, trial.rate.P, k1.P);
        k1.G = select(reusable, trial.rate.G, k1.G);
        needs_rate = projected;

        // Next step
        const Plain ratio = tolerance / max(trial.error, Plain(1e-30 * tolerance));
        Plain factor = min(max(0.9 * fifth_root(max(ratio, Plain(1e-30))), Plain(0.2)), Plain(3.0));
        factor = select(rejected, min(factor, select(above, Plain(0.9), Plain(0.5))), factor);
        factor = select(trial.error <= Plain(1e300), factor, Plain(0.2));
        const Plain used = fraction * plain_length;
        step = select(active & !quick, used * factor, step);
        const Mask underflow = rejected & !quick & (step < smallest_fraction * plain_length);
        const Mask exhausted =
            rejected & (out.evaluations + 7.0 > Plain(double(control.evaluation_limit)));
        const Mask over_limit =
            accepted & (out.evaluations + 6.0 > Plain(double(control.evaluation_limit)));
        fresh = Mask(false);
        quick = quick & !active;

        const Mask ended = accepted & (seg.done >= one);
        const Mask turned = ended & !seg.last;
        const Mask failed = underflow | exhausted | (over_limit & !(ended & seg.last));
        out.failed = out.failed | failed;
        out.progress = select(failed, value(s) / value(path.length), out.progress);
        out.next_step = select(active, step, out.next_step);
        active = active & !(failed | separating | (ended & seg.last));
        if (any(turned)) {
            seg.start = select(turned, seg.end, seg.start);
            seg.end = select(turned, path.length, seg.end);
            seg.done = select(turned, zero, seg.done);
            seg.loading = seg.loading | turned;
            seg.last = seg.last | turned;
            needs_rate = needs_rate | turned;
            fresh = turned;
        }
    }
    out.h = intergranular_strain(m, path, path.length, out.y, seg.loading);
    return out;
}

GRIT_KERNEL_END
