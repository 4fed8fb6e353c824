// SPDX-License-Identifier: BSD-3-Clause
// A whole path: each of its segments by the short increment or step by step.
#pragma once

#include "umat/integrate/integrator.hpp"
#include "umat/integrate/short_increment.hpp"

GRIT_KERNEL_BEGIN

// To the end of a segment, by what the short increment found or step by step.
template <class Real, bool igs>
inline void to_end_of_segment(const MaterialOf<Real>& m, const Control& control,
                              const StraightPath<Real>& path, const Segment<Real>& start,
                              const ShortIncrement<Real>& quick, const MaskOf<Real>& where,
                              const PlainOf<Real>& allowed, const PlainOf<Real>& advised_step,
                              Integrated<Real>& out) {
    using Plain = PlainOf<Real>;
    out.evaluations = out.evaluations + select(where, quick.evaluations, Plain(0.0));
    const MaskOf<Real> done = where & quick.accepted, rest = where & !quick.accepted;
    if (any(rest))
        Integrator<Real, igs>(m, control, path, start, rest, allowed, advised_step, out).run();
    if (!any(done)) return;
    assign(done, out.y.T, quick.T);
    assign(done, out.h, quick.h);
    out.outside_cone = out.outside_cone | (done & quick.outside_cone);
    out.error = out.error + select(done, quick.error, Plain(0.0));
    out.substeps = out.substeps + select(done, Plain(1.0), Plain(0.0));
    out.next_step = select(done, value(path.length), out.next_step);
    out.h_late = select(done, quick.h_late, out.h_late);
}

// From the start of the first segment and a short increment tried there.
template <class Real, bool igs>
inline Integrated<Real> integrate(const MaterialOf<Real>& m, const Control& control,
                                  const StraightPath<Real>& path, const Segment<Real>& first,
                                  const ShortIncrement<Real>& quick, const PlainOf<Real>& allowed,
                                  const PlainOf<Real>& advised_step) {
    using Plain = PlainOf<Real>;
    using Mask = MaskOf<Real>;
    Integrated<Real> out;
    out.y = first.y;
    out.h = first.h;
    out.s = first.s;
    out.failed = out.separated = out.outside_cone = Mask(false);
    out.separation_at = path.length;
    out.error = out.substeps = out.evaluations = out.next_step = Plain(0.0);
    out.h_late = OfMemory<Real>(0.0);
    out.progress = Plain(1.0);
    to_end_of_segment<Real, igs>(m, control, path, first, quick, Mask(true), allowed, advised_step,
                                 out);
    if constexpr (igs) {
        Mask turned = !(first.last | out.failed | out.separated);
        const Mask dear = turned & !is_affordable(control, out, 4.0);
        out.failed = out.failed | dear;
        out.progress = select(dear, value(first.end) / value(path.length), out.progress);
        turned = turned & !dear;
        if (any(turned)) {
            const Segment<Real> second = second_segment(m, path, first, out.y.T);
            const auto again =
                short_increment<Real, igs>(m, control, path, second, allowed, Plain(0.0));
            to_end_of_segment<Real, igs>(m, control, path, second, again, turned,
                                         turned_share * allowed, advised_step, out);
        }
    }
    return out;
}

template <class Real>
GRIT_INLINE PlainOf<Real> allowed_error(const MaterialOf<Real>& m, const Control& control,
                                        const StraightPath<Real>& path,
                                        const Segment<Real>& first) {
    using Plain = PlainOf<Real>;
    const Plain length = value(path.length);
    return allowed_error<Plain>(control, length, first.relative_rate / value(first.at.ds),
                                first.memory *
                                    min(plain(m).inverse_R * length, Plain(longest_averaged)));
}

template <class Real, bool igs, class Stress>
inline Integrated<Real> integrate(const MaterialOf<Real>& m, const Control& control,
                                  const StraightPath<Real>& path, const Tensor<Stress>& T_0,
                                  const PlainOf<Real>& advised_step, const PlainOf<Real>& spent) {
    const Segment<Real> first = first_segment<Real, igs>(m, path, T_0);
    const auto allowed = allowed_error(m, control, path, first);
    const auto quick = short_increment<Real, igs>(m, control, path, first, allowed, spent);
    return integrate<Real, igs>(m, control, path, first, quick, allowed, advised_step);
}

GRIT_KERNEL_END
